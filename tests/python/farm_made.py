"""Small tank farms made for tests: simulated scans and a campaign that lists them."""

from __future__ import annotations

import contextlib
import io
import os
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple

import pytest

RADIUS = 4.0
SEEN = {"count": 4, "distance": 5, "step_deg": 0.4, "max_range": 15}
NEEDED = ("distributed", "sqlalchemy", "alembic", "fsspec", "xxhash", "tank_datum")


def require_farm() -> None:
    """Skips where the extra `farm` is not installed."""
    for name in NEEDED:
        pytest.importorskip(name, reason="the extra farm is not installed")


def scene(seed: int, tilt: float = 0.002, z0: float = 0.0, x: float = 0.0) -> dict[str, Any]:
    """A tank of 4 m radius, 12 000 points."""
    tank = {"radius": RADIUS, "height": 2, "tilt_slope": tilt, "x": x, "base_elevation": z0}
    return {
        "seed": seed,
        "tanks": [tank],
        "scanner": SEEN,
        "near_datum": 0.6,
        "measurement": {"range_sigma": 0.001},
    }


def scan(path: Path, **given: Any) -> Path:
    import tank_datum

    path.parent.mkdir(parents=True, exist_ok=True)
    tank_datum.simulate(scene(**given), path)
    path.with_name(path.stem + ".truth.json").unlink(missing_ok=True)
    return path


class Said(NamedTuple):
    """What a command gave."""

    returncode: int
    stdout: str
    stderr: str


@dataclass
class Farm:
    """A campaign's text, part by part, and the command on it."""

    folder: Path
    head: str = 'site = "North"\n[options]\nstations = 90\n'
    tanks: list[str] = field(default_factory=list)
    scans: list[str] = field(default_factory=list)

    @property
    def file(self) -> Path:
        return self.folder / "farm.toml"

    def tank(self, name: str, more: str = "") -> None:
        self.tanks.append(f'[[tank]]\nname = "{name}"\n{more}\n')

    def scan(self, files: str, tank: str, date: str, more: str = "") -> None:
        self.scans.append(f'[[scan]]\nfiles = "{files}"\ntank = "{tank}"\ndate = {date}\n{more}\n')

    def write(self) -> Path:
        self.file.write_text("\n".join([self.head, *self.tanks, *self.scans]))
        return self.file

    def command(self, name: str, *words: object) -> Said:
        """Runs a command in this process."""
        from tank_datum.farm._main import main

        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            status = main([name, str(self.file), *map(str, words)])
        return Said(status, out.getvalue(), err.getvalue())


def farm_command(*words: object, timeout: float = 120) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        command_line(*words), capture_output=True, text=True, timeout=timeout, env=environment()
    )


def command_line(*words: object) -> list[str]:
    return [sys.executable, "-m", "tank_datum.farm", *map(str, words)]


def environment() -> dict[str, str]:
    return {**os.environ, "OMP_NUM_THREADS": "1"}


def rows(farm: Farm, sql: str) -> list[tuple[Any, ...]]:
    """What the history answers."""
    import sqlite3

    with sqlite3.connect(farm.folder / "history.sqlite") as database:
        return database.execute(sql).fetchall()
