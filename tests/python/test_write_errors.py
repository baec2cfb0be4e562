"""Results are written whole or not at all; an old one is never left beside a failure as if new."""

from __future__ import annotations

import resource
import shutil
import signal
import subprocess
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

import clouds
from conftest import executable, run_program
from results import FOLDER, RESULTS, Run, write_xyz
from test_errors import FILE_FAILED, NO_DATUM, USABLE, WRONG_USE, no_datum, one_line

Runner = Callable[..., Run]


@pytest.fixture(scope="module")
def scan(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_xyz(tmp_path_factory.mktemp("tank") / "tank.pcd", clouds.tank())


@pytest.fixture(scope="module")
def tank_free(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_xyz(tmp_path_factory.mktemp("floor") / "floor.pcd", clouds.floor())


def names(folder: Path) -> list[str]:
    return sorted(str(p.relative_to(folder)) for p in folder.rglob("*") if p.is_file())


@pytest.mark.parametrize("place", ["below a file", "/proc"])
def test_folder_that_cannot_be_made(run: Runner, scan: Path, tmp_path: Path, place: str) -> None:
    """Refused to every user, root too."""
    (tmp_path / "file").write_text("here first")
    out = Path("/proc/tank_datum/out") if place == "/proc" else tmp_path / "file" / "out"
    result = run(scan, "-o", out)
    assert result.returncode == FILE_FAILED
    assert result.stdout == ""
    one_line(result, "report", str(out), "expected")
    assert names(tmp_path) == ["file"]


def test_output_is_a_file(run: Runner, scan: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    out.write_text("here first")
    result = run(scan, "-o", out)
    assert result.returncode == FILE_FAILED
    one_line(result, "report", "expected")
    assert out.read_text() == "here first"


@pytest.fixture
def small_disk(tmp_path: Path) -> Iterator[Path]:
    """A file system of 64 kB."""
    disk = tmp_path / "disk"
    disk.mkdir()
    made = subprocess.run(
        ["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", str(disk)], capture_output=True
    )
    if made.returncode != 0:
        pytest.skip("a small tmpfs needs the right to mount; the file size limit is tested besides")
    yield disk
    subprocess.run(["umount", str(disk)], check=True)


def test_full_disk(run: Runner, scan: Path, small_disk: Path) -> None:
    out = small_disk / "out"
    result = run(scan, "-o", out)
    assert result.returncode == FILE_FAILED
    assert result.stdout == ""
    one_line(result, "No space", "expected")
    assert ".tank_datum-" not in result.stderr
    assert names(small_disk) == []


def run_limited(words: list[object], kind: int, most: int) -> Run:
    return subprocess.run(
        [str(w) for w in words],
        preexec_fn=lambda: resource.setrlimit(kind, (most, most)),
        capture_output=True,
        text=True,
        timeout=60,
    )


def test_file_size_limit(scan: Path, tmp_path: Path) -> None:
    """ulimit -f: a write beyond it fails as on a full disk."""
    words = [executable("tank_datum"), scan, "-o", tmp_path / "out"]
    result = run_limited(words, resource.RLIMIT_FSIZE, 8192)
    assert result.returncode == FILE_FAILED
    one_line(result, "report", "File too large", "expected")
    assert names(tmp_path) == []


@pytest.mark.parametrize("most", range(4, 12))
def test_few_open_files(scan: Path, tmp_path: Path, most: int) -> None:
    """ulimit -n: enough, or one line and nothing left behind."""
    words = [executable("tank_datum"), scan, "-o", tmp_path / "out", "--quiet"]
    result = run_limited(words, resource.RLIMIT_NOFILE, most)
    if result.returncode == USABLE:
        assert names(tmp_path / "out") == sorted(FOLDER)
        return
    assert result.returncode in (FILE_FAILED, 127), result.stderr  # 127: not even the libraries
    if result.returncode == FILE_FAILED:
        one_line(result, "Too many open files", "expected")
        assert names(tmp_path) == []


def test_two_runs_into_one_folder_at_once(scan: Path, tmp_path: Path) -> None:
    """Each ends with its own whole result there, or is refused with a line."""
    out, alone = tmp_path / "out", tmp_path / "alone"
    assert run_program("tank_datum", [scan, "-o", alone]).returncode == USABLE
    words = [str(executable("tank_datum")), str(scan), "-o", str(out), "--quiet"]
    for _ in range(4):
        both = [subprocess.Popen(words, stderr=subprocess.PIPE, text=True) for _ in range(2)]
        said = [process.communicate(timeout=60)[1] for process in both]
        assert USABLE in [process.returncode for process in both], said
        for process, line in zip(both, said, strict=True):
            assert process.returncode == USABLE or line.count("\n") == 1, said
        assert names(out) == sorted(FOLDER)
        assert contents(out) == contents(alone)


def test_timings_not_writable(run: Runner, scan: Path, tmp_path: Path) -> None:
    for place in ("/dev/full", tmp_path / "none" / "t.json"):
        out = tmp_path / "out"
        result = run(scan, "-o", out, "--timings", place)
        assert result.returncode == FILE_FAILED
        one_line(result, str(place), "expected")


def test_full_stdout(scan: Path, tmp_path: Path) -> None:
    """A summary that cannot be written is a file that cannot be written."""
    with Path("/dev/full").open("w") as full:
        result = subprocess.run(
            [str(executable("tank_datum")), str(scan), "-o", str(tmp_path / "out")],
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            timeout=60,
        )
    assert result.returncode == FILE_FAILED
    assert result.stderr.startswith("tank_datum: ")


FAILURES: dict[str, tuple[list[str], int]] = {
    "file missing": (["{folder}/none.pcd"], FILE_FAILED),
    "option refused by its stage": (["{scan}", "--k", "2"], WRONG_USE),
}
WRONG_WORDS = [["--frobnicate"], ["--method", "best"], ["--tank", "a,b,c"], ["--k", "x"]]


@pytest.fixture(scope="module")
def finished(scan: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("finished") / "out"
    assert run_program("tank_datum", [scan, "-o", out]).returncode == USABLE
    return out


def contents(folder: Path) -> dict[str, bytes]:
    return {n: (folder / n).read_bytes() for n in FOLDER}


@pytest.mark.parametrize("name", FAILURES)
def test_old_result_stays(
    run: Runner, scan: Path, finished: Path, tmp_path: Path, name: str
) -> None:
    """A run that began and failed leaves the old result as it was, and says that it is old."""
    out = Path(shutil.copytree(finished, tmp_path / "out"))
    args, status = FAILURES[name]
    words = [a.format(folder=tmp_path, scan=scan) for a in args]
    result = run(*words, "-o", out)
    assert result.returncode == status
    one_line(result, f"; {out} holds the results of an earlier run, unchanged")
    assert names(out) == sorted(FOLDER)
    assert contents(out) == contents(finished)


@pytest.mark.parametrize("words", WRONG_WORDS, ids=" ".join)
def test_wrong_use_touches_nothing(
    run: Runner, scan: Path, finished: Path, tmp_path: Path, words: list[str]
) -> None:
    """A command line that cannot be understood begins no run: the old result stays where it is."""
    out = Path(shutil.copytree(finished, tmp_path / "out"))
    assert run(scan, "-o", out, *words).returncode == WRONG_USE
    assert names(out) == sorted(FOLDER)
    assert contents(out) == contents(finished)


def test_result_without_datum_replaces_an_old_one(
    run: Runner, scan: Path, tank_free: Path, tmp_path: Path
) -> None:
    out = tmp_path / "out"
    assert run(scan, "-o", out).returncode == USABLE
    no_datum(run(tank_free, "-o", out), out, "no_tank")


def test_other_files_in_the_folder_stay(run: Runner, scan: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    out.mkdir()
    (out / "notes.txt").write_text("mine")
    assert run(scan, "-o", out).returncode == USABLE
    assert run(tmp_path / "none.pcd", "-o", out).returncode == FILE_FAILED
    assert (out / "notes.txt").read_text() == "mine"


def test_stopped_by_the_user(scan: Path, tmp_path: Path) -> None:
    """Control-C or a kill leaves nothing that looks like a result."""
    for number in (signal.SIGINT, signal.SIGTERM):
        out = tmp_path / f"out{number}"
        process = subprocess.Popen(
            [str(executable("tank_datum")), str(scan), "-o", str(out)],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        time.sleep(0.02)
        process.send_signal(number)
        process.wait(timeout=30)
        assert process.returncode in (0, -number, 128 + number)
        if process.returncode != 0:
            assert not any((out / n).exists() for n in RESULTS)


def test_synth_refuses_too(tmp_path: Path) -> None:
    result = run_program("tank_datum_synth", ["-o", tmp_path / "s.pcd", "--radius", "-1"])
    assert result.returncode == WRONG_USE
    assert result.stderr.startswith("tank_datum_synth: ")
    assert len(result.stderr.splitlines()) == 1
    result = run_program("tank_datum_synth", ["-o", tmp_path / "none" / "s.pcd", "--radius", "4"])
    assert result.returncode == FILE_FAILED
    assert names(tmp_path) == []
    assert NO_DATUM == 1
