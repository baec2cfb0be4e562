"""Scans that the library reads through pye57 and laspy: E57, LAZ and COPC give what PCD gives."""

# ruff: noqa: F811  fixtures are imported
from __future__ import annotations

import subprocess
from collections.abc import Callable
from pathlib import Path

import laspy
import numpy as np
import pytest

from foreign_fixtures import (  # noqa: F401
    NAMES,
    e57,
    installed,
    jittered,
    labelled,
    laz,
    scan,
    write_setups,
)
from format_writers import STEP, Setups, in_floats, poses, write_e57, write_las
from results import Run, read_datum, write_pcd
from test_formats import Result, assert_near, result_of

tank_datum = pytest.importorskip("tank_datum", reason="the module is not installed")

Runner = Callable[..., Run]


# ---- the same results ----


def test_laz_gives_the_bytes_of_pcd(
    laz: Path,
    labelled: Result,
    installed: Runner,
    tmp_path: Path,
) -> None:
    found = result_of(installed, [laz], tmp_path / "out")
    assert found.table == labelled.table
    assert found.points == labelled.points
    assert [setup["name"] for setup in found.setups] == ["scan", "1", "2"]
    for got, wanted in zip(found.setups, labelled.setups, strict=True):
        assert {**got, "name": ""} == {**wanted, "name": ""}


def test_scans_of_e57_are_setups(
    e57: Path, jittered: Setups, run: Runner, installed: Runner, tmp_path: Path
) -> None:
    """Poses applied, names and places kept: against a PCD for each setup."""
    expected = result_of(run, write_setups(tmp_path, jittered), tmp_path / "pcd")
    found = result_of(installed, [e57], tmp_path / "e57")
    assert found.points == expected.points
    assert [setup["name"] for setup in found.setups] == list(NAMES)
    assert_near(found, expected)


def test_files_beside_each_other(
    e57: Path, jittered: Setups, run: Runner, installed: Runner, tmp_path: Path
) -> None:
    """A scan may mix what the library reads and what it does not."""
    files = write_setups(tmp_path, jittered)
    two, turns = Setups(jittered.points[1:], jittered.origins[1:]), poses()[1:]
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("format_writers.poses", lambda: turns)
        path = write_e57(tmp_path / "two.e57", two, NAMES[1:])
    expected = result_of(run, files, tmp_path / "pcd")
    found = result_of(installed, [files[0], path], tmp_path / "mixed")
    assert [setup["name"] for setup in found.setups] == ["north", "two:south", "two:east"]
    of_setups = [[setup["points"] for setup in result.setups] for result in (found, expected)]
    assert of_setups[0] == of_setups[1]
    np.testing.assert_allclose(found.stations["z"], expected.stations["z"], rtol=0, atol=STEP / 10)


@pytest.mark.parametrize("kind", ["e57", "laz"])
def test_module_and_record(
    kind: str, request: pytest.FixtureRequest, installed: Runner, tmp_path: Path
) -> None:
    """extract_datum gives the command's datum.json; hash, path and points are those of the file."""
    path: Path = request.getfixturevalue(kind)
    assert installed(path, "-o", tmp_path / "out", "--threads", 1).returncode == 0
    datum = tank_datum.extract_datum(path)
    written = read_datum(tmp_path / "out")
    assert datum.to_dict() == written
    (file,) = written["input"]["files"]
    hashed = subprocess.run(["xxhsum", "-H2", path], capture_output=True, text=True, check=True)
    assert (file["path"], file["hash"]["value"]) == (str(path), hashed.stdout.split()[0])
    assert sorted(p.name for p in (tmp_path / "out").iterdir())[-2:] == [
        "shell.csv",
        "stations.csv",
    ]
    assert (tmp_path / "out" / "report.html").exists()


def test_units(jittered: Setups, run: Runner, installed: Runner, tmp_path: Path) -> None:
    """--units scales the points and the places."""
    feet = 0.3048
    scaled = Setups([p / feet for p in jittered.points], [o / feet for o in jittered.origins])
    path = write_e57(tmp_path / "scan.dat", scaled, NAMES)
    metres = Setups([p * feet for p in in_floats(scaled).points], jittered.origins)
    expected = result_of(run, write_setups(tmp_path, metres), tmp_path / "m")
    assert installed(path, "-o", tmp_path / "ft", "--units", "ft").returncode == 0
    found = read_datum(tmp_path / "ft")["setups"]
    for got, wanted in zip(found, expected.setups, strict=True):
        assert got["points"] == wanted["points"]
        np.testing.assert_allclose(got["origin"], wanted["origin"], rtol=0, atol=1e-6)


# ---- a choice of points ----


