"""Processes: forked, interrupted, and the command."""

import csv
import io
import json
import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time

import pytest

import couplet


def command(*arguments, given=None):
    """What the command prints, and its exit code."""
    done = subprocess.run([sys.executable, "-m", "couplet", *arguments], input=given, capture_output=True, text=True)
    return done.stdout, done.stderr, done.returncode


def test_the_command():
    out, _, code = command("constants", "triple", "--weight", "heyman", "--quantity", "eta", "--digits", "40", "--plain")
    assert (out, code) == ("0.6796047320988855147875348962096841095455\n", 0)
    assert command("-V")[0] == f"couplet {couplet.__version__}\n"
    _, error, code = command("state", "--half-opening", "4", "--friction", "1")
    with pytest.raises(couplet.CoupletError) as caught:
        couplet.state(4, 1)
    assert (error, code) == (f"couplet: {caught.value}\n", 2)
    assert command("state")[2] == 2 and command("sate")[2] == 2
    drawn = command("draw", "--half-opening", "80deg", "--friction", "0.35")[0]
    assert "couplet draw --half-opening 80deg --friction 0.35" in drawn
    # The same picture, but for the command that it names.
    assert len(drawn) - len(couplet.state("80deg", "0.35").svg()) < 100


def test_threads_of_the_environment_have_a_limit():
    line = "import couplet; couplet.state(1, 1); couplet.constants('T', digits=5)"
    for threads, words in [("20000", "RAYON_NUM_THREADS=20000: threads are a whole number from 1 to 1024"), ("2", "")]:
        environment = {**os.environ, "RAYON_NUM_THREADS": threads}
        done = subprocess.run([sys.executable, "-c", line], capture_output=True, text=True, env=environment)
        assert words in done.stderr and (done.returncode == 0) == (words == ""), done.stderr


def test_the_script():
    script = os.path.join(os.path.dirname(sys.executable), "couplet")
    done = subprocess.run([script, "-V"], capture_output=True, text=True)
    assert done.stdout == f"couplet {couplet.__version__}\n"


def test_numbers_are_those_of_the_command():
    sample = command("sample", "--count", "40", "--seed", "3")[0] or pytest.fail("no sample")
    rows = list(csv.DictReader(io.StringIO(sample)))
    assert len(rows) >= 40
    out = command("states", "--format", "jsonl", "--digits", "17", given=sample)[0]
    answers = [json.loads(line) for line in out.splitlines()]
    assert len(answers) == len(rows)
    compared = 0
    for answer in answers:
        arch = (answer["half_opening"], answer["friction"])
        state = couplet.state(*arch, weight=answer["weight"], digits=17)
        assert state.can_stand == answer["can_stand"]
        for name, value in state.values.items():
            told = answer[name]
            assert (value.text, value.text_lower, value.text_upper) == (told["value"], told["lower"], told["upper"])
            assert value.text == "inf" or value.double == float.fromhex(told["hex"])
            compared += 1
    assert compared > 100


def test_doubles_are_those_of_the_command():
    np = pytest.importorskip("numpy")
    random = np.random.default_rng(7)
    alpha, mu = random.uniform(0.05, 2.9, 50), random.uniform(0.01, 2.5, 50)
    lines = [f"{a.hex()},{m.hex()}" for a, m in zip(alpha.tolist(), mu.tolist())]
    out = command("states", "--format", "jsonl", given="\n".join(["half_opening,friction", *lines, ""]))[0]
    told = [json.loads(line)["thickness"] for line in out.splitlines()]
    found = couplet.states(alpha, mu)["thickness"].tolist()
    assert [value and value["hex"] for value in told] == [
        None if np.isnan(x) else value["hex"] if float.fromhex(value["hex"]) == x else x for x, value in zip(found, told)
    ]


def _in_child(queue):
    queue.put((couplet.constants("T", digits=40)["thickness"].text, couplet.state("80deg", "0.35").thickness.text))


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork on this system")
@pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning")
def test_a_forked_process_does_not_hang():
    couplet.constants("T", digits=40)
    couplet.constants("T", digits=40, threads=2)
    context = multiprocessing.get_context("fork")
    queue = context.Queue()
    child = context.Process(target=_in_child, args=(queue,))
    child.start()
    told = queue.get(timeout=120)
    child.join(120)
    assert child.exitcode == 0
    assert told == (couplet.constants("T", digits=40)["thickness"].text, couplet.state("80deg", "0.35").thickness.text)


@pytest.mark.skipif(os.name != "posix", reason="signals of POSIX")
def test_ctrl_c_stops_an_array():
    pytest.importorskip("numpy")
    program = """
import signal
# What runs in the background may be born deaf to it.
signal.signal(signal.SIGINT, signal.default_int_handler)
import couplet, numpy
random = numpy.random.default_rng(1)
def tell(done, all_):
    print(done, flush=True)
try:
    couplet.states(random.uniform(0.1, 2.4, 3_000_000), 0.9, threads=1, progress=tell)
except KeyboardInterrupt:
    print("stopped", flush=True)
"""
    child = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True)
    try:
        assert int(child.stdout.readline()) > 0
        child.send_signal(signal.SIGINT)
        rest, _ = child.communicate(timeout=120)
    finally:
        child.kill()
    assert rest.splitlines()[-1] == "stopped" and child.returncode == 0


def test_other_threads_run_meanwhile():
    """The interpreter lock is released: with it held, this thread would go on when the other has ended."""
    thread = threading.Thread(target=couplet.constants, args=("T",), kwargs={"digits": 100_000, "threads": 1})
    thread.start()
    counted = 0
    while thread.is_alive():
        counted += 1
        time.sleep(0.001)
    assert counted > 5


def test_threads_ask_at_once():
    """Each gets its own answers; and a Python without a global lock stays without one."""
    pytest.importorskip("numpy")
    program = """
import concurrent.futures, sys, sysconfig
import couplet

def asked(number):
    alpha = [0.5 + number / 7 + row / 300 for row in range(300)]
    states = couplet.states(alpha, 0.9, quantities=["thickness"], threads=1 + number % 3)
    return states.tobytes(), str(couplet.state(alpha[0], "0.9", digits=40).thickness)

alone = [asked(number) for number in range(8)]
with concurrent.futures.ThreadPoolExecutor(8) as threads:
    assert list(threads.map(asked, range(8))) == alone
assert not sysconfig.get_config_var("Py_GIL_DISABLED") or not sys._is_gil_enabled()
"""
    done = subprocess.run([sys.executable, "-W", "error", "-c", program], capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")
