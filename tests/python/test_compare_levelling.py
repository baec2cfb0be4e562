"""A levelling survey compared with a scan, both ways, and with another levelling."""

from __future__ import annotations

import json
import math
import subprocess
from pathlib import Path
from typing import Any

import pytest

from conftest import ROOT, executable

SAMPLE = ROOT / "tests" / "data" / "sample.pcd"
ROD = 0.15  # m, from the datum to where the rod stands


def call(name: str, *arguments: object) -> subprocess.CompletedProcess:
    command = [str(executable(name)), *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True)


@pytest.fixture(scope="module")
def scan(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("scan") / "scan"
    assert call("tank_datum", SAMPLE, "--quiet", "-o", out).returncode == 0
    return out


def table(path: Path, scan: Path, step: float, sunk: float = 0.0, sigma: str = "0.0005") -> Path:
    """The scanned datum as a levelling has it: from the rod's foot, at stations of its own."""
    stations = json.loads((scan / "datum.json").read_text())["stations"]
    z = [s["z"] + ROD for s in stations]
    rows = ["azimuth_deg,elevation" + (",sigma" if sigma else "")]
    azimuth = 0.4
    while azimuth < 360:
        i, share = math.floor(azimuth), azimuth % 1
        height = (1 - share) * z[i] + share * z[(i + 1) % 360]
        height -= sunk if 90 < azimuth < 150 else 0.0
        rows.append(f"{azimuth},{height:.6f}" + (f",{sigma}" if sigma else ""))
        azimuth += step
    path.write_text("\n".join(rows) + "\n")
    return path


def levelling(file: Path, out: Path, *options: object, diameter: float = 10) -> Any:
    command = ("--stations-csv", file, "--diameter", diameter, "-o", out, "--quiet", *options)
    return call("tank_datum", *command)


def compared(baseline: Path, later: Path, out: Path, *options: object) -> dict[str, Any]:
    done = call("tank_datum_compare", baseline, later, "-o", out, *options)
    assert done.returncode == 0, done.stderr
    (movement,) = json.loads((out / "movement.json").read_text())["movements"]
    return movement


def moved(movement: dict[str, Any]) -> list[float]:
    return [s["azimuth_deg"] for s in movement["stations"] if s["significant"]]


def test_levelling_and_scan_both_ways(tmp_path: Path, scan: Path) -> None:
    level = tmp_path / "level"
    file = table(tmp_path / "t.csv", scan, 20, sunk=0.01)
    assert levelling(file, level).returncode == 0
    for baseline, later, sign in ((scan, level, -1), (level, scan, 1)):
        movement = compared(baseline, later, tmp_path / "m")
        assert movement["removed"] == "mean"
        assert "movement.rod_height" in movement["not_given"]
        assert movement["matched"] == len(movement["stations"]) == 18
        assert movement["max"] == pytest.approx(sign * 0.01, abs=0.003)
        assert {100.4, 120.4, 140.4} <= {round(a, 3) for a in moved(movement)}
        tied = compared(baseline, later, tmp_path / "n", "--remove", "none")
        assert tied["max"] == pytest.approx(-sign * ROD, abs=1e-3)
        assert tied["significant"] == 18


def test_levelling_against_levelling(tmp_path: Path, scan: Path) -> None:
    for name, sunk in (("a", 0.0), ("b", 0.01)):
        file = table(tmp_path / f"{name}.csv", scan, 20, sunk)
        assert levelling(file, tmp_path / name).returncode == 0
    movement = compared(tmp_path / "a", tmp_path / "b", tmp_path / "m")
    assert movement["max"] == pytest.approx(-0.01, abs=2e-6)
    assert [round(a, 3) for a in moved(movement)] == [100.4, 120.4, 140.4]
    again = levelling(tmp_path / "b.csv", tmp_path / "c", "--baseline", tmp_path / "a")
    assert again.returncode == 0, again.stderr
    inside = json.loads((tmp_path / "c/datum.json").read_text())["movement"]
    assert inside["stations"] == movement["stations"]


def test_a_scan_with_a_levelled_baseline(tmp_path: Path, scan: Path) -> None:
    level, out = tmp_path / "level", tmp_path / "out"
    assert levelling(table(tmp_path / "t.csv", scan, 25), level).returncode == 0
    options = ("--quiet", "-o", out, "--baseline", level)
    done = call("tank_datum", SAMPLE, *options)
    assert done.returncode == 0, done.stderr
    movement = json.loads((out / "datum.json").read_text())["movement"]
    assert (movement["matched"], movement["significant"]) == (15, 0)
    assert movement["rms"] < 1e-4
    assert "movement.rod_height" in movement["not_given"]


def test_without_standard_errors_one_refusal_says_what_to_do(tmp_path: Path, scan: Path) -> None:
    level = tmp_path / "level"
    assert levelling(table(tmp_path / "t.csv", scan, 20, sigma=""), level).returncode == 0
    tries = [
        call("tank_datum_compare", level, scan, "-o", tmp_path / "m"),
        call("tank_datum_compare", scan, level, "-o", tmp_path / "m"),
        call("tank_datum", SAMPLE, "--quiet", "-o", tmp_path / "o", "--baseline", level),
        levelling(tmp_path / "t.csv", tmp_path / "o", "--baseline", scan),
    ]
    for done in tries:
        assert done.returncode == 2
        assert done.stderr.count("\n") == 1
        assert "a sigma column in the levelling's table" in done.stderr
    assert not (tmp_path / "m").exists() and not (tmp_path / "o").exists()


def test_another_diameter_and_too_few_stations(tmp_path: Path, scan: Path) -> None:
    file = table(tmp_path / "t.csv", scan, 20)
    assert levelling(file, tmp_path / "wide", diameter=10.3).returncode == 0
    done = call("tank_datum_compare", tmp_path / "wide", scan, "-o", tmp_path / "m")
    assert (done.returncode, "radius of" in done.stderr) == (2, True), done.stderr
    assert levelling(table(tmp_path / "few.csv", scan, 51.5), tmp_path / "few").returncode == 0
    done = call("tank_datum_compare", tmp_path / "few", scan, "-o", tmp_path / "m")
    assert done.returncode == 1
    assert "only 7 stations are measured in both surveys, and 8 are needed" in done.stderr
