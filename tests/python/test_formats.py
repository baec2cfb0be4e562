"""One scan of three setups in every format: the same stations and the same setups."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import laspy
import numpy as np
import pytest

from conftest import SMALL_TANK
from format_writers import SHIFT, STEP, WRITERS, Setups, write_las, write_ptx
from programs import run_program
from results import Run, Stations, read_datum, read_pcd, read_stations, write_pcd

Runner = Callable[..., Run]


@dataclass(frozen=True)
class Result:
    table: bytes
    stations: Stations
    setups: list[dict[str, object]]
    points: int


@pytest.fixture(scope="module")
def scan(tmp_path_factory: pytest.TempPathFactory) -> Setups:
    """Three setups of a small tank that disagree by millimetres, in steps of a tenth.

    The coordinates are those that a scale and an offset make of whole numbers, to the last bit.
    """
    folder = tmp_path_factory.mktemp("setups")
    seen = {"--scanners": 3, "--distance": 8, "--max-range": 25, "--step-deg": 0.1}
    options = dict(SMALL_TANK) | seen | {"--seed": 5}
    words = [str(word) for pair in options.items() for word in pair]
    made = run_program(
        "tank_datum_synth", ["-o", folder / "s.pcd", "--quiet", "--double", "--per-setup", *words]
    )
    assert made.returncode == 0, made.stderr
    points, origins = [], []
    for path in sorted(folder.glob("s_*.pcd")):
        columns = read_pcd(path)
        points.append(np.stack([columns[n] for n in "xyz"], axis=1) + SHIFT)
        head = path.read_bytes()[:500].split(b"VIEWPOINT ")[1].split(b"\n")[0]
        origins.append(np.array([float(v) for v in head.split()[:3]]) + SHIFT)
    moved = [setup + [0, 0, dz] for setup, dz in zip(points, (0.003, -0.002, 0.0), strict=True)]
    return Setups([np.round((p - SHIFT) / STEP) * STEP + SHIFT for p in moved], origins)


def result_of(run: Runner, scans: list[Path], out: Path) -> Result:
    made = run(*scans, "-o", out, "--quiet", "--no-report")
    assert made.returncode == 0, made.stderr
    datum = read_datum(out)
    return Result(
        (out / "stations.csv").read_bytes(),
        read_stations(out),
        datum["setups"],
        sum(file["points"] for file in datum["input"]["files"]),
    )


@pytest.fixture(scope="module")
def labelled(scan: Setups, run: Runner, tmp_path_factory: pytest.TempPathFactory) -> Result:
    """The result from a PCD with a field of setups."""
    folder = tmp_path_factory.mktemp("labelled")
    columns = dict(zip("xyz", scan.all().T.astype("<f8"), strict=True))
    path = write_pcd(folder / "scan.pcd", columns | {"setup": scan.labels()})
    return result_of(run, [path], folder / "out")


def assert_near(found: Result, expected: Result) -> None:
    """The same stations and setups, a tenth of the coordinates' step apart at most."""
    assert found.stations.flag == expected.stations.flag
    for column in ("x", "y", "z", "radius"):
        got, wanted = found.stations[column], expected.stations[column]
        np.testing.assert_allclose(got, wanted, rtol=0, atol=STEP / 10, err_msg=column)
    assert len(found.setups) == len(expected.setups) == 3
    for got, wanted in zip(found.setups, expected.setups, strict=True):
        assert got["name"] == wanted["name"]
        assert got["points"] == wanted["points"]
        assert got["verdict"] == wanted["verdict"]
        assert got["dz"] == pytest.approx(wanted["dz"], abs=STEP / 10)
        np.testing.assert_allclose(got["origin"], wanted["origin"], rtol=0, atol=1e-6)


@pytest.mark.parametrize("name", WRITERS)
def test_the_same_stations_and_setups(
    name: str, scan: Setups, labelled: Result, run: Runner, tmp_path: Path
) -> None:
    """Every bit of the coordinates is that of the PCD, and so is every byte of the stations."""
    path = WRITERS[name](tmp_path / "scan.dat", scan)
    found = result_of(run, [path], tmp_path / "out")
    assert found.table == labelled.table
    for got, wanted in zip(found.setups, labelled.setups, strict=True):
        assert {**got, "name": ""} == {**wanted, "name": ""}
    named = {str(setup["name"]) for setup in found.setups}
    assert named == ({"scan", "1", "2"} if name.startswith("las") else {"0", "1", "2"})


