"""The values of result files: of JSON by key, of CSV by column."""

from __future__ import annotations

import csv
import json
import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

Scalar = str | float | bool | dict[str, Any] | list[Any] | None
"""A value that holds no other; of the dicts and lists those that are empty."""


def read_json(path: Path) -> Any:
    """What a file holds. Raises OSError and ValueError."""
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except RecursionError:
        raise ValueError("values too deep in each other") from None


def json_values(path: Path) -> dict[str, Scalar]:
    """The same by key, nested ones as a.b.0."""
    table = read_json(path)
    try:
        return dict(_flat(table))
    except RecursionError:
        raise ValueError("values too deep in each other") from None


def _flat(value: Any, path: str = "") -> Iterator[tuple[str, Scalar]]:
    if isinstance(value, dict) and value:
        for key, inner in value.items():
            yield from _flat(inner, f"{path}.{key}" if path else key)
    elif isinstance(value, list) and value:
        for index, inner in enumerate(value):
            yield from _flat(inner, f"{path}.{index}" if path else str(index))
    else:
        yield path, value


Table = tuple[list[str], list[list[str]]]


def csv_table(path: Path) -> Table:
    """Columns and rows; the second column of a name has another. Raises OSError and ValueError."""
    try:
        with path.open(newline="", encoding="utf-8") as lines:
            names, *rows = list(csv.reader(lines)) or [[]]
    except csv.Error as error:
        raise ValueError(str(error)) from None
    before = [names[:i].count(name) for i, name in enumerate(names)]
    unique = [
        name if not count else f"{name} ({count + 1})"
        for name, count in zip(names, before, strict=True)
    ]
    return unique, rows


def csv_value(row: list[str], at: int) -> Scalar:
    """A cell; None where the row has none."""
    if at >= len(row):
        return None
    try:
        number = (
            float(row[at]) if "_" not in row[at] else math.nan
        )  # Python's 1_0 is no 10
    except ValueError:
        return row[at]
    return number if math.isfinite(number) else row[at]
