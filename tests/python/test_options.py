"""Each option does what CONTRACT.md says of it, against a run without it."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from results import Run, Stations, read_datum, read_pcd, read_points, read_stations
from results import write_xyz as write

Runner = Callable[..., Run]
Synth = Callable[..., Path]

HUNDREDTH_OF_A_MM = 1e-5


@pytest.fixture(scope="module")
def default(run: Runner, synth: Synth, tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("default") / "out"
    assert run(synth(), "-o", out).returncode == 0
    return out


def stations_of(run: Runner, scan: Path, out: Path, *options: object) -> Stations:
    result = run(scan, "-o", out, *options)
    assert result.returncode == 0, result.stderr
    return read_stations(out)


def assert_same_place(a: Stations, b: Stations, rows: Any, tolerance: float) -> None:
    """Row i of a is row rows[i] of b."""
    for name in "xyz":
        assert np.abs(a[name] - b[name][rows]).max() < tolerance


def test_stations(run: Runner, synth: Synth, tmp_path: Path, default: Path) -> None:
    s = stations_of(run, synth(), tmp_path / "out", "--stations", 90)
    assert len(s) == 90
    assert s["azimuth_deg"] == pytest.approx(np.arange(90) * 4.0)
    of_all = read_stations(default)
    assert np.abs(s["z"] - of_all["z"][::4]).max() < 0.0008  # sectors four times as wide
    assert np.abs(s["radius"] - of_all["radius"][::4]).max() < 0.004


def test_zero_azimuth(run: Runner, synth: Synth, tmp_path: Path, default: Path) -> None:
    """Azimuths count from there: station 0 is where station 30 was."""
    s = stations_of(run, synth(), tmp_path / "out", "--zero-azimuth-deg", 30)
    assert s["azimuth_deg"] == pytest.approx(np.arange(360.0), abs=1e-9)
    rows = (np.arange(360) + 30) % 360
    assert_same_place(s, read_stations(default), rows, HUNDREDTH_OF_A_MM)


def test_clockwise(run: Runner, synth: Synth, tmp_path: Path, default: Path) -> None:
    s = stations_of(run, synth(), tmp_path / "out", "--clockwise")
    assert s["azimuth_deg"] == pytest.approx(np.arange(360.0), abs=1e-9)
    rows = -np.arange(360) % 360
    assert_same_place(s, read_stations(default), rows, HUNDREDTH_OF_A_MM)


def test_method(run: Runner, synth: Synth, tmp_path: Path, default: Path) -> None:
    """z of the paper's method is the z_paper that stands beside the refined one."""
    s = stations_of(run, synth(), tmp_path / "out", "--method", "paper")
    assert np.array_equal(s["z"], s["z_paper"])
    refined = read_stations(default)
    assert s["z_paper"] == pytest.approx(refined["z_paper"], abs=HUNDREDTH_OF_A_MM)
    assert np.abs(refined["z"] - refined["z_paper"]).min() > 0.005


@pytest.mark.parametrize(
    "option",
    ["--k=30", "--angle-deg=60", "--centre-tolerance=0.03", "--control-points=20"],
)
def test_option_of_the_papers_chain(
    run: Runner, synth: Synth, tmp_path: Path, default: Path, option: str
) -> None:
    s = stations_of(run, synth(), tmp_path / "out", option)
    assert not np.allclose(s["z_paper"], read_stations(default)["z_paper"], atol=1e-6)


def test_search_points(run: Runner, synth: Synth, tmp_path: Path, default: Path) -> None:
    """Fewer points for the edge search, the same for the refined z."""
    s = stations_of(run, synth(), tmp_path / "out", "--search-points", 10_000)
    few = read_points(tmp_path / "out" / "datum_points.pcd")
    assert 0 < len(few) < len(read_points(default / "datum_points.pcd"))
    assert_same_place(s, read_stations(default), np.arange(360), 0.001)


def test_fit_points(run: Runner, synth: Synth, tmp_path: Path, default: Path) -> None:
    """Fewer points for the fits: about the same z, of larger standard error."""
    s = stations_of(run, synth(), tmp_path / "out", "--fit-points", 20_000)
    d = read_stations(default)
    assert s["n_foundation"].sum() < d["n_foundation"].sum()
    assert np.median(s["sigma_z"]) > np.median(d["sigma_z"])
    assert (np.abs(s["z"] - d["z"]) < 4 * np.hypot(s["sigma_z"], d["sigma_z"])).all()


