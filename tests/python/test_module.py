"""The Python module: the same numbers as the command, options and errors, and a run given up."""

from __future__ import annotations

import inspect
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from conftest import ROOT
from results import Array, Run, read_datum, read_pcd, read_points, read_stations, write_pcd

tank_datum = pytest.importorskip("tank_datum", reason="the module is not installed")

Runner = Callable[..., Run]
SAMPLE = ROOT / "tests" / "data" / "sample.pcd"


@pytest.fixture(scope="module")
def command(run: Runner, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The results of the command on the sample."""
    out = tmp_path_factory.mktemp("command") / "out"
    assert run(SAMPLE, "-o", out).returncode == 0
    return out


@pytest.fixture(scope="module")
def datum() -> Any:
    return tank_datum.extract_datum(str(SAMPLE))


@pytest.fixture(scope="module")
def points() -> Array:
    """The sample's points as they are stored."""
    columns = read_pcd(SAMPLE)
    return np.column_stack([columns[n] for n in "xyz"])


def same(a: Array, b: Array) -> None:
    """Equal bit for bit, NaN where NaN."""
    np.testing.assert_array_equal(np.asarray(a), np.asarray(b))


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


def test_several_paths_are_one_scan(points: Array, datum: Any, tmp_path: Path) -> None:
    for name, part in (("a.pcd", points[:9000]), ("b.pcd", points[9000:])):
        write_pcd(tmp_path / name, {n: part[:, i] for i, n in enumerate("xyz")})
    both = tank_datum.extract_datum([tmp_path / "a.pcd", tmp_path / "b.pcd"])
    same(both.stations["z"], datum.stations["z"])


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
    config = tomllib.loads(run(SAMPLE, "--print-config").stdout)
    of_runs = {"all", "quiet", "no-report"}
    wanted = {k.replace("-", "_"): v for k, v in config.items() if k not in of_runs}
    got = tank_datum.defaults()
    assert got.pop("tank") is None and wanted.pop("tank") == ""
    assert got.pop("heights") == [] and wanted.pop("heights") == ""
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
    named = re.findall(r"^    (\w+): .* = \.\.\.", signature, re.MULTILINE)
    assert set(named) == {*tank_datum.defaults(), "progress"}


# ---- errors ----


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"k": 2}, "options: normals.k, 2, expected >= 3"),
        ({"method": "exact"}, "options: method, exact, expected refined or paper"),
        ({"search": "slow"}, "options: search, slow, expected flann or buckets"),
        ({"units": "inch"}, "options: units, inch, expected m, mm, ft or in"),
        ({"stations": 4}, "options: stations.count, 4"),
        ({"min_radius": -1.0}, "options: locate.min_radius, -1"),
        ({"heights": [0.5, 0.4]}, "options: shell.heights, 0.4"),
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
    for wrong in (points[:, :2], points.astype(int), points.ravel(), points.astype(">f8"), 7, None):
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


# ---- a run watched and given up ----


def test_progress_names_the_stages() -> None:
    stages: list[str] = []
    tank_datum.extract_datum(SAMPLE, progress=stages.append)
    assert stages[:3] == ["locate", "crop", "normals"] and stages[-1] == "checks"


def test_what_progress_raises_ends_the_run(datum: Any) -> None:
    def stop(stage: str) -> None:
        raise LookupError(stage)

    with pytest.raises(LookupError, match="locate"):
        tank_datum.extract_datum(SAMPLE, progress=stop)
    same(tank_datum.extract_datum(SAMPLE).stations["z"], datum.stations["z"])


INTERRUPTED = """
import signal, sys, threading, time
import numpy as np, tank_datum
signal.signal(signal.SIGINT, signal.default_int_handler)  # ignored in background jobs
random = np.random.default_rng(1)
points = 60 * random.random((30_000_000, 3), dtype=np.float32) - 30
ticks = []
threading.Thread(target=lambda: [(ticks.append(1), time.sleep(0.02)) for _ in range(9999)],
                 daemon=True).start()
print("ready", flush=True)
try:
    tank_datum.extract_datum(points)
except KeyboardInterrupt:
    print("interrupted", len(ticks) > 10, flush=True)
    sys.exit(3)
"""


def test_ctrl_c_is_heard_within_a_second_and_the_lock_is_free() -> None:
    process = subprocess.Popen(
        [sys.executable, "-c", INTERRUPTED], stdout=subprocess.PIPE, text=True
    )
    assert process.stdout is not None
    assert process.stdout.readline() == "ready\n"
    time.sleep(0.4)
    process.send_signal(signal.SIGINT)
    began = time.monotonic()
    assert process.stdout.readline() == "interrupted True\n"
    assert time.monotonic() - began < 1.0
    assert process.wait(timeout=30) == 3


# ---- the launcher ----


def launcher() -> Path:
    return Path(sys.executable).parent / "tank_datum"


@pytest.mark.parametrize(
    "arguments", [["--version"], ["--help"], ["none.pcd"], ["--k", "1", str(SAMPLE)], ["--wrong"]]
)
def test_launcher_is_the_command(run: Runner, tmp_path: Path, arguments: list[str]) -> None:
    wanted = run(*arguments, cwd=tmp_path)
    got = subprocess.run([launcher(), *arguments], cwd=tmp_path, capture_output=True, text=True)
    assert (got.returncode, got.stdout, got.stderr) == (
        wanted.returncode,
        wanted.stdout,
        wanted.stderr,
    )


def test_launcher_writes_the_same_bytes(command: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    assert subprocess.run([launcher(), SAMPLE, "-o", out, "--quiet"]).returncode == 0
    for file in sorted(command.iterdir()):
        assert (out / file.name).read_bytes() == file.read_bytes(), file.name


# ---- NumPy ----

OLD_NUMPY = """
import json, sys
import numpy as np, tank_datum
points = np.load(sys.argv[1])
print(np.__version__)
print(json.dumps(tank_datum.extract_datum(points).stations["z"].tolist()))
"""


def test_numpy_1(datum: Any, points: Array, tmp_path: Path) -> None:
    """NumPy 1.24, installed beside, sees the same values."""
    pip = [sys.executable, "-m", "pip", "install", "-q", "--no-deps", "--only-binary", ":all:"]
    subprocess.run([*pip, "--target", tmp_path / "old", "numpy==1.24.4"], check=True)
    shutil.copytree(Path(inspect.getfile(tank_datum)).parent, tmp_path / "old" / "tank_datum")
    np.save(tmp_path / "points.npy", points)
    result = subprocess.run(
        [sys.executable, "-c", OLD_NUMPY, tmp_path / "points.npy"],
        env={**os.environ, "PYTHONPATH": str(tmp_path / "old")},
        capture_output=True,
        text=True,
    )
    assert result.returncode == 0, result.stderr
    version, values = result.stdout.splitlines()
    assert version == "1.24.4" and np.__version__.startswith("2.")
    same(np.array(json.loads(values)), datum.stations["z"])
