"""The cases file: what to run, and how far results may move."""

from __future__ import annotations

import os
import re
import sys
import tomllib
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from fnmatch import fnmatchcase
from pathlib import Path
from typing import Any

from tank_datum_qa._regular_file import read_regular_text

FILES = ("datum.json", "stations.csv")
FILES_OF = {
    "extract": FILES,
    "levelling": FILES,
    "compare": ("movement.json", "movement.csv"),
}
"""what is compared of each command's results, unless the case says"""
KEYS = (
    "command",
    "files",
    "fixture",
    "inputs",
    "name",
    "options",
    "status",
    "tolerance",
)
IGNORE = "ignore"
OUTPUTS = re.compile(r"-o|--(output|timings|json)\b")
"""the options after which a command writes somewhere else"""


class CasesError(Exception):
    """A cases file that cannot be used; the message has the place, the value, the expectation."""


@dataclass(frozen=True)
class Tolerances:
    """How far a value may move: rules `pattern = number`, the first that matches, else not at all.

    A pattern is `column`, `key.key` or, with the file before it, `stations.csv:z`; `*` stands for
    anything, also for the index of a list. The number is absolute, in the value's own unit; the
    word "ignore" leaves the value out of the comparison.
    """

    rules: tuple[tuple[str, float | None], ...] = ()

    own: int = 0
    """how many of them, the first, are the case's own"""

    def of(self, file: str, key: str) -> float | None:
        """The largest change allowed, or None for a value that is not compared."""
        for pattern, tolerance in self.rules:
            if matches(pattern, file, key):
                return tolerance
        return 0.0


def matches(pattern: str, file: str, key: str) -> bool:
    """Whether a rule is for a value."""
    return fnmatchcase(key, pattern) or fnmatchcase(f"{file}:{key}", pattern)


@dataclass(frozen=True)
class Case:
    """One run, and the fixture of its results; paths are relative to the cases file."""

    name: str
    inputs: tuple[str, ...]
    fixture: Path
    root: Path
    """of the cases file, in which runs start"""
    command: str = "extract"
    """extract, compare or levelling"""
    options: tuple[str, ...] = ()
    status: int = 0
    files: tuple[str, ...] = FILES
    tolerances: Tolerances = field(default_factory=Tolerances)


def _refuse(where: str, value: object, expected: str) -> CasesError:
    return CasesError(f"{where}, {value!r}, expected {expected}")


def _rules(where: str, table: Any) -> tuple[tuple[str, float | None], ...]:
    if not isinstance(table, dict):
        raise _refuse(where, table, "a table of pattern = number")
    rules: list[tuple[str, float | None]] = []
    for pattern, value in table.items():
        whole = isinstance(value, int) and not isinstance(value, bool)
        number = isinstance(value, float) or (whole and value <= sys.float_info.max)
        if value != IGNORE and not (number and value >= 0):
            expected = f'a number >= 0 or "{IGNORE}"'
            raise _refuse(f"{where}.{pattern}", value, expected)
        rules.append((pattern, None if value == IGNORE else float(value)))
    return tuple(rules)


def _is_below(root: Path, path: Path) -> bool:
    """Also when links are followed; the folder itself is not, nor what no file can be called."""
    try:
        return root.resolve() in path.resolve().parents
    except (ValueError, OSError, RuntimeError):
        return False


def _texts(where: str, value: Any, least: int) -> tuple[str, ...]:
    if not (isinstance(value, list) and all(isinstance(v, str) for v in value)):
        raise _refuse(where, value, "a list of texts")
    if len(value) < least:
        raise _refuse(where, value, f"at least {least}")
    for text in value:
        if "\0" in text:
            raise _refuse(where, text, "texts without the character NUL")
    return tuple(value)


def _files(where: str, value: Any) -> tuple[str, ...]:
    """Names in the folder of results itself, which no link of a path leads out of."""
    files = _texts(where, value, 1)
    for file in files:
        if Path(file).name != file or file in ("", ".."):
            raise _refuse(where, file, "names of files in the fixture")
    return files