def test_ptx_is_its_scans_each_with_its_place(scan: Setups, run: Runner, tmp_path: Path) -> None:
    """Against files of a setup each, which say in VIEWPOINT where the scanner stood.

    Points off the grid of steps: none lies on the edge of a cell, on either side of which the last
    digit could put it.
    """
    random = np.random.default_rng(1)
    points = [p + random.uniform(-0.5 * STEP, 0.5 * STEP, p.shape) for p in scan.points]
    scan = Setups(points, scan.origins)
    files = []
    for i, (points, origin) in enumerate(zip(scan.points, scan.origins, strict=True)):
        columns = dict(zip("xyz", points.T.astype("<f8"), strict=True))
        path = write_pcd(tmp_path / f"{i}.pcd", columns)
        place = " ".join(f"{v:.12f}" for v in origin)
        path.write_bytes(
            path.read_bytes().replace(b"VIEWPOINT 0 0 0", f"VIEWPOINT {place}".encode())
        )
        files.append(path)
    expected = result_of(run, files, tmp_path / "pcd")
    found = result_of(run, [write_ptx(tmp_path / "scan.ptx", scan)], tmp_path / "ptx")
    dropped = sum(100 - len(points) % 100 for points in scan.points)
    assert found.points == expected.points + dropped
    assert read_datum(tmp_path / "ptx")["input"]["invalid_points"] == dropped
    assert_near(found, expected)


def test_blanks_and_no_header(scan: Setups, run: Runner, tmp_path: Path) -> None:
    """Three columns: the points of a PCD without setups."""
    np.savetxt(tmp_path / "scan.xyz", scan.all(), fmt="%.17g")
    columns = dict(zip("xyz", scan.all().T.astype("<f8"), strict=True))
    pcd = write_pcd(tmp_path / "scan.pcd", columns)
    found, expected = (
        result_of(run, [path], tmp_path / path.suffix[1:]) for path in (tmp_path / "scan.xyz", pcd)
    )
    assert found.table == expected.table


@pytest.mark.parametrize("name", ["las_1.4", "csv"])
def test_threads_do_not_change_a_byte(name: str, scan: Setups, run: Runner, tmp_path: Path) -> None:
    path = WRITERS[name](tmp_path / "scan", scan)
    for threads in (1, 2):
        made = run(path, "-o", tmp_path / f"out{threads}", "--threads", threads, "--no-report")
        assert made.returncode == 0, made.stderr
    for file in ("stations.csv", "datum_points.pcd"):
        assert (tmp_path / "out1" / file).read_bytes() == (tmp_path / "out2" / file).read_bytes()


def test_classes_of_las(scan: Setups, run: Runner, tmp_path: Path) -> None:
    """Points of other classes, and withheld ones, are as if they were not there, and counted."""
    path = write_las(tmp_path / "scan.las", scan, "1.4", 6)
    las = laspy.read(path)
    las.classification = np.where(np.arange(len(las.x)) % 4 == 0, 7, 6)
    las.withheld = np.arange(len(las.x)) % 4 == 1
    las.write(str(path))
    kept = np.arange(len(las.x)) % 4 >= 2
    columns = dict(zip("xyz", scan.all()[kept].T.astype("<f8"), strict=True))
    pcd = write_pcd(tmp_path / "scan.pcd", columns | {"setup": scan.labels()[kept]})
    expected = result_of(run, [pcd], tmp_path / "pcd")
    made = run(path, "-o", tmp_path / "las", "--las-classes", "2,6", "--no-report")
    assert made.returncode == 0, made.stderr
    assert (tmp_path / "las" / "stations.csv").read_bytes() == expected.table
    datum = read_datum(tmp_path / "las")
    assert datum["input"]["left_out_points"] == len(las.x) - int(kept.sum())
    assert datum["options"]["las_classes"] == [2, 6]


@pytest.mark.parametrize("typed", ["256", "-1", "6,2", "2.5", "ground"])
def test_classes_that_are_none(typed: str, scan: Setups, run: Runner, tmp_path: Path) -> None:
    path = write_las(tmp_path / "scan.las", scan, "1.2", 0)
    made = run(path, "-o", tmp_path / "out", f"--las-classes={typed}")
    assert made.returncode == 2
    assert "--las-classes" in made.stderr
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"ASTM-E57" + bytes(40), "E57, expected"),
        (b"LASF" + bytes(400), "LAS version"),
        (b"1,5;2,5;3,5\n", "decimal points, not commas"),
        (b"ply\nformat ascii 1.0\nend_header\n", "no vertex"),
        (b"99999\n1 2 3\n", "99999 points, expected at most 1"),
        (bytes(100), "expected PCD, LAS, PLY, PTX, PTS"),
    ],
    ids=["e57", "las", "commas", "ply", "pts", "zeros"],
)
def test_files_that_are_none(content: bytes, said: str, run: Runner, tmp_path: Path) -> None:
    path = tmp_path / "scan"
    path.write_bytes(content)
    made = run(path, "-o", tmp_path / "out")
    assert made.returncode == 3
    assert made.stderr.count("\n") == 1
    assert said in made.stderr
    assert not (tmp_path / "out").exists()
