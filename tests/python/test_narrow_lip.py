"""Lips too narrow for a section to show: what they lie on must not pass for them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from results import Run, read_datum, read_stations, read_truth

Runner = Callable[..., Run]
Synth = Callable[..., Path]


@pytest.mark.parametrize(("width", "noise"), [(0.020, 0.0005), (0.025, 0.002), (0.030, 0.005)])
def test_the_datum_is_on_the_lip(
    run: Runner, synth: Synth, tmp_path: Path, width: float, noise: float
) -> None:
    scan = synth(
        foundation="annular_plate",
        plate_width=width,
        plate_thickness=0.008,
        noise=noise,
        step_deg=0.08,
    )
    assert run(scan, "-o", tmp_path / "out", "--setup-error", 0).returncode == 0
    stations = read_stations(tmp_path / "out")
    measured = stations.where("measured")
    assert measured.sum() >= 320
    truth = np.array([s["z"] for s in read_truth(scan)["tanks"][0]["stations"]])
    error = (stations["z"] - truth)[measured]
    assert abs(np.mean(error)) < 0.001
    assert np.mean(np.abs(error) < 2.0 * stations["sigma_z"][measured]) >= 0.9
    datum = read_datum(tmp_path / "out")
    assert datum["datum"]["surface"] == "annular_plate"
    assert any("lip is narrower" in note for note in datum["notes"])
