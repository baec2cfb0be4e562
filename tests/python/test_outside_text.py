"""Names and cells from outside are data: no terminal is steered by them, a bad one is one line."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from conftest import run_program
from report_pages import SAMPLE
from results import Run, read_datum

ESCAPE = "\x1b[31m\x07\nsecond\r\x9b31m"  # colour, bell, lines, and the one-character form of ESC [


def edited(command: Path, keys: list[str], value: object) -> str:
    """The text of the command's datum.json with another value."""
    whole = read_datum(command)
    part = whole
    for key in keys[:-1]:
        part = part[key]
    part[keys[-1]] = value
    return json.dumps(whole)


def csv(cell: str) -> str:
    return '"' + cell + '"'


# The file of each case, by its name, and the words that name it with {it}; {result} is a folder.
FILES: dict[str, tuple[Callable[[Path], str], list[str]]] = {
    "status of a baseline": (
        lambda result: edited(result, ["status"], ESCAPE),
        ["tank_datum", "{sample}", "-o", "{out}", "--baseline", "{it}"],
    ),
    "status of a survey": (
        lambda result: edited(result, ["status"], ESCAPE),
        ["tank_datum_compare", "{result}", "{it}", "-o", "{out}"],
    ),
    "method of a survey": (
        lambda result: edited(result, ["options", "method"], ESCAPE),
        ["tank_datum_compare", "{result}", "{it}", "-o", "{out}"],
    ),
    "surface of a survey": (
        lambda result: edited(result, ["datum", "surface"], ESCAPE),
        ["tank_datum_compare", "{result}", "{it}", "-o", "{out}"],
    ),
    "elevation of a levelling": (
        lambda _: "azimuth_deg,elevation\n0," + csv("1" + ESCAPE) + "\n",
        ["tank_datum", "--stations-csv", "{it}", "--diameter", "10", "-o", "{out}"],
    ),
    "header of a levelling": (
        lambda _: csv("azimuth" + ESCAPE) + ",elevation\n0,1\n",
        ["tank_datum", "--stations-csv", "{it}", "--diameter", "10", "-o", "{out}"],
    ),
    "place of a setup": (
        lambda _: "a," + csv(ESCAPE) + ",2,3\n",
        ["tank_datum", "{sample}", "-o", "{out}", "--setup-origins", "{it}"],
    ),
    "name of a setup": (
        lambda _: 2 * (csv("a" + ESCAPE) + ",1,2,3\n"),
        ["tank_datum", "{sample}", "-o", "{out}", "--setup-origins", "{it}"],
    ),
    "option of a file": (
        lambda _: "k = \x1b[31mx\n",
        ["tank_datum", "{sample}", "-o", "{out}", "--config", "{it}"],
    ),
    "key of a scene": (
        lambda _: json.dumps({"tanks": [{"radius" + ESCAPE: 3}]}),
        ["tank_datum_synth", "--scene", "{it}", "-o", "{out}.pcd"],
    ),
    "word of a scene": (
        lambda _: json.dumps({"tanks": [{"roof": ESCAPE}]}),
        ["tank_datum_synth", "--scene", "{it}", "-o", "{out}.pcd"],
    ),
    "row of a text": (
        lambda _: "1 2 3\n1 \x9b31m 3\n",
        ["tank_datum", "{it}", "-o", "{out}"],
    ),
    "word on the command line": (
        lambda _: "",
        ["tank_datum", "{sample}", "-o", "{out}", "--method", ESCAPE],
    ),
    "path on the command line": (lambda _: "", ["tank_datum", "none" + ESCAPE, "-o", "{out}"]),
}


def steers(text: str) -> bool:
    return any(c != "\n" and (c < " " or "\x7f" <= c < "\xa0") for c in text)


def run_on(name: str, command: Path, tmp_path: Path) -> Run:
    make, (program, *words) = FILES[name]
    given = tmp_path / "given"
    given.write_text(make(command), encoding="utf-8")
    places = {"it": given, "out": tmp_path / "out", "sample": SAMPLE, "result": command}
    return run_program(program, [w.format(**places) for w in words], tmp_path)


@pytest.mark.parametrize("name", FILES)
def test_one_line_that_does_not_steer(command: Path, tmp_path: Path, name: str) -> None:
    done = run_on(name, command, tmp_path)
    assert done.returncode != 0
    assert len(done.stderr.splitlines()) == 1, done.stderr
    assert not steers(done.stderr + done.stdout), ascii(done.stderr)


def test_names_of_files_in_summary_and_results(tmp_path: Path) -> None:
    scan = shutil.copy(SAMPLE, tmp_path / "a\x1b[31m<b>\x9b.pcd")
    done = run_program("tank_datum", [scan, "-o", tmp_path / "o\x1b[31m"])
    assert done.returncode == 0, done.stderr
    assert done.stdout
    assert not steers(done.stdout + done.stderr)
    datum = json.loads((tmp_path / "o\x1b[31m" / "datum.json").read_text())
    assert datum["input"]["files"][0]["path"] == str(scan)
    page = (tmp_path / "o\x1b[31m" / "report.html").read_text()
    assert "[31m<b>" not in page
    compared = run_program(
        "tank_datum_compare", [tmp_path / "o\x1b[31m"] * 2 + ["-o", tmp_path / "moved"]
    )
    assert compared.returncode == 0, compared.stderr
    assert not steers(compared.stdout + compared.stderr)
