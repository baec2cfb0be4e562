"""Points far from the tank, and floats of a damaged block: neither the datum nor the memory follows
them, and where the tank is given neither.
"""

from __future__ import annotations

import os
import resource
import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from conftest import executable
from report_pages import SAMPLE
from results import Array, read_datum, read_pcd, write_xyz

MAP = np.array([512034.25, 4012877.5, 100.0])  # of a georeferenced scan [m]


def points() -> Array:
    columns = read_pcd(SAMPLE)
    return np.column_stack([columns[n].astype(np.float64) for n in "xyz"])


def damaged(count: int) -> Array:
    """The sample with random bytes over `count` of its rows."""
    made, random = points(), np.random.default_rng(21)
    bits = random.integers(0, 2**32, (count, 3), dtype=np.uint32)
    with np.errstate(invalid="ignore"):
        made[5000 : 5000 + count] = bits.view(np.float32)
    return made


def with_rows(place: int, rows: list[list[float]]) -> Array:
    made = points()
    return np.vstack([made[:place], rows, made[place:]])


# Each with how far its datum may be from the sample's [m], by what is lost of the tank itself.
CLOUDS: dict[str, tuple[Callable[[], Array], float]] = {
    "one point 1 km away": (lambda: with_rows(9000, [[1e3, 0, 0]]), 0.0),
    "one point 1e9 m away": (lambda: with_rows(9000, [[1e9, 0, 0]]), 0.0),
    "the first point 1e9 m away": (lambda: with_rows(0, [[1e9, 0, 0]]), 0.0),
    "one point 1e9 m above the shell": (lambda: with_rows(9000, [[4.9, 0, 1e9]]), 0.0),
    "one point beyond every integer": (lambda: with_rows(9000, [[1e300, -1e300, 1e300]]), 0.0),
    "300 rows of random bytes": (lambda: damaged(300), 5e-5),
    "a third of random bytes": (lambda: damaged(9000), 3e-3),
    "no returns in a map's frame": (
        lambda: np.vstack([np.zeros((3000, 3)), points() + MAP]),
        1e-6,
    ),
}


@pytest.fixture(scope="module")
def plain(tmp_path_factory: pytest.TempPathFactory) -> dict[str, tuple[float, int]]:
    """Mean datum and peak memory of the sample alone, with and without its tank."""
    folder = tmp_path_factory.mktemp("plain")
    scan = write_xyz(folder / "scan.pcd", points())
    return {tank: measured(scan, folder / "out", tank) for tank in ("", "0,0,5")}


def within_limits() -> None:
    resource.setrlimit(resource.RLIMIT_CPU, (60, 60))
    resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))


def measured(scan: Path, out: Path, tank: str, *more: str) -> tuple[float, int]:
    words = [str(executable("tank_datum")), str(scan), "-o", str(out), "--quiet", *more]
    process = subprocess.Popen(
        [*words, *(["--tank", tank] if tank else [])],
        stderr=subprocess.PIPE,
        preexec_fn=within_limits,
    )
    assert process.stderr
    said = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = status
    assert status == 0, said
    return read_datum(out)["datum"]["mean"], usage.ru_maxrss


@pytest.mark.parametrize("tank", ["", "0,0,5"], ids=["searched", "given"])
@pytest.mark.parametrize("name", CLOUDS)
def test_neither_datum_nor_memory_follows(
    plain: dict[str, tuple[float, int]], tmp_path: Path, name: str, tank: str
) -> None:
    make, apart = CLOUDS[name]
    made, shift = make(), MAP if "map" in name else np.zeros(3)
    given = ",".join(f"{v}" for v in (*shift[:2], 5)) if tank else ""
    mean, peak = measured(write_xyz(tmp_path / "scan.pcd", made), tmp_path / "out", given)
    expected, least = plain[tank]
    assert mean - shift[2] == pytest.approx(expected, abs=max(apart, 1e-12))
    assert peak < 1.1 * least + 4096  # kB; what the allocator rounds up


@pytest.mark.parametrize("scale", [1e-6, 1e6])
def test_memory_does_not_follow_the_unit(
    plain: dict[str, tuple[float, int]], tmp_path: Path, scale: float
) -> None:
    """The sample as if its unit were another one than it says."""
    scan = write_xyz(tmp_path / "scan.pcd", scale * points())
    mean, peak = measured(scan, tmp_path / "out", "", "--min-radius", str(scale))
    expected, least = plain[""]
    assert mean == pytest.approx(scale * expected, abs=1e-3 * scale)
    assert peak < 1.5 * least


@pytest.mark.parametrize(
    ("made", "far", "invalid"),
    [
        pytest.param(lambda: with_rows(9000, [[1e9, 0, 0], [0, 400, 0]]), 1, 0, id="far"),
        pytest.param(lambda: with_rows(9000, [[0, 0, 600], [0, 0, 0]]), 2, 0, id="high_and_zero"),
        pytest.param(lambda: with_rows(9000, [[np.nan, 0, 0]]), 0, 1, id="not_finite"),
        pytest.param(points, 0, 0, id="none"),
    ],
)
def test_rows_passed_over_are_counted(
    tmp_path: Path, made: Callable[[], Array], far: int, invalid: int
) -> None:
    """The sample's radius is 5 m: 500 m from it is far."""
    scan = write_xyz(tmp_path / "scan.pcd", made())
    words = [executable("tank_datum"), scan, "-o", tmp_path / "out"]
    said = subprocess.check_output([*map(str, words)], text=True)
    given = read_datum(tmp_path / "out")["input"]
    assert (given["far_points"], given["invalid_points"]) == (far, invalid)
    lines = [line for line in said.splitlines() if line.startswith("passed over")]
    assert len(lines) == (far + invalid > 0)
    if lines:
        assert f"{max(far, invalid)} " in lines[0]
        assert lines[0].endswith(f"of {given['files'][0]['points']} rows")
