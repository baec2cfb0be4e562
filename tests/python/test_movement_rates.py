"""The two commands that say how often movement is judged rightly."""

from __future__ import annotations

import os
import re
import subprocess
import sys

import pytest

from conftest import ROOT, executable

LINES = ("unmoved: any significant station", "dip: found", "dip: significant elsewhere too")
WHOLE = ("unmoved: mean settlement significant", "unmoved: change of tilt significant")


def shares(text: str, lines: tuple[str, ...] = LINES) -> list[float]:
    """Per cent of each line."""
    return [float(re.search(rf"{line} .* ([\d.]+) %", text).group(1)) for line in lines]


def simulated(*options: object, lines: tuple[str, ...] = LINES) -> list[float]:
    command = [executable("tank_datum_rates"), "movement", "--runs", 40, *options]
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True, check=True)
    return shares(done.stdout, lines)


def test_simulated_surveys() -> None:
    alarms, found, _ = simulated()
    assert alarms <= 15.0  # 40 runs: binomial(40, 0.05) exceeds 6 once in 300
    assert found == 100.0


@pytest.mark.parametrize(
    "options",
    [("--sigma", 0.003), ("--dip", 0.0001), ("--dip-width-deg", 1)],
)
def test_what_cannot_be_seen_is_not_found(options: tuple[object, ...]) -> None:
    assert simulated(*options)[1] < 50.0


def test_errors_beyond_their_sigma_are_estimated_and_raise_none() -> None:
    assert simulated("--scatter", 2)[0] < 10.0


def test_few_stations_of_claimed_half_sigma_raise_no_mean_or_tilt() -> None:
    settled, tilted = simulated("--stations", 24, "--scatter", 2, lines=WHOLE)
    assert max(settled, tilted) <= 15.0


def test_windows_as_wide_as_said_raise_none() -> None:
    assert simulated("--window-deg", 13)[0] <= 15.0


@pytest.mark.parametrize(
    "option",
    [
        "--runs=0",
        "--stations=7",
        "--sigma=-1",
        "--scatter=0",
        "--window-deg=0",
        "--dip-width-deg=0",
    ],
)
def test_bad_values_are_refused_by_name(option: str) -> None:
    command = [str(executable("tank_datum_rates")), "movement", option]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 2
    assert option.split("=")[0] in done.stderr


def test_the_whole_chain_once() -> None:
    command = [sys.executable, ROOT / "scripts" / "movement_rates.py", "--runs", "1"]
    environment = {**os.environ, "TANK_DATUM_BIN": str(executable("tank_datum").parent)}
    done = subprocess.run(
        [str(c) for c in command], capture_output=True, text=True, env=environment
    )
    assert done.returncode == 0, done.stderr
    assert "points on the foundation behind a station" in done.stdout
    assert shares(done.stdout) == [0.0, 100.0, 0.0]
