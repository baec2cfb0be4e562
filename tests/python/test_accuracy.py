"""Small simulated scans, seconds each: the error against the truth, and what sigma_z says of it.

R 4 m, 0.2 degree between rays (17 mm at the tank), 1 mm of range noise. ./scripts/accuracy has the
large scenes. Measured when written (RMS, largest, within 2 sigma, stations measured):
  four scanners, pad       0.13 mm  0.54 mm   95 %  360
  annular plate            0.10     0.34      97    320 (40 bridged)
  one scanner              0.15     0.34     100    109
  soil on 30 degrees       0.10     0.55      94    344
  boxes, pipes, outliers   0.14     0.56      94    351
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from results import Run, Stations, read_datum, read_stations, read_truth

Runner = Callable[..., Run]
Synth = Callable[..., Path]

SCENES: dict[str, tuple[dict[str, object], int, int]] = {  # options, fewest and most measured
    "pad": ({}, 360, 360),
    "annular plate": ({"foundation": "annular_plate"}, 320, 360),
    "one scanner": ({"scanners": 1}, 100, 131),
    "soil": ({"soil": "90:30:0.04"}, 325, 346),
    "clutter": ({"boxes": 4, "pipes": 4, "outliers": 0.005}, 340, 358),
}


@pytest.fixture(scope="module", params=SCENES)
def scene(
    request: pytest.FixtureRequest,
    run: Runner,
    synth: Synth,
    tmp_path_factory: pytest.TempPathFactory,
) -> tuple[str, Path, Path]:
    options = SCENES[request.param][0]
    scan = synth("--mixed-pixels", **options) if request.param == "clutter" else synth(**options)
    out = tmp_path_factory.mktemp("accuracy") / "out"
    assert run(scan, "-o", out).returncode == 0
    return request.param, scan, out


def truth_of(scan: Path, name: str) -> np.ndarray:
    return np.array([station[name] for station in read_truth(scan)["tanks"][0]["stations"]])


def error(scan: Path, stations: Stations, name: str = "z") -> np.ndarray:
    return stations[name] - truth_of(scan, "z")


def test_elevation(scene: tuple[str, Path, Path]) -> None:
    name, scan, out = scene
    stations = read_stations(out)
    measured = stations.where("measured")
    _, fewest, most = SCENES[name]
    assert fewest <= measured.sum() <= most
    off = error(scan, stations)[measured]
    assert np.sqrt(np.mean(off**2)) < 0.0003
    assert np.abs(off).max() < 0.001
    assert abs(off.mean()) < 0.0001


def test_sigma_is_true(scene: tuple[str, Path, Path]) -> None:
    """85 to 100 % within two standard errors, which are not made large for it."""
    _, scan, out = scene
    stations = read_stations(out)
    measured = stations.where("measured")
    off, sigma = error(scan, stations)[measured], stations["sigma_z"][measured]
    assert np.mean(np.abs(off) < 2.0 * sigma) >= 0.85
    assert np.median(sigma) < 2.1 * np.sqrt(np.mean(off**2))


def test_bridged_stations(scene: tuple[str, Path, Path]) -> None:
    """Interpolated ones are rarer than an eighth, and hold their own standard errors."""
    _, scan, out = scene
    stations = read_stations(out)
    bridged = stations.where("interpolated")
    off = np.abs(error(scan, stations)[bridged])
    assert bridged.sum() < 0.125 * len(stations)
    assert (off < 4.0 * stations["sigma_z"][bridged]).all()


def test_unseen_is_not_measured(scene: tuple[str, Path, Path]) -> None:
    """A line that no ray reached, or that lies below soil, is not measured.

    The soil thins out to nothing at its ends: what is measured there is right within its error.
    """
    _, scan, out = scene
    stations = read_stations(out)
    measured = stations.where("measured")
    open_line = truth_of(scan, "visible") & ~truth_of(scan, "covered")
    beside = open_line | np.roll(open_line, 1) | np.roll(open_line, -1)
    through = measured & ~beside
    assert (np.abs(error(scan, stations)[through]) < 2.0 * stations["sigma_z"][through]).all()
    assert through.sum() <= 0.4 * truth_of(scan, "covered").sum()


def test_circle(scene: tuple[str, Path, Path]) -> None:
    """Centre and radius within 1 mm, of the arc of one scanner too."""
    _, scan, out = scene
    tank, truth = read_datum(out)["tank"], read_truth(scan)["tanks"][0]
    assert np.hypot(*np.subtract(tank["center"], truth["center"])) < 0.0003
    assert abs(tank["radius"] - truth["radius"]) < 0.0003


def test_paper_is_high(scene: tuple[str, Path, Path]) -> None:
    """Its edge points straddle the crease: the denser the scan the less, 20 mm at 17 mm spacing."""
    name, scan, out = scene
    off = error(scan, read_stations(out), "z_paper")
    assert 0.015 < np.nanmedian(off) < 0.030
    if name in ("pad", "annular plate"):
        assert np.nanstd(off) < 0.003


def test_tilt_and_extremes(run: Runner, synth: Synth, tmp_path: Path) -> None:
    """The tank's slope and direction, its highest and lowest point, from a scan of low noise."""
    scan = synth(noise=0.0002)
    assert run(scan, "-o", tmp_path / "out").returncode == 0
    datum, truth = read_datum(tmp_path / "out"), read_truth(scan)["tanks"][0]
    assert datum["tilt"]["slope"] == pytest.approx(0.002, abs=2e-5)
    assert datum["tilt"]["direction_deg"] == pytest.approx(30.0, abs=1.0)
    assert datum["datum"]["min"] == pytest.approx(truth["min"], abs=0.0005)
    assert datum["datum"]["max"] == pytest.approx(truth["max"], abs=0.0005)
