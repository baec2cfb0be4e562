"""What goes wrong ends in one line and a status; never in a crash, a hang or a new result."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import clouds
from conftest import ROOT
from results import Array, Run, read_datum, read_pcd, write_pcd, write_xyz

USABLE, NO_DATUM, WRONG_USE, FILE_FAILED = 0, 1, 2, 3

Runner = Callable[..., Run]
Synth = Callable[..., Path]


def one_line(result: Run, *words: str) -> str:
    """The reason: one line `tank_datum: stage: what, value, expected ...` that has these words."""
    lines = result.stderr.splitlines()
    assert len(lines) == 1, result.stderr
    line = lines[0]
    assert line.startswith("tank_datum: "), line
    assert line.count(": ") >= 2, line
    for word in words:
        assert word in line, line
    return line


def refused(result: Run, status: int, folder: Path, *words: str) -> str:
    """Refused before there is a result: status, one line, and an output folder without files."""
    assert result.returncode == status, (result.returncode, result.stderr)
    assert result.stdout == ""
    assert not folder.exists() or list(folder.iterdir()) == []
    return one_line(result, *words)


def no_datum(result: Run, folder: Path, *statuses: str) -> None:
    """The data hold no datum: results are written, say why, and hold no station."""
    assert result.returncode == NO_DATUM, (result.returncode, result.stderr)
    datum = read_datum(folder)
    assert datum["status"] in statuses
    assert datum["message"]
    # the record says "option up x", the command's own line "--up x"
    one_line(result, datum["status"], datum["message"].replace("option up ", "--up "))
    assert sorted(p.name for p in folder.iterdir()) == [
        "datum.json",
        "manifest.json",
        "report.html",
        "shell.csv",
        "stations.csv",
    ]
    assert (folder / "stations.csv").read_text().count("\n") == 1
    assert not {"datum", "tilt", "antipodal"} & datum.keys()


# ---- files ----


def scan_bytes(points: Array) -> bytes:
    header = (
        "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
        f"WIDTH {len(points)}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {len(points)}\n"
        "DATA binary\n"
    )
    return header.encode() + points.astype("<f4").tobytes()


GOOD = scan_bytes(clouds.floor(count=1000))
BAD_FILES: dict[str, tuple[bytes, str]] = {
    "empty": (b"", "header"),
    "cut in the header": (GOOD[:60], "header"),
    "cut before DATA": (GOOD[: GOOD.index(b"DATA")], "DATA"),
    "no data at all": (GOOD[: GOOD.index(b"binary\n") + 7], "bytes"),
    "cut in the data": (GOOD[:-5000], "bytes"),
    "more points than bytes": (
        GOOD.replace(b"POINTS 1000", b"POINTS 9999").replace(b"WIDTH 1000", b"WIDTH 9999"),
        "bytes",
    ),
    "WIDTH against POINTS": (GOOD.replace(b"WIDTH 1000", b"WIDTH 900"), "POINTS"),
    "points beyond any file": (GOOD.replace(b" 1000\n", b" 999999999999999999\n"), ""),
    "negative points": (GOOD.replace(b"POINTS 1000", b"POINTS -1"), "POINTS"),
    "unknown type": (GOOD.replace(b"TYPE F F F", b"TYPE F F Q"), "Q"),
    "unknown size": (GOOD.replace(b"SIZE 4 4 4", b"SIZE 4 4 3"), "3"),
    "fewer sizes than fields": (GOOD.replace(b"SIZE 4 4 4", b"SIZE 4 4"), "SIZE"),
    "unknown data": (GOOD.replace(b"DATA binary", b"DATA packed"), "packed"),
    "no z": (GOOD.replace(b"FIELDS x y z", b"FIELDS x y w"), "z"),
    "no x, y, z": (GOOD.replace(b"FIELDS x y z", b"FIELDS a b c"), "x"),
    "text": (b"not a point cloud\n" * 50, ""),
    "compressed nonsense": (GOOD.replace(b"DATA binary\n", b"DATA binary_compressed\n"), ""),
    "ascii with a word": (
        GOOD[: GOOD.index(b"DATA")] + b"DATA ascii\n" + b"1 2 abc\n" * 1000,
        "abc",
    ),
    "ascii too short": (GOOD[: GOOD.index(b"DATA")] + b"DATA ascii\n" + b"1 2 3\n" * 10, "10"),
}


@pytest.mark.parametrize("name", BAD_FILES)
def test_bad_file(run: Runner, tmp_path: Path, name: str) -> None:
    content, word = BAD_FILES[name]
    scan = tmp_path / "scan.pcd"
    scan.write_bytes(content)
    result = run(scan, "-o", tmp_path / "out", timeout=20)
    refused(result, FILE_FAILED, tmp_path / "out", "scan.pcd", "expected", word)


def test_missing_file_and_folder_as_file(run: Runner, tmp_path: Path) -> None:
    result = run(tmp_path / "none.pcd", "-o", tmp_path / "out")
    refused(result, FILE_FAILED, tmp_path / "out", "none.pcd", "expected")
    result = run(tmp_path, "-o", tmp_path / "out")
    refused(result, FILE_FAILED, tmp_path / "out", str(tmp_path), "expected")


def test_second_of_several_files_is_bad(run: Runner, tmp_path: Path) -> None:
    good = write_xyz(tmp_path / "good.pcd", clouds.tank())
    bad = tmp_path / "bad.pcd"
    bad.write_bytes(GOOD[:-5000])
    refused(run(good, bad, "-o", tmp_path / "out"), FILE_FAILED, tmp_path / "out", "bad.pcd")


# ---- data ----

NAN = float("nan")
CLOUDS: dict[str, tuple[Array, tuple[str, ...]]] = {
    "all NaN": (np.full((500, 3), NAN), ("too_few_points",)),
    "one point": (np.zeros((1, 3)), ("too_few_points",)),
    "three points": (np.eye(3), ("too_few_points",)),
    "one point 5000 times": (np.full((5000, 3), 7.0), ("no_tank",)),
    "collinear": (clouds.collinear(), ("no_tank",)),
    "vertical line": (clouds.collinear() * [0.0, 0.0, 1.0], ("no_tank",)),
    "flat floor": (clouds.floor(), ("no_tank",)),
    "box room": (clouds.box_room(), ("no_tank",)),
    "infinite": (np.vstack([np.full((9, 3), np.inf), clouds.floor(count=5000)]), ("no_tank",)),
    "huge": (clouds.floor(count=5000) * 1e300, ("no_tank",)),
    "shell without floor": (clouds.tank()[clouds.tank()[:, 2] > 0.6], ("no_crease",)),
}


@pytest.mark.parametrize("method", ["refined", "paper"])
@pytest.mark.parametrize("name", CLOUDS)
def test_no_datum(run: Runner, tmp_path: Path, name: str, method: str) -> None:
    points, statuses = CLOUDS[name]
    scan = write_xyz(tmp_path / "scan.pcd", points)
    no_datum(run(scan, "-o", tmp_path / "out", "--method", method), tmp_path / "out", *statuses)


def test_given_tank_where_there_is_none(run: Runner, tmp_path: Path) -> None:
    scan = write_xyz(tmp_path / "scan.pcd", clouds.floor())
    out = tmp_path / "out"
    no_datum(run(scan, "-o", out, "--tank", "0,0,4"), out, "no_tank", "no_crease")
    far = run(scan, "-o", out, "--tank", "90,0,8")
    no_datum(far, out, "no_tank")
    assert "the scan shows no shell on the given circle, of radius 8 m" in far.stderr


def test_zero_points(run: Runner, tmp_path: Path) -> None:
    scan = write_xyz(tmp_path / "scan.pcd", np.empty((0, 3)))
    no_datum(run(scan, "-o", tmp_path / "out"), tmp_path / "out", "too_few_points")


def test_k_larger_than_the_cloud(run: Runner, tmp_path: Path) -> None:
    scan = write_xyz(tmp_path / "scan.pcd", clouds.tank(spacing=0.05))
    out = tmp_path / "out"
    no_datum(run(scan, "-o", out, "--k", 100_000), out, "too_few_points")


# ---- options ----

BAD_OPTIONS: list[tuple[str, str, str]] = [
    *[("--k", v, "k") for v in ("2", "0", "-5", "nan", "x", "1e3", "99999999999")],
    *[("--angle-deg", v, "angle") for v in ("0", "90", "-1", "nan", "inf", "x")],
    *[("--centre-tolerance", v, "tolerance") for v in ("-1", "nan", "inf")],
    *[("--control-points", v, "control") for v in ("3", "-1", "nan")],
    *[("--stations", v, "stations") for v in ("0", "-3", "7", "nan", "99999999999")],
    *[("--zero-azimuth-deg", v, "zero") for v in ("nan", "inf")],
    *[("--min-radius", v, "radius") for v in ("0", "-1", "nan", "inf")],
    *[("--threads", v, "threads") for v in ("-1", "nan", "1.5", "1025", "100000")],
    *[("--heights", v, "heights") for v in ("0.3,101", "0.3,1e9", "nan", "-1", "0")],
    *[("--pick", v, "pick") for v in ("0", "-1", "nan")],
    *[("--search-points", v, "search") for v in ("0", "-1", "nan")],
    *[("--fit-points", v, "fit") for v in ("0", "-1", "nan", "999")],
    *[("--tank", v, "tank") for v in ("0,0", "0,0,0", "0,0,-1", "nan,0,3", "0,0,nan", "0,0,inf")],
    *[("--tank", v, "tank") for v in ("inf,0,3", "a,b,c")],
    ("--method", "best", "best"),
    ("--search", "brute", "brute"),
    ("--units", "inch", "inch"),
]


@pytest.mark.parametrize(("option", "value", "word"), BAD_OPTIONS)
def test_bad_value(run: Runner, tmp_path: Path, option: str, value: str, word: str) -> None:
    scan = write_xyz(tmp_path / "scan.pcd", clouds.tank(spacing=0.05))
    result = run(scan, "-o", tmp_path / "out", f"{option}={value}", timeout=20)
    refused(result, WRONG_USE, tmp_path / "out", word, "expected")


@pytest.mark.parametrize(
    "args",
    [
        ["--frobnicate"],
        ["--k"],
        ["-x", "1"],
        ["--height-steps", "10"],
        ["--baseline", ""],
        ["--limits="],
    ],
)
def test_bad_option(run: Runner, tmp_path: Path, args: list[str]) -> None:
    scan = write_xyz(tmp_path / "scan.pcd", clouds.tank(spacing=0.05))
    result = run(scan, "-o", tmp_path / "out", *args)
    refused(result, WRONG_USE, tmp_path / "out", "command line", args[0].rstrip("="), "expected")


def test_no_scan(run: Runner, tmp_path: Path) -> None:
    refused(run(cwd=tmp_path), WRONG_USE, tmp_path / "out", "scan", "expected")


def test_bad_config(run: Runner, tmp_path: Path) -> None:
    scan = write_xyz(tmp_path / "scan.pcd", clouds.tank(spacing=0.05))
    out, config = tmp_path / "out", tmp_path / "config.toml"
    for text, word in [("k=2\n", "k"), ("frobnicate=1\n", "frobnicate"), ("k=x\n", "k")]:
        config.write_text(text)
        refused(run(scan, "-o", out, "--config", config), WRONG_USE, out, word)
    for text, line in [("stations = [90\n", 1), ("stations = 90\nstations = 80\n", 2)]:
        config.write_text(text)
        refused(
            run(scan, "-o", out, "--config", config), WRONG_USE, out, f"config.toml line {line}"
        )
    result = run(scan, "-o", out, "--config", tmp_path / "none.toml")
    refused(result, FILE_FAILED, out, "none.toml")
    config.write_text("k = 20\n")
    result = run(scan, "-o", out, "--config", config, "--config", config)
    refused(result, WRONG_USE, out, "--config")


@pytest.mark.parametrize(("kind", "said"), [("<f4", True), ("<f8", False)])
def test_coarse_coordinates_are_named(run: Runner, tmp_path: Path, kind: str, said: bool) -> None:
    """A tank at map coordinates kept in 4-byte floats is stairs of 0.25 m: the line says so."""
    columns = read_pcd(ROOT / "tests" / "data" / "sample.pcd")
    shifts = {"x": 512034.25, "y": 4012877.5, "z": 0.0}
    moved = {n: (columns[n].astype(float) + s).astype(kind) for n, s in shifts.items()}
    scan = write_pcd(tmp_path / "scan.pcd", moved)
    run(scan, "-o", tmp_path / "out")
    message = read_datum(tmp_path / "out")["message"]
    told = "coordinates have steps of 250 mm here: store 8-byte ones, or a finer scale"
    assert (told in message) == said
