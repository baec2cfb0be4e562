"""The table of interfaces in src/doc/python.md names what there is; a gap has its reason there."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable

import pytest

from conftest import ROOT
from results import Run

tank_datum = pytest.importorskip("tank_datum", reason="the module is not installed")

from tank_datum_qa import _cases  # noqa: E402

PAGE = (ROOT / "src" / "doc" / "python.md").read_text()
SECTION = PAGE.split("## Which interface has what")[1].split("\n## ")[0]
ROWS = [
    [cell.strip() for cell in line.strip("|").split("|")]
    for line in SECTION.splitlines()
    if line.startswith("|")
][2:]
COLUMNS = {"C++": 1, "command": 2, "Python": 3, "QA cases": 4}
HEADERS = "\n".join(p.read_text() for p in (ROOT / "include").rglob("*") if p.is_file())
SETTINGS = tomllib.loads((ROOT / "scripts" / "pyproject.toml").read_text())["project"]
COMMANDS = SETTINGS["scripts"].keys() | {"tank_datum_view"}  # which needs a display and VTK


def named(column: str) -> set[str]:
    """What a column names as code."""
    return {name for row in ROWS for name in re.findall(r"`([^`]+)`", row[COLUMNS[column]])}


@pytest.fixture(scope="module")
def options(run: Callable[..., Run]) -> str:
    return run("--help").stdout


def in_python(name: str) -> bool:
    if name.endswith("="):
        return name == "progress=" or name[:-1] in tank_datum.defaults()
    found: object = tank_datum
    for part in name.removeprefix("tank_datum.").split("."):
        found = getattr(found, part, None)
    return found is not None


def test_no_cell_is_empty() -> None:
    """Each has what there is, or a footnote with the reason."""
    assert len(ROWS) > 15
    assert all(len(row) == 5 and all(row) for row in ROWS)
    used = set(re.findall(r"\[\^(\d+)\](?!:)", SECTION))
    assert used == set(re.findall(r"^\[\^(\d+)\]: \S", SECTION, re.MULTILINE))


def test_cpp_is_in_the_public_headers() -> None:
    for name in named("C++"):
        if name.endswith(".h"):
            assert list((ROOT / "include").rglob(name)), name
            continue
        for part in name.split("::"):
            assert re.search(rf"\b{part}\b", HEADERS), name


def test_commands_and_options_are_there(options: str) -> None:
    for name in named("command"):
        if name.startswith("-"):
            assert re.search(rf"(?<!\S){name}\b", options), name
        elif "/" in name:
            assert (ROOT / name).is_file(), name
        else:
            assert name in COMMANDS, name


def test_python_has_it() -> None:
    extras = SETTINGS["optional-dependencies"]
    for name in named("Python"):
        assert name in extras or in_python(name), name
    assert not in_python("extract_nothing") and not in_python("colour=")


def test_cases_have_it(options: str) -> None:
    for name in named("QA cases"):
        assert name in (options if name.startswith("-") else _cases.FILES_OF), name


def test_nothing_public_is_left_out() -> None:
    """Every function of the package, every installed command and every kind of case."""
    told = PAGE.split("## What may be given")[0]
    functions = {n for n in tank_datum.__all__ if n[0].islower() and n not in ("stages",)}
    assert {n for n in functions if f"`{n}" not in told and f"{n}()`" not in told} == set()
    studies = {"tank_datum_qa", "tank_datum_farm", "tank_datum_report"}  # have pages of their own
    assert COMMANDS - named("command") <= studies
    assert set(_cases.FILES_OF) == {n for n in named("QA cases") if not n.startswith("-")}
