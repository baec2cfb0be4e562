"""Real scans: three boxes and a mug on a table, which are cylinders on a plane.

What an independent look at the data gives (NumPy alone; r-z plots were looked at) stands with each
object, and beside it what tank_datum makes of it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from results import Array, Run, Stations, read_datum, read_stations, write_xyz

Runner = Callable[..., Run]
MM = 0.001


@dataclass(frozen=True)
class Bounds:
    """A little more than was measured; the issue's own are 1 mm of z and 1 % of R."""

    seen: int  # fewest stations measured where wall and table are dense
    rms: float  # of z there against the table [mm]
    rms_everywhere: float  # and of all that are flagged measured
    largest: float
    radius: float  # relative, against INDEX.md and against the own fit
    center: float  # [mm]
    paper: int  # fewest stations of the paper's method
    paper_median: float  # [mm]


@dataclass(frozen=True)
class Thing:
    """A cylinder on a table, depth camera, points 1 to 2 mm apart; azimuths in degrees."""

    name: str
    radius: float  # INDEX.md [m]
    seen: tuple[float, float]  # where wall and table are dense, and a datum can be asked for
    hidden: tuple[float, float]  # the middle of the camera's shadow, where there is neither
    bounds: Bounds


# Independent look. Upright robust circle of the wall from 15 mm above the table to 15 mm below its
# top (radius leaning freely in brackets), and robust plane of the table within 15 to 60 mm of the
# wall (height under the axis, slope):
#   mosd_43_3     R 98.2 mm (98.2), wall sigma 1.2 mm; table z 1.0 mm, slope 6.5 mm/m, sigma 1.1 mm
#   mosd_44_3     R 41.2 mm (40.9), wall sigma 1.3 mm; table z 1.1 mm, slope 5.7 mm/m, sigma 1.1 mm
#   mosd_35_2     R 91.3 mm (91.7), wall sigma 1.1 mm; table z 1.1 mm, slope 1.9 mm/m, sigma 1.1 mm
#   mug_zup_crop  R 38.5 mm (38.8), wall sigma 0.7 mm; table z 0.1 mm, slope 4.6 mm/m, sigma 0.6 mm
# The cameras smear the corner: within 5 mm of the wall the table points rise by up to 3 mm, and the
# wall's lowest 8 mm lean outwards. Wall and table are seen together over 205-330 degrees (box),
# 195-320 (can), 210-232 and 300-330 (pot, between them its skirt is hidden by a box in front),
# 200-325 (mug).
#
# tank_datum, refined, against the table (median, RMS, of N stations seen; then all measured):
#   mosd_43_3     R  98.8 mm  z -0.09  0.77 mm of 106; all 127: RMS 0.71, largest 2.1
#   mosd_44_3     R  41.9 mm  z  0.33  1.01 mm of  87; all  94: RMS 0.98, largest 1.6
#   mosd_35_2     R  92.0 mm  z -0.83  0.97 mm of  36; all  70: RMS 1.06, largest 2.0
#   mug_zup_crop  R  38.7 mm  z -0.40  0.64 mm of  79; all  94: RMS 0.78, largest 3.3
# The mug's wall flares at its foot, of which 110 degrees are seen: alone they give R 42.7 mm, and
# the 302 degrees seen higher up decide.
# The paper's method (stations measured, median): 72, 2.6 mm; 27, 2.2 mm; 32, 5.2 mm; 34, 0.4 mm.
THINGS = [
    Thing(
        "mosd_43_3", 0.0987, (215, 320), (30, 150), Bounds(90, 1.0, 1.0, 2.6, 0.01, 2.2, 50, 3.2)
    ),
    Thing(
        "mosd_44_3", 0.0419, (210, 310), (60, 140), Bounds(75, 1.2, 1.2, 1.9, 0.02, 2.5, 18, 3.0)
    ),
    Thing(
        "mosd_35_2", 0.0922, (205, 242), (40, 150), Bounds(30, 1.2, 1.3, 2.5, 0.01, 2.8, 22, 6.5)
    ),
    Thing(
        "mug_zup_crop", 0.0389, (215, 315), (90, 130), Bounds(65, 0.9, 1.2, 3.5, 0.01, 2.0, 24, 1.0)
    ),
]


def within(azimuth: Array, arc: tuple[float, float]) -> Array:
    return (azimuth >= arc[0]) & (azimuth <= arc[1])


def azimuths(plan: Array) -> Array:
    return np.degrees(np.arctan2(plan[:, 1], plan[:, 0])) % 360.0


def robust_plane(points: Array) -> Array:
    """z = p0 + p1 x + p2 y by least squares on what lies within three robust sigmas."""
    rows = np.column_stack([np.ones(len(points)), points[:, :2]])
    kept = np.abs(points[:, 2] - np.median(points[:, 2])) < 0.005
    plane = np.zeros(3)
    for _ in range(20):
        plane = np.linalg.lstsq(rows[kept], points[kept, 2], rcond=None)[0]
        off = np.abs(points[:, 2] - rows @ plane)
        kept = off < 3.0 * 1.4826 * np.median(off[kept])
    return plane