def test_classes_of_laz_are_those_of_las(
    scan: Setups,
    run: Runner,
    installed: Runner,
    tmp_path: Path,
) -> None:
    for version, point_format in (("1.2", 1), ("1.4", 6)):
        path = write_las(tmp_path / "scan.las", scan, version, point_format)
        las = laspy.read(path)
        las.classification = np.where(np.arange(len(las.x)) % 4 == 0, 7, 6)
        las.withheld = np.arange(len(las.x)) % 4 == 1
        las.write(str(path))
        las.write(str(tmp_path / "scan.laz"))
        data = []
        for program, scan_path in ((run, path), (installed, tmp_path / "scan.laz")):
            out = tmp_path / f"{version}{scan_path.suffix}"
            made = program(scan_path, "-o", out, "--las-classes", "2,6", "--no-report")
            assert made.returncode == 0, made.stderr
            data.append((out / "stations.csv").read_bytes())
            datum = read_datum(out)
            assert datum["input"]["left_out_points"] == -(-len(las.x) // 4) + -(
                -(len(las.x) - 1) // 4
            )
            data.append(datum["input"]["left_out_points"])
        assert data[:2] == data[2:]


@pytest.fixture(scope="module")
def two(scan: Setups, run: Runner, tmp_path_factory: pytest.TempPathFactory) -> Result:
    """From a PCD of setups 1 and 2 alone."""
    folder = tmp_path_factory.mktemp("two")
    wanted = scan.labels() > 0
    columns = dict(zip("xyz", scan.all()[wanted].T.astype("<f8"), strict=True))
    path = write_pcd(folder / "scan.pcd", columns | {"setup": scan.labels()[wanted]})
    return result_of(run, [path], folder / "out")


@pytest.mark.parametrize("kind", ["pcd", "laz"])
def test_some_setups(
    kind: str,
    scan: Setups,
    laz: Path,
    two: Result,
    installed: Runner,
    tmp_path: Path,
) -> None:
    """As if the others were not in the file, but counted: natively read and by laspy."""
    columns = dict(zip("xyz", scan.all().T.astype("<f8"), strict=True))
    pcd = write_pcd(tmp_path / "scan.pcd", columns | {"setup": scan.labels()})
    path = {"pcd": pcd, "laz": laz}[kind]
    made = installed(path, "-o", tmp_path / "out", "--setups", "1, 2", "--no-report")
    assert made.returncode == 0, made.stderr
    assert (tmp_path / "out" / "stations.csv").read_bytes() == two.table
    datum = read_datum(tmp_path / "out")
    assert [setup["name"] for setup in datum["setups"]] == ["1", "2"]
    assert datum["input"]["files"][0]["points"] == len(scan.all())
    assert datum["input"]["left_out_points"] == len(scan.points[0])
    assert datum["options"]["setups"]["names"] == ["1", "2"]


def test_some_scans_of_e57(
    e57: Path, jittered: Setups, run: Runner, installed: Runner, tmp_path: Path
) -> None:
    north, _, east = write_setups(tmp_path, jittered)
    expected = result_of(run, [north, east], tmp_path / "pcd")
    made = installed(e57, "-o", tmp_path / "e57", "--setups", "east,north", "--no-report")
    assert made.returncode == 0, made.stderr
    datum = read_datum(tmp_path / "e57")
    assert [setup["name"] for setup in datum["setups"]] == ["north", "east"]
    assert datum["input"]["left_out_points"] == len(jittered.points[1])
    assert datum["datum"]["mean"] == pytest.approx(
        read_datum(tmp_path / "pcd")["datum"]["mean"], abs=1e-5
    )
    assert len(expected.setups) == 2
    kept = tank_datum.extract_datum(e57, setups=["north", "east"])
    assert kept.to_dict()["setups"] == datum["setups"]


@pytest.mark.parametrize("kind", ["e57", "laz"])
def test_setups_that_are_not_there(
    kind: str, request: pytest.FixtureRequest, installed: Runner, tmp_path: Path
) -> None:
    names = {"e57": "north, south, east", "laz": "scan, 1, 2"}[kind]
    path = request.getfixturevalue(kind)
    made = installed(path, "-o", tmp_path / "out", "--setups", "west")
    assert made.returncode == 2
    assert made.stderr == (
        f"tank_datum: io: --setups, west, expected names of setups that the scan has: {names}\n"
    )
    assert not (tmp_path / "out").exists()


def test_arrays_have_no_setups() -> None:
    with pytest.raises(tank_datum.OptionError, match="setups, a, expected none"):
        tank_datum.extract_datum(np.zeros((5, 3)), setups=["a"])
