"""tank_datum_compare and --baseline: files, exit statuses, and what the options change."""

import json
import math
import subprocess
from pathlib import Path

import pytest

from conftest import ROOT, executable

SAMPLE = ROOT / "tests" / "data" / "sample.pcd"


def epoch(path: Path, dip: float = 0.0, **changes: object) -> Path:
    stations = []
    for i in range(360):
        near = abs(i - 100) < 5
        z = 1 + 0.006 * math.cos(math.radians(2 * i)) - (dip if near else 0)
        stations.append(
            {"azimuth_deg": i, "direction_deg": i, "z": z, "sigma_z": 0.0002, "flag": "measured"}
        )
    result = {
        "schema": 1,
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
    assert sorted(f.name for f in (tmp_path / "m").iterdir()) == [
        "manifest.json",
        "movement.csv",
        "movement.json",
        "report.html",
    ]


def test_options_change_the_outcome(tmp_path: Path) -> None:
    surveys = [epoch(tmp_path / f"{i}.json", 0.002 * i) for i in range(2)]

    def movement(*options: str) -> dict:
        done = compare(*surveys, "-o", tmp_path / "m", *options)
        assert done.returncode == 0, done.stderr
        return json.loads((tmp_path / "m/movement.json").read_text())["movements"][0]

    def significant(*options: str) -> int:
        return movement(*options)["significant"]

    assert significant() > 0
    assert significant("--registration-error", "0.005") == 0
    # surveys that do not fit each other: the datum's waves are no errors, and stations moved
    turned = movement("--azimuth-offset-deg", "45")
    assert turned["rms"] > 0.005 > 2.0 * movement()["rms"]
    assert turned["significant"] > 180
    epoch(surveys[1], 0.0008)
    assert significant("--correlation-deg", "1") > significant("--correlation-deg", "60")
    compare(*surveys, "-o", tmp_path / "m", "--remove", "mean")
    assert (
        json.loads((tmp_path / "m/movement.json").read_text())["movements"][0]["removed"] == "mean"
    )


def test_dates_make_the_trend_one_per_year(tmp_path: Path) -> None:
    """2 mm in four years, and the same from two surveys where a third has a gap."""
    surveys = [epoch(tmp_path / f"{i}.json", d) for i, d in enumerate((0.0, 0.001, 0.002))]
    for i, missing in ((1, range(98, 102)), (2, range(200, 210))):
        later = json.loads(surveys[i].read_text())
        for k in missing:
            later["stations"][k] |= {"z": None, "sigma_z": None, "flag": "missing"}
        surveys[i].write_text(json.dumps(later))
    dates = "2020-01-01,2022-01-01,2024-01-01"
    done = compare(*surveys, "-o", tmp_path / "m", "--dates", dates)
    assert done.returncode == 0, done.stderr
    assert "mm/year" in done.stdout
    result = json.loads((tmp_path / "m/movement.json").read_text())
    assert result["trend"]["unit"] == "m/year"
    assert [m["date"] for m in result["movements"]] == dates.split(",")[1:]
    assert result["baseline_date"] == "2020-01-01"
    rates = result["trend"]["stations"]
    assert rates[96]["rate"] == pytest.approx(-0.0005, rel=1e-6)
    assert rates[100]["rate"] == pytest.approx(-0.0005, rel=1e-6)
    sigma = math.hypot(0.0002, 0.0001)  # its own and what all stations of a scan share
    assert rates[96]["sigma"] == pytest.approx(sigma / math.sqrt(8), rel=0.01)
    assert rates[100]["sigma"] == pytest.approx(sigma * math.sqrt(2) / 4, rel=1e-6)
    assert rates[205]["rate"] == pytest.approx(0.0, abs=1e-9)
    rows = [r.split(",") for r in (tmp_path / "m/movement.csv").read_text().splitlines()]
    assert float(rows[97][1]) == rates[96]["rate"]
    assert rows[101][3:6] == ["", "", ""] and rows[101][8] == "1"
    assert rows[206][3:6] != ["", "", ""] and rows[206][6:] == ["", "", ""]


@pytest.mark.parametrize(
    ("dates", "reason"),
    [
        ("2020-01-01", "expected one for each of the 2 surveys"),
        ("2020-01-01,2019-01-01", "one after the date before"),
        ("2020-01-01,2021-02-29", "2021-02-29"),
        ("2020-01-01,soon", "soon"),
    ],
)
def test_bad_dates_are_refused(tmp_path: Path, dates: str, reason: str) -> None:
    survey = epoch(tmp_path / "a.json")
    done = compare(survey, survey, "-o", tmp_path / "m", "--dates", dates)
    assert (done.returncode, reason in done.stderr) == (2, True), done.stderr
    assert not (tmp_path / "m").exists()


def test_surveys_of_other_station_counts_share_one_table(tmp_path: Path) -> None:
    """A coarse survey between two fine ones: its dz stands where it has a station."""
    surveys = [epoch(tmp_path / f"{i}.json", 0.001 * i) for i in range(3)]
    coarse = json.loads(surveys[1].read_text())
    coarse["stations"] = coarse["stations"][::4]
    surveys[1].write_text(json.dumps(coarse))
    assert compare(*surveys, "-o", tmp_path / "m").returncode == 0
    rows = (tmp_path / "m/movement.csv").read_text().splitlines()[1:]
    assert len(rows) == 360
    assert [bool(r.split(",")[3]) for r in rows[:6]] == [True, False, False, False, True, False]
    assert [float(rows[100].split(",")[k]) for k in (3, 6)] == pytest.approx([-0.001, -0.002])


def test_a_failure_leaves_the_earlier_result(tmp_path: Path) -> None:
    surveys = [epoch(tmp_path / f"{i}.json", 0.001 * i) for i in range(2)]
    other = epoch(tmp_path / "other.json", tank={"center": [0, 0], "radius": 29})
    assert compare(*surveys, "-o", tmp_path / "m").returncode == 0
    (tmp_path / "m/datum.json").write_text("not of this command")
    before = {p.name: p.read_bytes() for p in (tmp_path / "m").iterdir()}
    failed = compare(surveys[0], other, "-o", tmp_path / "m")
    assert failed.returncode == 2
    assert f"; {tmp_path / 'm'} holds the results of an earlier run, unchanged" in failed.stderr
    assert {p.name: p.read_bytes() for p in (tmp_path / "m").iterdir()} == before


@pytest.mark.parametrize(
    ("options", "status", "reason"),
    [
        (["--remove", "all"], 2, "--remove"),
        (["--azimuth-offset-deg", "north"], 2, "--azimuth-offset-deg"),
        (["--azimuth-offset-deg", "9", "--estimate-azimuth-offset"], 2, "--azimuth-offset-deg, 9"),
        (["--registration-tilt-arcsec", "-1"], 2, "--registration-tilt-arcsec, -1"),
        (["--registration-error", "-1"], 2, "--registration-error, -1"),
        (["--correlation-deg", "-1"], 2, "--correlation-deg, -1"),
        (["--radius-difference", "0"], 2, "--radius-difference, 0"),
        (["--centre-distance", "0"], 2, "--centre-distance, 0"),
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


def test_a_dash_is_no_folder(tmp_path: Path) -> None:
    done = subprocess.run(
        [
            executable("tank_datum_compare"),
            epoch(tmp_path / "0.json"),
            tmp_path / "0.json",
            "-o",
            "-",
        ],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 2
    expected = "--output, -, expected a folder, or ./- for one of that name"
    assert done.stderr == f"tank_datum_compare: command line: {expected}\n"
    assert not (tmp_path / "-").exists()
