"""The result files hold what CONTRACT.md promises: names, types, bytes."""

from __future__ import annotations

import hashlib
import itertools
import math
import re
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from contract_keys import AGREEMENT_OF_SEVERAL, KEYS, check_keys
from results import (
    FOLDER,
    HEADER,
    NO_FIGURES,
    Run,
    read_datum,
    read_pcd,
    read_points,
    read_stations,
    write_pcd,
    write_xyz,
)

Runner = Callable[..., Run]
Synth = Callable[..., Path]


def folder_of(method: str) -> set[str]:
    """The files of a result; the paper's method has no covariance to give nodes of."""
    return set(FOLDER) - ({"datum_nodes.csv"} if method == "paper" else set())


@pytest.fixture(scope="module", params=["whole", "one side", "plate", "paper"])
def result(
    request: pytest.FixtureRequest, run: Runner, synth: Synth, tmp_path_factory: Any
) -> tuple[str, Path]:
    """A datum all round, one of a third of the ring, one with short gaps, and one of the paper."""
    scan = synth()
    if request.param == "one side":
        scan = synth(scanners=1)
    if request.param == "plate":
        scan = synth(foundation="annular_plate")  # too few points on it at six stations
    out = tmp_path_factory.mktemp("result") / "out"
    method = "paper" if request.param == "paper" else "refined"
    assert run(scan, "-o", out, "--method", method).returncode == 0
    return request.param, out


def test_folder_holds_the_results_alone(result: tuple[str, Path]) -> None:
    name, out = result
    assert sorted(p.name for p in out.iterdir()) == sorted(folder_of(name))


def test_datum_json(result: tuple[str, Path]) -> None:
    """Keys in order and of their types; movement comes with a baseline alone."""
    name, out = result
    datum = read_datum(out)
    if name == "paper":
        assert datum["datum"]["surface"] is None
        assert datum["tank"]["sigma_radius"] is None
        assert datum["covariance"] is None
        datum["datum"]["surface"], datum["tank"]["sigma_radius"] = "", 0.0
        datum["covariance"] = {"independent": [], "factors": []}
    if name == "one side":  # no two stations opposite each other
        assert set(datum["antipodal"].pop("h")) == {None}
        assert set(datum["antipodal"].values()) == {None}
        datum["antipodal"] = dict.fromkeys(datum["antipodal"], 0.0) | {"h": []}
        datum["agreement"] |= AGREEMENT_OF_SEVERAL
    check_keys(datum, KEYS)
    assert datum["schema"] == 1
    assert datum["status"] == ("partial" if name == "one side" else "ok")
    assert (len(datum["input"]["origin"]), len(datum["tank"]["center"])) == (3, 2)
    assert datum["tank"]["side"] == "outside"
    assert datum["datum"]["surface"] in ("foundation", "annular_plate", "ringwall", "")


def test_input_is_named_and_hashed(run: Runner, synth: Synth, tmp_path: Path) -> None:
    """The points as in the file; those that are NaN are counted apart."""
    columns = {n: v.copy() for n, v in read_pcd(synth()).items()}
    columns["z"][:7] = np.nan
    scan = write_pcd(tmp_path / "scan.pcd", columns)
    assert run("scan.pcd", cwd=tmp_path).returncode == 0
    given = read_datum(tmp_path / "scan.datum")["input"]
    assert given["files"] == [
        {
            "path": "scan.pcd",
            "sha256": None,
            "hash": {"algorithm": "xxh3_128", "value": xxhsum(scan)},
            "points": len(columns["z"]),
        }
    ]
    assert given["invalid_points"] == 7


def xxhsum(path: Path) -> str:
    """What users check with; of Debian's package xxhash."""
    program = shutil.which("xxhsum")
    if program is None:
        pytest.skip("xxhsum is not installed")
    return subprocess.check_output([program, "-H2", path], text=True).split()[0]


@pytest.mark.parametrize("threads", [1, 2])
def test_checksum_changes_the_hash_and_nothing_else(
    threads: int, run: Runner, synth: Synth, tmp_path: Path
) -> None:
    scan = synth()
    sha256 = hashlib.sha256(scan.read_bytes()).hexdigest()
    expected = {
        "default": (None, {"algorithm": "xxh3_128", "value": xxhsum(scan)}),
        "xxh3": (None, {"algorithm": "xxh3_128", "value": xxhsum(scan)}),
        "sha256": (sha256, {"algorithm": "sha256", "value": sha256}),
        "none": (None, None),
        "no": (None, None),
    }
    flags = {"default": (), "no": ("--no-checksum",)}
    results = []
    for kind, (old, new) in expected.items():
        words = flags.get(kind, ("--checksum", kind))
        out = tmp_path / kind
        assert run(scan, "-o", out, "--threads", threads, *words).returncode == 0
        results.append(read_datum(out))
        (file,) = results[-1]["input"]["files"]
        assert (file.pop("sha256"), file.pop("hash")) == (old, new)
    assert results == [results[0]] * len(results)
    page = (tmp_path / "none" / "report.html").read_text()
    assert "not taken" in page


def test_checksum_that_is_none(run: Runner, synth: Synth, tmp_path: Path) -> None:
    made = run(synth(), "-o", tmp_path / "out", "--checksum", "md5")
    assert made.returncode == 2
    assert "--checksum" in made.stderr and "xxh3" in made.stderr


def cells(out: Path) -> list[list[str]]:
    lines = (out / "stations.csv").read_text().splitlines()
    assert lines[0] == HEADER
    return [line.split(",") for line in lines[1:]]


