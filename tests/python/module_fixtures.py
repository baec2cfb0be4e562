"""What the tests of the Python module share: the sample's points, and its results by
module and command.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from report_pages import SAMPLE
from results import Array, Run, read_pcd

Runner = Callable[..., Run]


@pytest.fixture(scope="session")
def command(run: Runner, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The results of the command on the sample."""
    out = tmp_path_factory.mktemp("command") / "out"
    assert run(SAMPLE, "-o", out).returncode == 0
    return out


@pytest.fixture(scope="session")
def datum() -> Any:
    tank_datum = pytest.importorskip("tank_datum", reason="the module is not installed")
    return tank_datum.extract_datum(str(SAMPLE))


@pytest.fixture(scope="session")
def points() -> Array:
    """The sample's points as they are stored."""
    columns = read_pcd(SAMPLE)
    return np.column_stack([columns[n] for n in "xyz"])


def same(a: Array, b: Array) -> None:
    """Equal bit for bit, NaN where NaN."""
    np.testing.assert_array_equal(np.asarray(a), np.asarray(b))


def two_setups(points: Array) -> tuple[Array, Array]:
    """What two scanners see of a tank about the origin: 170 degrees each, 80 of them both."""
    turn = np.degrees(np.arctan2(points[:, 1], points[:, 0])) % 360.0
    second = (np.arange(len(points)) % 2).astype(bool)
    both = (turn >= 90.0) & (turn < 170.0)
    first_sees = (turn < 90.0) | (both & ~second)
    second_sees = ((turn >= 170.0) & (turn < 260.0)) | (both & second)
    return points[first_sees], points[second_sees]
