"""What studies take from the Python module: single stages, curves, limits, simulated scans."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from programs import run_program
from results import read_pcd

tank_datum = pytest.importorskip("tank_datum", reason="the module is not installed")

stages = tank_datum.stages
SCENE = {
    "tanks": [{"radius": 4, "height": 3, "tilt_slope": 0.002}],
    "scanner": {"count": 3, "distance": 5, "step_deg": 0.4, "max_range": 15},
    "near_datum": 1,
}


def step(spacing: float = 0.05) -> np.ndarray:
    """A floor and a wall that meet in the line x = 1, z = 0."""
    along = np.arange(0.0, 2.0, spacing)
    floor = [(x, y, 0.0) for x in np.arange(0.0, 1.0, spacing) for y in along]
    wall = [(1.0, y, z) for z in np.arange(0.0, 1.0, spacing) for y in along]
    return np.array(floor + wall)


@pytest.mark.parametrize("search", ["flann", "buckets"])
def test_neighbours_are_the_nearest(search: Any) -> None:
    points = np.random.default_rng(3).random((300, 3)) + 4e6
    found = stages.neighbours(points, 7, search=search)
    apart = np.linalg.norm(points[:, None] - points[None], axis=2)
    wanted = np.sort(apart, axis=1)[:, :7]
    np.testing.assert_allclose(np.take_along_axis(apart, found, 1), wanted, atol=1e-6)
    assert (found[:, 0] == np.arange(300)).all()


@pytest.mark.parametrize("shift", [0.0, 4e6])
def test_normals_and_candidates_of_a_step(shift: float) -> None:
    points = step() + shift
    found = stages.normals(points, 9)
    x, z = points[:, 0] - shift, points[:, 2] - shift
    floor, wall = x < 0.8, z > 0.2
    np.testing.assert_allclose(np.abs(found.normals[floor, 2]), 1.0, atol=1e-4)
    np.testing.assert_allclose(np.abs(found.normals[wall, 0]), 1.0, atol=1e-4)
    edge = stages.candidates(found, 30.0)
    assert len(edge) > 20 and (np.hypot(x[edge] - 1.0, z[edge]) < 0.25).all()
    assert len(stages.candidates(found, 80.0)) < len(edge)


def test_edge_points_keep_to_the_circle() -> None:
    turn = np.linspace(0, 2 * np.pi, 200, endpoint=False)
    ring = np.column_stack([5 + 3 * np.cos(turn), 3 * np.sin(turn), 0 * turn])
    points = np.vstack([ring, [[5.0, 0.0, 0.0], [9.0, 0.0, 0.0]]])
    edge = stages.edge_points(points, np.arange(202), tolerance=0.05)
    assert sorted(edge.indices) == list(range(200))
    assert edge.center == pytest.approx((5.0, 0.0), abs=1e-6) and edge.radius == pytest.approx(3.0)
    assert (np.diff(edge.azimuth_deg) > 0).all()
    all_of_them = stages.edge_points(points, np.arange(202), tank=(5, 0, 3), tolerance=4.0)
    assert len(all_of_them.indices) == 202


@pytest.mark.parametrize(
    ("call", "name"),
    [
        (lambda p, n: stages.normals(p, 0), "k"),
        (lambda p, n: stages.normals(p, -5), "k"),
        (lambda p, n: stages.normals(p, search="slow"), "search"),
        (lambda p, n: stages.normals(p, threads=-1), "threads"),
        (lambda p, n: stages.candidates(n, 0.0), "angle_deg"),
        (lambda p, n: stages.candidates(n._replace(neighbours=n.neighbours + 9000)), "neighbours"),
        (lambda p, n: stages.edge_points(p, np.array([1]), tolerance=-1.0), "centre_tolerance"),
        (lambda p, n: stages.edge_points(p, np.array([9000])), "candidates"),
        (lambda p, n: stages.normals(np.vstack([p, [[np.nan, 0, 0]]])), "row 1600 of points"),
    ],
)
def test_bad_options_of_stages_are_refused_by_name(call: Any, name: str) -> None:
    points = step()
    found = stages.normals(points)
    with pytest.raises(tank_datum.OptionError) as caught:
        call(points, found)
    assert caught.value.name == name


# ---- the paper's curves ----


def test_curves_are_those_of_the_command(datum: Any, command: Path) -> None:
    words = [command / "stations.csv", "--points", 12, "--from-deg", 30, "--to-deg", 200]
    printed = run_program("tank_datum_curves", words, None, 60).stdout.splitlines()[2:]
    curves = tank_datum.compare_curves(datum, points=12, from_deg=30, to_deg=200)
    assert [
        f"{c.kind:<12} {1e3 * c.rms:10.3f} {1e3 * c.largest:10.3f} {1e3 * c.overshoot:13.3f}"
        for c in curves
    ] == printed


def test_refused_curves(datum: Any) -> None:
    for options, name in (
        ({"points": 3}, "points"),
        ({"from_deg": 9, "to_deg": 8}, "to_deg"),
        ({"to_deg": 4}, "known places"),
    ):
        with pytest.raises(tank_datum.OptionError) as caught:
            tank_datum.compare_curves(datum, **options)
        assert caught.value.name == name


# ---- limits ----


def test_limits_are_those_of_the_checks(tmp_path: Path) -> None:
    listed = tank_datum.limits()
    tilt = next(limit for limit in listed if limit.code == "GB 50473" and "tilt" in limit.name)
    assert tilt.unit in ("m", "m/m", "1/m") and tilt.citation
    path = tmp_path / "limits.csv"
    path.write_text(tank_datum.limits_text())
    assert tank_datum.limits(path) == listed
    path.write_text("code\n")
    with pytest.raises(tank_datum.OptionError, match="limits.csv"):
        tank_datum.limits(path)


# ---- simulated scans ----


def test_simulated_arrays_are_the_commands_scan(tmp_path: Path) -> None:
    (tmp_path / "scene.json").write_text(json.dumps(SCENE))
    words = ["--scene", tmp_path / "scene.json", "-o", tmp_path / "scan.pcd", "--double", "--quiet"]
    assert run_program("tank_datum_synth", words, None, 60).returncode == 0
    made = tank_datum.simulate(SCENE)
    columns = read_pcd(tmp_path / "scan.pcd")
    np.testing.assert_array_equal(made.points, np.column_stack([columns[n] for n in "xyz"]))
    np.testing.assert_allclose(made.intensity, columns["intensity"], rtol=1e-6)
    assert json.loads((tmp_path / "scan.truth.json").read_text()) == made.truth
    assert sum(map(len, made.by_setup())) == len(made.points) and len(made.by_setup()) == 3
    assert (
        tank_datum.simulate(tmp_path / "scene.json", threads=1).points.tobytes()
        == made.points.tobytes()
    )


def test_simulated_files_are_the_commands(tmp_path: Path) -> None:
    (tmp_path / "scene.json").write_text(json.dumps(SCENE))
    words = ["--scene", tmp_path / "scene.json", "-o", tmp_path / "a.pcd", "--quiet"]
    assert run_program("tank_datum_synth", words, None, 60).returncode == 0
    made = tank_datum.simulate(SCENE, tmp_path / "b.pcd")
    assert (tmp_path / "a.pcd").read_bytes() == (tmp_path / "b.pcd").read_bytes()
    assert (tmp_path / "a.truth.json").read_bytes() == (tmp_path / "b.truth.json").read_bytes()
    assert len(made.points) == 0


def test_bad_scenes_are_refused(tmp_path: Path) -> None:
    with pytest.raises(tank_datum.OptionError, match="radius"):
        tank_datum.simulate({"tanks": [{"radius": -4}]})
    with pytest.raises(tank_datum.OptionError, match="colour"):
        tank_datum.simulate({"colour": 1})
    (tmp_path / "scene.json").write_text("{")
    for path in (tmp_path / "scene.json", tmp_path / "none.json"):
        with pytest.raises(tank_datum.FileError) as caught:
            tank_datum.simulate(path)
        assert caught.value.filename == str(path)