def test_stations_csv(result: tuple[str, Path]) -> None:
    """One row per station, a shortest decimal or nothing in each cell, never a NaN."""
    name, out = result
    rows = cells(out)
    names = HEADER.split(",")
    assert [int(row[0]) for row in rows] == list(range(360))
    assert np.array([float(row[1]) for row in rows]) == pytest.approx(np.arange(360.0))
    assert not re.search("nan|inf", (out / "stations.csv").read_text(), re.IGNORECASE)
    flags = {row[names.index("flag")] for row in rows}
    assert (
        flags
        == {
            "whole": {"measured"},
            "one side": {"measured", "interpolated", "missing"},
            "plate": {"measured", "interpolated"},
            "paper": {"measured"},
        }[name]
    )
    for row in rows:
        assert len(row) == len(names)
        known = {n for n, cell in zip(names, row, strict=True) if cell and n not in NO_FIGURES}
        assert (row[-1] == "") == (row[names.index("flag")] == "measured" or name == "paper")
        if row[names.index("flag")] == "missing":
            assert known == {"azimuth_deg", "x", "y"}  # its place on the circle, and nothing else
            continue
        assert {"azimuth_deg", "x", "y", "z", "radius", "z_tilt", "u"} <= known
        assert {"u_fit", "curvature"}.isdisjoint(known)  # too small a tank for the regression
        of_refined = {"sigma_z", "n_shell", "n_foundation"}
        if row[names.index("flag")] == "measured":
            of_refined.add("sigma_radius")
        assert (known & of_refined) == (set() if name == "paper" else of_refined)


def test_columns_agree(result: tuple[str, Path]) -> None:
    """radius and x, y about the centre; u = z - z_tilt; counts, extremes and mean of datum.json."""
    name, out = result
    datum, s = read_datum(out), read_stations(out)
    center = datum["tank"]["center"]
    known = ~s.where("missing")
    angle = np.radians(s["azimuth_deg"])
    assert s["x"][known] == pytest.approx((center[0] + s["radius"] * np.cos(angle))[known])
    assert s["y"][known] == pytest.approx((center[1] + s["radius"] * np.sin(angle))[known])
    assert s["u"][known] == pytest.approx((s["z"] - s["z_tilt"])[known], abs=1e-12)
    if name == "paper":
        assert np.array_equal(s["z"], s["z_paper"])
    section = datum["datum"]
    for flag in ("measured", "interpolated", "missing"):
        assert section[flag] == s.where(flag).sum()
    z = s["z"]
    assert section["min"] == pytest.approx(np.nanmin(z), abs=1e-12)
    assert section["max"] == pytest.approx(np.nanmax(z), abs=1e-12)
    assert section["range"] == pytest.approx(section["max"] - section["min"], abs=1e-12)
    assert section["min_azimuth_deg"] == pytest.approx(s["azimuth_deg"][np.nanargmin(z)])
    assert section["max_azimuth_deg"] == pytest.approx(s["azimuth_deg"][np.nanargmax(z)])
    assert np.nanmin(z) < section["mean"] < np.nanmax(z)
    tilt = datum["tilt"]
    assert tilt["angle_arcsec"] == pytest.approx(math.degrees(math.atan(tilt["slope"])) * 3600)


def test_gaps(run: Runner, synth: Synth, tmp_path: Path) -> None:
    """8 degrees without points are bridged, with an error that grows inwards; 14 are missing."""
    points = read_points(synth())
    azimuth = np.degrees(np.arctan2(points[:, 1], points[:, 0])) % 360.0
    seen = (np.abs(azimuth - 100.0) > 4.0) & (np.abs(azimuth - 200.0) > 7.0)
    scan = write_xyz(tmp_path / "scan.pcd", points[seen])
    assert run(scan, "-o", tmp_path / "out").returncode == 0
    s = read_stations(tmp_path / "out")
    flag = np.array(s.flag)
    assert (flag[97:104] == "interpolated").all()
    assert (flag[194:207] == "missing").all()
    assert (flag[[90, 110, 185, 215]] == "measured").all()
    sigma = s["sigma_z"]
    assert sigma[100] > 1.2 * max(sigma[97], sigma[103])
    assert sigma[100] > np.median(sigma[s.where("measured")])


def test_clouds(result: tuple[str, Path]) -> None:
    """datum_curve.pcd: the stations that are known, in order. datum_points.pcd: points near it."""
    _, out = result
    s = read_stations(out)
    known = ~s.where("missing")
    curve = read_points(out / "datum_curve.pcd")
    assert np.array_equal(curve, np.column_stack([s[n][known] for n in "xyz"]))
    edge = read_points(out / "datum_points.pcd")
    tank = read_datum(out)["tank"]
    distance = np.hypot(*(edge[:, :2] - tank["center"]).T)
    assert len(edge) > 200
    assert np.abs(distance - tank["radius"]).max() < 0.41  # a tenth of the radius


@pytest.mark.parametrize("method", ["refined", "paper"])
def test_same_bytes(run: Runner, synth: Synth, tmp_path: Path, method: str) -> None:
    """Two runs, one and two threads: not a byte differs."""
    folders = [tmp_path / str(i) for i in range(4)]
    # the paper's closed curve swings by metres over the half that two scanners do not see: no tank
    scan = synth() if method == "paper" else synth(scanners=2)
    for folder, threads in zip(folders, (0, 0, 1, 2), strict=True):
        args = ["-o", folder, "--method", method, "--threads", threads]
        assert run(scan, *args).returncode == 0
    for (a, b), name in itertools.product(itertools.pairwise(folders), folder_of(method)):
        assert (a / name).read_bytes() == (b / name).read_bytes(), name
