"""The cases in pytest: each run has a folder of its own, and paths are as in the command."""

from __future__ import annotations

from pathlib import Path

import pytest

from qa_command import fake, one_case, qa
from test_qa_commands import in_pytest

FILES = 'files = ["datum.json"]'


def test_a_run_has_not_the_results_of_the_one_before(tmp_path: Path) -> None:
    cases = one_case(tmp_path, more=FILES)
    cases.write_text(cases.read_text() + f'[[case]]\nname = "b"\ninputs = ["y"]\n{FILES}\n')
    for name in ("a", "b"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "datum.json").write_text("{}")
    command = fake(tmp_path, '[ "$1" = y ] || echo "{}" > "$out/datum.json"')
    (tmp_path / "test_both.py").write_text(
        "def test_both(tank_datum_qa):\n"
        "    passed = [tank_datum_qa('cases.toml', name).passed for name in 'aba']\n"
        "    assert passed == [True, False, True]\n"
    )
    result = in_pytest(tmp_path, "--tank-datum-command", str(command))
    assert result.returncode == 0, result.stdout


@pytest.mark.parametrize("link", ["file", "folder"])
def test_paths_are_relative_to_the_file_as_it_is_named(tmp_path: Path, link: str) -> None:
    """To the folder of a link, not of what it leads to; in the command and in pytest alike."""
    here, there = tmp_path / "here", tmp_path / "there"
    there.mkdir()
    one_case(there, more=FILES)
    if link == "folder":
        here.symlink_to(there)
    else:
        here.mkdir()
        (here / "cases.toml").symlink_to(there / "cases.toml")
    (here / "x").write_text("{}")
    (here / "a").mkdir()
    (here / "a" / "datum.json").write_text("{}")
    command = str(fake(tmp_path, 'cp "$1" "$out/datum.json"'))
    assert qa(here / "cases.toml", "--command", command).stdout == "PASS  a\n"
    (here / "test_it.py").write_text(
        "def test_it(tank_datum_qa):\n    assert tank_datum_qa('cases.toml', 'a').passed\n"
    )
    words = ["--tank-datum-command", command, "--tank-datum-cases", "cases.toml", "test_it.py"]
    result = in_pytest(here, *words)
    assert "2 passed" in result.stdout, result.stdout


def passing(folder: Path) -> str:
    """A file of two cases that pass, and the program that they run."""
    cases = one_case(folder, more=FILES)
    cases.write_text(cases.read_text() + f'[[case]]\nname = "b"\ninputs = ["y"]\n{FILES}\n')
    for name in ("a", "b"):
        (folder / name).mkdir()
        (folder / name / "datum.json").write_text("{}")
    return str(fake(folder, 'echo "{}" > "$out/datum.json"'))


def test_one_case_is_run_alone(tmp_path: Path) -> None:
    """By the name under which pytest reports it."""
    words = ["--tank-datum-command", passing(tmp_path), "--tank-datum-cases", "cases.toml"]
    result = in_pytest(tmp_path, *words, "cases.toml::b")
    assert "1 passed" in result.stdout, result.stdout
    assert "2 passed" in in_pytest(tmp_path, *words, "cases.toml").stdout


def test_a_file_in_addopts_is_found_from_every_folder(tmp_path: Path) -> None:
    command = passing(tmp_path)
    (tmp_path / "pytest.ini").write_text("[pytest]\naddopts = --tank-datum-cases cases.toml\n")
    deep = tmp_path / "deep"
    deep.mkdir()
    for folder in (tmp_path, deep):
        result = in_pytest(folder, "--tank-datum-command", command)
        assert "2 passed" in result.stdout, result.stdout
    none = in_pytest(deep, "--tank-datum-cases", "none.toml")
    assert "--tank-datum-cases none.toml, expected a file" in none.stderr, none.stderr
