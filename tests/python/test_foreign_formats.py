"""Scans that the library reads through pye57 and laspy: E57, LAZ and COPC."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import laspy
import numpy as np
import pye57
import pytest

from format_writers import STEP, Setups, write_e57, write_las
from programs import TIMEOUT
from results import Array, Run, read_datum, write_pcd
from test_formats import Result, assert_near, labelled, result_of, scan  # noqa: F401

tank_datum = pytest.importorskip("tank_datum", reason="the module is not installed")
from tank_datum import _foreign  # noqa: E402

Runner = Callable[..., Run]
NAMES = ("north", "south", "east")
INSTALL = "pip install 'tank_datum[formats]'"


def launcher() -> Path:
    return Path(sys.executable).parent / "tank_datum"


@pytest.fixture(scope="module")
def installed() -> Runner:
    """The command that the package installs."""

    def run(*arguments: object, env: dict[str, str] | None = None) -> Run:
        words = [str(launcher()), *map(str, arguments)]
        return subprocess.run(
            words,
            capture_output=True,
            text=True,
            timeout=TIMEOUT,
            env={**os.environ, **(env or {})},
        )

    return run


@pytest.fixture(scope="module")
def jittered(scan: Setups) -> Setups:  # noqa: F811
    """Off the grid of steps: no point lies on the edge of a cell, where a last digit decides."""
    random = np.random.default_rng(1)
    points = [p + random.uniform(-0.5 * STEP, 0.5 * STEP, p.shape) for p in scan.points]
    return Setups(points, scan.origins)


@pytest.fixture(scope="module")
def e57(jittered: Setups, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_e57(tmp_path_factory.mktemp("e57") / "scan.dat", jittered, NAMES)


@pytest.fixture(scope="module")
def laz(scan: Setups, tmp_path_factory: pytest.TempPathFactory) -> Path:  # noqa: F811
    return write_las(tmp_path_factory.mktemp("laz") / "scan.laz", scan, "1.4", 6)


def write_setups(folder: Path, scan: Setups) -> list[Path]:  # noqa: F811
    """A PCD for each setup, with its place."""
    files = []
    for name, points, origin in zip(NAMES, scan.points, scan.origins, strict=True):
        columns = dict(zip("xyz", points.T.astype("<f8"), strict=True))
        path = write_pcd(folder / f"{name}.pcd", columns)
        place = " ".join(f"{v:.12f}" for v in origin)
        path.write_bytes(
            path.read_bytes().replace(b"VIEWPOINT 0 0 0", f"VIEWPOINT {place}".encode())
        )
        files.append(path)
    return files


# ---- the same results ----


def test_laz_gives_the_bytes_of_pcd(
    laz: Path,
    labelled: Result,  # noqa: F811
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
    two = Setups(jittered.points[1:], jittered.origins[1:])
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("format_writers.poses", lambda: [np.eye(3)] * 2)
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
    hashed = subprocess.run(["sha256sum", path], capture_output=True, text=True, check=True)
    assert (file["path"], file["sha256"]) == (str(path), hashed.stdout.split()[0])
    assert sorted(p.name for p in (tmp_path / "out").iterdir())[-2:] == [
        "shell.csv",
        "stations.csv",
    ]
    assert (tmp_path / "out" / "report.html").exists()


def test_units(e57: Path, jittered: Setups, installed: Runner, tmp_path: Path) -> None:
    """--units scales the points and the places."""
    feet = 0.3048
    scaled = Setups([p / feet for p in jittered.points], [o / feet for o in jittered.origins])
    path = write_e57(tmp_path / "scan.dat", scaled, NAMES)
    expected = result_of(installed, [e57], tmp_path / "m")
    assert installed(path, "-o", tmp_path / "ft", "--units", "ft").returncode == 0
    found = read_datum(tmp_path / "ft")["setups"]
    for got, wanted in zip(found, expected.setups, strict=True):
        assert got["points"] == wanted["points"]
        np.testing.assert_allclose(got["origin"], wanted["origin"], rtol=0, atol=1e-6)


# ---- a choice of points ----


def test_classes_of_laz_are_those_of_las(
    scan: Setups,  # noqa: F811
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
def two(scan: Setups, run: Runner, tmp_path_factory: pytest.TempPathFactory) -> Result:  # noqa: F811
    """From a PCD of setups 1 and 2 alone."""
    folder = tmp_path_factory.mktemp("two")
    wanted = scan.labels() > 0
    columns = dict(zip("xyz", scan.all()[wanted].T.astype("<f8"), strict=True))
    path = write_pcd(folder / "scan.pcd", columns | {"setup": scan.labels()[wanted]})
    return result_of(run, [path], folder / "out")


@pytest.mark.parametrize("kind", ["pcd", "laz"])
def test_some_setups(
    kind: str,
    scan: Setups,  # noqa: F811
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


# ---- files of other programs ----


def blocks_of(path: Path, kind: str) -> tuple[Any, Array]:
    """What the reader says, and all points."""
    reader = _foreign.open_blocks(str(path), kind, [])
    points, rows = [np.empty((0, 3))], 0
    for block, _, invalid, left_out in reader.blocks(None):
        points.append(block)
        rows += len(block) + invalid + left_out
    assert rows == reader.size
    return reader, np.concatenate(points)


def test_real_e57(data: Path) -> None:
    """Counts and points against scans that pye57 reads whole."""
    files = sorted((data / "formats" / "e57").glob("*.e57"))
    assert len(files) == 21
    for path in files:
        reader, points = blocks_of(path, "E57")
        with pye57.E57(str(path)) as file:
            assert reader.size == sum(
                file.get_header(i).point_count for i in range(file.scan_count)
            )
            scans = [file.read_scan(i, ignore_missing_fields=True) for i in range(file.scan_count)]
        whole = np.concatenate(
            [np.stack([s[f"cartesian{a}"] for a in "XYZ"], axis=1) for s in scans]
        )
        np.testing.assert_allclose(points, whole, rtol=0, atol=1e-9, err_msg=path.name)


def test_real_laz(data: Path) -> None:
    """Every bit is what laspy makes of the whole file; COPC among them."""
    files = sorted((data / "formats" / "laz").glob("*.laz"))
    assert len(files) == 9
    for path in files:
        reader, points = blocks_of(path, "LAZ")
        whole = laspy.read(path)
        assert reader.size == len(whole.points)
        np.testing.assert_array_equal(points, whole.xyz[np.asarray(whole.withheld) == 0], path.name)


def test_blocks_of_a_large_scan(tmp_path: Path) -> None:
    """More rows than a block, rows without a point, and a scan that is passed over."""
    rows = _foreign.FIRST_BLOCK + _foreign.BLOCK + 1000
    columns = {f"cartesian{axis}": np.arange(rows, dtype=float) + i for i, axis in enumerate("XYZ")}
    columns["cartesianInvalidState"] = (np.arange(rows) % 100 == 7).astype(np.int8)
    path = tmp_path / "large.e57"
    with pye57.E57(str(path), "w") as file:
        for _ in range(2):
            file.write_scan_raw(columns, name="twice")
    reader, points = blocks_of(path, "E57")
    assert reader.setups == {0: ("twice 0", None), 1: ("twice 1", None)}
    kept = np.arange(rows)[np.arange(rows) % 100 != 7]
    np.testing.assert_array_equal(points[:, 2], np.tile(kept + 2.0, 2))
    left_out = [(len(p), left) for p, _, _, left in reader.blocks([1])]
    assert left_out[0] == (0, rows)
    assert sum(n for n, _ in left_out) == len(kept)
    assert max(n for n, _ in left_out) <= _foreign.BLOCK


# ---- what is refused ----


def refused(made: Run, out: Path) -> str:
    assert made.returncode == 3, made.stderr
    assert made.stderr.count("\n") == 1, made.stderr
    assert made.stdout == ""
    assert not out.exists()
    return made.stderr


BROKEN: dict[str, Callable[[bytes], bytes]] = {
    "half": lambda whole: whole[: len(whole) // 2],
    "last byte": lambda whole: whole[:-1],
    "header": lambda whole: whole[:110],
    "ones": lambda whole: (
        whole[: len(whole) // 3] + b"\xff" * 4000 + whole[len(whole) // 3 + 4000 :]
    ),
}


@pytest.mark.parametrize("how", BROKEN)
@pytest.mark.parametrize("kind", ["e57", "laz"])
def test_broken_files(
    kind: str, how: str, request: pytest.FixtureRequest, installed: Runner, tmp_path: Path
) -> None:
    path = tmp_path / "broken"
    path.write_bytes(BROKEN[how](request.getfixturevalue(kind).read_bytes()))
    line = refused(installed(path, "-o", tmp_path / "out"), tmp_path / "out")
    assert f"of {path}" in line and ", expected " in line
    with pytest.raises(tank_datum.FileError, match="expected"):
        tank_datum.extract_datum(path)


def test_scale_of_laz_that_is_none(laz: Path, installed: Runner, tmp_path: Path) -> None:
    whole = bytearray(laz.read_bytes())
    whole[131:139] = bytes(8)
    (tmp_path / "broken").write_bytes(whole)
    line = refused(installed(tmp_path / "broken", "-o", tmp_path / "out"), tmp_path / "out")
    assert f"LAS scale of x of {tmp_path}/broken, 0.000000, expected a number > 0" in line


def test_pose_that_is_no_rotation(
    jittered: Setups, installed: Runner, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("format_writers.Quaternion", Doubled)
    path = write_e57(tmp_path / "scan.e57", jittered, NAMES)
    line = refused(installed(path, "-o", tmp_path / "out"), tmp_path / "out")
    assert "rotation of scan 0 of" in line and "2 0 0 0, expected a quaternion of length 1" in line


class Doubled:
    """A quaternion whose matrix would scale."""

    def __init__(self, matrix: Array) -> None:
        self.elements = np.array([2.0, 0.0, 0.0, 0.0])


@pytest.mark.parametrize(("kind", "package"), [("e57", "pye57"), ("laz", "lazrs")])
def test_package_that_is_missing(
    kind: str, package: str, request: pytest.FixtureRequest, installed: Runner, tmp_path: Path
) -> None:
    (tmp_path / f"{package}.py").write_text("raise ModuleNotFoundError")
    path = request.getfixturevalue(kind)
    made = installed(path, "-o", tmp_path / "out", env={"PYTHONPATH": str(tmp_path)})
    assert INSTALL in refused(made, tmp_path / "out")


@pytest.mark.parametrize("kind", ["e57", "laz"])
def test_executable_says_who_reads_it(
    kind: str, request: pytest.FixtureRequest, run: Runner, tmp_path: Path
) -> None:
    line = refused(run(request.getfixturevalue(kind), "-o", tmp_path / "out"), tmp_path / "out")
    assert f", {kind.upper()}, expected PCD, LAS" in line and INSTALL in line


@pytest.mark.parametrize(
    "arguments", [["--k", "1"], ["--wrong"], ["--version"], ["--print-config"]]
)
def test_the_rest_is_the_executables(
    arguments: list[str], e57: Path, run: Runner, installed: Runner
) -> None:
    got, wanted = installed(e57, *arguments), run(e57, *arguments)
    assert (got.returncode, got.stdout, got.stderr) == (
        wanted.returncode,
        wanted.stdout,
        wanted.stderr,
    )


# ---- given up ----


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_signals_clean_up(number: signal.Signals, tmp_path: Path) -> None:
    """In the middle of a scan: the line and the status of the executable, nothing left."""
    random = np.random.default_rng(1)
    columns = {f"cartesian{axis}": 60 * random.random(4_000_000) for axis in "XYZ"}
    with pye57.E57(str(tmp_path / "large.e57"), "w") as file:
        file.write_scan_raw(columns)
    out = tmp_path / "out"
    process = subprocess.Popen(
        [launcher(), tmp_path / "large.e57", "-o", out],
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),
    )
    while not out.exists():
        assert process.poll() is None
        time.sleep(0.01)
    time.sleep(0.2)
    process.send_signal(number)
    began = time.monotonic()
    _, said = process.communicate(timeout=TIMEOUT)
    assert time.monotonic() - began < 5
    assert process.returncode == -number
    assert said == f"tank_datum: stopped by {signal.strsignal(number)}\n"
    assert not out.exists()


def test_what_progress_raises_ends_the_run(e57: Path) -> None:
    def stop(stage: str) -> None:
        raise LookupError(stage)

    with pytest.raises(LookupError, match="locate"):
        tank_datum.extract_datum(e57, progress=stop)
    assert tank_datum.extract_datum(e57).usable
