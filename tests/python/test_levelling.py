"""Stations typed in: the known answers of the codes' own examples, and what is refused."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from conftest import ROOT
from results import Run, read_datum, read_stations

Runner = Callable[..., Run]
LEVELLING = ROOT / "tests" / "data" / "levelling"
INCH, FOOT, KSI = 0.0254, 0.3048, 6.894757


SWAPPED = "azimuth_deg,elevation\n" + "".join(f"1.00{a // 90},{a}\n" for a in range(0, 360, 90))


def survey(run: Runner, out: Path, file: Path, diameter: float, *options: object) -> dict[str, Any]:
    result = run("--stations-csv", file, "--diameter", diameter, "-o", out, *options)
    assert result.returncode == 0, result.stderr
    return read_datum(out)


def check(datum: dict[str, Any], name: str) -> dict[str, Any]:
    found: list[dict[str, Any]] = [c for c in datum["checks"] if c["name"] == name]
    assert len(found) == 1, name
    return found[0]


def table(path: Path, rows: dict[float, float], sigma: float | None = None) -> Path:
    lines = [f"{a},{z}" + ("" if sigma is None else f",{sigma}") for a, z in rows.items()]
    header = "azimuth_deg,elevation" + ("" if sigma is None else ",sigma")
    path.write_text("\n".join([header, *lines]) + "\n")
    return path


def test_the_terminal_lists_every_check_that_fails(run: Runner, tmp_path: Path) -> None:
    """Second opinions too, which are said to be ones."""
    waves = {a: 0.05 * math.cos(math.radians(2 * a)) for a in range(0, 360, 5)}
    file = table(tmp_path / "waves.csv", waves, 0.0005)
    steel = ["--height", 14, "--yield-mpa", 250, "--modulus-mpa", 200_000, "--roof", "fixed"]
    result = run("--stations-csv", file, "--diameter", 40, "-o", tmp_path / "out", *steel)
    failed = [c for c in read_datum(tmp_path / "out")["checks"] if c["verdict"] == "fail"]
    lines = [line for line in result.stdout.splitlines() if line.startswith("fail ")]
    assert len(lines) == len(failed)
    second = [f"{c['code']} {c['name']}" for c in failed if c["role"] == "second opinion"]
    assert second
    for line in lines:
        assert line.endswith("(a second opinion)") == any(name in line for name in second)


def test_sixteen_stations_of_the_pemy_white_paper(run: Runner, tmp_path: Path) -> None:
    """STANDARDS 4.1: D 120 ft, H 40 ft, 36 ksi, 29e6 psi; elevations in inches."""
    steel = ["--height", 40 * FOOT, "--yield-mpa", 36 * KSI, "--modulus-mpa", 29_000 * KSI]
    file = LEVELLING / "sixteen_stations_inches.csv"
    datum = survey(run, tmp_path / "out", file, 120 * FOOT, "--units", "in", *steel)
    radius, tilt = 60 * FOOT, datum["tilt"]
    assert datum["datum"]["mean"] / INCH == pytest.approx(-1.1469, abs=5e-5)
    amplitude, direction = tilt["slope"] * radius / INCH, math.radians(tilt["direction_deg"])
    assert amplitude * math.cos(direction) == pytest.approx(-0.3318, abs=5e-5)
    assert amplitude * math.sin(direction) == pytest.approx(-0.4083, abs=5e-5)
    assert amplitude == pytest.approx(0.5261, abs=5e-5)
    r2 = tilt["r2"]
    assert r2 == pytest.approx(0.6167, abs=5e-5)
    assert 1 - (1 - r2) * 15 / 13 == pytest.approx(0.5577, abs=5e-5)
    assert tilt["standard_error"] / INCH == pytest.approx(0.3254, abs=5e-5)
    assert r2 / 2 / ((1 - r2) / 13) == pytest.approx(10.46, abs=5e-3)
    assert tilt["p_value"] == pytest.approx(0.002, abs=5e-5)
    classic = check(datum, "out-of-plane settlement S_i")
    assert classic["value"] / INCH == pytest.approx(0.645, abs=5e-4)
    assert classic["limit"] / INCH == pytest.approx(1.137, abs=5e-4)
    assert classic["verdict"] == "pass"


def test_fourteen_stations_of_an_inspection_report(run: Runner, tmp_path: Path) -> None:
    """STANDARDS 4.2: D 138 ft, H 59.083 ft, 32 ksi, 29e6 psi: station 3 fails."""
    steel = ["--height", 59.083 * FOOT, "--yield-mpa", 32 * KSI, "--modulus-mpa", 29_000 * KSI]
    file = LEVELLING / "fourteen_stations.csv"
    datum = survey(run, tmp_path / "out", file, 138 * FOOT, *steel)
    assert datum["tilt"]["slope"] * 69 * FOOT == pytest.approx(0.07005, abs=5e-6)
    assert datum["tilt"]["r2"] == pytest.approx(0.862, abs=5e-4)
    classic = check(datum, "out-of-plane settlement S_i")
    assert classic["value"] == pytest.approx(0.0389, abs=5e-5)
    assert classic["limit"] == pytest.approx(0.0300, abs=5e-5)
    assert classic["azimuth_deg"] == pytest.approx(2 * 360 / 14, abs=1e-5)
    assert classic["verdict"] == "fail"


@pytest.mark.parametrize(("h", "arcsec"), [(0.015, 51.566), (0.15, 0.14324 * 3600)])
def test_inclination_of_the_paper(run: Runner, tmp_path: Path, h: float, arcsec: float) -> None:
    """STANDARDS 4.3: h over D = 60 m."""
    file = table(tmp_path / "t.csv", {a: h if a == 90 else 0.0 for a in range(0, 360, 30)})
    across = survey(run, tmp_path / "out", file, 60)["antipodal"]
    assert across["max_h"] == pytest.approx(h)
    assert across["angle_arcsec"] == pytest.approx(arcsec, abs=0.02)
    assert across["azimuth_deg"] == 90
    assert across["h"] == pytest.approx([0, 0, 0, h, 0, 0])


def test_allowable_second_differences(run: Runner, tmp_path: Path) -> None:
    """STANDARDS 4.4: D 60 m, H 16 m, 235 MPa, 206 GPa: 14.6 mm at 20 ft; none at one degree."""
    steel = ["--height", 16, "--yield-mpa", 235, "--modulus-mpa", 206_000]
    file = table(tmp_path / "t.csv", {a: 0.001 * math.cos(a / 30) for a in range(360)}, 0.0003)
    datum = survey(run, tmp_path / "a", file, 60, *steel, "--classic-points", 30)
    spacing = datum["out_of_plane"]["second_differences"]["spacing"]
    classic = check(datum, "out-of-plane settlement S_i")
    assert classic["limit"] * (6.096 / spacing) ** 2 == pytest.approx(0.0146, abs=5e-5)
    refused = survey(run, tmp_path / "b", file, 60, *steel, "--classic-points", 360)
    classic = check(refused, "out-of-plane settlement S_i")
    assert (classic["verdict"], classic["value"], classic["limit"]) == (
        "not_applicable",
        None,
        None,
    )
    assert "judges noise" in classic["note"]


def test_results_are_those_of_a_scan(run: Runner, tmp_path: Path) -> None:
    out = tmp_path / "out"
    file = table(tmp_path / "t.csv", {a: 1.0 + 0.01 * math.sin(a) for a in range(0, 360, 2)}, 1e-3)
    datum = survey(run, out, file, 30)
    assert datum["input"]["kind"] == "levelling"
    assert datum["input"]["files"][0]["points"] == 180
    assert datum["tank"]["radius"] == 15
    stations = read_stations(out)
    assert len(stations) == 180
    assert stations["sigma_z"] == pytest.approx(1e-3)
    assert math.isfinite(stations["curvature"].sum())
    assert sorted(p.name for p in out.glob("*.pcd")) == ["datum_curve.pcd"]


def test_missing_elevations(run: Runner, tmp_path: Path) -> None:
    file = table(tmp_path / "t.csv", {a: 1.0 for a in range(0, 360, 30)})
    file.write_text(file.read_text().replace("60,1.0", "60,"))
    datum = survey(run, tmp_path / "out", file, 30)
    assert datum["status"] == "partial"
    assert datum["datum"]["missing"] == 1


@pytest.mark.parametrize(
    ("content", "options", "status", "said"),
    [
        ("azimuth_deg,elevation\n0,x\n", (), 2, 'line 2 elevation, "x", expected a number'),
        ("angle,z\n0,1\n", (), 2, '"angle,z", expected the header azimuth_deg,elevation'),
        (SWAPPED, (), 2, "elevations, 270.000000 m apart, expected at most a tenth"),
        ("", (), 2, "no lines"),
        ("azimuth_deg,elevation\n0,1\n", (), 1, "1 stations have an elevation"),
        ("azimuth_deg,elevation\n0,1\n", ("--diameter", -3), 2, "diameter, -3"),
        ("azimuth_deg,elevation\n0,1\n", ("--all",), 2, "--all"),
        ("azimuth_deg,elevation\n0,1\n", ("scan.pcd",), 2, "scan"),
        (None, (), 3, "No such file"),
    ],
)
def test_refused(
    run: Runner,
    tmp_path: Path,
    content: str | None,
    options: tuple[object, ...],
    status: int,
    said: str,
) -> None:
    file = tmp_path / "t.csv"
    if content is not None:
        file.write_text(content)
    diameter = [] if "--diameter" in options else ["--diameter", 20]
    result = run("--stations-csv", file, *diameter, "-o", tmp_path / "out", *options)
    assert result.returncode == status
    assert said in result.stderr
    assert result.stderr.count("\n") == 1


def test_the_summary_names_every_failed_check_the_worst_first(run: Runner, tmp_path: Path) -> None:
    steel = ["--height", 59.083 * FOOT, "--yield-mpa", 32 * KSI, "--modulus-mpa", 29_000 * KSI]
    file, out = LEVELLING / "fourteen_stations.csv", tmp_path / "out"
    done = run("--stations-csv", file, "--diameter", 138 * FOOT, "-o", out, *steel)
    failed = [c for c in read_datum(out)["checks"] if c["verdict"] == "fail"]
    failed.sort(key=lambda c: -c["value"] / c["limit"])
    lines = [line for line in done.stdout.splitlines() if line.startswith("fail ")]
    assert len(lines) == len(failed) == 3
    for line, one in zip(lines, failed, strict=True):
        assert f"{one['code']} {one['name']}:" in line
    assert "38.9 mm, limit 30.0 mm" in done.stdout


def test_needs_a_diameter(run: Runner) -> None:
    result = run("--stations-csv", LEVELLING / "fourteen_stations.csv")
    assert result.returncode == 2
    assert "--diameter" in result.stderr


def test_what_only_a_scan_needs_is_said(run: Runner, tmp_path: Path) -> None:
    """Not of the defaults, which a printed file of options has."""
    table = ("--stations-csv", LEVELLING / "fourteen_stations.csv", "--diameter", 42, "--quiet")
    config = tmp_path / "options.toml"
    config.write_text(run("--print-config").stdout)
    result = run(*table, "-o", tmp_path / "a", "--config", config)
    assert (result.returncode, result.stderr) == (0, "")
    result = run(*table, "-o", tmp_path / "b", "--stations", 72, "--up", "y", "--accept")
    assert result.returncode == 0
    assert result.stderr.splitlines() == [
        f"tank_datum: warning: --{words} is not used: a levelling survey has no scan"
        for words in ("stations 72", "accept true", "up y")
    ]
    result = run(*table, "-o", tmp_path / "c", "--tank", "0,0,21")
    assert result.returncode == 2 and "--tank, 0,0,21, expected none with" in result.stderr


def test_survey_points_stand_between_unequal_stations(run: Runner, tmp_path: Path) -> None:
    """They were read at the station of the number, as if all stood equally far apart."""
    azimuths = [*range(0, 200, 20), 225, 270, 315]
    file = table(tmp_path / "rows.csv", {a: round(10 + a / 1000, 6) for a in azimuths})
    points = survey(run, tmp_path / "out", file, 20, "--survey-points", 16)["survey_points"]
    at = {round(p["azimuth_deg"], 6): p["z"] for p in points}
    assert at[315] == pytest.approx(10.315) and at[22.5] == pytest.approx(10.0225)
    assert at[247.5] == pytest.approx(10.2475) and at[180] == pytest.approx(10.18)
