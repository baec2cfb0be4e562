"""Where the farm's bounds lie: each test fails when its bound is halved or doubled."""

from __future__ import annotations

import json
import math
import os
import time
from pathlib import Path

import numpy as np
import pytest

from farm_made import require_farm

require_farm()

from tank_datum.farm.campaign import FarmTank, Survey  # noqa: E402
from tank_datum.farm.engine import Engine, _Queued  # noqa: E402
from tank_datum.farm.heights import datum_of, shift_of  # noqa: E402
from tank_datum.farm.hydrotest import hydrotests_of  # noqa: E402
from tank_datum.farm.lines import Line, fit_line_and_level, student  # noqa: E402
from tank_datum.farm.over_time import EpochDatum  # noqa: E402
from tank_datum.farm.store import Store  # noqa: E402
from tank_datum.farm.task import FAILED, Meant, Row, Task  # noqa: E402
from tank_datum.farm.trend import Trend, reaching  # noqa: E402
from tank_datum.farm.work import _is_there  # noqa: E402

from farm_drawn import base  # noqa: E402

HOUR = 3600.0


def drawn(lift: float = 0.0, tilt: float = 0.0, scatter: float = 0.0) -> object:
    """The base datum, lifted and tilted; neighbours up and down in turn by the scatter."""
    record = json.loads(json.dumps(base()))
    for number, station in enumerate(record["stations"]):
        along = math.cos(math.radians(station["azimuth_deg"]))
        station["z"] += lift + 4.0 * tilt * along + scatter * (-1) ** number
    return datum_of(json.dumps(record), "drawn")


@pytest.mark.parametrize(("apart", "there"), [(0.2, True), (0.3, False)], ids=["near", "far"])
def test_a_tank_stands_within_a_quarter_of_its_radius(apart: float, there: bool) -> None:
    meant = Meant("T", (10.0, 0.0, 8.0), {})
    assert _is_there({"center": (10.0 + 8.0 * apart, 0.0), "radius": 8.0}, meant) is there
    assert _is_there({"center": (10.0, 0.0), "radius": 8.0 * (1.0 + apart)}, meant) is there


@pytest.mark.parametrize(
    ("stations", "arcs"), [(36, 6.0), (360, 61.0 / 6.0)], ids=["10 deg apart", "1 deg apart"]
)
def test_stable_stations_share_their_errors_over_six_degrees(stations: int, arcs: float) -> None:
    """61 stations a degree apart are ten arcs, six of ten degrees six."""
    tank = FarmTank("T", height_reference="stable", stable_deg=((5.0, 65.0),))
    shift = shift_of(tank, around(stations), around(stations, 0.050, scatter=0.001), {}, 0.0)
    few = student(0.975, int(arcs) - 1) / 1.959964
    assert shift.dz == pytest.approx(-0.050, abs=2e-5)
    assert shift.sigma == pytest.approx(few * 0.001 / math.sqrt(int(arcs) - 1), rel=0.01)
    assert (shift.slope_x, shift.slope_y, shift.sigma_slope) == (0.0, 0.0, None)


def around(stations: int, lift: float = 0.0, scatter: float = 0.0) -> object:
    """A level datum of stations without errors, neighbours up and down in turn by the scatter."""
    record = json.loads(json.dumps(base()))
    first = record["stations"][0]
    record["stations"] = [
        first
        | {
            "station": number,
            "azimuth_deg": 360.0 / stations * number,
            "direction_deg": 360.0 / stations * number,
            "z": lift + scatter * (-1) ** number,
            "sigma_z": 1e-9,
        }
        for number in range(stations)
    ]
    return datum_of(json.dumps(record), "around")


@pytest.mark.parametrize(
    "sectors",
    [((0.0, 200.0),), ((0.0, 10.0), (100.0, 110.0), (200.0, 210.0), (290.0, 300.0))],
    ids=["one side", "four"],
)
def test_height_and_tilt_of_stable_sectors_err_as_they_say(
    sectors: tuple[tuple[float, float], ...],
) -> None:
    """Errors of 1 mm that are alike over six degrees, drawn 300 times."""
    draw = np.random.default_rng(11)
    tank = FarmTank("T", height_reference="stable", stable_deg=sectors)
    still = around(360)
    beyond = {"height": 0, "slope": 0, "far side": 0}
    for _ in range(300):
        record = json.loads(json.dumps(still.to_dict()))
        errors = np.repeat(draw.normal(0.0, 0.001, 60), 6)
        for station, error in zip(record["stations"], errors, strict=True):
            station["z"] = float(error)
        shift = shift_of(tank, still, datum_of(json.dumps(record), "drawn"), {}, 0.0)
        radius = record["tank"]["radius"]
        assert shift.sigma_slope is not None
        at_far = shift.dz - radius * shift.slope_x * math.cos(math.radians(80.0))
        at_far -= radius * shift.slope_y * math.sin(math.radians(80.0))
        beyond["height"] += abs(shift.dz) > 2.0 * shift.sigma
        beyond["slope"] += abs(shift.slope_x) > 2.0 * shift.sigma_slope
        beyond["far side"] += abs(at_far) > 2.0 * math.hypot(
            shift.sigma, radius * shift.sigma_slope
        )
    assert all(count <= 0.06 * 300 for count in beyond.values()), beyond


