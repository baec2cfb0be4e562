"""Files of options: a line that is refused is named; --print-config and --json without ado."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from conftest import ROOT
from results import Run

Runner = Callable[..., Run]
SAMPLE = ROOT / "tests" / "data" / "sample.pcd"
LEVELLING = ROOT / "tests" / "data" / "levelling" / "fourteen_stations.csv"
TABLE = ("--stations-csv", LEVELLING, "--diameter", 42)


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("stations=abc", "stations = 8 to 36000"),
        ("stations=7", "stations 8 to 36000"),
        ("nonsense=1", "NAME=VALUE of an option that tank_datum --help lists"),
        ("k2", "NAME=VALUE of an option that tank_datum --help lists"),
        ("k=2", "k >= 3"),
        ("height=8q", "a length as 8, 8m, 26.25ft, 315in or 8000mm"),
        ("search=foo", "search = flann or buckets"),
        ("clockwise=perhaps", "true or false"),
        ("output=there", "another option: --output goes on the command line"),
        ("k=", "k = >= 3"),
        ("heights=0.3,0.6", 'heights="0.3,0.6": a list stands in quotes'),
        ("tank=0,0,5", 'tank="0,0,5": a list stands in quotes'),
        ("heights=0.6,0.3", "heights = > 0 and <= 100 m and above the one before"),
    ],
)
def test_a_bad_line_is_named(run: Runner, tmp_path: Path, line: str, expected: str) -> None:
    config = tmp_path / "options.toml"
    config.write_text(f"# of the tank farm\nangle-deg=40\n\n  {line}  \nk=30\n")
    result = run(SAMPLE, "-o", tmp_path / "out", "--config", config)
    assert result.returncode == 2
    said = f"tank_datum: command line: {config} line 4, {line}, expected {expected}\n"
    assert result.stderr == said
    assert not (tmp_path / "out").exists()


def test_good_lines_are_taken(run: Runner, tmp_path: Path) -> None:
    config = tmp_path / "options.toml"
    config.write_text("; old style\r\nk=30\r\nclockwise=true\r\nheight=26ft\r\n")
    result = run("--config", config, "--print-config")
    assert result.returncode == 0, result.stderr
    printed = tomllib.loads(result.stdout)
    assert (printed["k"], printed["clockwise"], printed["height"]) == (30, True, "26ft")


def test_a_byte_order_mark_is_named(run: Runner, tmp_path: Path) -> None:
    """An editor shows none; the line that it stands in looks right."""
    config = tmp_path / "options.toml"
    config.write_text("k=30\n", encoding="utf-8-sig")
    result = run("--config", config, "--print-config")
    assert result.returncode == 2
    where = f"tank_datum: command line: {config} line 1"
    assert result.stderr == f"{where}, a byte order mark, expected UTF-8 without one\n"


def test_options_are_printed_without_a_scan(run: Runner, tmp_path: Path) -> None:
    result = run("--print-config", "--k", 30, cwd=tmp_path)
    assert result.returncode == 0, result.stderr
    assert tomllib.loads(result.stdout)["k"] == 30
    assert run(SAMPLE, "--print-config", "--k", 30, cwd=tmp_path).stdout == result.stdout
    assert list(tmp_path.iterdir()) == []


def test_printed_options_may_be_given_again(run: Runner, tmp_path: Path) -> None:
    config = tmp_path / "options.toml"
    config.write_text(run("--print-config", "--k", 30).stdout)
    again = run("--config", config, "--print-config")
    assert again.stdout == config.read_text(), again.stderr


# ---- datum.json where a script wants it ----


def test_json_on_standard_output(run: Runner, tmp_path: Path) -> None:
    """The text of datum.json and nothing else."""
    result = run(*TABLE, "-o", tmp_path / "out", "--json", "-")
    assert result.returncode == 0, result.stderr
    assert result.stdout == (tmp_path / "out" / "datum.json").read_text()
    assert json.loads(result.stdout)["status"] == "ok"


def test_json_in_a_file(run: Runner, tmp_path: Path) -> None:
    """Replaced when it is the program's; kept under another name when it is somebody else's."""
    words = (*TABLE, "-o", tmp_path / "out", "--json", tmp_path / "tank.json")
    for _ in range(2):
        result = run(*words)
        assert result.returncode == 0 and "status" in result.stdout, result.stderr
    assert (tmp_path / "tank.json").read_bytes() == (tmp_path / "out/datum.json").read_bytes()
    assert sorted(p.name for p in tmp_path.iterdir()) == ["out", "tank.json"]
    (tmp_path / "tank.json").write_text("a note")
    assert "kept" in run(*words).stderr
    assert (tmp_path / "tank.kept.json").read_text() == "a note"


def test_json_of_every_tank_is_a_list(run: Runner, tmp_path: Path) -> None:
    result = run(SAMPLE, "-o", tmp_path / "out", "--all", "--json", "-")
    assert result.returncode == 0, result.stderr
    listed: list[Any] = json.loads(result.stdout)
    assert listed == [json.loads((tmp_path / "out/tank_1/datum.json").read_text())]


def test_json_is_no_input_and_no_result(run: Runner, tmp_path: Path) -> None:
    table = tmp_path / "table.csv"
    table.write_bytes(LEVELLING.read_bytes())
    words = ("--stations-csv", table, "--diameter", 42, "-o", tmp_path / "out")
    for path in (table, tmp_path / "out" / "datum.json"):
        result = run(*words, "--json", path)
        assert result.returncode == 2 and "--json" in result.stderr, result.stderr
    assert table.read_bytes() == LEVELLING.read_bytes()


@pytest.mark.parametrize(("lines", "status"), [(1000, 0), (1001, 2)])
def test_a_file_of_options_has_at_most_1000_lines(
    run: Runner, tmp_path: Path, lines: int, status: int
) -> None:
    config = tmp_path / "options.toml"
    config.write_text("# a remark\n" * (lines - 1) + "k = 30\n")
    result = run(SAMPLE, "-o", tmp_path / "out", "--config", config, "--quiet")
    assert result.returncode == status, result.stderr
    if status:
        reason = f"{config}, 1001 lines, expected at most 1000"
        assert result.stderr == f"tank_datum: command line: {reason}\n"
