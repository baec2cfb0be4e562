"""tank_datum_convert: a copy of any format gives the same datum, to the last bit."""

# ruff: noqa: F811  fixtures are imported
from __future__ import annotations

import resource
import signal
import subprocess
from pathlib import Path

import numpy as np
import pytest

from foreign_fixtures import NAMES, e57, jittered, launcher, laz  # noqa: F401
from format_writers import WRITERS, Setups, write_ptx
from programs import TIMEOUT, executable, run_program
from results import Run, read_datum, read_pcd, read_stations
from test_formats import Runner, scan  # noqa: F401

BITS = ("stations.csv", "shell.csv", "datum_points.pcd", "datum_curve.pcd", "datum_nodes.csv")


def convert(*arguments: object) -> Run:
    return run_program("tank_datum_convert", arguments)


def assert_same_results(out: Path, other: Path) -> None:
    """All files but what datum.json says of the files that went in."""
    for name in BITS:
        assert (out / name).read_bytes() == (other / name).read_bytes(), name
    one, two = read_datum(out), read_datum(other)
    for datum in (one, two):
        for key in ("files", "invalid_points", "left_out_points"):
            del datum["input"][key]
    assert one == two


@pytest.mark.parametrize("name", [*WRITERS, "ptx"])
def test_copy_gives_the_same_datum(name: str, scan: Setups, run: Runner, tmp_path: Path) -> None:
    """Setups with their names and places, in a map's frame; results bit for bit."""
    path = {**WRITERS, "ptx": write_ptx}[name](tmp_path / "scan.dat", scan)
    made = convert(path, tmp_path / "copy.pcd")
    assert made.returncode == 0, made.stderr
    assert made.stdout.startswith(f"{len(scan.all())} points of ")
    for scan_path, out in ((path, "original"), (tmp_path / "copy.pcd", "copy")):
        assert run(scan_path, "-o", tmp_path / out, "--no-report").returncode == 0
    assert_same_results(tmp_path / "original", tmp_path / "copy")
    setups = read_datum(tmp_path / "copy")["setups"]
    assert len(setups) == 3
    columns = read_pcd(tmp_path / "copy.pcd")
    assert columns["x"].dtype == columns["y"].dtype == np.float64
    assert np.abs(columns["x"]).max() < 200  # of a map's frame at 300 km


@pytest.mark.parametrize("kind", ["e57", "laz"])
def test_copy_of_foreign_formats(
    kind: str, request: pytest.FixtureRequest, run: Runner, tmp_path: Path
) -> None:
    """Through the installed command; what it writes the executable reads."""
    path = request.getfixturevalue(kind)
    words = [launcher().with_name("tank_datum_convert"), path, tmp_path / "copy.pcd"]
    made = subprocess.run(words, capture_output=True, text=True, timeout=TIMEOUT)
    assert made.returncode == 0, made.stderr
    words = [launcher(), path, "-o", tmp_path / "original", "--no-report"]
    assert subprocess.run(words, capture_output=True, timeout=TIMEOUT).returncode == 0
    assert run(tmp_path / "copy.pcd", "-o", tmp_path / "copy", "--no-report").returncode == 0
    assert_same_results(tmp_path / "original", tmp_path / "copy")
    names = [setup["name"] for setup in read_datum(tmp_path / "copy")["setups"]]
    assert names == (list(NAMES) if kind == "e57" else ["scan", "1", "2"])


def test_several_files_are_setups_of_one(scan: Setups, run: Runner, tmp_path: Path) -> None:
    single = [Setups([points], [np.zeros(3)]) for points in scan.points]
    files = [
        WRITERS[name](tmp_path / f"{name}.dat", setup)
        for name, setup in zip(("las_1.2", "ply_big", "csv"), single, strict=True)
    ]
    assert convert(*files, tmp_path / "copy.pcd").returncode == 0
    assert run(*files, "-o", tmp_path / "original", "--no-report").returncode == 0
    assert run(tmp_path / "copy.pcd", "-o", tmp_path / "copy", "--no-report").returncode == 0
    assert_same_results(tmp_path / "original", tmp_path / "copy")


def test_units_and_a_choice_of_setups(scan: Setups, run: Runner, tmp_path: Path) -> None:
    """The copy is in metres."""
    path = WRITERS["las_1.4"](tmp_path / "scan.las", scan)
    for words in (["--units", "ft", "--setups", "1,2"], ["--las-classes", "0"]):
        out = tmp_path / words[0].strip("-")
        made = convert(path, out.with_suffix(".pcd"), *words, "--quiet")
        assert (made.returncode, made.stdout) == (0, "")
        more = ["--min-radius", "0.5", "--no-report"]  # a tank of 4 feet
        assert run(path, "-o", out / "original", *words, *more).returncode == 0
        assert run(out.with_suffix(".pcd"), "-o", out / "copy", *more).returncode == 0
        for name in BITS:
            assert (out / "original" / name).read_bytes() == (out / "copy" / name).read_bytes()


