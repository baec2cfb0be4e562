"""Broken files of E57 and LAZ, packages that are missing, runs that are given up."""

# ruff: noqa: F811  fixtures are imported
from __future__ import annotations

import resource
import signal
import struct
import subprocess
import time
from collections.abc import Callable
from pathlib import Path

import laspy
import numpy as np
import pye57
import pytest

from foreign_fixtures import (  # noqa: F401
    NAMES,
    e57,
    installed,
    jittered,
    launcher,
    laz,
    scan,
)
from format_writers import Setups, write_e57
from programs import TIMEOUT
from results import Array, Run

tank_datum = pytest.importorskip("tank_datum", reason="the module is not installed")

Runner = Callable[..., Run]
INSTALL = "pip install 'tank_datum[formats]'"


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


def test_layers_of_laz_beyond_their_chunk(laz: Path, installed: Runner, tmp_path: Path) -> None:
    """lazrs would claim what memory they say."""
    whole = bytearray(laz.read_bytes())
    (data,) = struct.unpack_from("<I", whole, 96)
    for layer in range(9):
        broken = whole.copy()
        struct.pack_into("<I", broken, data + 8 + 30 + 4 + 4 * layer, 1 << 31)
        (tmp_path / "broken").write_bytes(broken)
        with pytest.raises(tank_datum.FileError, match="LASzip layers of chunk 0 of"):
            tank_datum.extract_datum(tmp_path / "broken")
    line = refused(installed(tmp_path / "broken", "-o", tmp_path / "out"), tmp_path / "out")
    assert "bytes, expected at most" in line


def test_chunks_of_laz_of_two_thousand_million_rows(tmp_path: Path) -> None:
    """As the record of LASzip says they are: nothing is claimed for rows that are not there."""
    header = laspy.LasHeader(version="1.4", point_format=6)
    cloud = laspy.LasData(header)
    cloud.x, cloud.y, cloud.z = np.random.default_rng(1).random((3, 300))
    cloud.write(tmp_path / "small.laz")
    whole = bytearray((tmp_path / "small.laz").read_bytes())
    at = whole.index(b"laszip encoded") + 52  # behind its user id and the rest of its head
    struct.pack_into("<I", whole, at + 12, 1 << 31)
    (tmp_path / "small.laz").write_bytes(whole)
    words = [launcher().with_name("tank_datum_convert"), tmp_path / "small.laz", tmp_path / "c.pcd"]
    made = subprocess.run(
        words,
        capture_output=True,
        text=True,
        timeout=TIMEOUT,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (8 << 30, 8 << 30)),
    )
    assert made.returncode == 0, made.stderr
    assert made.stdout.startswith("300 points of ")


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
