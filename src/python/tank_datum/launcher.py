"""The command tank_datum: the executable that came with the package, in this process's place.

Scans that the executable does not read, E57 and compressed LAS, are given to the same command
inside this process.
"""

from __future__ import annotations

import os
import signal
import sys
from pathlib import Path

from tank_datum import _core


def run_here(words: list[str]) -> int:
    """The command in this process, which its signals end as they do the executable."""
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        if signal.getsignal(number) != signal.SIG_IGN:
            signal.signal(number, lambda number, _: _core.stop_command_by(number))
    for number in (signal.SIGPIPE, signal.SIGXFSZ):  # which Python ignores
        signal.signal(number, signal.SIG_DFL)
    status: int = _core.run_command([os.fsencode(word) for word in words])
    return status


def main() -> None:
    """Behaviour and exit status are the executable's."""
    words = ["tank_datum", *sys.argv[1:]]
    if any(_core.foreign_format(os.fsencode(word)) for word in words[1:]):
        sys.exit(run_here(words))
    command = Path(__file__).parent / "bin" / "tank_datum"
    os.execv(command, words)
