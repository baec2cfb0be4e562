"""What scripts/fuzz, or a reader of the code, found once: a result or a line; no crash, no hang."""

from __future__ import annotations

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
    "scene": ["tank_datum_synth", "--scene", "{it}", "-o", "{out}.pcd"],
}


@pytest.mark.parametrize("finding", FINDINGS, ids=lambda path: path.name[:24])
def test_a_finding_is_refused_or_read(tmp_path: Path, finding: Path) -> None:
    program, *words = WORDS[finding.name.partition("-")[0]]
    places = {"it": finding, "out": tmp_path / "out", "sample": SAMPLE}
    done = run_program(program, [w.format(**places) for w in words], tmp_path, timeout=30)
    assert done.returncode in (0, 1, 2, 3), done.stderr
    assert ": unexpected: " not in done.stderr
    if done.returncode > 1:
        assert done.stderr.count("\n") == 1, done.stderr
