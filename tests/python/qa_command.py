"""The QA script as a command."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

from programs import ROOT, executable


def qa(cases: Path, *args: object, timeout: float = 600) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, ROOT / "scripts" / "qa.py", cases, *args]
    environment = {**os.environ, "TANK_DATUM_BIN": str(executable("tank_datum").parent)}
    return subprocess.run(
        [str(c) for c in command], capture_output=True, text=True, env=environment, timeout=timeout
    )
