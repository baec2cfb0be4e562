"""--baseline: the same comparison within a run, and baselines that are refused."""

import copy
import json
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from conftest import ROOT, executable

SAMPLE = ROOT / "tests" / "data" / "sample.pcd"


def test_baseline_is_the_same_comparison(tmp_path: Path) -> None:
    run = [executable("tank_datum"), SAMPLE, "--quiet", "-o"]
    subprocess.run([*run, tmp_path / "a"], check=True)
    again = [*run, tmp_path / "b", "--baseline", tmp_path / "a", "--remove", "mean"]
    subprocess.run([*again, "--registration-error", "0.002"], check=True)
    movement = json.loads((tmp_path / "b/datum.json").read_text())["movement"]
    assert (movement["matched"], movement["significant"], movement["removed"]) == (360, 0, "mean")
    assert movement["max"] == pytest.approx(0, abs=1e-9)
    assert movement["registration_error"] == 0.002
    options = json.loads((tmp_path / "b/datum.json").read_text())["options"]["movement"]
    assert (options["baseline"], options["remove"]) == (str(tmp_path / "a"), "mean")
    refused = subprocess.run(
        [*run, tmp_path / "b", "--registration-error", "-1"], capture_output=True, text=True
    )
    assert refused.returncode == 2
    assert "--registration-error" in refused.stderr


@pytest.fixture(scope="module")
def of_the_sample(tmp_path_factory: pytest.TempPathFactory) -> dict:
    out = tmp_path_factory.mktemp("sample") / "a"
    subprocess.run([executable("tank_datum"), SAMPLE, "--quiet", "-o", out], check=True)
    return json.loads((out / "datum.json").read_text())


def station(**values: object) -> Callable[[dict], Any]:
    return lambda datum: datum["stations"][7].update(**values)


def every_direction_zero(datum: dict) -> None:
    for one in datum["stations"]:
        one["direction_deg"] = 0


DAMAGES: list[tuple[dict | Callable[[dict], Any], str]] = [
    (every_direction_zero, "stations.direction_deg 0 of all, expected directions round the tank"),
    (station(sigma_z=0), "stations[7].sigma_z 0, expected >= 1e-15 m, or null"),
    (station(sigma_z=-1), "stations[7].sigma_z -1, expected >= 1e-15 m, or null"),
    (station(sigma_z=1e-320), "stations[7].sigma_z 1e-320, expected >= 1e-15 m, or null"),
    (station(flag="seen"), 'stations[7] flag "seen", expected one of measured, interpolated'),
    (station(window_deg=-3), "stations[7].window_deg -3, expected 0 to 360 deg, or null"),
    ({"input": {"kind": "photo"}}, 'input.kind "photo", expected one of scan, levelling'),
    ({"covariance": {"independent": [], "factors": []}}, "covariance 0 errors, expected one of"),
    ({"about": {"survey_date": "2024-02-30"}}, 'about.survey_date "2024-02-30", expected a day'),
    ({"checks": 20_000 * [{}]}, "checks 20000 entries, expected at most 1000"),
    ({"stations": 36_001 * [{}]}, "stations 36001 entries, expected at most 36000"),
]


