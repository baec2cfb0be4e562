"""The commands: the executables that came with the package, in this process's place.

Scans that the executables do not read, E57 and compressed LAS, are given to the same commands
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
            signal.signal(
                number, lambda number, _: _core.stop_command_by(number, words[0])
            )
    for number in (signal.SIGPIPE, signal.SIGXFSZ):  # which Python ignores
        signal.signal(number, signal.SIG_DFL)
    status: int = _core.run_command([os.fsencode(word) for word in words])
    return status


def become(program: str) -> None:
    """Never returns: behaviour and exit status are the executable's."""
    os.execv(Path(__file__).parent / "bin" / program, [program, *sys.argv[1:]])


def run(program: str) -> None:
    words = [program, *sys.argv[1:]]
    if any(_core.foreign_format(os.fsencode(word)) for word in words[1:]):
        sys.exit(run_here(words))
    become(program)


def main() -> None:
    """tank_datum: behaviour and exit status are the executable's."""
    run("tank_datum")


def convert() -> None:
    """tank_datum_convert: the same."""
    run("tank_datum_convert")


def compare() -> None:
    """tank_datum_compare."""
    become("tank_datum_compare")


def curves() -> None:
    """tank_datum_curves."""
    become("tank_datum_curves")


def report() -> None:
    """tank_datum_report."""
    become("tank_datum_report")


def synth() -> None:
    """tank_datum_synth."""
    become("tank_datum_synth")
