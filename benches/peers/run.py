#!/usr/bin/env python3
"""couplet beside what else one would use for the triple point; see README.md in this folder.

    run.py            50 to 1,000,000 digits (about 40 minutes)
    run.py --quick    up to 1,000 digits

Writes tables, with machine and commit, to standard output.

Installs what is missing: wheels from PyPI into target/peers, and, as root, the Debian package pari-gp.
"""

import argparse
import datetime
import decimal
import json
import os
import platform
import resource
import shutil
import subprocess
import sys
from pathlib import Path
from statistics import median

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
VENV = ROOT / "target" / "peers"
PYTHON = VENV / "bin" / "python"

LIMIT = 300  # seconds of CPU time for one computation
GROWTH = 10  # of the time from ten times fewer digits, at least: what would take longer than the limit is not tried
ROUNDS = 3
ONCE = 10.0  # what takes longer is not repeated in a further round

# Titles, program and method. The first of each list is what the others are compared with.
INSIDE = [
    ("couplet, enclosures of all unknowns, **proved**", "couplet", "enclosure"),
    ("Arb, Newton + Krawczyk, **proved**", "arb.py", "proof"),
    ("Arb from C, Newton + Krawczyk, **proved**", "arb.c", "proof"),
    ("Arb, Newton", "arb.py", "newton"),
    ("Arb from C, Newton", "arb.c", "newton"),
    ("gmpy2 (MPFR), Newton", "gmpy2_peer.py", "newton"),
    ("PARI/GP, Newton", "pari.gp", "newton"),
    ("mpmath, Newton", "mpmath_peer.py", "newton"),
    ("mpmath, `findroot`", "mpmath_peer.py", "findroot"),
    ("SymPy, `nsolve`", "float64.py", "nsolve"),
    ("couplet, enclosures of 13 quantities, **proved**", "couplet", "enclosures"),
    ("Arb from C, the same, **proved**", "arb.c", "enclosures"),
    ("couplet, 13 quantities, correctly rounded decimals, **proved**", "couplet", "constants"),
    ("Arb, 13 quantities, decimals not always correctly rounded, **proved**", "arb.py", "quantities"),
    ("Arb from C, the same, **proved**", "arb.c", "quantities"),
    ("couplet, the same as above and the proof in the large box before it", "couplet", "everything"),
]
COMMANDS = [
    ("`couplet constants T`, 13 quantities, correctly rounded, **proved**", "command", ""),
    ("Arb, Newton + Krawczyk, **proved**", "arb.py", "proof"),
    ("Arb, Newton", "arb.py", "newton"),
    ("gmpy2 (MPFR), Newton", "gmpy2_peer.py", "newton"),
    ("PARI/GP, Newton", "pari.gp", "newton"),
    ("mpmath, Newton", "mpmath_peer.py", "newton"),
]
BARE = [
    ("MPFR in couplet (rug)", "couplet", "bare"),
    ("Arb", "arb.py", "bare"),
    ("Arb from C", "arb.c", "bare"),
    ("MPFR in gmpy2", "gmpy2_peer.py", "bare"),
    ("PARI/GP", "pari.gp", "bare"),
    ("mpmath", "mpmath_peer.py", "bare"),
]
DOUBLES = [
    ("couplet, `solve::newton`, 64 bits (MPFR), nothing proved", "couplet", "newton"),
    ("couplet, isolation: the root exists, is unique in a large box, and is physical", "couplet", "isolate"),
    ("scipy, `fsolve`, six equations, no Jacobian", "float64.py", "fsolve"),
    ("scipy, `root`, three equations with Jacobian", "float64.py", "root"),
    ("SymPy, `nsolve`", "float64.py", "nsolve"),
    ("Python's floats, Newton, three equations", "float64.py", "newton"),
]


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--quick", action="store_true", help="up to 1,000 digits, to standard output")
    arguments = parser.parse_args()
    missing = install()
    programs = build()
    sizes = [50, 1_000] if arguments.quick else [50, 1_000, 10_000, 100_000, 1_000_000]
    cells = {}  # (kind, program, method, digits) -> list of seconds, or an apology
    wanted = [("inside", *row[1:], n) for n in sizes for row in INSIDE + BARE]
    wanted += [("inside", *row[1:], 15) for row in DOUBLES]
    wanted += [("command", *row[1:], n) for n in sizes for row in COMMANDS]
    values = {}  # (program, method, digits) -> six decimals
    load = os.getloadavg()[1]
    for number in range(ROUNDS):
        for kind, program, method, digits in wanted:
            cell = cells.setdefault((kind, program, method, digits), [])
            before = cells.get((kind, program, method, digits // 10))
            if program in missing:
                cells[kind, program, method, digits] = "not installed"
            elif isinstance(before, str) or (before and min(before) > LIMIT / GROWTH):
                cells[kind, program, method, digits] = "not tried"
            elif not isinstance(cell, str) and not (cell and max(cell) > ONCE):
                print(f"{number + 1}/{ROUNDS} {kind} {program} {method} {digits}", file=sys.stderr)
                seconds, numbers = run(programs, kind, program, method, digits)
                if seconds is None:
                    cells[kind, program, method, digits] = f"> {LIMIT} s"
                else:
                    cell.append(seconds)
                if numbers:
                    values[program, method, digits] = numbers
    compared = agree(values)
    print(report(cells, sizes, compared, missing, load, arguments.quick))


def install():
    """The programs that could not be had, with what to do about it printed."""
    requirements = HERE / "requirements.txt"
    stamp = VENV / "requirements.txt"
    if not stamp.exists() or stamp.read_text() != requirements.read_text():
        subprocess.run([sys.executable, "-m", "venv", VENV], check=True)
        pip = [
            PYTHON,
            "-m",
            "pip",
            "install",
            "--quiet",
            "--disable-pip-version-check",
            "--only-binary",
            ":all:",
        ]
        subprocess.run([*pip, "-r", requirements], check=True)
        shutil.copy(requirements, stamp)
    if not shutil.which("gp") and os.geteuid() == 0 and shutil.which("apt-get"):
        subprocess.run(["apt-get", "update", "-qq"], check=False)
        subprocess.run(["apt-get", "install", "-y", "-qq", "--no-install-recommends", "pari-gp"], check=False)
    if shutil.which("gp"):
        return set()
    print(
        "PARI/GP is missing and left out; install the package 'pari-gp' (sudo apt-get install pari-gp)",
        file=sys.stderr,
    )
    return {"pari.gp"}


def build():
    """The paths of couplet, of its side of the comparison and of Arb's in C."""
    subprocess.run(["cargo", "build", "--release", "--locked", "--quiet"], cwd=ROOT, check=True)
    bench = [
        "cargo",
        "bench",
        "--locked",
        "--quiet",
        "--no-run",
        "--bench",
        "peers",
        "--message-format",
        "json",
    ]
    lines = subprocess.run(bench, cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()
    messages = [json.loads(line) for line in lines]
    programs = {m["target"]["name"]: m["executable"] for m in messages if m.get("executable")}
    # The wheel's library, which finds those it needs beside itself.
    libraries = next(VENV.glob("lib/python*/site-packages/python_flint.libs"))
    flint, linked = next(libraries.glob("libflint*")), VENV / "arb"
    compiler = ["cc", "-std=c11", "-O2", HERE / "arb.c", flint, f"-Wl,-rpath,{libraries}", "-lm", "-o", linked]
    subprocess.run(compiler, check=True)
    return {"couplet": programs["peers"], "command": programs["couplet"], "arb.c": linked}


def run(programs, kind, program, method, digits):
    """Seconds of CPU time (None: over the limit), and the six decimals if the program timed itself."""
    inside = kind == "inside"
    extra = {"RAYON_NUM_THREADS": "1", "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    # Python's start-up is that of compiled modules, which are kept out of this folder.
    extra |= {"PYTHONDONTWRITEBYTECODE": "", "PYTHONPYCACHEPREFIX": str(VENV / "pycache")}
    if program in ("couplet", "arb.c"):
        command = [programs[program], method, str(digits)]
    elif program == "command":
        command = [programs[program], "constants", "T", "--weight", "milankovitch", "--digits", str(digits)]
    elif program == "pari.gp":
        command = ["gp", "-q", "-f", "-s", "512M", HERE / program]
        extra |= {"METHOD": method, "DIGITS": str(digits)} | ({"TIME": "1"} if inside else {})
    else:
        command = [PYTHON, HERE / program, method, str(digits)] + (["--time"] if inside else [])
    before = spent()
    job = subprocess.Popen(
        command, env=os.environ | extra, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True
    )
    while True:
        try:
            printed, _ = job.communicate(timeout=1)
            break
        except subprocess.TimeoutExpired:
            if running(job.pid) > LIMIT:
                job.kill()
                job.communicate()
                return None, None
    seconds = spent() - before
    if job.returncode:
        sys.exit(f"{program} {method} {digits} failed")
    if not inside:
        return seconds, None
    told = json.loads(printed)
    return told["seconds"], told["values"]


def running(pid):
    """CPU time of a process that still runs. (A limit set by RLIMIT_CPU makes its own clock coarse.)"""
    fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def spent():
    """CPU time of all processes that have ended."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def agree(values):
    """How many sets of decimals agree with couplet's in all digits but the last two; one that does not
    ends the run."""
    context = decimal.Context(prec=max(digits for _, _, digits in values) + 10)
    for (program, method, digits), numbers in values.items():
        # Of doubles couplet's own reference is the row of 50 digits.
        reference = values["couplet", "constants", max(digits, 50)]
        for number, right in zip(map(decimal.Decimal, numbers), map(decimal.Decimal, reference), strict=True):
            unit = decimal.Decimal(1).scaleb(right.adjusted() - digits + 1)
            if context.abs(context.subtract(number, right)) > 100 * unit:
                sys.exit(f"{program} {method} {digits}: {str(number)[:30]} is not {str(right)[:30]}")
    return len(values)


def report(cells, sizes, compared, missing, load, quick):
    def seconds(kind, row, digits):
        cell = cells[kind, *row[1:], digits]
        return cell if isinstance(cell, str) else median(cell)

    def table(kind, rows, columns, first):
        lines = [
            f"| {first} | " + " | ".join(f"{n:,} digits" for n in columns) + " |",
            "|---" * (len(columns) + 1) + "|",
        ]
        for row in rows:
            shown = []
            for n in columns:
                value, base = seconds(kind, row, n), seconds(kind, rows[0], n)
                shown.append(value if isinstance(value, str) else f"{time(value)} ({ratio(value / base)})")
            lines.append(f"| {row[0]} | " + " | ".join(shown) + " |")
        return "\n".join(lines)

    date = datetime.date.today().isoformat()
    command = "benches/peers/run.py" + (" --quick" if quick else "")
    isolation = seconds("inside", DOUBLES[1], 15)
    return f"""# couplet and its peers: results

{versions(missing)}

Machine: {processor()}, {os.cpu_count()} cores, load average {load:.1f} at the start; commit {commit()}; {date};
command `{command}`. What is compared, and what is fair in it: benches/peers/README.md.

CPU time on one thread, median of {ROUNDS} rounds (one where it exceeds {ONCE:.0f} s). In brackets the ratio to
the first row: **below 1 is faster than couplet**. All {compared} sets of six unknowns agree with couplet's in
every digit but the last two.

## The root alone

Inside the process, warmed up: no start-up, no decimals unless stated. couplet's proof that the root is the
only one in a large box is made once for any number of digits and not in the first row; it takes
{time(isolation)}.

{table("inside", INSIDE, sizes, "unknowns of T, Milankovitch's weight")}

## The whole command

From start-up to decimals on a pipe; couplet's with the proof in the large box.

{table("command", COMMANDS, sizes, "command")}

## The yardstick

Sine and cosine of the three angles, full length, by the libraries themselves: how much of the differences
above is the library's and not the method's.

{table("inside", BARE, sizes, "library")}

## Double precision

{table("inside", DOUBLES, [15], "solver").replace("15 digits", "time")}
"""


def time(seconds):
    for unit, name in ((1, "s"), (1e-3, "ms"), (1e-6, "µs")):
        if seconds >= 0.9995 * unit or unit == 1e-6:
            value = seconds / unit
            return f"{value:.0f} {name}" if value >= 100 else f"{value:.3g} {name}"


def ratio(value):
    return f"{value:,.0f}" if value >= 100 else f"{value:.2g}" if value < 1 else f"{value:.3g}"


def output(*command):
    result = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    return result.stdout.strip()


def commit():
    changed = output("git", "status", "--porcelain", "--", "src", "benches", "Cargo.lock")
    return output("git", "rev-parse", "--short", "HEAD") + (" with changes" if changed else "")


def processor():
    lines = Path("/proc/cpuinfo").read_text().splitlines()
    return next(
        (line.split(":")[1].strip() for line in lines if line.startswith("model name")), platform.processor()
    )


def versions(missing):
    python = """
import flint, gmpy2, mpmath, platform, scipy, sympy
print(f"Python {platform.python_version()}, python-flint {flint.__version__} (FLINT {flint.__FLINT_VERSION__}),",
      f"gmpy2 {gmpy2.version()} ({gmpy2.mpfr_version()}, {gmpy2.mp_version()}),\\n"
      f"mpmath {mpmath.__version__}, scipy {scipy.__version__}, SymPy {sympy.__version__}", end="")"""
    lock = (ROOT / "Cargo.lock").read_text().split("[[package]]")
    engine = next(p for p in lock if 'name = "gmp-mpfr-sys"' in p).split('version = "')[1].split('"')[0]
    rust = " ".join(output("rustc", "--version").split()[:2])
    couplet = output("target/release/couplet", "--version")
    pari = "" if missing else ",\nPARI/GP " + output("gp", "--version-short")
    return f"{couplet} ({rust}, gmp-mpfr-sys {engine}),\n{output(PYTHON, '-c', python)}{pari}."


if __name__ == "__main__":
    main()
