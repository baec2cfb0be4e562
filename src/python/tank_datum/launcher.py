"""The command tank_datum: the executable that came with the package, in this process's place."""

from __future__ import annotations

import os
import sys
from pathlib import Path


def main() -> None:
    """Never returns: behaviour and exit status are the executable's."""
    command = Path(__file__).parent / "bin" / "tank_datum"
    os.execv(command, ["tank_datum", *sys.argv[1:]])
