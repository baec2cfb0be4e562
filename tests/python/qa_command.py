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


def fake(folder: Path, body: str) -> Path:
    """A program in the place of tank_datum: lines of sh, in which $out is the folder of results."""
    path = folder / "tank_datum"
    find = 'for word; do [ "$before" = -o ] && out=$word; before=$word; done; mkdir -p "$out"\n'
    path.write_text(f"#!/bin/sh\n{find}{body}\n")
    path.chmod(0o755)
    return path


def one_case(folder: Path, name: str = "a", more: str = "") -> Path:
    """A file of one case whose input is `x`."""
    path = folder / "cases.toml"
    path.write_text(f'[[case]]\nname = "{name}"\ninputs = ["x"]\n{more}\n')
    return path
