"""The QA script: what moved is named and measured, and only what is allowed to move passes."""

from __future__ import annotations

import csv
import json
import shutil
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest

from conftest import ROOT
from qa_command import qa

CASES = """
[tolerance]
"stations.csv:z" = 0.00001
"input.files.*.path" = "ignore"

[[case]]
name = "sample"
inputs = ["{scan}"]
options = ["--stations", "36"]
"""


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a cases file whose fixture is as the command writes it today."""
    folder = tmp_path_factory.mktemp("qa")
    path = folder / "cases.toml"
    path.write_text(CASES.format(scan=ROOT / "tests" / "data" / "sample.pcd"))
    result = qa(path, "--update")
    assert result.returncode == 0, result.stderr
    assert "rewritten: datum.json, stations.csv" in result.stdout
    return folder


@pytest.fixture
def cases(made: Path, tmp_path: Path) -> Path:
    """The same to change at will."""
    shutil.copytree(made, tmp_path / "qa")
    return tmp_path / "qa" / "cases.toml"


def stations_of(cases: Path) -> list[list[str]]:
    with (cases.parent / "sample" / "stations.csv").open(newline="") as file:
        return list(csv.reader(file))


def put_stations(cases: Path, rows: list[list[str]]) -> None:
    with (cases.parent / "sample" / "stations.csv").open("w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows(rows)


def moved(cases: Path, column: str, by: float) -> None:
    """Moves the fixture's fifth station in one column."""
    rows = stations_of(cases)
    at = rows[0].index(column)
    rows[5][at] = repr(float(rows[5][at]) + by)
    put_stations(cases, rows)


def test_same_passes(cases: Path) -> None:
    result = qa(cases)
    assert result.returncode == 0
    assert result.stdout == "PASS  sample\n"


def test_last_digit_within_tolerance_passes_and_is_shown(cases: Path) -> None:
    moved(cases, "z", 0.000009)
    result = qa(cases)
    assert result.returncode == 0
    line = next(x for x in result.stdout.splitlines() if "stations.csv" in x)
    assert line.split() == ["stations.csv", "z", "moved", "1", "9e-06", "1e-05", "row", "5", "ok"]


def test_beyond_tolerance_fails(cases: Path) -> None:
    moved(cases, "z", -0.000011)
    result = qa(cases)
    assert result.returncode == 1
    line = next(x for x in result.stdout.splitlines() if "stations.csv" in x)
    assert line.split() == [
        "stations.csv", "z", "moved", "1", "1.1e-05", "1e-05", "row", "5", "FAIL",
    ]  # fmt: skip


def test_without_tolerance_nothing_may_move(cases: Path) -> None:
    moved(cases, "radius", 1e-12)
    result = qa(cases)
    assert result.returncode == 1
    assert "radius" in result.stdout


def test_text_that_changes_is_quoted(cases: Path) -> None:
    rows = stations_of(cases)
    rows[3][rows[0].index("flag")] = "missing"
    put_stations(cases, rows)
    result = qa(cases)
    assert result.returncode == 1
    assert '"missing" became "measured"' in result.stdout


def test_columns_are_named(cases: Path) -> None:
    rows = [row[:-1] + ["0"] for row in stations_of(cases)]
    rows[0][-1] = "torsion"
    put_stations(cases, rows)
    result = qa(cases)
    assert result.returncode == 1
    lines = [line.split() for line in result.stdout.splitlines()]
    assert ["stations.csv", "torsion", "is", "missing", "FAIL"] in lines
    assert ["stations.csv", "reason", "is", "new", "FAIL"] in lines


def test_rows_are_counted(cases: Path) -> None:
    put_stations(cases, stations_of(cases)[:-2])
    result = qa(cases)
    assert result.returncode == 1
    assert "34 rows became 36" in result.stdout


def test_keys_are_named(cases: Path) -> None:
    path = cases.parent / "sample" / "datum.json"
    datum = json.loads(path.read_text())
    datum["tilt"]["twist"] = 1
    del datum["tank"]["radius"]
    path.write_text(json.dumps(datum))
    lines = [line.split() for line in qa(cases).stdout.splitlines()]
    assert ["datum.json", "tilt.twist", "is", "missing", "FAIL"] in lines
    assert ["datum.json", "tank.radius", "is", "new", "FAIL"] in lines


def test_missing_file_is_named(cases: Path) -> None:
    text = cases.read_text().replace('"stations.csv:z" = 0.00001\n', "")
    cases.write_text(text + 'files = ["datum.json", "levels.csv"]\n')
    result = qa(cases)
    assert result.returncode == 1
    assert ["levels.csv", "is", "missing", "FAIL"] in [
        line.split() for line in result.stdout.splitlines()
    ]


