"""Stations change as the points of the scan do, within what their sigmas allow, and with no more.

Seeds are fixed; TANK_DATUM_PROPERTY_SEEDS=N tries the first N of them instead of one.
"""

from __future__ import annotations

import os
import subprocess
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import pytest

from conftest import executable, run_program
from report_pages import SAMPLE
from results import FOLDER, Array, read_pcd, read_stations, write_xyz

SEEDS = range(int(os.environ.get("TANK_DATUM_PROPERTY_SEEDS", "1")))
STATIONS = 360
RADIUS = 5.0  # of the sample [m]
Random = np.random.Generator


@dataclass
class Changed:
    """Scans made of the sample's points, and what becomes of its stations."""

    scans: list[Array]
    z: Callable[[Array], Array] = lambda z: z  # from the sample's to the changed
    order: Callable[[Array], Array] = lambda i: i  # the changed station of each of the sample's
    words: list[str] = field(default_factory=list)


def points() -> Array:
    columns = read_pcd(SAMPLE)
    return np.column_stack([columns[n].astype(np.float64) for n in "xyz"])


def turned(random: Random) -> Changed:
    steps = int(random.integers(1, STATIONS))
    angle = 2 * np.pi * steps / STATIONS
    turn = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0]])
    made = points()
    made[:, :2] = made @ turn.T
    return Changed([made], order=lambda i: (i + steps) % STATIONS)


def shifted(_: Random) -> Changed:
    return Changed([points() + [1e5, 4e6, 100.0]], z=lambda z: z + 100.0)


def permuted(random: Random) -> Changed:
    return Changed([random.permutation(points())])


def split(random: Random) -> Changed:
    made = random.permutation(points())
    return Changed(np.array_split(made, 3))


def thinned(random: Random) -> Changed:
    made = points()
    return Changed([made[random.random(len(made)) < 0.7]])


def in_millimetres(_: Random) -> Changed:
    return Changed([points() * 1000.0], words=["--units", "mm"])


def mirrored(_: Random) -> Changed:
    return Changed([points() * [1.0, -1.0, 1.0]], order=lambda i: -i % STATIONS)


def with_far_clutter(random: Random) -> Changed:
    box = random.uniform([60, 60, -1], [63, 64, 4], (2000, 3))
    return Changed([np.vstack([points(), box])])


def with_outliers(random: Random) -> Changed:
    made = points()
    low, high = made.min(axis=0) - 1.0, made.max(axis=0) + 1.0
    noise = random.uniform(low, high, (len(made) // 5, 3))
    return Changed([np.vstack([made, noise])])


def twice(_: Random) -> Changed:
    return Changed([np.vstack([points(), points()])])


def scaled(_: Random) -> Changed:
    return Changed([points() * 1.001], z=lambda z: z * 1.001)


def tilted(random: Random) -> Changed:
    """The whole scan, as by a scanner that is not level: by a milliradian, towards anywhere."""
    slope, towards = 1e-3, random.uniform(0, 2 * np.pi)
    axis = np.array([-np.sin(towards), np.cos(towards), 0.0])
    made = points()
    made = made - np.sin(slope) * np.cross(axis, made)
    azimuths = 2 * np.pi * np.arange(STATIONS) / STATIONS
    rise = RADIUS * np.sin(slope) * np.cos(azimuths - towards)
    return Changed([made], z=lambda z: z + rise)


CHANGES = [
    turned,
    shifted,
    permuted,
    split,
    thinned,
    in_millimetres,
    mirrored,
    with_far_clutter,
    with_outliers,
    twice,
    scaled,
    tilted,
]


@pytest.fixture(scope="module")
def plain(tmp_path_factory: pytest.TempPathFactory) -> tuple[Array, Array]:
    """z and sigma_z of the sample's stations."""
    folder = tmp_path_factory.mktemp("plain")
    return measured(folder, Changed([points()]))


def measured(folder: Path, changed: Changed) -> tuple[Array, Array]:
    scans = [write_xyz(folder / f"scan{i}.pcd", made) for i, made in enumerate(changed.scans)]
    done = run_program("tank_datum", [*scans, "-o", folder / "out", "--quiet", *changed.words])
    assert done.returncode == 0, done.stderr
    stations = read_stations(folder / "out")
    is_measured = stations.where("measured")
    z, sigma = (np.where(is_measured, stations[name], np.nan) for name in ("z", "sigma_z"))
    return z, sigma


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("change", CHANGES, ids=lambda change: change.__name__)
def test_stations_change_as_their_points_do(
    plain: tuple[Array, Array], tmp_path: Path, change: Callable[[Random], Changed], seed: int
) -> None:
    changed = change(np.random.default_rng(seed))
    z, sigma = measured(tmp_path, changed)
    at = changed.order(np.arange(STATIONS))
    both = np.isfinite(plain[0]) & np.isfinite(z[at])
    assert both.sum() > 0.95 * STATIONS
    apart = np.abs(z[at] - changed.z(plain[0]))[both]
    allowed = 3.0 * np.hypot(plain[1], sigma[at])[both]
    assert np.mean(apart <= allowed) >= 0.997, np.sort(apart / allowed)[-10:]


@pytest.mark.parametrize(
    ("words", "counted"),
    [
        (["--clockwise"], lambda i: -i % STATIONS),
        (["--zero-azimuth-deg", "37"], lambda i: (i - 37) % STATIONS),
        (["--clockwise", "--zero-azimuth-deg", "-112"], lambda i: (248 - i) % STATIONS),
    ],
    ids=["clockwise", "turned", "both"],
)
def test_the_way_stations_are_counted_moves_none(
    tmp_path: Path, words: list[str], counted: Callable[[Array], Array]
) -> None:
    # few points, so that stations lean on their neighbours
    few = np.random.default_rng(7).permutation(points())[::6]
    folders = [tmp_path / "plain", tmp_path / "counted"]
    for folder in folders:
        folder.mkdir()
    z, sigma = measured(folders[0], Changed([few]))
    again, sigma_again = measured(folders[1], Changed([few], words=words))
    at = counted(np.arange(STATIONS))
    assert np.isfinite(z).sum() > 0.5 * STATIONS
    np.testing.assert_allclose(again[at], z, atol=1e-9)
    np.testing.assert_allclose(sigma_again[at], sigma, atol=1e-9)


SURROUNDINGS: dict[str, dict[str, str]] = {
    "one thread": {"OMP_NUM_THREADS": "1"},
    "two threads": {"OMP_NUM_THREADS": "2"},
    "locale": {"LC_ALL": "de_DE.UTF-8", "LANG": "de_DE.UTF-8"},
    "no locale": {"LC_ALL": "POSIX"},
    "time zone": {"TZ": "Pacific/Kiritimati"},
    "home": {"HOME": "/nonexistent"},
}


@pytest.mark.parametrize("mask", [0o000, 0o077], ids=["open", "closed"])
@pytest.mark.parametrize("name", SURROUNDINGS)
def test_the_same_bytes_in_any_surroundings(
    command: Path, tmp_path: Path, name: str, mask: int
) -> None:
    folder = tmp_path / "a folder"
    folder.mkdir()
    done = subprocess.run(
        [str(executable("tank_datum")), str(SAMPLE), "-o", "out"],
        cwd=folder,
        env={**os.environ, **SURROUNDINGS[name]},
        umask=mask,
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert done.returncode == 0, done.stderr
    for file in FOLDER:
        assert (folder / "out" / file).read_bytes() == (command / file).read_bytes(), file
