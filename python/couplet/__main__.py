"""`python -m couplet` and the script `couplet` are the command."""

from __future__ import annotations

import signal
import sys

from . import _core


def main() -> int:
    """Runs the command with the arguments of the process; its exit code."""
    # The command has its own ways with these.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    return _core.run(sys.argv[1:])


if __name__ == "__main__":
    sys.exit(main())