def test_missing_fixture_is_named(cases: Path) -> None:
    (cases.parent / "sample" / "stations.csv").unlink()
    result = qa(cases)
    assert result.returncode == 1
    assert "has no fixture" in result.stdout


def test_update_shows_then_rewrites(cases: Path) -> None:
    before = stations_of(cases)
    moved(cases, "z", 0.5)
    result = qa(cases, "--update")
    assert result.returncode == 0
    assert "0.5" in result.stdout
    assert stations_of(cases) == before
    assert sorted(p.name for p in (cases.parent / "sample").iterdir()) == [
        "datum.json",
        "stations.csv",
    ]


def everything(folder: Path) -> dict[str, bytes]:
    return {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*") if p.is_file()}


def test_update_writes_the_fixtures_it_names_and_nothing_else(cases: Path) -> None:
    """A fixture further down runs in the cases file's own folder too."""
    root = cases.parent
    text = cases.read_text().replace('name = "sample"', 'name = "sample"\nfixture = "deep/B"')
    shutil.copy(ROOT / "tests" / "data" / "sample.pcd", root / "scan.pcd")
    cases.write_text(text.replace(str(ROOT / "tests" / "data" / "sample.pcd"), "scan.pcd"))
    shutil.copytree(root / "sample", root / "deep" / "B")
    for name in ("notes.txt", "report.html", "datum.json.bak", "deep/datum.json"):
        (root / "deep" / "B" / name).parent.mkdir(parents=True, exist_ok=True)
        (root / "deep" / "B" / name).write_text("mine")
    stations = root / "deep" / "B" / "stations.csv"
    stations.write_text(stations.read_text().replace("measured", "missing", 1))
    before = everything(root)
    result = qa(cases, "--update")
    assert result.returncode == 0, result.stdout + result.stderr
    after = everything(root)
    assert set(after) == set(before)
    changed = {name for name in after if after[name] != before[name]}
    assert changed == {"deep/B/stations.csv", "deep/B/datum.json"}


def test_update_keeps_what_tank_datum_did_not_write(cases: Path) -> None:
    fixture = cases.parent / "sample"
    (fixture / "datum.json").write_text('{"datum": "WGS 84"}')
    (fixture / "stations.csv").write_text("petrol stations")
    result = qa(cases, "--update")
    assert result.returncode == 0, result.stdout + result.stderr
    assert (fixture / "datum.kept.json").read_text() == '{"datum": "WGS 84"}'
    assert (fixture / "stations.kept.csv").read_text() == "petrol stations"
    assert result.stderr.count("kept as") == 2
    assert qa(cases).returncode == 0


def test_junit_is_no_input_and_replaces_only_its_own(cases: Path, tmp_path: Path) -> None:
    before = cases.read_bytes()
    refused = qa(cases, "--junit", cases)
    assert (refused.returncode, refused.stdout, cases.read_bytes()) == (2, "", before)
    (tmp_path / "junit.xml").write_text("mine")
    for _ in range(2):
        assert qa(cases, "--junit", tmp_path / "junit.xml").returncode == 0
    assert (tmp_path / "junit.kept.xml").read_text() == "mine"
    assert not (tmp_path / "junit.kept-2.xml").exists()


def test_status_is_compared(cases: Path) -> None:
    cases.write_text(cases.read_text().replace('"36"]', '"36", "--min-radius", "50"]'))
    result = qa(cases)
    assert result.returncode == 1
    assert "exit status 1, expected 0: tank_datum: no_tank" in result.stdout


def test_ignored_key_may_differ(cases: Path) -> None:
    path = cases.parent / "sample" / "datum.json"
    datum = json.loads(path.read_text())
    datum["input"]["files"][0]["path"] = "elsewhere.pcd"
    path.write_text(json.dumps(datum))
    assert qa(cases).returncode == 0


def test_junit(cases: Path, tmp_path: Path) -> None:
    moved(cases, "z", 0.25)
    assert qa(cases, "--junit", tmp_path / "junit.xml").returncode == 1
    suite = ElementTree.parse(tmp_path / "junit.xml").getroot()
    assert (suite.get("tests"), suite.get("failures")) == ("1", "1")
    failure = suite.find("testcase/failure")
    assert failure is not None and "stations.csv z moved 1 0.25" in " ".join(
        (failure.text or "").split()
    )


def test_command_that_is_not_there(cases: Path) -> None:
    result = qa(cases, "--command", "/nowhere/tank_datum")
    assert result.returncode == 1
    assert "/nowhere/tank_datum: No such file" in result.stdout


def test_own_fixtures() -> None:
    """This project's own results are what they were."""
    result = qa(ROOT / "tests" / "data" / "qa" / "cases.toml")
    assert result.returncode == 0, result.stdout
