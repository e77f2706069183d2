"""Ctrl-C ends a call that takes long, and the next call works, which does not wait for what is given up."""

import signal
import subprocess
import sys

import pytest

# A shell starts what runs behind it with Ctrl-C ignored.
CALL = """
import os
import signal
import couplet
signal.signal(signal.SIGINT, signal.default_int_handler)
try:
    print("begins", flush=True)
    {call}
except KeyboardInterrupt:
    print(couplet.state("1.4", "0.5", digits=6).thickness, flush=True)
    os._exit(7)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="signals of Unix")
@pytest.mark.parametrize(
    "call", ["couplet.constants('T', digits=10**6)", "couplet.certify('T', digits=10**6)", "couplet.map(tolerance=1e-12)"]
)
def test_ctrl_c_ends_a_call(call: str) -> None:
    process = subprocess.Popen([sys.executable, "-c", CALL.format(call=call)], stdout=subprocess.PIPE, text=True)
    assert process.stdout is not None
    assert process.stdout.readline() == "begins\n"
    process.send_signal(signal.SIGINT)
    told, _ = process.communicate(timeout=15)
    assert process.returncode == 7
    assert told.startswith("0.0")
