#!/usr/bin/env python3
"""Every option with limits, at its least and at its largest value: it ends within a minute, or says within two
seconds on standard error how long it takes. Prints the table of all of them, and ends with 1 if one does neither.

The limits of numbers and digits are those that the program names where it refuses a value; those of the arch are
the ends of its domain.

    benches/limits.py [PROGRAM]
"""

import re
import subprocess
import sys
import tempfile
import threading
import time

LONGEST = 60.0
FIRST_WORD = 2.0
# After so long a question that says how long it takes is ended.
PATIENCE = 75.0

ARCH = "--half-opening 80deg --friction 0.6"
THICK = ARCH + " --thickness 0.3"
SMALL, LARGE = "1e-300", "1e300"

# A question, and the options that are asked of it. Without ends the program is asked for its limits.
QUESTIONS = [
    (f"state {ARCH}", [("--digits",), ("--stones",)]),
    ("state --friction 0.6", [("--half-opening", SMALL, "179.999999deg")]),
    ("state --half-opening 80deg", [("--friction", SMALL, LARGE)]),
    ("state --thrust 0.3", [("--digits",)]),
    (f"assess {THICK}", [("--digits",), ("--stones",), ("--tilt", SMALL, LARGE)]),
    (f"assess {ARCH}", [("--thickness", SMALL, "2")]),
    (f"assess {THICK} --tilt 0.1", [("--digits",), ("--stones",)]),
    (f"assess {THICK} --tilt 0.1 --stones 12", [("--digits",)]),
    ("find half-opening --friction 0.6", [("--digits",), ("--thickness", SMALL, "2")]),
    ("find friction --half-opening 80deg", [("--digits",), ("--thickness", SMALL, "2")]),
    ("find boundary rrs/ss --friction 1.4", [("--digits",)]),
    ("find boundary rrr/srr --half-opening 80deg", [("--digits",)]),
    ("equation 7 --rotation-joint 1 --weight milankovitch", [("--digits",)]),
    (f"voussoirs {ARCH} --stones 10", [("--digits",)]),
    (f"voussoirs {ARCH}", [("--stones",), ("--stones", "2..10001", "2..10001")]),
    (f"voussoirs {THICK} --stones 10", [("--digits",)]),
    (f"voussoirs {THICK} --stones 10 --tilt 0.1", [("--digits",)]),
    (f"voussoirs {THICK} --tilt 0.1", [("--stones",)]),
    ("complementarity --half-opening 2.3 --friction 1.05", [("--digits",), ("--stones",)]),
    ("complementarity --half-opening 2.3 --friction 1.05 --stones 8", [("--digits",)]),
    ("complementarity --half-opening 2.3 --friction 1.05 --thickness 0.7", [("--stones",)]),
    ("complementarity --half-opening 2.3 --branch", [("--tolerance", "1e-8", "0.1")]),
    ("sample", [("--count", "1", "1000000")]),
    ("map", [("--tolerance", "1e-8", "0.1")]),
    ("map point rotation --at 1.0", [("--digits",)]),
    ("map point rrs/rsr --at 1.1", [("--digits",)]),
    ("figure 2", [("--tolerance", "1e-8", "0.1")]),
    (f"draw {ARCH} --format svg", [("--stones",), ("--amplitude", "1e-9", "1")]),
    ("certify T", [("--digits",)]),
    (f"certify state {ARCH}", [("--digits",)]),
    ("certify asymmetric --half-opening 2.3 --friction 1.05", [("--digits",)]),
    ("constants T --weight milankovitch", [("--digits",)]),
    ("constants", [("--digits",)]),
    ("constants", [("--threads", "1", "64")]),
]


def limits(program, question, option):
    """What the program allows, by its refusal."""
    for wrong in ["0", "9" * 30, "x"]:
        told = subprocess.run([program, *question.split(), option, wrong], capture_output=True, text=True, timeout=PATIENCE)
        found = re.search(r"from (\d+) to (\d+)", told.stderr) or re.search(r"at (least) .* at most (\d+)", told.stderr)
        if told.returncode == 2 and found:
            return found.groups()
    raise SystemExit(f"{question} {option}: the refusal names no limits: {told.stderr.strip()}")


def run(program, question, option, value):
    """Seconds, exit code, and the seconds after which it said how long it takes."""
    start = time.monotonic()
    said = []
    with tempfile.TemporaryFile() as out:
        command = [program, *question.split(), option, value]
        process = subprocess.Popen(command, stdout=out, stderr=subprocess.PIPE, text=True)

        def listen():
            for line in process.stderr:
                if "about" in line:
                    said.append(time.monotonic() - start)

        listener = threading.Thread(target=listen)
        listener.start()
        try:
            code = process.wait(timeout=PATIENCE)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
            code = None
        listener.join()
    return time.monotonic() - start, code, said[0] if said else None


def main():
    program = sys.argv[1] if len(sys.argv) > 1 else "target/release/couplet"
    wrong = []
    print("| question | option | value | s | exit |")
    print("|---|---|---|---:|---:|")
    for question, options in QUESTIONS:
        for option, *ends in options:
            ends = ends or limits(program, question, option)
            for value in dict.fromkeys(ends):
                seconds, code, said = run(program, question, option, value)
                keeps = (code is not None and seconds <= LONGEST) or (said is not None and said <= FIRST_WORD)
                shown = f"{seconds:.1f}" if code is not None else f"over {PATIENCE:.0f}"
                mark = "" if keeps else " **too long, and says nothing**"
                print(f"| `{question}` | `{option}` | {value} | {shown}{mark} | {code} |", flush=True)
                if not keeps or code not in (0, 1, None):
                    wrong.append(f"{question} {option} {value}: {shown} s, exit {code}")
    for line in wrong:
        print(line, file=sys.stderr)
    raise SystemExit(1 if wrong else 0)


main()
