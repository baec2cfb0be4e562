"""The Python API over arrays: several tanks, levellings, and surveys compared."""

from __future__ import annotations

import datetime
import json
import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from conftest import ROOT
from programs import run_program
from results import Run

tank_datum = pytest.importorskip("tank_datum", reason="the module is not installed")

Runner = Callable[..., Run]
SAMPLE = ROOT / "tests" / "data" / "sample.pcd"
SCENE = {
    "tanks": [{"radius": 4, "height": 3, "tilt_slope": 0.002}],
    "scanner": {"count": 4, "distance": 5, "step_deg": 0.2, "max_range": 15},
    "near_datum": 1,
}


def test_baseline_is_a_datum_or_a_path(datum: Any, command: Path) -> None:
    by_path = tank_datum.extract_datum(SAMPLE, baseline=command)
    by_loaded = tank_datum.extract_datum(SAMPLE, baseline=tank_datum.load(command))
    assert by_path == by_loaded
    by_datum = tank_datum.extract_datum(SAMPLE, baseline=datum)
    assert by_datum.movement.baseline == str(SAMPLE)
    assert by_datum.movement.stations == by_path.movement.stations
    assert tank_datum.extract_datum(SAMPLE, baseline=None) == datum
    with pytest.raises(tank_datum.OptionError, match="method, paper"):
        tank_datum.extract_datum(SAMPLE, baseline=datum, method="paper")


def test_several_tanks(run: Runner, tmp_path: Path) -> None:
    scene = {**SCENE, "tanks": [{"radius": 4, "height": 3}, {"radius": 3, "height": 3, "x": 14}]}
    scan = tmp_path / "two.pcd"
    tank_datum.simulate(scene, scan)
    found = tank_datum.find_tanks(scan)
    assert [round(tank.radius, 1) for tank in found] == [4.0, 3.0]
    assert run(scan, "--all", "-o", tmp_path / "out").returncode == 0
    datums = tank_datum.extract_datums(scan)
    assert datums == [tank_datum.load(tmp_path / "out" / f"tank_{n}") for n in (1, 2)]
    other = tank_datum.extract_datum(scan, tank=found[1].circle)
    assert other.tank.radius == pytest.approx(3.0, abs=0.01)


def test_levelling_is_the_commands(run: Runner, tmp_path: Path) -> None:
    table = tmp_path / "rod.csv"
    rows = [f"{a},{0.01 * np.cos(np.radians(a)):.5f},0.001" for a in range(0, 360, 15)]
    table.write_text("azimuth_deg,elevation,sigma\n" + "\n".join(rows) + "\n")
    assert run("--stations-csv", table, "--diameter", 30, "-o", tmp_path / "out").returncode == 0
    levelled = tank_datum.read_levelling(table, 30)
    assert levelled == tank_datum.load(tmp_path / "out")
    assert levelled.tilt.slope == pytest.approx(0.01 / 15, rel=1e-3)
    with pytest.raises(tank_datum.OptionError, match="diameter"):
        tank_datum.read_levelling(table, -1)
    for name, value in {"k": 30, "stations": 72, "up": "z", "heights": [1.0], "tank": None}.items():
        said = f"options: {name}, .*, expected none: a levelling survey has no scan"
        with pytest.raises(tank_datum.OptionError, match=said):
            tank_datum.read_levelling(table, 30, **{name: value})
    used = {"zero_azimuth_deg": 30, "clockwise": True, "units": "mm", "height": 9, "remove": "none"}
    assert tank_datum.read_levelling(table, 30, **used).status == "ok"


def test_comparison_is_the_commands(datum: Any, tmp_path: Path) -> None:
    second = tank_datum.extract_datum(SAMPLE, stations=180)
    datum.save(tmp_path / "a"), second.save(tmp_path / "b")
    folders = [tmp_path / "a", tmp_path / "b", tmp_path / "a"]
    dates = ["2020.5", "2021-05-31", "2022-06-01"]
    words = [*folders, "-o", tmp_path / "by_command", "--dates", ",".join(dates)]
    assert run_program("tank_datum_compare", words, None, 60).returncode == 0
    given = [2020.5, datetime.date(2021, 5, 31), "2022-06-01"]
    comparison = tank_datum.compare(folders, given)
    comparison.save(tmp_path / "by_module")
    for file in sorted((tmp_path / "by_command").iterdir()):
        assert (tmp_path / "by_module" / file.name).read_bytes() == file.read_bytes(), file.name
    wanted = json.loads((tmp_path / "by_command" / "movement.json").read_text())
    assert comparison.unit == "m/year" == wanted["trend"]["unit"]
    rates = [row["rate"] for row in wanted["trend"]["stations"]]
    np.testing.assert_array_equal(comparison.trend["rate"], np.array(rates, dtype=float))
    for movement, stations in zip(wanted["movements"], comparison.stations, strict=True):
        dz = np.array([row["dz"] for row in movement["stations"]], dtype=float)
        np.testing.assert_array_equal(stations["dz"], dz)
    assert comparison == pickle.loads(pickle.dumps(comparison))
    loaded = tank_datum.compare([tank_datum.load(f) for f in folders], dates)
    assert loaded == comparison


@pytest.mark.parametrize(
    ("surveys", "options", "said"),
    [
        (1, {}, "epochs, .*, expected two surveys or more"),
        (2, {"dates": ["2024-05-31"]}, "dates, 1, expected one for each of the 2"),
        (2, {"remove": "all"}, "remove, all, expected auto, none, mean or tilt"),
    ],
)
def test_refused_comparisons(datum: Any, surveys: int, options: dict[str, Any], said: str) -> None:
    with pytest.raises(tank_datum.OptionError, match=said):
        tank_datum.compare([datum] * surveys, **options)
