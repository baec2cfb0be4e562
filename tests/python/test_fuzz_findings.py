"""What scripts/fuzz, or a reader of the code, found once: a result or a line; no crash, no hang."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from conftest import ROOT, run_program
from report_pages import SAMPLE

FINDINGS = sorted(p for p in (ROOT / "tests/fuzz/findings").glob("*-*") if p.is_file())
# How each reader is reached; {it} is the finding.
WORDS: dict[str, list[str]] = {
    "scan": ["tank_datum", "{it}", "-o", "{out}"],
    "table": ["tank_datum_curves", "{it}"],
    "origins": ["tank_datum", "{sample}", "-o", "{out}", "--setup-origins", "{it}"],
    "limits": ["tank_datum", "{sample}", "-o", "{out}", "--limits", "{it}"],
    "json": ["tank_datum", "{sample}", "-o", "{out}", "--baseline", "{it}"],
    "baseline": ["tank_datum", "{sample}", "-o", "{out}", "--baseline", "{it}"],
    "config": ["tank_datum", "{sample}", "-o", "{out}", "--config", "{it}"],
    "about": ["tank_datum", "{sample}", "-o", "{out}", "--about", "{it}"],
    "levelling": ["tank_datum", "--stations-csv", "{it}", "--diameter", "20", "-o", "{out}"],
    "options": ["tank_datum", "{sample}", "-o", "{out}"],
    "scene": ["tank_datum_synth", "--scene", "{it}", "-o", "{out}.pcd"],
}


# Those that Python reads.
MODULES = {
    "campaign": ["tank_datum.farm", "check", "{it}"],
    "cases": ["tank_datum_qa", "{it}", "--list"],
}


def read(finding: Path, folder: Path) -> subprocess.CompletedProcess[str]:
    kind = finding.name.partition("-")[0]
    places = {"it": finding, "out": folder / "out", "sample": SAMPLE}
    if kind in MODULES:
        words = [sys.executable, "-m", *(w.format(**places) for w in MODULES[kind])]
        return subprocess.run(words, cwd=folder, capture_output=True, text=True, timeout=60)
    program, *words = (w.format(**places) for w in WORDS[kind])
    if kind == "options":  # each line is a word
        lines = finding.read_bytes().splitlines()
        words += [line.partition(b"\0")[0].decode(errors="replace") for line in lines]
    return run_program(program, words, folder, timeout=30)


@pytest.mark.parametrize("finding", FINDINGS, ids=lambda path: path.name[:24])
def test_a_finding_is_refused_or_read(tmp_path: Path, finding: Path) -> None:
    done = read(finding, tmp_path)
    assert done.returncode in (0, 1, 2, 3), done.stderr
    assert ": unexpected: " not in done.stderr
    assert "Traceback" not in done.stderr
    if done.returncode > 1:
        assert done.stderr.count("\n") == 1, done.stderr
