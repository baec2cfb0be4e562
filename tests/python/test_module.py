"""The Python module: the same numbers as the command, options and errors."""

from __future__ import annotations

import inspect
import re
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from conftest import ROOT
from module_fixtures import same, two_setups
from results import Array, Run, read_datum, read_points, read_stations, write_pcd

tank_datum = pytest.importorskip("tank_datum", reason="the module is not installed")

Runner = Callable[..., Run]
SAMPLE = ROOT / "tests" / "data" / "sample.pcd"


# ---- the same numbers ----


def test_path_gives_the_commands_results(datum: Any, command: Path) -> None:
    assert datum.to_dict() == read_datum(command)
    assert datum.to_json() == (command / "datum.json").read_text()
    expected = read_stations(command)
    for name, column in expected.columns.items():
        same(datum.stations[name], column)
    assert list(datum.stations["flag"]) == expected.flag
    same(datum.edge_points, read_points(command / "datum_points.pcd"))


def test_array_gives_the_same(datum: Any, points: Array) -> None:
    other = tank_datum.extract_datum(points)
    for name in datum.stations.dtype.names:
        same(other.stations[name], datum.stations[name])
    same(other.edge_points, datum.edge_points)
    wanted, got = datum.to_dict(), other.to_dict()
    assert got.pop("input")["files"] == []
    wanted.pop("input")
    assert got["setups"][0]["name"] == "part 1"  # told apart by the order of the points
    assert got == wanted


@pytest.mark.parametrize("kind", ["double", "fortran", "columns", "rows", "reversed", "read_only"])
def test_any_stride(datum: Any, points: Array, kind: str) -> None:
    wide = np.zeros((2 * len(points), 7), dtype=points.dtype)
    wide[::2, 1:6:2] = points
    given = {
        "double": points.astype(np.float64),
        "fortran": np.asfortranarray(points),
        "columns": np.ascontiguousarray(wide[::2])[:, 1:6:2],
        "rows": wide[::2, 1:6:2],
        "reversed": np.ascontiguousarray(points[::-1])[::-1],
        "read_only": points.copy(),
    }[kind]
    given.flags.writeable = False
    same(tank_datum.extract_datum(given).stations["z"], datum.stations["z"])


def test_several_arrays_are_one_scan(datum: Any, points: Array) -> None:
    split = tank_datum.extract_datum([points[:9000], points[9000:9001], points[9001:]])
    same(split.stations["z"], datum.stations["z"])


def test_several_paths_are_one_scan(points: Array, tmp_path: Path) -> None:
    """Each a setup: as one scan when they are said to be registered without error."""
    parts = two_setups(points)
    for name, part in zip(("a.pcd", "b.pcd"), parts, strict=True):
        write_pcd(tmp_path / name, {n: part[:, i] for i, n in enumerate("xyz")})
    exact = {"setup_error": 1e-9, "setup_tilt_arcsec": 1e-6, "bad_setups": "keep"}
    both = tank_datum.extract_datum([tmp_path / "a.pcd", tmp_path / "b.pcd"], **exact)
    whole = tank_datum.extract_datum(np.concatenate(parts), **exact)
    np.testing.assert_allclose(both.stations["z"], whole.stations["z"], rtol=0, atol=1e-8)
    assert [setup["name"] for setup in both.to_dict()["setups"]] == ["a", "b"]


def test_points_that_are_not_finite_are_dropped(points: Array, datum: Any) -> None:
    holes = np.insert(points, [5, 700], np.nan, axis=0)
    other = tank_datum.extract_datum(holes)
    same(other.stations["z"], datum.stations["z"])
    assert other.to_dict()["input"]["invalid_points"] == 2


def test_what_it_says(datum: Any, command: Path) -> None:
    expected = read_datum(command)
    assert (datum.status, datum.usable, datum.message) == ("ok", True, "")
    assert datum.tank == expected["tank"]
    assert datum.tilt == expected["tilt"]
    assert datum.antipodal == expected["antipodal"]
    assert datum.harmonics == expected["harmonics"]
    assert datum.out_of_plane == expected["out_of_plane"]
    assert datum.checks == expected["checks"]
    assert "tank           radius 5.000 m" in datum.summary()
    assert repr(datum) == "<tank_datum.Datum ok, 360 stations>"


