"""tank_datum_qa: cases of every command, its options, and the same cases in pytest."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from importlib.metadata import entry_points
from pathlib import Path

import pytest

from conftest import ROOT
from programs import executable
from qa_command import fake, one_case, qa

CASES = """
[tolerance]
"*sigma*" = 1e-6

[[case]]
name = "spring"
inputs = ["scan.pcd"]
options = ["--stations", "36"]

[[case]]
name = "rod"
command = "levelling"
inputs = ["rod.csv"]
options = ["--diameter", "30"]

[[case]]
name = "movement"
command = "compare"
inputs = ["before", "before/datum.json"]
"""


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with cases of every command and their fixtures."""
    folder = tmp_path_factory.mktemp("qa")
    shutil.copy(ROOT / "tests/data/sample.pcd", folder / "scan.pcd")
    rows = "".join(f"{a},{0.001 * (a % 50)},0.001\n" for a in range(0, 360, 15))
    (folder / "rod.csv").write_text("azimuth_deg,elevation,sigma\n" + rows)
    words = [executable("tank_datum"), "scan.pcd", "-o", "before", "--stations", "36", "--quiet"]
    subprocess.run(words, cwd=folder, check=True)
    (folder / "cases.toml").write_text(CASES)
    result = qa(folder / "cases.toml", "--update")
    assert result.returncode == 0, result.stdout + result.stderr
    return folder


@pytest.fixture
def folder(made: Path, tmp_path: Path) -> Path:
    """The same to change at will."""
    shutil.copytree(made, tmp_path / "qa")
    return tmp_path / "qa"


def shift(path: Path, name: str, by: float) -> None:
    """Moves a figure of every station of a datum.json."""
    datum = json.loads(path.read_text())
    for station in datum["stations"]:
        station[name] += by * (2 if station["azimuth_deg"] == 90 else 1)
    path.write_text(json.dumps(datum))


def test_every_command_passes(folder: Path) -> None:
    result = qa(folder / "cases.toml")
    assert (result.returncode, result.stdout) == (0, "PASS  spring\nPASS  rod\nPASS  movement\n")
    assert {p.name for p in (folder / "movement").iterdir()} >= {"movement.json", "movement.csv"}


def test_file_is_found_from_anywhere(folder: Path) -> None:
    """Its paths are relative to it, whatever the folder of the call and however it is named."""
    words = [sys.executable, ROOT / "scripts/qa.py", "../qa/cases.toml", "-k", "spring"]
    environment = {**os.environ, "TANK_DATUM_BIN": str(executable("tank_datum").parent)}
    result = subprocess.run(
        words, cwd=folder / "before", capture_output=True, text=True, env=environment
    )
    assert result.returncode == 2 and "../qa/cases.toml, 'No such file" not in result.stdout
    words[2] = "../cases.toml"
    result = subprocess.run(
        words, cwd=folder / "before", capture_output=True, text=True, env=environment
    )
    assert (result.returncode, result.stdout) == (0, "PASS  spring\n"), result.stderr


def test_arrays_are_one_row(folder: Path) -> None:
    shift(folder / "spring" / "datum.json", "z", 0.5)
    result = qa(folder / "cases.toml", "-k", "spring")
    assert result.returncode == 1
    rows = [line.split() for line in result.stdout.splitlines() if "stations.*.z" in line]
    assert rows == [["datum.json", "stations.*.z", "moved", "36", "1", "0", "9", "FAIL"]]
    hint = f"when these changes are wanted: tank_datum_qa {folder}/cases.toml -k spring --update"
    assert result.stdout.splitlines()[-1] == hint


def test_words_of_arrays_are_one_row(folder: Path) -> None:
    text = (folder / "spring" / "datum.json").read_text()
    (folder / "spring" / "datum.json").write_text(text.replace('"measured"', '"missing"', 9))
    rows = qa(folder / "cases.toml", "-k", "spring").stdout.splitlines()
    assert sum("stations.*.flag" in row for row in rows) == 1
    assert any(re.search(r'"missing" became "measured" +[89] +[01] +FAIL', row) for row in rows)


def test_pattern_for_nothing_is_refused(folder: Path) -> None:
    cases = folder / "cases.toml"
    cases.write_text(CASES.replace('"*sigma*"', '"*sigmas*" = 1e-6\n"*sigma*"'))
    result = qa(cases)
    assert result.returncode == 2
    assert "tolerance.*sigmas*, for no value of any case" in result.stderr
    cases.write_text(CASES + "[case.tolerance]\nheave = 1.0\n")
    result = qa(cases)
    assert result.returncode == 1
    assert "tolerance 'heave', for no value of movement.json, movement.csv" in result.stdout


