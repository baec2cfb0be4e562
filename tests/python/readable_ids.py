"""Names of parametrised tests that a person can read."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from programs import ROOT

MOST = 28  # characters of one parameter


def words_of(value: object) -> str | None:
    """The words of a value that pytest itself would write in full or name by its number."""
    if isinstance(value, str | Path):
        return str(value)
    if isinstance(value, Mapping):
        return " ".join(f"{key}={item}" for key, item in value.items()) or "none"
    if isinstance(value, Sequence) and not isinstance(value, bytes):
        return " ".join(map(str, value)) or "none"
    return None


def readable_id(value: object) -> str | None:
    """Text, lists and mappings on one line of at most MOST characters; None: as pytest has it."""
    words = words_of(value)
    if words is None:
        return None
    line = " ".join(words.replace(f"{ROOT}/", "").split()) or "blank"
    return line if len(line) <= MOST else line[: MOST - 3].rstrip() + "..."