SCENES = sorted((Path(__file__).parents[1] / "scenes").glob("*.json"))


@pytest.mark.parametrize("scene", SCENES, ids=lambda path: path.stem)
def test_search(run: Runner, synth: Synth, tmp_path: Path, scene: Path) -> None:
    """Of every scene, coarsely seen, both engines give the same elevations, and say which it was.

    PCL sums the normals in float: of 1000 edge points at most one more or fewer is marked.
    """
    scan = synth(
        "--set",
        "scanner/row_step_deg=0.2",
        "--set",
        "scanner/step_deg=0.2",
        "--double",
        base=[("--scene", scene)],
    )
    found = {}
    for engine in ("flann", "buckets"):
        run(scan, "-o", tmp_path / engine, "--search", engine, "--pick", 1, "--no-report")
        found[engine] = read_datum(tmp_path / engine)
        assert found[engine]["options"]["normals"]["search"] == engine
    assert found["flann"]["message"] == found["buckets"]["message"]
    if found["flann"]["status"] not in ("ok", "partial"):
        return  # seen too coarsely: refused alike
    edges, other_edges = (
        len(read_points(tmp_path / engine / "datum_points.pcd")) for engine in found
    )
    assert abs(edges - other_edges) <= max(1, edges / 1000)
    stations, other = (read_stations(tmp_path / engine) for engine in found)
    for name in ("z", "sigma_z"):
        np.testing.assert_array_equal(stations[name], other[name])
    np.testing.assert_allclose(stations["z_paper"], other["z_paper"], rtol=0, atol=0.001)


def test_tank_given(run: Runner, synth: Synth, tmp_path: Path, default: Path) -> None:
    """A circle of the user's, centimetres off, gives the datum of the search."""
    s = stations_of(run, synth(), tmp_path / "out", "--tank", "0.02,-0.01,4.01")
    assert read_datum(tmp_path / "out")["options"]["tank"] == [0.02, -0.01, 4.01]
    assert_same_place(s, read_stations(default), np.arange(360), 0.001)


def test_min_radius(run: Runner, synth: Synth, tmp_path: Path) -> None:
    result = run(synth(), "-o", tmp_path / "out", "--min-radius", 5)
    assert result.returncode == 1
    assert read_datum(tmp_path / "out")["status"] == "no_tank"


@pytest.mark.parametrize(("units", "metres"), [("mm", 0.001), ("ft", 0.3048)])
def test_units(
    run: Runner, synth: Synth, tmp_path: Path, default: Path, units: str, metres: float
) -> None:
    """Results are in metres whatever the input is in."""
    scan = write(tmp_path / "scan.pcd", read_points(synth()) / metres)
    s = stations_of(run, scan, tmp_path / "out", "--units", units)
    assert read_datum(tmp_path / "out")["input"]["units"] == units
    assert_same_place(s, read_stations(default), np.arange(360), HUNDREDTH_OF_A_MM)


def test_georeferenced(run: Runner, synth: Synth, tmp_path: Path) -> None:
    """8-byte coordinates far from the origin lose nothing: z to 0.01 mm."""
    offset = (512034.25, 4012877.5, 113.375)
    points = read_points(synth("--double"))
    here = stations_of(run, write(tmp_path / "a.pcd", points), tmp_path / "a")
    there = stations_of(run, write(tmp_path / "b.pcd", points + offset), tmp_path / "b")
    for name, shift in zip("xyz", offset, strict=True):
        assert np.abs(there[name] - shift - here[name]).max() < HUNDREDTH_OF_A_MM
    assert there["sigma_z"] == pytest.approx(here["sigma_z"], rel=0.01)
    for cloud in ("datum_points.pcd", "datum_curve.pcd"):
        a, b = (read_points(tmp_path / n / cloud) for n in "ab")
        assert np.abs(b - offset - a).max() < HUNDREDTH_OF_A_MM