def table_at(points: Array, thing: Thing, x: Array, y: Array) -> Array:
    """The table under the wall, from its points 8 to 40 mm outside of it, all round: from the one
    arc of 18 degrees where the pot's foot is dense, the plane leans by 8 mm at its other side."""
    outside = np.hypot(points[:, 0], points[:, 1]) - thing.radius
    near = (outside > 0.008) & (outside < 0.040) & (np.abs(points[:, 2]) < 0.01)
    plane = robust_plane(points[near])
    return plane[0] + plane[1] * x + plane[2] * y


def wall_radius(points: Array, thing: Thing) -> float:
    """Robust geometric circle of the wall, 15 mm away from the table and from its top."""
    near = np.abs(np.hypot(points[:, 0], points[:, 1]) - thing.radius) < 0.012
    near &= points[:, 2] > 0.015
    plan = points[near & (points[:, 2] < np.percentile(points[near, 2], 97) - 0.015), :2]
    circle = np.array([0.0, 0.0, thing.radius])
    kept = np.ones(len(plan), dtype=bool)
    for _ in range(100):
        away = plan - circle[:2]
        distance = np.hypot(away[:, 0], away[:, 1])
        rows = np.column_stack([away / distance[:, None], np.ones(len(plan))])
        off = distance - circle[2]
        circle = circle + np.linalg.lstsq(rows[kept], off[kept], rcond=None)[0]
        kept = np.abs(off) < 3.0 * 1.4826 * np.median(np.abs(off[kept]))
    return float(circle[2])


@dataclass(frozen=True)
class Case:
    thing: Thing
    points: Array
    datum: dict[str, dict[str, Any]]  # by method
    stations: dict[str, Stations]

    def off(self, method: str) -> Array:
        """Height above the table [mm]."""
        s = self.stations[method]
        return (s["z"] - table_at(self.points, self.thing, s["x"], s["y"])) / MM


@pytest.fixture(scope="module", params=THINGS, ids=[t.name for t in THINGS])
def case(
    request: pytest.FixtureRequest,
    run: Runner,
    data: Path,
    tmp_path_factory: pytest.TempPathFactory,
) -> Case:
    thing, folder = request.param, tmp_path_factory.mktemp("thing")
    path = data / "cylinders_on_plane" / f"{thing.name}.xyz"
    points = np.loadtxt(path, usecols=(0, 1, 2))
    scan = write_xyz(folder / "scan.pcd", points)
    methods = ("refined", "paper")
    for method in methods:
        result = run(
            scan, "-o", folder / method, "--method", method, "--min-radius", 0.03, "--accept"
        )
        assert result.returncode == 0, result.stderr
    return Case(
        thing,
        points,
        {m: read_datum(folder / m) for m in methods},
        {m: read_stations(folder / m) for m in methods},
    )


def test_datum_is_the_table(case: Case) -> None:
    """z within 1 mm of the table's plane in the median, and no rougher than what was measured."""
    bounds, stations, off = case.thing.bounds, case.stations["refined"], case.off("refined")
    assert case.datum["refined"]["status"] == "partial"
    measured = stations.where("measured")
    seen = measured & within(stations["azimuth_deg"], case.thing.seen)
    assert seen.sum() >= bounds.seen
    assert abs(np.median(off[seen])) < 1.0
    assert np.sqrt(np.mean(off[seen] ** 2)) < bounds.rms
    assert np.sqrt(np.mean(off[measured] ** 2)) < bounds.rms_everywhere
    assert np.abs(off[measured]).max() < bounds.largest


def test_circle_is_the_wall(case: Case) -> None:
    tank, bounds = case.datum["refined"]["tank"], case.thing.bounds
    assert tank["radius"] == pytest.approx(case.thing.radius, rel=bounds.radius)
    assert tank["radius"] == pytest.approx(wall_radius(case.points, case.thing), rel=bounds.radius)
    assert np.hypot(*tank["center"]) < bounds.center * MM
    assert abs(tank["radius"] - case.thing.radius) < 2.0 * tank["sigma_radius"] < 4.0 * MM


@pytest.mark.parametrize("method", ["refined", "paper"])
def test_hidden_part_is_missing(case: Case, method: str) -> None:
    stations = case.stations[method]
    hidden = within(stations["azimuth_deg"], case.thing.hidden)
    assert hidden.sum() > 30
    assert all(np.array(stations.flag)[hidden] == "missing")
    assert np.isnan(stations["z"][hidden]).all()
    assert np.isnan(stations["z_paper"][hidden]).all()


def test_paper_is_near_the_table(case: Case) -> None:
    """Twenty neighbours reach over 4 mm here, and edge points are few: a handful of millimetres."""
    assert case.datum["paper"]["status"] == "partial"
    measured = case.stations["paper"].where("measured")
    assert measured.sum() >= case.thing.bounds.paper
    assert abs(np.median(case.off("paper")[measured])) < case.thing.bounds.paper_median
