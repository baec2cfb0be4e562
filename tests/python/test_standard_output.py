"""Standard output that is full or closed: a file that cannot be written."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from programs import executable
from report_pages import SAMPLE
from results import FOLDER
from test_errors import FILE_FAILED

PRINTED = {
    "help": ["--help"],
    "version": ["--version"],
    "config": ["--print-config"],
    "limits": ["--print-limits"],
    "json": [str(SAMPLE), "--json", "-", "-o", "out"],
    "summary": [str(SAMPLE), "-o", "out"],
}


def run_into(
    place: str, words: list[str], folder: Path, program: str = "tank_datum"
) -> subprocess.CompletedProcess[str]:
    """With a full standard output, or a closed one."""
    with Path("/dev/full").open("w") as full:
        return subprocess.run(
            [str(executable(program)), *words],
            cwd=folder,
            stdout=full if place == "full" else None,
            stderr=subprocess.PIPE,
            preexec_fn=(lambda: os.close(1)) if place == "closed" else None,
            text=True,
            timeout=60,
        )


@pytest.mark.parametrize("place", ["full", "closed"])
@pytest.mark.parametrize("words", PRINTED.values(), ids=PRINTED.keys())
def test_what_cannot_be_printed_is_said(place: str, words: list[str], tmp_path: Path) -> None:
    done = run_into(place, words, tmp_path)
    assert done.returncode == FILE_FAILED
    assert done.stderr.count("\n") == 1, done.stderr
    assert "standard output, not written, expected room for" in done.stderr
    if "-o" not in words:
        return
    assert sorted(p.name for p in (tmp_path / "out").iterdir()) == sorted(FOLDER)
    assert "the results of this run are in out" in done.stderr
    assert "earlier run" not in done.stderr


def test_a_comparison_that_cannot_be_printed_is_there(command: Path, tmp_path: Path) -> None:
    for _ in range(2):
        words = [str(command), str(command), "-o", "out"]
        done = run_into("full", words, tmp_path, "tank_datum_compare")
        assert done.returncode == FILE_FAILED
        assert done.stderr.count("\n") == 1, done.stderr
        assert done.stderr.endswith("; the results of this run are in out\n"), done.stderr
        assert (tmp_path / "out" / "movement.json").exists()


def test_nothing_is_printed_where_nothing_is_to_be(tmp_path: Path) -> None:
    done = run_into("closed", [str(SAMPLE), "-o", "out", "--quiet"], tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert sorted(p.name for p in (tmp_path / "out").iterdir()) == sorted(FOLDER)
