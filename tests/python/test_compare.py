"""tank_datum_compare and --baseline: files, exit statuses, and what the options change."""

import json
import math
import shutil
import subprocess
from pathlib import Path

import pytest

from conftest import executable


def epoch(path: Path, dip: float = 0.0, **changes: object) -> Path:
    stations = []
    for i in range(360):
        near = abs(i - 100) < 5
        z = 1 + 0.006 * math.cos(math.radians(2 * i)) - (dip if near else 0)
        stations.append(
            {"azimuth_deg": i, "direction_deg": i, "z": z, "sigma_z": 0.0002, "flag": "measured"}
        )
    result = {
        "status": "ok",
        "options": {"method": "refined"},
        "tank": {"center": [0, 0], "radius": 30},
        "datum": {"surface": "foundation"},
        "stations": stations,
    }
    path.write_text(json.dumps(result | changes))
    return path


def compare(*arguments: object) -> subprocess.CompletedProcess:
    command = [executable("tank_datum_compare"), *arguments]
    return subprocess.run([str(a) for a in command], capture_output=True, text=True, check=False)


def test_three_surveys_give_a_table_a_trend_and_files(tmp_path: Path) -> None:
    surveys = [epoch(tmp_path / f"{i}.json", 0.001 * i) for i in range(3)]
    done = compare(*surveys, "-o", tmp_path / "m")
    assert done.returncode == 0, done.stderr
    assert "removed: none" in done.stdout
    movements = json.loads((tmp_path / "m/movement.json").read_text())["movements"]
    assert [round(m["max"], 6) for m in movements] == [-0.001, -0.002]
    assert movements[1]["stations"][100]["significant"]
    rows = (tmp_path / "m/movement.csv").read_text().splitlines()
    assert len(rows) == 361
    assert float(rows[101].split(",")[1]) == pytest.approx(-0.001)
    assert sorted(f.name for f in (tmp_path / "m").iterdir()) == ["movement.csv", "movement.json"]


def test_options_change_the_outcome(tmp_path: Path) -> None:
    surveys = [epoch(tmp_path / f"{i}.json", 0.002 * i) for i in range(2)]

    def significant(*options: str) -> int:
        done = compare(*surveys, "-o", tmp_path / "m", *options)
        assert done.returncode == 0, done.stderr
        return json.loads((tmp_path / "m/movement.json").read_text())["movements"][0]["significant"]

    assert significant() > 0
    assert significant("--registration-mm", "5") == 0
    assert significant("--correlation-deg", "0") > significant("--correlation-deg", "3")
    assert significant("--azimuth-offset-deg", "45") > 100
    compare(*surveys, "-o", tmp_path / "m", "--remove", "mean")
    assert (
        json.loads((tmp_path / "m/movement.json").read_text())["movements"][0]["removed"] == "mean"
    )


@pytest.mark.parametrize(
    ("options", "status", "reason"),
    [
        (["--remove", "all"], 2, "--remove"),
        (["--azimuth-offset-deg", "north"], 2, "--azimuth-offset-deg"),
        (["--registration-mm", "-1"], 2, "registration_error"),
        (["--correlation-deg", "-1"], 2, "correlation"),
        (["--radius-tolerance", "0"], 2, "radius_tolerance"),
        (["--centre-tolerance", "0"], 2, "centre_tolerance"),
    ],
)
def test_bad_options_are_refused_by_name(
    tmp_path: Path, options: list, status: int, reason: str
) -> None:
    survey = epoch(tmp_path / "a.json")
    done = compare(survey, survey, "-o", tmp_path / "m", *options)
    assert (done.returncode, reason in done.stderr) == (status, True), done.stderr
    assert not (tmp_path / "m").exists()


def test_what_is_no_comparison_is_refused(tmp_path: Path) -> None:
    survey = epoch(tmp_path / "a.json")
    feet = epoch(tmp_path / "b.json", tank={"center": [0, 0], "radius": 30 / 0.3048})
    assert compare(survey, feet).returncode == 2
    assert "ft and m" in compare(survey, feet).stderr
    assert compare(survey, tmp_path / "none.json").returncode == 3
    assert compare(survey, epoch(tmp_path / "c.json", stations=3)).returncode == 3
    assert compare(survey, epoch(tmp_path / "d.json", status="no_tank")).returncode == 1
    assert compare(survey).returncode == 2


def test_baseline_is_the_same_comparison(tmp_path: Path) -> None:
    sample = Path(__file__).parents[1] / "data/sample.pcd"
    run = [executable("tank_datum"), sample, "--quiet", "-o"]
    subprocess.run([*run, tmp_path / "a"], check=True)
    again = [*run, tmp_path / "b", "--baseline", tmp_path / "a", "--remove", "mean"]
    subprocess.run([*again, "--registration-error", "0.002"], check=True)
    movement = json.loads((tmp_path / "b/datum.json").read_text())["movement"]
    assert (movement["matched"], movement["significant"], movement["removed"]) == (360, 0, "mean")
    assert movement["max"] == pytest.approx(0, abs=1e-9)
    assert movement["registration_error"] == 0.002
    shutil.rmtree(tmp_path / "b")
    refused = subprocess.run(
        [*run, tmp_path / "b", "--registration-error", "-1"], capture_output=True, text=True
    )
    assert refused.returncode == 2
    assert "registration_error" in refused.stderr