def _options(where: str, value: Any) -> tuple[str, ...]:
    options = _texts(where, value, 0)
    for option in options:
        if OUTPUTS.match(option):
            raise _refuse(where, option, "no option that names an output")
    return options


def _inputs(where: str, value: Any, command: str) -> tuple[str, ...]:
    inputs = _texts(where, value, 2 if command == "compare" else 1)
    if command == "levelling" and len(inputs) > 1:
        raise _refuse(where, list(inputs), "one table of stations")
    for name in inputs:
        if not name or name.startswith("-"):  # a command would take it for an option
            raise _refuse(where, name, "paths; ./-a is a file called -a")
    return inputs


def _case(
    where: str, table: Any, root: Path, common: tuple[tuple[str, float | None], ...]
) -> Case:
    if not isinstance(table, dict):
        raise _refuse(where, table, "a table")
    for key in table:
        if key not in KEYS:
            raise _refuse(where, key, f"one of {', '.join(KEYS)}")
    name = table.get("name")
    if not (isinstance(name, str) and name):
        raise _refuse(f"{where}.name", name, "a text")
    status = table.get("status", 0)
    if type(status) is not int or status not in (0, 1):
        raise _refuse(f"{name}.status", status, "0 or 1: other runs leave no results")
    fixture = table.get("fixture", name)
    if not (isinstance(fixture, str) and _is_below(root, root / fixture)):
        raise _refuse(
            f"{name}.fixture", fixture, "the name of a folder below the cases file's"
        )
    command = table.get("command", "extract")
    if not isinstance(command, str) or command not in FILES_OF:
        raise _refuse(f"{name}.command", command, "extract, compare or levelling")
    own = _rules(f"{name}.tolerance", table.get("tolerance", {}))
    return Case(
        name=name,
        inputs=_inputs(f"{name}.inputs", table.get("inputs"), command),
        fixture=root / fixture,
        root=root,
        command=command,
        options=_options(f"{name}.options", table.get("options", [])),
        status=status,
        files=_files(f"{name}.files", table.get("files", list(FILES_OF[command]))),
        tolerances=Tolerances(own + common, len(own)),
    )


def named(path: str | Path) -> Path:
    """A cases file by its absolute path, to whose folder its paths are relative: links stay."""
    return Path(os.path.abspath(path))


def read_cases(path: Path) -> list[Case]:
    """The cases of a TOML file: tables [[case]], and [tolerance] for all of them.

    Raises CasesError when the file cannot be read or does not say what it must.
    """
    try:
        return _checked(named(path))
    except RecursionError:
        deep = "values too deep in each other"
        raise _refuse(str(path), deep, "a cases file (TOML)") from None


def _checked(path: Path) -> list[Case]:
    try:
        table = tomllib.loads(read_regular_text(path).removeprefix("\ufeff"))
    except OSError as error:
        raise _refuse(str(path), error.strerror, "a readable file") from error
    except ValueError as error:
        raise _refuse(str(path), str(error), "TOML") from error
    for key in table:
        if key not in ("case", "tolerance"):
            raise _refuse(str(path), key, "[[case]] or [tolerance]")
    common = _rules("tolerance", table.get("tolerance", {}))
    listed = table.get("case", [])
    if not isinstance(listed, list) or not listed:
        raise _refuse(str(path), listed, "at least one [[case]]")
    cases = [
        _case(f"case {i + 1}", c, path.parent, common) for i, c in enumerate(listed)
    ]
    names = [case.name for case in cases]
    for name in names:
        if names.count(name) > 1:
            raise _refuse(str(path), name, "a name of its own for each case")
    fixtures: dict[Path, str] = {}
    for case in cases:
        other = fixtures.setdefault(case.fixture.resolve(), case.name)
        if other != case.name:
            raise _refuse(
                f"{case.name}.fixture",
                case.fixture.name,
                f"another than that of {other!r}",
            )
    return cases


def unused_rules(rules: Sequence[str], values: Iterable[tuple[str, str]]) -> list[str]:
    """The patterns that are for no value; `values` are files and keys."""
    known = list(values)
    return [
        rule
        for rule in rules
        if not any(matches(rule, file, key) for file, key in known)
    ]
