"""The programs of the build, or of the folder that TANK_DATUM_BIN names, as scripts run them."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
BIN = Path(os.environ.get("TANK_DATUM_BIN", ROOT / "build" / "bin"))


def call(name: str, *args: object, accepted: tuple[int, ...] = (0,)) -> str:
    """What a program writes to stdout; the script ends with its stderr at another exit status."""
    command = [str(BIN / name), *map(str, args)]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode not in accepted:
        script = Path(sys.argv[0]).stem
        raise SystemExit(f"{script}: {' '.join(command)}: {done.stderr.strip()}")
    return done.stdout
