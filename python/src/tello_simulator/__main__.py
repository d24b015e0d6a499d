"""Starts the program: `tello-simulator` and `python -m tello_simulator`."""

from __future__ import annotations

import os
import signal
import subprocess
import sys

from ._java import command


def main() -> int:
    """Run the program with the arguments of this process, and return its exit code."""
    try:
        words = command(sys.argv[1:])
    except FileNotFoundError as error:
        print(error, file=sys.stderr)
        return 1
    if os.name == "posix":
        os.execv(words[0], words)  # signals and the terminal go to the program itself
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C reaches the program, which ends
    return subprocess.run(words, check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