def test_no_tank_is_a_status(points: Array) -> None:
    flat = points.copy()
    flat[:, 2] = 0.0
    datum = tank_datum.extract_datum(flat)
    assert (datum.status, datum.usable) == ("no_tank", False)
    assert datum.message
    assert len(datum.stations) == 0 and datum.tilt is None


# ---- options ----


def test_defaults_are_the_commands(run: Runner) -> None:
    """Every option of the command that is not of its own alone."""
    config = tomllib.loads(run(SAMPLE, "--print-config").stdout)
    wanted = {k.replace("-", "_"): v for k, v in config.items()}
    got = tank_datum.defaults()
    assert got.pop("tank") is None and wanted.pop("tank") == ""
    for name in ("heights", "las_classes", "setups", "mark"):  # lists
        assert got.pop(name) == [] and wanted.pop(name) == ""
    assert set(wanted) - set(got) == {"all", "quiet", "no_report"}
    assert set(got) <= set(wanted)
    for name, value in got.items():
        assert ("" if value is None else value) == pytest.approx(wanted[name]), name


@pytest.mark.parametrize(
    ("options", "arguments"),
    [
        ({"method": "paper"}, ["--method", "paper"]),
        ({"k": 12, "angle_deg": 30.0}, ["--k", 12, "--angle-deg", 30]),
        ({"stations": 72, "zero_azimuth_deg": 10}, ["--stations", 72, "--zero-azimuth-deg", 10]),
        ({"clockwise": True}, ["--clockwise"]),
        ({"centre_tolerance": 0.05}, ["--centre-tolerance", 0.05]),
        ({"control_points": 24}, ["--control-points", 24]),
        ({"search_points": 8000}, ["--search-points", 8000]),
        ({"fit_points": 8000}, ["--fit-points", 8000]),
        ({"tank": (0, 0, 5)}, ["--tank", "0,0,5"]),
        ({"units": "ft"}, ["--units", "ft"]),
        ({"min_radius": 9.0}, ["--min-radius", 9]),
        ({"pick": 2}, ["--pick", 2]),
        (
            {"height": 9.0, "yield_mpa": 235.0, "modulus_mpa": 206_000.0, "roof": "open"},
            ["--height", 9, "--yield-mpa", 235, "--modulus-mpa", 206_000, "--roof", "open"],
        ),
        (
            {"foundation": "earth", "classic_points": 8},
            "--foundation earth --classic-points 8".split(),
        ),
        ({"heights": [0.2, 0.25]}, ["--heights", "0.2,0.25"]),
        ({"height_step": 0.15}, ["--height-step", 0.15]),
        ({"up": "-z"}, ["--up=-z"]),
        ({"level": True}, ["--level"]),
        ({"accept": True}, ["--accept"]),
        ({"no_checksum": True}, ["--no-checksum"]),
        ({"checksum": "sha256"}, ["--checksum", "sha256"]),
    ],
)
def test_options_are_the_commands(
    run: Runner, datum: Any, tmp_path: Path, options: dict[str, Any], arguments: list[object]
) -> None:
    run(SAMPLE, "-o", tmp_path / "out", *arguments)
    other = tank_datum.extract_datum(SAMPLE, **options)
    assert other.to_dict() == read_datum(tmp_path / "out")
    assert other.to_dict() != datum.to_dict()


def test_threads_and_search_change_nothing(datum: Any) -> None:
    for search in ("flann", "buckets"):
        other = tank_datum.extract_datum(SAMPLE, threads=1, search=search)
        same(other.stations["z"], datum.stations["z"])