def test_benchmarks_of_which_nothing_is_said_err_by_a_usual_millimetre() -> None:
    """Known as well as a variance of three values; two marks add what they differ by."""
    tank = FarmTank("T", height_reference="marks", marks={"A": 1.0, "B": 2.0})
    one = shift_of(tank, drawn(), drawn(), {"A": 1.003}, 0.0)
    assert one.dz == pytest.approx(-0.003)
    assert one.sigma == pytest.approx(0.001 * student(0.975, 3) / 1.959964)
    assert "registration_error" in one.note
    two = shift_of(tank, drawn(), drawn(), {"A": 1.003, "B": 1.997}, 0.0)
    both = math.sqrt((3e-6 + 2 * 0.003**2) / 4.0 / 2.0)
    assert two.sigma == pytest.approx(both * student(0.975, 4) / 1.959964)
    told = shift_of(tank, drawn(), drawn(), {"A": 1.003}, 0.0005)
    assert (told.sigma, told.note) == (0.0005, "")


@pytest.mark.parametrize(
    ("sectors", "levelled"),
    [(((0.0, 60.0), (180.0, 240.0)), True), (((0.0, 70.0), (90.0, 160.0)), False)],
    ids=["round", "one side"],
)
def test_stable_sectors_take_a_tilt_when_no_gap_is_half_a_turn(
    sectors: tuple[tuple[float, float], ...], levelled: bool
) -> None:
    tank = FarmTank("T", height_reference="stable", stable_deg=sectors)
    shift = shift_of(tank, drawn(), drawn(tilt=0.001), {}, 0.0)
    assert shift.slope_x == pytest.approx(-0.001 if levelled else 0.0, abs=1e-5)


@pytest.mark.parametrize(("last", "empty"), [(0.4, True), (0.6, False)], ids=["empty", "not"])
def test_a_tank_is_empty_again_within_a_twentieth_of_the_highest_level(
    last: float, empty: bool
) -> None:
    levels = (0.0, 10.0, last)
    epochs = [
        EpochDatum(
            Survey((), "T", "2024-01-01", str(n), fill_level=level, hydrotest="h"),
            drawn(-0.001 * n, scatter=1e-5),
        )
        for n, level in enumerate(levels)
    ]
    (test,) = hydrotests_of(FarmTank("T"), epochs)
    assert (test.lasting is not None) is empty


@pytest.mark.parametrize(("share", "told"), [(0.9, True), (0.97, False)], ids=["apart", "together"])
def test_level_and_date_are_told_apart_below_a_correlation(share: float, told: bool) -> None:
    times = np.array([-3.0, -1.0, 1.0, 3.0])
    other = np.array([1.0, -1.0, -1.0, 1.0])
    levels = share * times / np.std(times) + math.sqrt(1.0 - share**2) * other
    assert np.corrcoef(times, levels)[0, 1] == pytest.approx(share)
    assert (fit_line_and_level(times, levels, times, [1.0] * 4) is not None) is told


@pytest.mark.parametrize(("share", "moves"), [(0.9, True), (1.1, False)], ids=["below", "above"])
def test_a_tank_has_eight_tests(share: float, moves: bool) -> None:
    assert Trend("settlement", 1.0, 0.0, 2.0, share * 0.05 / 8).moves is moves


@pytest.mark.parametrize(("years", "dated"), [(150.0, True), (250.0, False)], ids=["150", "250"])
def test_dates_are_given_for_two_centuries(years: float, dated: bool) -> None:
    line = Line(2020.0, 0.0, 0.001, np.zeros((2, 2)))
    found = reaching(line, 0.001 * years, 0.05)
    assert found is not None and bool(found.earliest) is dated


def test_a_task_is_tried_four_times_when_storage_fails() -> None:
    came: list[int] = []
    task = Task("T/1", (), "", ())
    engine = Engine([], lambda task, row, tries: came.append(tries), lambda: None)
    for tries in range(4):
        engine._judge(_Queued(0.0, 0, task, tries), Row("T/1", FAILED, kind="io"))
    assert came == [4] and engine.left == 3
    engine._judge(_Queued(0.0, 0, task, 0), Row("T/1", FAILED, kind="error"))
    assert came == [4, 1]


@pytest.mark.parametrize(("hours", "there"), [(23, True), (25, False)], ids=["23", "25"])
def test_parts_of_other_machines_stay_a_day(tmp_path: Path, hours: int, there: bool) -> None:
    part = tmp_path / ".parts/other.1.ab.cd"
    part.mkdir(parents=True)
    os.utime(part, (time.time() - hours * HOUR,) * 2)
    Store(str(tmp_path)).sweep()
    assert part.exists() is there