@pytest.mark.parametrize(
    ("changes", "reason"), DAMAGES, ids=[reason.split(",")[0] for _, reason in DAMAGES]
)
def test_a_damaged_survey_is_refused_by_its_key(
    tmp_path: Path, of_the_sample: dict, changes: dict | Callable[[dict], Any], reason: str
) -> None:
    whole, damaged = tmp_path / "a.json", tmp_path / "b.json"
    whole.write_text(json.dumps(of_the_sample))
    datum = copy.deepcopy(of_the_sample)
    if callable(changes):
        changes(datum)
    else:
        datum |= changes
    damaged.write_text(json.dumps(datum))
    words = [executable("tank_datum_compare"), whole, damaged, "-o", tmp_path / "out"]
    done = subprocess.run(words, capture_output=True, text=True)
    assert done.returncode == 3, done.stderr
    assert done.stderr.startswith(f"tank_datum_compare: epoch: {damaged}, {reason}")
    assert done.stderr.count("\n") == 1
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("changes", "status", "reason"),
    [
        ("not JSON", 3, "a datum.json or a folder with one"),
        (
            {"stations": None},
            3,
            "stations missing, or of another type, expected a datum.json with its stations",
        ),
        ({"tank": {"center": [0, 0], "radius": "5"}}, 3, "tank missing, or of another type"),
        ({"options": {}}, 3, "options.method missing, or of another type"),
        ({"checks": 3}, 3, "checks missing, or of another type"),
        (
            lambda datum: datum["stations"].pop(),
            3,
            "covariance 360 errors, expected one of each of the 359 stations",
        ),
        (
            lambda datum: datum["stations"][7].update(sigma_z=1e300),
            3,
            "stations[7].sigma_z 1e+300, expected at most 1000 m",
        ),
        (
            lambda datum: datum["stations"][7].update(z=1e300),
            3,
            "stations[7].z 1e+300, expected at most 1e+08 m",
        ),
        (
            lambda datum: datum["stations"][7].update(azimuth_deg=None),
            3,
            "stations[7] missing, or of another type",
        ),
        ({"status": "no_tank"}, 2, "of status no_tank, expected a result with a usable datum"),
        ({"options": {"method": "paper"}}, 2, "of method paper, expected the method"),
        ({"tank": {"center": [0, 0], "radius": 6}}, 2, "radius of the tank in the scan"),
        ({"tank": {"center": [0, 0], "radius": 5000}}, 2, "as mm and m taken for each other"),
        ({"tank": {"center": [9, 0], "radius": 5}}, 2, "centre of the tank in the scan"),
    ],
)
def test_unusable_baselines_are_refused(
    tmp_path: Path,
    of_the_sample: dict,
    changes: dict | str | Callable[[dict], Any],
    status: int,
    reason: str,
) -> None:
    """Nothing is written, and what stood there before stays."""
    baseline, out = tmp_path / "baseline.json", tmp_path / "out"
    datum = copy.deepcopy(of_the_sample)
    if callable(changes):
        changes(datum)
    elif isinstance(changes, dict):
        datum |= changes
    baseline.write_text(changes if isinstance(changes, str) else json.dumps(datum))
    out.mkdir()
    (out / "datum.json").write_text("of an earlier run")
    command = [executable("tank_datum"), SAMPLE, "-o", out, "--baseline", baseline]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == status, done.stderr
    assert done.stderr.startswith("tank_datum: ") and reason in done.stderr
    assert done.stderr.count("\n") == 1
    assert [(p.name, p.read_text()) for p in out.iterdir()] == [("datum.json", "of an earlier run")]


def test_a_missing_baseline_is_a_file_error(tmp_path: Path) -> None:
    command = [executable("tank_datum"), SAMPLE, "-o", tmp_path / "out"]
    done = subprocess.run([*command, "--baseline", tmp_path / "no"], capture_output=True, text=True)
    assert done.returncode == 3
    assert "datum.json or a folder with one" in done.stderr
    assert list(tmp_path.iterdir()) == []


def test_a_baseline_is_not_written_over(tmp_path: Path) -> None:
    run = [executable("tank_datum"), SAMPLE, "--quiet", "-o", tmp_path / "a"]
    subprocess.run(run, check=True)
    before = (tmp_path / "a/datum.json").read_bytes()
    for baseline in (tmp_path / "a", tmp_path / "a/datum.json"):
        done = subprocess.run([*run, "--baseline", baseline], capture_output=True, text=True)
        assert done.returncode == 2
        assert "outside of the inputs; this is the baseline" in done.stderr
    assert (tmp_path / "a/datum.json").read_bytes() == before