def test_ring_alone(scan: Setups, run: Runner, tmp_path: Path) -> None:
    """The points near the foot; the stations are the scan's but for how it is located."""
    path = WRITERS["ply_little"](tmp_path / "scan.ply", scan)
    assert convert(path, tmp_path / "ring.pcd", "--ring").returncode == 0
    assert run(path, "-o", tmp_path / "original", "--no-report").returncode == 0
    columns = read_pcd(tmp_path / "ring.pcd")
    assert 0.05 * len(scan.all()) < len(columns["x"]) < 0.9 * len(scan.all())
    assert run(tmp_path / "ring.pcd", "-o", tmp_path / "ring", "--no-report").returncode == 0
    one, two = read_stations(tmp_path / "original"), read_stations(tmp_path / "ring")
    both = [a == b == "measured" for a, b in zip(one.flag, two.flag, strict=True)]
    assert sum(both) > 0.95 * one.flag.count("measured") > 200
    apart = (np.abs(one["z"] - two["z"]) / one["sigma_z"])[both]
    assert np.median(apart) < 0.01
    assert apart.max() < 1


def test_ring_of_no_tank(run: Runner, tmp_path: Path) -> None:
    np.savetxt(tmp_path / "scan.xyz", np.random.default_rng(1).uniform(0, 9, (5000, 3)))
    made = convert(tmp_path / "scan.xyz", tmp_path / "ring.pcd", "--ring")
    assert made.returncode == 1
    assert made.stderr == (
        "tank_datum_convert: no_tank: only 0 found, and the ring of tank 1 is wanted\n"
    )
    assert [p.name for p in tmp_path.iterdir()] == ["scan.xyz"]


def test_options_of_the_tank_without_its_ring(tmp_path: Path) -> None:
    """A copy of all points knows no tank."""
    for option, value in (("--tank", "0,0,5"), ("--pick", "1"), ("--min-radius", "2")):
        made = convert(tmp_path / "scan.xyz", tmp_path / "copy.pcd", option, value)
        assert made.returncode == 2
        assert f"command line: {option} requires --ring" in made.stderr


# ---- nothing half-written ----


def test_files_that_cannot_be_read_leave_nothing(scan: Setups, tmp_path: Path) -> None:
    path = WRITERS["csv"](tmp_path / "scan.csv", scan)
    whole = path.read_bytes()
    path.write_bytes(whole[: whole.index(b"\n", len(whole) // 2) + 1] + b"0,1,x,3\n")
    made = convert(path, tmp_path / "copy.pcd")
    assert made.returncode == 3
    assert made.stderr.count("\n") == 1 and "expected a number" in made.stderr
    assert [p.name for p in tmp_path.iterdir()] == ["scan.csv"]


def test_a_disk_that_is_full_leaves_nothing(scan: Setups, tmp_path: Path) -> None:
    path = WRITERS["ply_little"](tmp_path / "scan.ply", scan)
    most = len(scan.all()) * 20  # bytes of a file: less than the copy's 28 a point

    def limit() -> None:
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))

    words = [executable("tank_datum_convert"), path, tmp_path / "copy.pcd"]
    made = subprocess.run(
        words, capture_output=True, text=True, timeout=TIMEOUT, preexec_fn=limit, check=False
    )
    assert (made.returncode, made.stderr.count("\n")) == (3, 1)
    assert "copy.pcd, File too large, expected" in made.stderr
    assert [p.name for p in tmp_path.iterdir()] == ["scan.ply"]


@pytest.mark.parametrize(
    ("words", "status", "said"),
    [
        (["{scan}"], 2, "2"),
        (["{scan}", "{scan}"], 2, "scan"),
        (["{folder}/none", "{folder}/copy.pcd"], 3, "none"),
        (["{scan}", "{folder}"], 3, "folder"),
        (["{scan}", "{folder}/no/copy.pcd"], 3, "copy.pcd"),
        (["{scan}", "{folder}/copy.pcd", "--units", "mile"], 2, "--units"),
        (["{scan}", "{folder}/copy.pcd", "--setups", "west"], 2, "west"),
        (["{scan}", "{folder}/copy.pcd", "--method", "paper"], 2, "--method"),
    ],
    ids=["no copy", "itself", "none", "folder", "no folder", "units", "setups", "other option"],
)
def test_wrong_use(words: list[str], status: int, said: str, tmp_path: Path) -> None:
    path = tmp_path / "scan.xyz"
    path.write_text("1 2 3\n4 5 6\n")
    made = convert(*[word.format(scan=path, folder=tmp_path) for word in words])
    assert made.returncode == status
    assert made.stderr.count("\n") == 1
    assert made.stderr.startswith("tank_datum_convert: ") and said in made.stderr
    assert path.read_text() == "1 2 3\n4 5 6\n"
    assert [p.name for p in tmp_path.iterdir()] == ["scan.xyz"]


def test_replaces_its_own_and_keeps_what_is_somebody_elses(tmp_path: Path) -> None:
    path, copy = tmp_path / "scan.xyz", tmp_path / "copy.pcd"
    path.write_text("1 2 3\n4 5 6\n")
    copy.write_text("mine")
    for _ in range(2):
        assert convert(path, copy).returncode == 0
    assert (tmp_path / "copy.kept.pcd").read_text() == "mine"
    assert sorted(p.name for p in tmp_path.iterdir()) == ["copy.kept.pcd", "copy.pcd", "scan.xyz"]
