"""A result has the same bytes on processors with and without fused multiply-add and AVX2: the C
library is told to compute as on one that lacks them."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from conftest import executable
from report_pages import SAMPLE

LACKING = "glibc.cpu.hwcaps=" + ",".join(
    f"-{name}" for name in ("AVX", "AVX2", "AVX2_Usable", "FMA", "FMA_Usable", "FMA4", "AVX512F")
)
LEVELLING = SAMPLE.parent / "levelling/fourteen_stations.csv"
SINES = "import math; print([math.sin(0.001 * i).hex() for i in range(9999)])"


def bytes_of(words: list[object], tunables: str | None = None) -> bytes:
    environment = {k: v for k, v in os.environ.items() if k != "GLIBC_TUNABLES"}
    if tunables:
        environment["GLIBC_TUNABLES"] = tunables
    done = subprocess.run([*map(str, words)], env=environment, capture_output=True, timeout=120)
    assert done.returncode in (0, 1), done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def lacking() -> str:
    sines = [sys.executable, "-c", SINES]
    if bytes_of(sines) == bytes_of(sines, LACKING):
        pytest.skip("the C library computes one way alone: no FMA here, or no glibc")
    return LACKING


@pytest.mark.parametrize(
    "words",
    [
        [SAMPLE],
        [SAMPLE, "--method", "paper", "--search", "buckets"],
        ["--stations-csv", LEVELLING, "--diameter", "36"],
    ],
    ids=["refined", "paper", "levelling"],
)
def test_results_have_the_same_bytes(tmp_path: Path, lacking: str, words: list[object]) -> None:
    for folder, tunables in ("with", None), ("without", lacking):
        program = [executable("tank_datum"), *words, "-o", tmp_path / folder]
        bytes_of([*program, "--quiet"], tunables)
    names = sorted(path.name for path in (tmp_path / "with").iterdir())
    assert "stations.csv" in names
    for name in names:
        assert (tmp_path / "with" / name).read_bytes() == (tmp_path / "without" / name).read_bytes()


def test_a_simulated_scan_has_the_same_bytes(tmp_path: Path, lacking: str) -> None:
    for name, tunables in ("with", None), ("without", lacking):
        tank = [
            "--radius",
            3,
            "--height",
            2,
            "--step-deg",
            1,
            "--harmonics",
            "2:0.004:40",
            "--quiet",
        ]
        bytes_of([executable("tank_datum_synth"), *tank, "-o", tmp_path / f"{name}.pcd"], tunables)
    assert (tmp_path / "with.pcd").read_bytes() == (tmp_path / "without.pcd").read_bytes()
