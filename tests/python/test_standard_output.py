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


def run_into(place: str, words: list[str], folder: Path) -> subprocess.CompletedProcess[str]:
    """With a full standard output, or a closed one."""
    with Path("/dev/full").open("w") as full:
        return subprocess.run(
            [str(executable("tank_datum")), *words],
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


def test_nothing_is_printed_where_nothing_is_to_be(tmp_path: Path) -> None:
    done = run_into("closed", [str(SAMPLE), "-o", "out", "--quiet"], tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert sorted(p.name for p in (tmp_path / "out").iterdir()) == sorted(FOLDER)
