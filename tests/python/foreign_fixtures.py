"""What the tests of E57, LAZ and COPC share: the installed command, and a scan in each format."""

# ruff: noqa: F811  fixtures are imported
from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from format_writers import STEP, Setups, in_floats, write_e57, write_las
from programs import TIMEOUT
from results import Run, write_pcd
from test_formats import labelled, scan  # noqa: F401

Runner = Callable[..., Run]
NAMES = ("north", "south", "east")


def launcher() -> Path:
    return Path(sys.executable).parent / "tank_datum"


@pytest.fixture(scope="module")
def installed() -> Runner:
    """The command that the package installs."""

    def run(*arguments: object, env: dict[str, str] | None = None) -> Run:
        words = [str(launcher()), *map(str, arguments)]
        return subprocess.run(
            words,
            capture_output=True,
            text=True,
            timeout=TIMEOUT,
            env={**os.environ, **(env or {})},
        )

    return run


@pytest.fixture(scope="module")
def jittered(scan: Setups) -> Setups:
    """Off the grid of steps: no point lies on the edge of a cell, where a last digit decides.

    An E57 that pye57 writes holds these points.
    """
    random = np.random.default_rng(1)
    points = [p + random.uniform(-0.5 * STEP, 0.5 * STEP, p.shape) for p in scan.points]
    return in_floats(Setups(points, scan.origins))


@pytest.fixture(scope="module")
def e57(jittered: Setups, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_e57(tmp_path_factory.mktemp("e57") / "scan.dat", jittered, NAMES)


@pytest.fixture(scope="module")
def laz(scan: Setups, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_las(tmp_path_factory.mktemp("laz") / "scan.laz", scan, "1.4", 6)


def write_setups(folder: Path, scan: Setups) -> list[Path]:
    """A PCD for each setup, with its place."""
    files = []
    for name, points, origin in zip(NAMES, scan.points, scan.origins, strict=True):
        columns = dict(zip("xyz", points.T.astype("<f8"), strict=True))
        path = write_pcd(folder / f"{name}.pcd", columns)
        place = " ".join(f"{v:.12f}" for v in origin)
        path.write_bytes(
            path.read_bytes().replace(b"VIEWPOINT 0 0 0", f"VIEWPOINT {place}".encode())
        )
        files.append(path)
    return files