def test_chosen_and_listed(folder: Path) -> None:
    listed = qa(folder / "cases.toml", "--list").stdout
    assert listed.splitlines()[1:] == [
        "rod: levelling rod.csv",
        "movement: compare before before/datum.json",
    ]
    assert qa(folder / "cases.toml", "-k", "RO").stdout == "PASS  rod\n"
    result = qa(folder / "cases.toml", "-k", "autumn")
    assert result.returncode == 2 and "expected a part of one of: spring, rod" in result.stderr


def test_junit_has_times_and_readable_failures(folder: Path) -> None:
    shift(folder / "rod" / "datum.json", "z", 0.25)
    qa(folder / "cases.toml", "--junit", folder / "junit.xml")
    suite = ElementTree.parse(folder / "junit.xml").getroot()
    spring, rod, movement = suite.findall("testcase")
    assert all(float(case.get("time", "0")) > 0 for case in (spring, rod, movement))
    assert (rod.get("classname"), spring.find("failure")) == ("qa.levelling", None)
    failure = rod.find("failure")
    assert failure is not None
    assert "stations.*.z moved by 0.5, 0 allowed" in failure.get("message", "")
    assert len((failure.text or "").splitlines()) > 1


# ---- pytest ----


def in_pytest(folder: Path, *words: str) -> subprocess.CompletedProcess[str]:
    plugin = "tank_datum_qa.pytest_plugin"
    installed = any(entry.value == plugin for entry in entry_points(group="pytest11"))
    call = [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", *words]
    environment = {
        **os.environ,
        "TANK_DATUM_BIN": str(executable("tank_datum").parent),
        "PYTHONPATH": f"{ROOT / 'src/python'}{os.pathsep}{os.environ.get('PYTHONPATH', '')}",
    }
    call += [] if installed else ["-p", plugin]
    return subprocess.run(call, cwd=folder, capture_output=True, text=True, env=environment)


def test_cases_are_tests(folder: Path) -> None:
    shift(folder / "rod" / "datum.json", "z", 0.25)
    result = in_pytest(folder, "-v", "--tank-datum-cases", "cases.toml")
    assert result.returncode == 1, result.stdout + result.stderr
    for line in (
        "cases.toml::spring PASSED",
        "cases.toml::rod FAILED",
        "cases.toml::movement PASSED",
    ):
        assert line in result.stdout
    assert "stations.*.z" in result.stdout and "Traceback" not in result.stdout


def test_pattern_for_nothing_fails_in_pytest_too(folder: Path) -> None:
    cases = folder / "cases.toml"
    cases.write_text(CASES.replace('"*sigma*"', '"*sigmas*" = 1e-6\n"*sigma*"'))
    result = in_pytest(folder, "--tank-datum-cases", "cases.toml")
    assert result.returncode == 1
    assert "tolerance.*sigmas*, for no value of any case" in result.stdout


def test_fixture_finds_its_cases_beside_the_test(folder: Path) -> None:
    below = folder / "tests"
    below.mkdir()
    call = "def test_it(tank_datum_qa):\n    assert tank_datum_qa('{}', '{}').passed\n"
    (below / "test_root.py").write_text(call.format("cases.toml", "rod"))
    (below / "test_beside.py").write_text(call.format("../cases.toml", "rod"))
    (below / "test_none.py").write_text(call.format("cases.toml", "autumn"))
    result = in_pytest(folder, f"--rootdir={folder}", "tests")
    assert "2 passed" in result.stdout and "1 failed" in result.stdout, result.stdout
    assert "'autumn' in" in result.stdout and "expected one of: spring, rod" in result.stdout


def test_documented_fixture_runs_a_case(folder: Path) -> None:
    page = (ROOT / "src/doc/qa.md").read_text()
    block = re.search(r"```python\n(.*?)```", page, re.DOTALL)
    assert block is not None
    (folder / "test_tanks.py").write_text(block[1])
    assert in_pytest(folder).returncode == 0
    shift(folder / "spring" / "datum.json", "z", 0.25)
    result = in_pytest(folder)
    assert result.returncode == 1 and "stations.*.z" in result.stdout


def test_nothing_passes_beside_a_refused_pattern(tmp_path: Path) -> None:
    """What is rewritten is shown nevertheless."""
    cases = one_case(tmp_path, more='files = ["datum.json"]\n[tolerance]\nheave = 1.0')
    words = ["--command", fake(tmp_path, 'echo "{}" > "$out/datum.json"')]
    said = "qa: cases: tolerance.heave, for no value of any case"
    updated = qa(cases, *words, "--update")
    assert updated.returncode == 2 and updated.stderr.startswith(said)
    assert "rewritten: datum.json" in updated.stdout
    result = qa(cases, *words)
    assert (result.returncode, result.stdout) == (2, "") and result.stderr.startswith(said)
