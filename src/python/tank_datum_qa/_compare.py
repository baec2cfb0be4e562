"""Result files compared with fixtures, value by value."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from tank_datum_qa._cases import Case, Tolerances
from tank_datum_qa._values import Scalar, Table, csv_table, csv_value, json_values


@dataclass(frozen=True)
class Change:
    """What moved in one column or key: how many values, and the largest of the moves."""

    file: str
    key: str
    what: str  # "moved", or why it cannot be compared
    count: int = 1
    largest: float = math.nan
    tolerance: float = 0.0
    where: str = ""  # the row of the largest
    failed: bool = True

    def row(self) -> tuple[str, ...]:
        number = "" if math.isnan(self.largest) else f"{self.largest:.3g}"
        allowed = f"{self.tolerance:.3g}" if number else ""
        verdict = "FAIL" if self.failed else "ok"
        count = str(self.count) if self.what == "moved" or self.count > 1 else ""
        return (
            self.file,
            self.key,
            self.what,
            count,
            number,
            allowed,
            self.where,
            verdict,
        )


def _numbers(a: Scalar, b: Scalar) -> bool:
    return all(isinstance(v, int | float) and not isinstance(v, bool) for v in (a, b))


def _difference(a: Scalar, b: Scalar) -> float | None:
    """How far two values are apart: 0 when equal, None when that is no number."""
    if not _numbers(a, b):
        same = a == b and isinstance(a, bool) == isinstance(b, bool)  # true is not 1
        return 0.0 if same else None
    try:
        one, other = float(a), float(b)  # type: ignore[arg-type]
    except OverflowError:  # a whole number beyond all others
        return 0.0 if a == b else None
    apart = abs(one - other)
    if math.isfinite(apart):
        return apart
    both_nan = math.isnan(one) and math.isnan(other)
    return 0.0 if one == other or both_nan else None  # NaN is beyond every tolerance


def _short(value: Scalar) -> str:
    text = json.dumps(value)
    return text if len(text) <= 24 else text[:21] + "..."


@dataclass(frozen=True)
class _Pair:
    """A value of both files, and where in its column or array it stands."""

    key: str
    where: str
    old: Scalar
    new: Scalar


def _general(key: str) -> tuple[str, str]:
    """A key with `*` for the indices of lists, and these."""
    parts = key.split(".")
    indices = ".".join(part for part in parts if part.isdigit())
    return ".".join("*" if part.isdigit() else part for part in parts), indices


def _column(
    file: str, key: str, pairs: list[_Pair], tolerances: Tolerances
) -> Change | None:
    """What moved in one column or array: the value furthest beyond what it may, and how many."""
    moves: list[tuple[float, float, float, str]] = []
    others: list[_Pair] = []
    for pair in pairs:
        tolerance = tolerances.of(file, pair.key)
        difference = _difference(pair.old, pair.new)
        if tolerance is None or difference == 0.0:
            continue
        if difference is None:
            others.append(pair)
        else:
            moves.append((difference - tolerance, difference, tolerance, pair.where))
    if others:
        first, count = others[0], len(others) + len(moves)
        what = f"{_short(first.old)} became {_short(first.new)}"
        return Change(file, key, what, count, where=first.where)
    if not moves:
        return None
    beyond, largest, tolerance, where = max(moves, key=lambda move: move[:2])
    return Change(
        file, key, "moved", len(moves), largest, tolerance, where, beyond > 0.0
    )


def _only_in(
    file: str, keys: list[str], what: str, tolerances: Tolerances
) -> Iterator[Change]:
    """A row for each array of keys that the other file lacks."""
    grouped: dict[str, list[str]] = {}
    for key in keys:
        if tolerances.of(file, key) is not None:
            general, where = _general(key)
            grouped.setdefault(general, []).append(where)
    for general, places in grouped.items():
        yield Change(file, general, what, len(places), where=places[0])


def compare_json(
    file: str, fixture: Path, result: Path, tolerances: Tolerances
) -> list[Change]:
    """Every key of two JSON files, nested ones as a.b; arrays as one, a.*.b."""
    old = json_values(fixture)
    new = json_values(result)
    changes = [
        *_only_in(file, [k for k in old if k not in new], "is missing", tolerances)
    ]
    changes += _only_in(file, [k for k in new if k not in old], "is new", tolerances)
    arrays: dict[str, list[_Pair]] = {}
    for key in (k for k in old if k in new):
        general, where = _general(key)
        arrays.setdefault(general, []).append(_Pair(key, where, old[key], new[key]))
    columns = [_column(file, key, pairs, tolerances) for key, pairs in arrays.items()]
    return changes + [change for change in columns if change]


def _surplus(
    file: str, old: Table, new: Table, tolerances: Tolerances
) -> Iterator[Change]:
    """The rows whose cells beyond the last column differ."""
    (old_names, old_rows), (new_names, new_rows) = old, new
    places = [
        f"row {i + 1}"
        for i, (one, other) in enumerate(zip(old_rows, new_rows, strict=True))
        if one[len(old_names) :] != other[len(new_names) :]
    ]
    if places and tolerances.of(file, "") is not None:
        what = "cells beyond the columns differ"
        yield Change(file, "", what, len(places), where=places[0])


def compare_csv(
    file: str, fixture: Path, result: Path, tolerances: Tolerances
) -> list[Change]:
    """Every column of two CSV files, row by row."""
    old_names, old_rows = old = csv_table(fixture)
    new_names, new_rows = new = csv_table(result)
    changes: list[Change | None] = [
        Change(file, name, "is missing") for name in old_names if name not in new_names
    ]
    changes += [
        Change(file, name, "is new") for name in new_names if name not in old_names
    ]
    if len(old_rows) != len(new_rows):
        counts = f"{len(old_rows)} rows became {len(new_rows)}"
        return [c for c in changes if c] + [Change(file, "", counts)]
    for name in (n for n in old_names if n in new_names):
        old_at, new_at = old_names.index(name), new_names.index(name)
        pairs = [
            _Pair(
                name, f"row {i + 1}", csv_value(one, old_at), csv_value(other, new_at)
            )
            for i, (one, other) in enumerate(zip(old_rows, new_rows, strict=True))
        ]
        changes.append(_column(file, name, pairs, tolerances))
    changes += _surplus(file, old, new, tolerances)
    return [change for change in changes if change]


def compare_file(
    file: str, fixture: Path, result: Path, tolerances: Tolerances
) -> list[Change]:
    """Two files by their kind; those that are neither JSON nor CSV byte by byte."""
    if not result.exists():
        return [Change(file, "", "is missing")]
    if not result.is_file():  # nothing is waited for
        return [Change(file, "", "is no regular file")]
    if not fixture.exists():
        return [Change(file, "", "has no fixture")]
    if not fixture.is_file():
        return [Change(file, "", "has no regular file for its fixture")]
    try:
        if file.endswith(".json"):
            return compare_json(file, fixture, result, tolerances)
        if file.endswith(".csv"):
            return compare_csv(file, fixture, result, tolerances)
    except ValueError as error:
        return [Change(file, "", f"cannot be read: {error}")]
    if fixture.read_bytes() == result.read_bytes():
        return []
    return [Change(file, "", "differs")]


def compare(case: Case, results: Path) -> list[Change]:
    """All files of a case."""
    changes: list[Change] = []
    for file in case.files:
        changes += compare_file(
            file, case.fixture / file, results / file, case.tolerances
        )
    return changes


def values_of(case: Case, results: Path) -> Iterator[tuple[str, str]]:
    """File and key of every value of a case, in its fixture or its results."""
    for file in case.files:
        for path in (case.fixture / file, results / file):
            if not path.is_file():
                continue
            try:
                if file.endswith(".json"):
                    yield from ((file, key) for key in json_values(path))
                elif file.endswith(".csv"):
                    yield from ((file, name) for name in csv_table(path)[0])
            except (OSError, ValueError):
                continue
