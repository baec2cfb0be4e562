"""Coordinates of few digits, as LAS and tables hold them: quiet scans of level feet, whose points
lie on one or two steps.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from results import Run, read_datum, read_pcd, read_stations, read_truth, write_xyz

Runner = Callable[..., Run]
Synth = Callable[..., Path]

LEVEL = {"noise": 0.0003, "tilt-slope": 0.0, "harmonics": "2:0.0004:40"}


@pytest.mark.parametrize("foundation", ["pad", "annular_plate"])
@pytest.mark.parametrize("step", [0.0005, 0.001, 0.002])
def test_what_rounding_leaves_is_in_sigma(
    run: Runner, synth: Synth, tmp_path: Path, foundation: str, step: float
) -> None:
    scan = synth(foundation=foundation, pad_fall=0.0, **LEVEL)
    columns = read_pcd(scan)
    points = np.column_stack([columns[n].astype(np.float64) for n in "xyz"])
    rounded = write_xyz(tmp_path / "rounded.pcd", np.round(points / step) * step)
    assert run(rounded, "-o", tmp_path / "out", "--setup-error", 0).returncode == 0
    stations = read_stations(tmp_path / "out")
    measured = stations.where("measured")
    assert measured.sum() >= 320
    truth = np.array([s["z"] for s in read_truth(scan)["tanks"][0]["stations"]])
    off = np.abs(stations["z"] - truth)[measured] / stations["sigma_z"][measured]
    assert np.mean(off < 2.0) >= 0.9
    assert np.max(off) < 4.0
    assert np.median(stations["sigma_z"][measured]) < 0.5 * step + 0.0002
    notes = read_datum(tmp_path / "out")["notes"]
    assert any(f"rounded to {1e3 * step:.3g} mm" in note for note in notes)
