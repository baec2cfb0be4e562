"""The code checks of a scan: what they need, whose limits, what a report says beside them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from results import Run, read_datum, read_stations

Runner = Callable[..., Run]
Synth = Callable[..., Path]
STEEL = ("--height", 3, "--yield-mpa", 235, "--modulus-mpa", 206_000)
KEYS = {
    *("code", "clause", "name", "value", "sigma", "limit", "unit", "azimuth_deg", "verdict"),
    *("source", "citation", "note", "role", "low95", "high95"),
}
VERDICTS = {"pass", "fail", "undecided", "not_applicable", "not_evaluated"}
LARGE = {"radius": 10, "distance": 9, "scanners": 6, "max_range": 22}


@pytest.fixture(scope="module")
def datum(run: Runner, synth: Synth, tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    out = tmp_path_factory.mktemp("checks") / "out"
    assert run(synth(**LARGE), "-o", out, *STEEL, "--roof", "open").returncode == 0
    return read_datum(out) | {"out": out}


def by_name(datum: dict[str, Any], name: str) -> dict[str, Any]:
    return next(c for c in datum["checks"] if c["name"] == name)


def test_every_check_is_complete(datum: dict[str, Any]) -> None:
    assert len(datum["checks"]) > 12
    for check in datum["checks"]:
        assert set(check) == KEYS
        assert check["verdict"] in VERDICTS
        assert check["source"] in {"verified", "secondary", "unverified"}
        assert check["citation"]
        if check["verdict"] in {"not_applicable", "not_evaluated"}:
            assert check["note"], check["name"]
        else:
            assert None not in (check["value"], check["limit"]), check["name"]


def test_what_they_say_of_this_tank(datum: dict[str, Any]) -> None:
    """A tilt of 0.002 and a wave of 4 mm on a 20 m tank."""
    assert by_name(datum, "planar tilt")["code"] == "Greenwood"
    assert by_name(datum, "planar tilt")["verdict"] == "not_applicable"
    assert by_name(datum, "planar tilt")["value"] == pytest.approx(0.002, abs=5e-5)
    curvature = by_name(datum, "curvature by trigonometric regression")
    assert curvature["limit"] == pytest.approx(11 * 235 / 206_000 / 3)
    assert curvature["value"] == pytest.approx(0.004 * 4 / 100, rel=0.2)
    assert curvature["verdict"] == "pass"
    shown = by_name(datum, "curvature as the ballot prints it")
    assert shown["limit"] == pytest.approx(2 * curvature["limit"])
    assert shown["verdict"] == "not_applicable"


def test_the_shape(datum: dict[str, Any]) -> None:
    waves = {h["n"]: h for h in datum["harmonics"]}
    assert abs(waves[2]["amplitude"] - 0.004) < 3 * waves[2]["sigma"]
    assert waves[2]["phase_deg"] == pytest.approx(40 / 2, abs=2) or waves[2][
        "phase_deg"
    ] == pytest.approx(40, abs=2)
    assert waves[0]["amplitude"] == pytest.approx(datum["datum"]["mean"], abs=1e-4)
    fit = datum["out_of_plane"]
    assert fit["order"] >= 4 and fit["message"] == ""
    assert 0 < fit["sigma_curvature"] < fit["max_curvature"]
    stations = read_stations(datum["out"])
    assert abs(stations["curvature"]).max() == pytest.approx(fit["max_curvature"])
    assert abs(stations["u"] - stations["u_fit"]).max() < 0.002


def test_notes(datum: dict[str, Any]) -> None:
    notes = " ".join(datum["notes"])
    assert "Screening for a storage-tank engineer, not a code evaluation." in notes
    assert "levels of the instrument" in notes


def test_summary(run: Runner, synth: Synth, tmp_path: Path) -> None:
    text = run(synth(**LARGE), "-o", tmp_path / "out", *STEEL, "--roof", "open").stdout
    assert "checks " in text and "not applicable (screening, no code evaluation)" in text
    assert len(text.splitlines()) <= 15


def test_without_the_tanks_facts(run: Runner, synth: Synth, tmp_path: Path) -> None:
    assert run(synth(**LARGE), "-o", tmp_path / "out").returncode == 0
    curvature = by_name(read_datum(tmp_path / "out"), "curvature by trigonometric regression")
    assert curvature["verdict"] == "not_evaluated"
    for option in ("height", "yield_mpa", "modulus_mpa"):
        assert f"option {option}" in curvature["note"]


def test_limits_of_ones_own(run: Runner, synth: Synth, tmp_path: Path) -> None:
    file = tmp_path / "own.csv"
    header = next(
        line for line in run("--print-limits").stdout.splitlines() if line.startswith("code,")
    )
    rows = (
        "Works,7,our tilt,tilt_slope,judge,0.001,,m/m,,,,verified,page 3",
        "Works,8,our radius,roundness_foot,judge,0.0001,,m,,,,verified,page 3",
    )
    file.write_text("\n".join((header, *rows)) + "\n")
    assert run(synth(**LARGE), "-o", tmp_path / "out", "--limits", file).returncode == 0
    datum = read_datum(tmp_path / "out")
    tilt, radius = datum["checks"]
    assert [(c["code"], c["verdict"]) for c in (tilt, radius)][0] == ("Works", "fail")
    foot = datum["shell"]["roundness"][0]
    assert (foot["tolerance"], foot["verdict"]) == (0.0001, radius["verdict"])
    assert datum["options"]["analysis"]["limits"] == str(file)


def test_printed_limits_are_those_used(run: Runner, synth: Synth, tmp_path: Path) -> None:
    file = tmp_path / "limits.csv"
    file.write_text(run("--print-limits").stdout)
    for out, options in (("a", ()), ("b", ("--limits", file))):
        assert run(synth(**LARGE), "-o", tmp_path / out, *STEEL, *options).returncode == 0
    a, b = read_datum(tmp_path / "a"), read_datum(tmp_path / "b")
    assert a["checks"] == b["checks"]


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--height", -2), "--height, -2, expected > 0 and <= 100 m"),
        (("--height", "26.25 furlongs"), "--height, 26.25 furlongs, expected a length"),
        (("--service", "old"), "--service"),
        (("--yield-mpa", 0), "--yield-mpa, 0, expected > 50 and <= 2000 MPa"),
        (("--yield-mpa", 235e6), "--yield-mpa, 2.35e+08, expected > 50"),
        (("--modulus-mpa", -1), "--modulus-mpa, -1, expected > 50000 and <= 500000 MPa"),
        (("--modulus-mpa", 206), "--modulus-mpa, 206, expected > 50000"),
        (("--roof", "dome"), "--roof"),
        (("--foundation", "sand"), "--foundation"),
        (("--classic-points", -4), "--classic-points, -4, expected >= 0"),
    ],
)
def test_refused_options(
    run: Runner, synth: Synth, tmp_path: Path, options: tuple[object, ...], said: str
) -> None:
    result = run(synth(), "-o", tmp_path / "out", *options)
    assert result.returncode == 2
    assert said in result.stderr
    assert not (tmp_path / "out" / "datum.json").exists()


def test_height_takes_units(run: Runner, synth: Synth, tmp_path: Path) -> None:
    limits = set()
    for i, height in enumerate(("3.048", "10ft", "120 in", "3048mm", "3.048m")):
        out = tmp_path / str(i)
        assert run(synth(**LARGE), "-o", out, *STEEL[2:], "--height", height).returncode == 0
        limits.add(
            round(by_name(read_datum(out), "curvature by trigonometric regression")["limit"], 9)
        )
    assert limits == {round(11 * 235 / 206_000 / 3.048, 9)}


def test_headline(datum: dict[str, Any]) -> None:
    assert datum["service"] == "in-service"
    keys = {"word", "governing", "utilisation", "utilisation_95", "sentence"}
    assert set(datum["verdict"]) == keys
    assert datum["verdict"]["word"] in {"FAIL", "UNDECIDED", "INCOMPLETE", "PASS"}
    roles = {c["name"]: c["role"] for c in datum["checks"] if c["verdict"] != "not_applicable"}
    assert roles["curvature by trigonometric regression"] == "governing"
    new = [c for c in datum["checks"] if c["code"] == "API 650"]
    assert new and all(c["role"] == "for comparison" for c in new)


@pytest.mark.parametrize(("content", "status"), [("code,clause\n", 2), (None, 3)])
def test_refused_limits(
    run: Runner, synth: Synth, tmp_path: Path, content: str | None, status: int
) -> None:
    file = tmp_path / "limits.csv"
    if content is not None:
        file.write_text(content)
    result = run(synth(), "-o", tmp_path / "out", "--limits", file)
    assert result.returncode == status
    assert str(file) in result.stderr
    assert result.stderr.count("\n") == 1
