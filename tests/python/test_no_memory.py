"""Memory and threads that are not to be had: one line, status 3, the old result whole.

In threads of libraries too, where an exception would end the process.
"""

from __future__ import annotations

import os
import resource
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from conftest import executable, run_program
from report_pages import SAMPLE
from results import FOLDER, Run

FILE_FAILED = 3
SAMPLES = 24  # of the calls of operator new of a run, evenly by their logarithm and by their number

# Each writes {out} or below; {result} is a folder of results.
PROGRAMS: dict[str, list[str]] = {
    "tank_datum flann": ["{sample}", "-o", "{out}", "--quiet"],
    "tank_datum buckets": ["{sample}", "-o", "{out}", "--quiet", "--search", "buckets"],
    "tank_datum_compare": ["{result}", "{result}", "-o", "{out}"],
    "tank_datum_convert": ["{sample}", "{out}.pcd", "--quiet"],
    "tank_datum_synth": ["-o", "{out}.pcd", "--radius", "4", "--step-deg", "2", "--quiet"],
}


def words_of(name: str, result: Path, out: Path) -> list[str]:
    words = [w.format(sample=SAMPLE, result=result, out=out) for w in PROGRAMS[name]]
    return [str(executable(name.split()[0])), *words]


def run_failing(words: list[str], at: int, count: Path, on: bool = False) -> Run:
    environment = {
        **os.environ,
        "LD_PRELOAD": str(executable("fail_at_new.so")),
        "TANK_DATUM_FAIL_NEW_AT": str(at),
        "TANK_DATUM_NEW_COUNT_FILE": str(count),
        **({"TANK_DATUM_FAIL_NEW_ON": "1"} if on else {}),
    }
    return subprocess.run(words, env=environment, capture_output=True, text=True, timeout=120)


def chosen(calls: int) -> list[int]:
    half = SAMPLES // 2
    by_size = {int(calls ** (i / half)) for i in range(half)}
    return sorted(by_size | {1 + calls * i // half for i in range(half)})


@pytest.mark.parametrize("on", [False, True], ids=["once", "from there on"])
@pytest.mark.parametrize("name", PROGRAMS)
def test_any_call_for_memory_may_fail(command: Path, tmp_path: Path, name: str, on: bool) -> None:
    out, count = tmp_path / "out", tmp_path / "count"
    words = words_of(name, command, out)
    assert run_failing(words, 0, count).returncode == 0
    calls = int(count.read_text())
    assert calls > 1000
    before = {p: p.read_bytes() for p in tmp_path.rglob("*") if p.is_file() and p != count}
    failed = 0
    for at in chosen(calls):
        done = run_failing(words, at, count, on)
        assert done.returncode in (0, FILE_FAILED), f"call {at}: {done.stderr}"
        if done.returncode == 0:
            continue  # who asked did without
        failed += 1
        assert done.stderr.count("\n") == 1, f"call {at}: {done.stderr}"
        assert done.stderr.startswith(name.split()[0] + ": "), f"call {at}: {done.stderr}"
        assert ", expected " in done.stderr, f"call {at}: {done.stderr}"
        count.unlink(missing_ok=True)
        if on:  # what is being made stays, and the next run removes it
            for left in list(tmp_path.rglob(".tank_datum-*")):
                shutil.rmtree(left)
        after = {p: p.read_bytes() for p in tmp_path.rglob("*") if p.is_file()}
        assert after.keys() == before.keys(), f"call {at}"
        assert after == before, f"call {at}"
    assert failed > SAMPLES // 2


def limited(kind: int, most: int) -> Callable[[], None]:
    return lambda: resource.setrlimit(kind, (most, most))


@pytest.mark.parametrize("megabytes", [50, 70, 90, 120, 200])
def test_little_address_space(tmp_path: Path, megabytes: int) -> None:
    done = subprocess.run(
        words_of("tank_datum flann", tmp_path, tmp_path / "out"),
        preexec_fn=limited(resource.RLIMIT_AS, megabytes << 20),
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert done.returncode in (0, FILE_FAILED), done.stderr
    if done.returncode == FILE_FAILED:
        assert done.stderr.count("\n") == 1, done.stderr
        assert not list(tmp_path.rglob("*.json"))


@pytest.mark.parametrize("megabytes", [100, 400, 12_000])
def test_many_threads_in_little_space(command: Path, tmp_path: Path, megabytes: int) -> None:
    """1024 stacks take 8 GB of addresses: fewer threads do it, or memory ends."""
    out = tmp_path / "out"
    done = subprocess.run(
        [*words_of("tank_datum flann", command, out)[:-1], "--threads", "1024"],
        preexec_fn=limited(resource.RLIMIT_AS, megabytes << 20),
        capture_output=True,
        text=True,
        timeout=120,
    )
    if done.returncode == FILE_FAILED:
        # OpenMP may say so too, in two lines of its own, before it gives up
        assert "tank_datum: " in done.stderr, done.stderr
        assert not list(tmp_path.rglob("*.json"))
        return
    assert done.returncode == 0, done.stderr
    for name in FOLDER:
        assert (out / name).read_bytes() == (command / name).read_bytes(), name


def on_stack(kilobytes: int, most: int, out: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        words_of("tank_datum flann", out.parent, out),
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_STACK, (kilobytes << 10, most)),
        capture_output=True,
        text=True,
        timeout=120,
    )


@pytest.mark.parametrize("kilobytes", [64, 192, 1023])
def test_a_stack_that_is_too_small_is_refused(tmp_path: Path, kilobytes: int) -> None:
    done = on_stack(kilobytes, kilobytes << 10, tmp_path / "out")
    assert done.returncode == FILE_FAILED
    assert f"memory: the stack (ulimit -s), {kilobytes} kB, expected 1024 kB or more" in done.stderr
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("kilobytes", "most"), [(64, resource.RLIM_INFINITY), (64, 1 << 20), (1024, 1 << 20)]
)
def test_a_stack_that_may_grow_grows(
    command: Path, tmp_path: Path, kilobytes: int, most: int
) -> None:
    done = on_stack(kilobytes, most, tmp_path / "out")
    assert done.returncode == 0, done.stderr
    found, expected = (d / "stations.csv" for d in (tmp_path / "out", command))
    assert found.read_bytes() == expected.read_bytes()


def test_more_threads_than_any_machine_has_are_refused(tmp_path: Path) -> None:
    done = run_program("tank_datum", [SAMPLE, "-o", tmp_path / "out", "--threads", "1025"])
    assert done.returncode == 2
    assert "--threads, 1025, expected 0 to 1024" in done.stderr
    shutil.rmtree(tmp_path / "out", ignore_errors=True)
