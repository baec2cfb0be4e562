"""tank_datum_add_qa as a project calls it: a program that is not there is refused at once."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

from programs import ROOT

PROJECT = """
cmake_minimum_required(VERSION 3.25)
project(tanks LANGUAGES NONE)
enable_testing()
set(tank_datum_COMMAND {default})
include({function})
add_executable(mine IMPORTED)
set_target_properties(mine PROPERTIES IMPORTED_LOCATION /bin/true)
tank_datum_add_qa("{cases}" {words})
"""


def configured(
    folder: Path,
    words: str,
    default: str = "/bin/true",
    cases: str = "cases.toml",
    project: str = PROJECT,
) -> tuple[str, str]:
    """What the configuration says is wrong, and the command of the test that it made."""
    if shutil.which("cmake") is None:
        pytest.skip("cmake is not installed")
    function = ROOT / "src/cmake/tank_datum-qa.cmake"
    text = project.format(function=function, words=words, default=default, cases=cases)
    (folder / "CMakeLists.txt").write_text(text)
    (folder / "cases.toml").touch()
    (folder / "beside").write_text("#!/bin/sh\n")
    (folder / "beside").chmod(0o755)
    call = ["cmake", "-S", str(folder), "-B", str(folder / "build")]
    said = " ".join(subprocess.run(call, capture_output=True, text=True).stderr.split())
    made = folder / "build" / "CTestTestfile.cmake"
    return said, made.read_text() if made.exists() else ""


@pytest.mark.parametrize(
    ("words", "program"),
    [
        pytest.param("", "/bin/true", id="default"),
        pytest.param("COMMAND /bin/false", "/bin/false", id="path"),
        pytest.param("COMMAND beside", "{folder}/beside", id="relative path"),
        pytest.param("COMMAND sh", "/bin/sh", id="name on the path"),
        pytest.param("COMMAND mine", "/bin/true", id="target"),
        pytest.param("COMMAND $<TARGET_FILE:mine>", "/bin/true", id="generator expression"),
    ],
)
def test_program_is_found(tmp_path: Path, words: str, program: str) -> None:
    said, made = configured(tmp_path, words)
    assert said == ""
    assert f'"--command" "{program.format(folder=tmp_path)}"' in made.replace("/usr/bin/", "/bin/")


@pytest.mark.parametrize(
    ("words", "default", "wrong"),
    [
        pytest.param("COMMAND", "/bin/true", "COMMAND, expected a value", id="no value"),
        pytest.param("NAME COMMAND /bin/true", "/bin/true", "NAME, expected a value", id="name"),
        pytest.param(
            "COMMAND /no/such", "/bin/true", "COMMAND /no/such, expected a program", id="path"
        ),
        pytest.param(
            "COMMAND nosuch", "/bin/true", "COMMAND nosuch, expected a program", id="word"
        ),
        pytest.param('COMMAND ""', "/bin/true", "COMMAND, expected a value", id="empty"),
        pytest.param("", "/no/such", "COMMAND /no/such, expected a program", id="default"),
    ],
)
def test_program_that_is_not_there(tmp_path: Path, words: str, default: str, wrong: str) -> None:
    said, made = configured(tmp_path, words, default)
    assert f"tank_datum_add_qa: {wrong}" in said
    assert made == ""


@pytest.mark.parametrize("cases", [".", "", "none.toml"])
def test_what_is_no_file_of_cases_is_refused(tmp_path: Path, cases: str) -> None:
    said, made = configured(tmp_path, "", cases=cases)
    assert "expected a file of cases" in said and "tank_datum_add_qa: " in said
    assert "add_test" not in made


def test_a_semicolon_is_part_of_a_name(tmp_path: Path) -> None:
    (tmp_path / "a;b.toml").touch()
    said, made = configured(tmp_path, "", cases="a;b.toml")
    assert said == "" and f'"{tmp_path}/a;b.toml" "--command" "/bin/true"' in made


def test_the_package_may_be_found_in_another_folder(tmp_path: Path) -> None:
    """Of which a function is seen from outside, and a variable is not."""
    (tmp_path / "below").mkdir()
    function = ROOT / "src/cmake/tank_datum-qa.cmake"
    text = f"set(tank_datum_QA_DIR /qa)\nset(tank_datum_COMMAND /bin/true)\ninclude({function})\n"
    (tmp_path / "below" / "CMakeLists.txt").write_text(text)
    project = PROJECT.replace("set(tank_datum_COMMAND {default})\n", "")
    project = project.replace("include({function})", "add_subdirectory(below)")
    said, made = configured(tmp_path, "", project=project)
    assert said == "" and '"--command" "/bin/true"' in made and "PYTHONPATH=/qa" in made
