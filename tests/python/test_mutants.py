"""scripts/mutants.py finds the named numbers and alters one at a time."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))

import mutants  # noqa: E402


@pytest.mark.parametrize(
    ("number", "factor", "wanted"),
    [
        ("8", 0.5, "4"),
        ("1", 0.5, None),
        ("3", 2.0, "6"),
        ("0.3", 2.0, "0.6"),
        ("1e-3", 0.5, "0.0005"),
        ("30'000", 2.0, "60000"),
        ("0.0", 2.0, None),
    ],
)
def test_scaled(number: str, factor: float, wanted: str | None) -> None:
    assert mutants.scaled(number, factor) == wanted


def test_numbers_are_found_and_altered_one_at_a_time(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    source = tmp_path / "a.cpp"
    source.write_text(
        "constexpr double kOne = 0.25, kTwo = 4.0;  // [m]\nconstexpr int kThree = 7;\n"
        "constexpr double kNot = kOne * 2.0;\n"
    )
    monkeypatch.setattr(mutants, "ROOT", tmp_path)
    found = mutants.mutants_of(source)
    assert [(m.name, m.line, m.new) for m in found] == [
        ("kOne", 1, "0.125"), ("kOne", 1, "0.5"), ("kTwo", 1, "2.0"), ("kTwo", 1, "8.0"),
        ("kThree", 2, "3"), ("kThree", 2, "14"),
    ]  # fmt: skip
    assert source.read_text()[found[4].start : found[4].end] == "7"
