"""The commands beside tank_datum: the executables that came with the package."""

from __future__ import annotations

import os
import sys
from pathlib import Path


def _become(name: str) -> None:
    """Never returns: behaviour and exit status are the executable's."""
    os.execv(Path(__file__).parent / "bin" / name, [name, *sys.argv[1:]])


def compare() -> None:
    """The command tank_datum_compare."""
    _become("tank_datum_compare")


def curves() -> None:
    """The command tank_datum_curves."""
    _become("tank_datum_curves")


def synth() -> None:
    """The command tank_datum_synth."""
    _become("tank_datum_synth")
