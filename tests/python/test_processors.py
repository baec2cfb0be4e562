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
INCHES = SAMPLE.parent / "levelling/sixteen_stations_inches.csv"
SCENES = SAMPLE.parents[1] / "scenes"
SINES = "import math; print([math.sin(0.001 * i).hex() for i in range(9999)])"
MODULE = """
import sys, tank_datum
tank_datum.extract_datum(sys.argv[1], threads=2).save(sys.argv[2])
"""


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


def assert_same_files(a: Path, b: Path, wanted: str) -> None:
    names = sorted(path.name for path in a.iterdir())
    assert wanted in names
    assert names == sorted(path.name for path in b.iterdir())
    for name in names:
        assert (a / name).read_bytes() == (b / name).read_bytes(), name


@pytest.mark.parametrize(
    "words",
    [
        [SAMPLE],
        [SAMPLE, "--search", "buckets", "--stations", "72"],
        [SAMPLE, "--method", "paper"],
        [SAMPLE, "--method", "paper", "--search", "buckets"],
        ["--stations-csv", LEVELLING, "--diameter", "36"],
        ["--stations-csv", INCHES, "--diameter", "36", "--display-units", "ft"],
    ],
    ids=["refined", "refined-buckets", "paper", "paper-buckets", "levelling", "inches"],
)
def test_results_have_the_same_bytes(tmp_path: Path, lacking: str, words: list[object]) -> None:
    for folder, tunables in ("with", None), ("without", lacking):
        program = [executable("tank_datum"), *words, "-o", tmp_path / folder]
        bytes_of([*program, "--quiet"], tunables)
    assert_same_files(tmp_path / "with", tmp_path / "without", "stations.csv")


def test_the_module_writes_the_same_bytes(tmp_path: Path, lacking: str) -> None:
    for folder, tunables in ("with", None), ("without", lacking):
        bytes_of([sys.executable, "-c", MODULE, SAMPLE, tmp_path / folder], tunables)
    assert_same_files(tmp_path / "with", tmp_path / "without", "stations.csv")


SURVEYS = {
    "few": ["--radius", 3, "--height", 2, "--step-deg", 1, "--harmonics", "2:0.004:40"],
    "setups": ["--scene", SCENES / "small12.json", "--label-setups"]
    + ["--set", "scanner/step_deg=0.3", "--set", "measurement/mixed_pixels=true"]
    + ["--set", "frame_tilt_deg=0.5", "--setup-sigma-dz", 0.002, "--lobes", 0.01],
}


@pytest.mark.parametrize("survey", SURVEYS)
def test_a_simulated_scan_has_the_same_bytes(tmp_path: Path, lacking: str, survey: str) -> None:
    for name, tunables in ("with", None), ("without", lacking):
        program = [executable("tank_datum_synth"), *SURVEYS[survey], "--quiet"]
        bytes_of([*program, "-o", tmp_path / f"{name}.pcd"], tunables)
    for suffix in "pcd", "truth.json":
        a, b = tmp_path / f"with.{suffix}", tmp_path / f"without.{suffix}"
        assert a.read_bytes() == b.read_bytes()


def test_a_movement_has_the_same_bytes(tmp_path: Path, lacking: str) -> None:
    rows = LEVELLING.read_text().split()
    for survey, sunk in ("first", 0.0), ("second", 0.004):
        lines = [f"{rows[0]},sigma"]
        for number, row in enumerate(rows[1:]):
            azimuth, z = row.split(",")
            lines.append(f"{azimuth},{float(z) - sunk * (number % 5) * (number % 3)},0.0005")
        (tmp_path / f"{survey}.csv").write_text("\n".join(lines))
        level = ["--stations-csv", tmp_path / f"{survey}.csv", "--diameter", "36", "--quiet"]
        bytes_of([executable("tank_datum"), *level, "-o", tmp_path / survey])
    surveys = [tmp_path / "first", tmp_path / "second"]
    for folder, tunables in ("with", None), ("without", lacking):
        bytes_of([executable("tank_datum_compare"), *surveys, "-o", tmp_path / folder], tunables)
    assert_same_files(tmp_path / "with", tmp_path / "without", "movement.csv")


def test_a_report_has_the_same_bytes(tmp_path: Path, lacking: str) -> None:
    bytes_of([executable("tank_datum"), SAMPLE, "-o", tmp_path / "datum", "--quiet"])
    for name, tunables in ("with", None), ("without", lacking):
        program = [executable("tank_datum_report"), tmp_path / "datum", "--picture", "none"]
        bytes_of([*program, "--html", tmp_path / f"{name}.html"], tunables)
    assert (tmp_path / "with.html").read_bytes() == (tmp_path / "without.html").read_bytes()