def test_georeferenced_by_the_scanner(run: Runner, synth: Synth, tmp_path: Path) -> None:
    """The same of a scene that lies there, as tank_datum_synth writes it."""
    here = stations_of(run, synth("--double"), tmp_path / "a")
    there = stations_of(run, synth("--double", "--offset", "1000,2000,50"), tmp_path / "b")
    assert np.abs(there["z"] - 50.0 - here["z"]).max() < HUNDREDTH_OF_A_MM


def test_several_scans_are_one(run: Runner, synth: Synth, tmp_path: Path) -> None:
    """A file per scanner station: of setups said to be registered without error it gives what one
    file of all of them gives; else their errors are estimated, and sigma_z holds the difference.
    """
    split = synth("--stations-split")
    parts = sorted(split.parent.glob(f"{split.stem}_?.pcd"))
    assert len(parts) == 4
    merged = write(tmp_path / "merged.pcd", np.vstack([read_points(p) for p in parts]))
    exact = ("--setup-error", 1e-9, "--setup-tilt-arcsec", 1e-6, "--bad-setups", "keep")
    assert run(*parts, "-o", tmp_path / "parts", *exact).returncode == 0
    assert run(*parts, "-o", tmp_path / "adjusted").returncode == 0
    assert run(merged, "-o", tmp_path / "merged", *exact).returncode == 0
    whole, held, free = (read_stations(tmp_path / name) for name in ("merged", "parts", "adjusted"))
    assert held.flag == whole.flag
    for name in ("x", "y", "z", "sigma_z", "radius", "sigma_radius", "z_paper"):
        np.testing.assert_allclose(held[name], whole[name], rtol=0, atol=1e-8, err_msg=name)
    assert (np.abs(free["z"] - whole["z"]) < 4.0 * free["sigma_z"]).all()
    assert np.median(free["sigma_setup"]) > 10.0 * np.median(held["sigma_setup"])
    a, b = read_datum(tmp_path / "parts"), read_datum(tmp_path / "merged")
    assert [f["path"] for f in a["input"]["files"]] == [str(p) for p in parts]
    assert sum(f["points"] for f in a["input"]["files"]) == b["input"]["files"][0]["points"]
    assert [setup["name"] for setup in a["setups"]] == [p.stem for p in parts]
    assert b["agreement"]["told_apart_by"] == "order"


def test_default_folder(run: Runner, synth: Synth, tmp_path: Path) -> None:
    """<first scan's stem>.datum, in the folder where the command runs."""
    scan = synth()
    assert run(scan, cwd=tmp_path).returncode == 0
    assert [p.name for p in tmp_path.iterdir()] == [f"{scan.stem}.datum"]


def test_timings(run: Runner, synth: Synth, tmp_path: Path) -> None:
    path = tmp_path / "timings.json"
    assert run(synth(), "-o", tmp_path / "out", "--timings", path).returncode == 0
    timings = json.loads(path.read_text())
    assert list(timings) == ["stages", "total", "peak_memory_bytes"]
    assert len(timings["stages"]) >= 5
    assert 0 < sum(timings["stages"].values()) <= timings["total"]
    assert len(read_pcd(synth())["x"]) * 8 < timings["peak_memory_bytes"] < 2e9


# ---- more than one tank ----


def test_longest_bridge(run: Runner, synth: Synth, tmp_path: Path) -> None:
    """An arc of 8 degrees that was not seen is bridged, unless bridges may span 4 degrees only."""
    points = read_points(synth())
    azimuth = np.degrees(np.arctan2(points[:, 1], points[:, 0])) % 360.0
    scan = write(tmp_path / "scan.pcd", points[(azimuth < 100.0) | (azimuth > 108.0)])
    bridged = stations_of(run, scan, tmp_path / "a")
    assert set(bridged.flag[102:107]) == {"interpolated"}
    left = stations_of(run, scan, tmp_path / "b", "--longest-bridge-deg", 4)
    assert set(left.flag[102:107]) == {"missing"}
    datum = read_datum(tmp_path / "b")
    assert datum["options"]["stations"]["longest_bridge_deg"] == 4.0
    assert (datum["status"], datum["datum"]["interpolated"]) == ("partial", 0)