def test_stub_lists_the_options() -> None:
    stub = Path(inspect.getfile(tank_datum)).with_suffix(".pyi").read_text()
    signature = stub[stub.index("def extract_datum") :]
    named = re.findall(r"^    (\w+): .* = .+,$", signature, re.MULTILINE)
    assert set(named) == {*tank_datum.defaults(), "progress"}


def test_help_lists_the_options() -> None:
    text = tank_datum.extract_datum.__doc__
    assert "    k: neighbours of a point, itself included (>= 3); default 20\n" in text
    assert "    setup_error: how well setups are registered in height and plan, 1 sigma [m]" in text
    listed = re.findall(r"^    (\w+): ", text[text.index("Options:") :], re.MULTILINE)
    assert listed == list(tank_datum.defaults())


def test_origins_of_setups_are_in_the_units_of_the_scan(points: Array, tmp_path: Path) -> None:
    for name, part in (("a.pcd", points[::2]), ("b.pcd", points[1::2])):
        write_pcd(tmp_path / name, {n: 1000 * part[:, i] for i, n in enumerate("xyz")})
    (tmp_path / "origins.csv").write_text("a,8000,0,1500\nb,-8000,0,1500\n")
    scans = [tmp_path / "a.pcd", tmp_path / "b.pcd"]
    datum = tank_datum.extract_datum(scans, units="mm", setup_origins=tmp_path / "origins.csv")
    wanted = {"a": [8.0, 0.0, 1.5], "b": [-8.0, 0.0, 1.5]}
    assert datum.to_dict()["options"]["setups"]["origins"] == wanted
    other = tank_datum.extract_datum(scans, units="mm", setup_origins=wanted)
    assert other.to_dict() == datum.to_dict()


# ---- errors ----


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"k": 2}, "options: k, 2, expected >= 3"),
        ({"method": "exact"}, "options: method, exact, expected refined or paper"),
        ({"search": "slow"}, "options: search, slow, expected flann or buckets"),
        ({"roof": "a = 1 (must be b)"}, "options: roof, a = 1 (must be b), expected open or fixed"),
        ({"angle_deg": 95}, "options: angle_deg, 95, expected > 0 and < 90 deg"),
        ({"angle_deg": 1e300}, "options: angle_deg, 1e+300, expected > 0 and < 90 deg"),
        ({"units": "inch"}, "options: units, inch, expected ft, in, m, mm or us-ft"),
        ({"stations": 4}, "options: stations, 4, expected 8 to 36000"),
        ({"min_radius": -1.0}, "options: min_radius, -1, expected > 0 m"),
        ({"heights": [0.5, 0.4]}, "options: heights, 0.4, expected > 0 and <= 100 m and above"),
    ],
)
def test_refused_options(options: dict[str, Any], said: str) -> None:
    with pytest.raises(ValueError, match=re.escape(said)) as caught:
        tank_datum.extract_datum(SAMPLE, **options)
    assert caught.type is tank_datum.OptionError


def test_wrong_types(points: Array) -> None:
    with pytest.raises(TypeError, match="unexpected keyword argument 'radius'"):
        tank_datum.extract_datum(points, radius=3)
    with pytest.raises(TypeError, match="k = 'many', expected"):
        tank_datum.extract_datum(points, k="many")
    for wrong in (points[:, :2], points.astype(complex), points.ravel(), 7, None):
        with pytest.raises(TypeError, match="expected an array of shape"):
            tank_datum.extract_datum(wrong)
    with pytest.raises(TypeError, match="expected an array or a path"):
        tank_datum.extract_datum([])
    with pytest.raises(TypeError, match="the one or the other"):
        tank_datum.extract_datum([points, SAMPLE])


def test_file_errors_are_the_commands(run: Runner, tmp_path: Path) -> None:
    missing = tmp_path / "none.pcd"
    with pytest.raises(OSError, match="none.pcd") as caught:
        tank_datum.extract_datum(missing)
    assert caught.type is tank_datum.FileError
    assert run(missing).stderr == f"tank_datum: {caught.value}\n"


def test_empty_array() -> None:
    assert tank_datum.extract_datum(np.zeros((0, 3))).status == "too_few_points"
