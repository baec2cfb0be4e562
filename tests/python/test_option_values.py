"""Every number of every option at 0, negative, beyond all sizes or none: a result, or a line that
names the option."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from conftest import run_program
from report_pages import SAMPLE

VALUES = ("", "0", "-1", "1e300", "-1e300", "nan", "99999999999999999999")
# How a value of each kind is written; {} is the number.
WRITTEN = {
    "number": ["{}"],
    "integer": ["{}"],
    "fact": ["{}"],
    "length": ["{}", "{}ft"],
    "numbers": ["{}", "0.5,{}"],
    "integers": ["{}", "2,{}"],
    "circle": ["{},0,5", "0,0,{}"],
}


def options() -> list[tuple[str, str]]:
    listed = json.loads(run_program("tank_datum", ["--print-options"]).stdout)
    return [(option["name"], option["kind"]) for option in listed if option["kind"] in WRITTEN]


def test_options_of_every_kind_are_tried() -> None:
    assert {kind for _, kind in options()} == set(WRITTEN)


@pytest.mark.parametrize(("name", "kind"), options(), ids=lambda words: words)
def test_any_number_gives_a_result_or_a_line(tmp_path: Path, name: str, kind: str) -> None:
    flag = "--" + name.replace("_", "-")
    survey = [SAMPLE]
    if name == "diameter":
        survey = ["--stations-csv", SAMPLE.parent / "levelling/fourteen_stations.csv"]
    for value in (w.format(v) for w in WRITTEN[kind] for v in VALUES):
        words = [*survey, f"{flag}={value}", "--no-report", "--quiet", "-o", tmp_path / "out"]
        done = run_program("tank_datum", words, timeout=60)
        assert done.returncode in (0, 1, 2), (value, done.stderr)
        assert done.stderr.count("\n") == (done.returncode > 0), (value, done.stderr)
        if done.returncode == 2:
            assert name in done.stderr.replace("-", "_"), (value, done.stderr)


@pytest.mark.parametrize("typed", ["0360", "0x168", "-010", "08"])
def test_an_integer_is_decimal(tmp_path: Path, typed: str) -> None:
    """0360 was taken for octal, and so were 240 stations."""
    (tmp_path / "options.cfg").write_text(f"stations = {typed}\n")
    for words in (
        [f"--stations={typed}"],
        [f"--k={typed}"],
        ["--config", tmp_path / "options.cfg"],
    ):
        done = run_program("tank_datum", [SAMPLE, *words, "--no-report", "-o", tmp_path / "out"])
        assert (done.returncode, done.stderr.count("\n")) == (2, 1), done.stderr
        assert typed in done.stderr
        assert not (tmp_path / "out").exists()
