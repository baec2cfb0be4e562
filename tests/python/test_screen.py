"""What the command prints, and its options as a file."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from results import FOLDER, RESULTS, Run, read_datum, read_stations

Runner = Callable[..., Run]
Synth = Callable[..., Path]

CHOSEN = {
    "method": "paper",
    "k": 25,
    "angle-deg": 50.0,
    "centre-tolerance": 0.2,
    "control-points": 12,
    "search": "flann",
    "stations": 72,
    "zero-azimuth-deg": 15.0,
    "heights": "0.25,0.5",
    "height-step": 0.5,
    "tank": "0.01,0,4.01",
    "search-points": 50_000,
    "fit-points": 40_000,
    "min-radius": 1.5,
    "height": 3.5,
    "yield-mpa": 235.0,
    "modulus-mpa": 206_000.0,
    "roof": "open",
    "foundation": "earth",
    "classic-points": 12,
    "remove": "tilt",
    "registration-error": 0.001,
    "registration-tilt-arcsec": 5.0,
    "azimuth-offset-deg": 12.0,
    "correlation-deg": 3.0,
    "radius-difference": 0.1,
    "centre-distance": 0.5,
    "threads": 1,
}


def listed(run: Runner) -> list[dict[str, Any]]:
    """What the command says of its options, with the name they have on its line."""
    options: list[dict[str, Any]] = json.loads(run("--print-options").stdout)
    return [option | {"name": option["name"].replace("_", "-")} for option in options]


def at(options: dict[str, Any], place: str) -> Any:
    value: Any = options
    for key in place.split("."):
        value = value[key]
    return value


def words(options: dict[str, Any]) -> list[str]:
    return [f"--{name}={value}" for name, value in options.items()]


def test_summary(run: Runner, synth: Synth, tmp_path: Path) -> None:
    """At most 15 lines, with the figures of datum.json, and where the results are."""
    out = tmp_path / "out"
    result = run(synth(), "-o", out)
    lines = result.stdout.splitlines()
    assert 5 <= len(lines) <= 15
    assert result.stderr == ""
    assert lines[-1].split() == ["results", f"{out}/report.html"]
    datum = read_datum(out)
    assert f"radius {datum['tank']['radius']:.3f} m" in result.stdout
    assert f"mean {datum['datum']['mean']:.4f} m" in result.stdout
    assert "360 measured, 0 interpolated, 0 missing" in result.stdout


def test_quiet(run: Runner, synth: Synth, tmp_path: Path) -> None:
    result = run(synth(), "-o", tmp_path / "out", "--quiet")
    assert (result.returncode, result.stdout, result.stderr) == (0, "", "")
    assert sorted(p.name for p in (tmp_path / "out").iterdir()) == sorted(FOLDER)


def test_version_and_help(run: Runner, tmp_path: Path) -> None:
    result = run("--version", cwd=tmp_path)
    assert result.returncode == 0
    assert result.stdout.startswith("tank_datum ")
    help_text = run("--help", cwd=tmp_path)
    assert help_text.returncode == 0
    names = [option["name"] for option in listed(run)]
    assert {"k", "output", "config", "quiet"} <= set(names)
    for name in names:
        assert f"--{name}" in help_text.stdout
    assert list(tmp_path.iterdir()) == []


def test_version_is_that_of_the_results(run: Runner, synth: Synth, tmp_path: Path) -> None:
    assert run(synth(), "-o", tmp_path / "out").returncode == 0
    version = read_datum(tmp_path / "out")["version"]
    assert run("--version").stdout == f"tank_datum {version}\n"


@pytest.mark.parametrize("chosen", [{}, CHOSEN], ids=["defaults", "chosen"])
def test_printed_options_are_those_used(
    run: Runner, synth: Synth, tmp_path: Path, chosen: dict[str, Any]
) -> None:
    """Every line of --print-config equals what datum.json says was used."""
    scan, out = synth(), tmp_path / "out"
    printed = tomllib.loads(run(scan, *words(chosen), "--print-config").stdout)
    options = [option for option in listed(run) if option["configurable"]]
    assert set(printed) == {option["name"] for option in options}
    assert {k: printed[k] for k in chosen} == chosen
    assert run(scan, "-o", out, *words(chosen)).returncode == 0
    datum = read_datum(out)
    assert datum["input"]["units"] == printed["units"]
    for option in options:
        if not option["place"] or option["kind"] == "places":
            continue
        used = at(datum["options"], option["place"])
        if used is None:
            used = ""
        if isinstance(used, list):
            used = ",".join(f"{v:g}" for v in used)
        wanted = used if isinstance(used, str) else pytest.approx(used)
        assert printed[option["name"]] == wanted, option["name"]


def test_config_round_trip(run: Runner, synth: Synth, tmp_path: Path) -> None:
    """The options printed, read back, print the same and give the same bytes."""
    scan, config = synth(), tmp_path / "tank.toml"
    given = [*words(CHOSEN), "--clockwise"]
    config.write_text(run(scan, *given, "--print-config").stdout)
    again = run(scan, "--config", config, "--print-config")
    assert again.stdout == config.read_text()
    assert run(scan, "-o", tmp_path / "a", *given).returncode == 0
    assert run(scan, "-o", tmp_path / "b", "--config", config).returncode == 0
    for name in set(RESULTS) - {"datum_nodes.csv"}:  # the paper's elevations have no errors
        assert (tmp_path / "a" / name).read_bytes() == (tmp_path / "b" / name).read_bytes()


def test_command_line_goes_over_the_config(run: Runner, synth: Synth, tmp_path: Path) -> None:
    config = tmp_path / "tank.toml"
    config.write_text("stations=90\n")
    assert run(synth(), "-o", tmp_path / "a", "--config", config).returncode == 0
    assert len(read_stations(tmp_path / "a")) == 90
    result = run(synth(), "-o", tmp_path / "b", "--config", config, "--stations", 120)
    assert result.returncode == 0
    assert len(read_stations(tmp_path / "b")) == 120


def test_print_config_writes_nothing(run: Runner, tmp_path: Path) -> None:
    assert run("none.pcd", "--print-config", cwd=tmp_path).returncode == 0
    assert list(tmp_path.iterdir()) == []
