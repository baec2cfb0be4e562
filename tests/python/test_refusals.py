"""How a refused option and a name of the user's are said: whole, and as they were typed."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import clouds
from results import Run, write_xyz
from test_errors import FILE_FAILED, WRONG_USE, refused

Runner = Callable[..., Run]


@pytest.mark.parametrize("option", ["scan", "--limits", "--baseline", "--setup-origins"])
def test_a_name_that_looks_like_a_refusal_stays_whole(
    run: Runner, tmp_path: Path, option: str
) -> None:
    name = tmp_path / "option k = 2 (must be >= 3).csv"
    scan = write_xyz(tmp_path / "scan.pcd", clouds.tank(spacing=0.05))
    words = [name] if option == "scan" else [scan, option, name]
    result = run(*words, "-o", tmp_path / "out")
    refused(result, FILE_FAILED, tmp_path / "out", str(name), "expected")


def test_a_refused_value_is_named_as_it_was_typed(run: Runner, tmp_path: Path) -> None:
    """By its flag, in its unit."""
    scan = write_xyz(tmp_path / "scan.pcd", clouds.tank(spacing=0.05))
    for option, value, expected in (
        ("--k", 2, ">= 3"),
        ("--angle-deg", 95, "> 0 and < 90 deg"),
        ("--setup-tilt-arcsec", -3, "0 to 324000 arcsec"),
        ("--centre-tolerance", -0.1, ">= 0 m"),
    ):
        result = run(scan, "-o", tmp_path / "out", f"{option}={value}")
        line = refused(result, WRONG_USE, tmp_path / "out")
        assert line == f"tank_datum: options: {option}, {value}, expected {expected}"


def test_the_circle_that_is_advised_can_be_given(run: Runner, tmp_path: Path) -> None:
    """To the millimetre, also in coordinates of a country."""
    points = clouds.tank(spacing=0.02)
    near = np.hypot(points[:, 0], points[:, 1]) < 3.01
    scan = write_xyz(tmp_path / "scan.pcd", points[near] + [512034.25, 4012877.5, 35.0])
    advised = run(scan, "-o", tmp_path / "out").stdout
    x, y, radius = map(float, re.search(r"\(--tank\) as ([\d.,]+);", advised)[1].split(","))
    assert (x, y, radius) == pytest.approx((512034.25, 4012877.5, 3.0), abs=0.005)
