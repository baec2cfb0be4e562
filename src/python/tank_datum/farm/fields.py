"""Values of a campaign's tables, each refused by its name and line."""

from __future__ import annotations

import datetime
import math
import unicodedata
from collections.abc import Sequence
from typing import Any

from tank_datum.farm.errors import Problem
from tank_datum.farm.toml_lines import Path, line_of

TURNS = ("LRE", "RLE", "LRO", "RLO", "PDF", "LRI", "RLI", "FSI", "PDI")
EARLIEST, LATEST = 1900, 2199  # years of surveys; the library's end in 2199


class Reader:
    """A file whose values are read; gathers what is wrong with them."""

    def __init__(self, file: str, lines: dict[Path, int]) -> None:
        self.file, self.lines = file, lines
        self.problems: list[Problem] = []
        self.refused: set[Path] = set()

    def refuse(self, path: Path, value: object, expected: str) -> None:
        """Notes "file:line: name, value, expected ..."."""
        self.refused.add(path)
        name = ".".join(str(part) for part in path if isinstance(part, str))
        self.say(path, f"{name}, {shown(value)}, expected {expected}")

    def say(self, path: Path, reason: str) -> None:
        self.problems.append(Problem(self.file, line_of(self.lines, path), reason))

    def table(self, given: dict[str, Any], path: Path) -> Table:
        return Table(self, given, path)


def shown(value: object) -> str:
    text = "nothing" if value is None else repr(value)
    return text if len(text) <= 80 else text[:77] + "..."


class Table:
    """One table. What it is asked for it knows; the rest is refused in the end."""

    def __init__(self, reader: Reader, given: dict[str, Any], path: Path) -> None:
        self._reader, self._given, self.path = reader, given, path
        self._known: set[str] = set()

    def line(self) -> int:
        return line_of(self._reader.lines, self.path)

    def text(self, name: str, default: str = "", *, needed: bool = False) -> str:
        value = self._take(name)
        if value is None and not needed:
            return default
        if not isinstance(value, str) or not value.strip():
            self._refuse(name, value, "a text that is not empty")
            return default
        if any(_is_control(letter) for letter in value):
            self._refuse(name, value, "a text without control characters")
        return value

    def name(self, name: str, default: str = "", *, needed: bool = False) -> str:
        """A text that is a name: written in one way, without blanks around it."""
        return named(self.text(name, default, needed=needed))

    def flag(self, name: str) -> bool:
        value = self._take(name)
        if value is not None and not isinstance(value, bool):
            self._refuse(name, value, "true or false")
        return value is True

    def number(
        self,
        name: str,
        *,
        above: float | None = None,
        least: float | None = None,
        most: float | None = None,
    ) -> float | None:
        value = self._take(name)
        if value is None:
            return None
        bound = "" if above is None else f" > {above:g}"
        bound = bound if least is None else f" >= {least:g}"
        bound += "" if most is None else f", at most {most:g}"
        good = (
            _is_number(value)
            and (above is None or value > above)
            and (least is None or value >= least)
            and (most is None or value <= most)
        )
        if not good:
            self._refuse(name, value, f"a number{bound}")
            return None
        return float(value)

    def numbers(self, name: str, count: int) -> Any:
        value = self._take(name)
        if value is None:
            return None
        if not _are_numbers(value, count):
            self._refuse(name, value, f"{count} numbers")
            return None
        return tuple(float(v) for v in value)

    def choice(self, name: str, words: Sequence[str]) -> str | None:
        value = self._take(name)
        if value is not None and value not in words:
            self._refuse(name, value, " or ".join(words))
            return None
        return None if value is None else str(value)

    def date(self, name: str) -> datetime.date | None:
        value = self._take(name)
        if isinstance(value, datetime.datetime):
            value = value.date()
        if isinstance(value, str):
            try:
                value = datetime.date.fromisoformat(value)
            except ValueError:
                pass
        if not isinstance(value, datetime.date):
            self._refuse(name, value, "a date as 2024-05-31")
            return None
        if not EARLIEST <= value.year <= LATEST:
            self._refuse(name, str(value), f"a date from {EARLIEST} to {LATEST}")
            return None
        return value

    def texts(self, name: str) -> tuple[str, ...]:
        value = self._take(name)
        listed = [value] if isinstance(value, str) else value
        good = isinstance(listed, list) and listed and all(_is_text(v) for v in listed)
        if not good:
            self._refuse(name, value, "paths, globs or URLs, one at least")
            return ()
        return tuple(listed)

    def marks(self, name: str) -> dict[str, float]:
        value = self._take(name)
        if value is None:
            return {}
        if not isinstance(value, dict) or not all(
            _is_number(v) for v in value.values()
        ):
            self._refuse(name, value, "names of benchmarks with an elevation each")
            return {}
        return {named(key): float(v) for key, v in value.items()}

    def sectors(self, name: str) -> tuple[tuple[float, float], ...]:
        value = self._take(name)
        if value is None:
            return ()
        if not isinstance(value, list) or not all(_are_numbers(v, 2) for v in value):
            self._refuse(name, value, "sectors as [[10, 80], [200, 250]]")
            return ()
        return tuple((float(a), float(b)) for a, b in value)

    def options(self, name: str) -> dict[str, Any]:
        value = self._take(name)
        if value is not None and not isinstance(value, dict):
            self._refuse(name, value, "a table of options")
            return {}
        return dict(value or {})

    def inner(self, name: str) -> Table:
        value = self.options(name)
        return Table(self._reader, value, (*self.path, name))

    def tables(self, name: str, *, needed: bool = False) -> list[Table]:
        value = self._take(name)
        if value is None and not needed:
            return []
        if not isinstance(value, list) or not all(isinstance(v, dict) for v in value):
            self._refuse(name, value, f"one [[{name}]] at least")
            return []
        return [
            Table(self._reader, v, (*self.path, name, i)) for i, v in enumerate(value)
        ]

    def refuse_unknown(self) -> None:
        for name in sorted(self._given.keys() - self._known):
            known = ", ".join(sorted(self._known))
            self._refuse(name, self._given[name], f"one of: {known}")

    def _take(self, name: str) -> Any:
        self._known.add(name)
        return self._given.get(name)

    def _refuse(self, name: str, value: object, expected: str) -> None:
        self._reader.refuse((*self.path, name), value, expected)


def named(text: str) -> str:
    return unicodedata.normalize("NFC", text).strip()


def _is_control(letter: str) -> bool:
    """Also what turns the direction of writing, or ends a line."""
    turns = unicodedata.bidirectional(letter) in TURNS
    return turns or unicodedata.category(letter) in ("Cc", "Zl", "Zp")


def _is_number(value: object) -> bool:
    if isinstance(value, bool) or not isinstance(value, int | float):
        return False
    try:
        return math.isfinite(value)
    except OverflowError:  # a whole number of hundreds of digits
        return False


def _are_numbers(value: object, count: int) -> bool:
    return (
        isinstance(value, list)
        and len(value) == count
        and all(_is_number(v) for v in value)
    )


def _is_text(value: object) -> bool:
    return isinstance(value, str) and bool(value.strip())
