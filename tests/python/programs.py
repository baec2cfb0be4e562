"""The project's programs, as the build made them."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Sequence
from pathlib import Path

import pytest

from results import Run

ROOT = Path(__file__).resolve().parents[2]
TIMEOUT = 120.0  # s; a hang is a failure


def executable(name: str) -> Path:
    """One of the project's programs, in the folder TANK_DATUM_BIN or in build/bin."""
    path = Path(os.environ.get("TANK_DATUM_BIN", ROOT / "build" / "bin")) / name
    if not path.exists():
        pytest.exit(
            f"{path} is not built: run ./scripts/test, or name its folder in TANK_DATUM_BIN"
        )
    return path


def run_program(
    name: str, args: Sequence[object], cwd: Path | None = None, timeout: float = TIMEOUT
) -> Run:
    words = [str(executable(name)), *map(str, args)]
    return subprocess.run(
        words, cwd=cwd, capture_output=True, text=True, errors="replace", timeout=timeout
    )
