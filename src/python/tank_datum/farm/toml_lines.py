"""Where in a TOML file a key stands; tomllib reads values but does not say.

A file that tomllib accepts is a row of statements: headers and `key = value`. A statement ends with
the first line at which tomllib accepts what was gathered, since a newline ends a complete one.
"""

from __future__ import annotations

import tomllib
from collections.abc import Iterator
from typing import Any

Path = tuple[str | int, ...]


def line_numbers(text: str) -> dict[Path, int]:
    """The line of every key, table and element of an array of tables, by its path.

    text: TOML that tomllib has accepted. What is inside a value has the value's line.
    """
    lines: dict[Path, int] = {}
    table: Path = ()
    counts: dict[Path, int] = {}
    for number, statement in _statements(text):
        keys = _keys(tomllib.loads(statement))
        if statement.lstrip().startswith("["):
            table = _opened(keys, counts, statement.lstrip().startswith("[["))
            lines.setdefault(table, number)
        else:
            for depth in range(1, len(keys) + 1):
                lines.setdefault((*table, *keys[:depth]), number)
    return lines


def line_of(lines: dict[Path, int], path: Path) -> int:
    """The line of a path, or of the innermost part of it that has one; 0 without any."""
    while path and path not in lines:
        path = path[:-1]
    return lines.get(path, 0)


def _statements(text: str) -> Iterator[tuple[int, str]]:
    gathered, begun = "", 0
    for number, line in enumerate(text.split("\n"), start=1):
        begun = begun if gathered else number
        gathered += line + "\n"
        try:
            found = tomllib.loads(gathered)
        except tomllib.TOMLDecodeError:
            continue
        if found:
            yield begun, gathered
        gathered = ""


def _keys(found: dict[str, Any]) -> list[str]:
    """The keys of one statement, outermost first; those of its value left out."""
    keys: list[str] = []
    node: Any = found
    while isinstance(node, dict) and len(node) == 1:
        ((key, node),) = node.items()
        keys.append(key)
        if isinstance(node, list) and node == [{}]:
            break
    return keys


def _opened(keys: list[str], counts: dict[Path, int], is_element: bool) -> Path:
    """The path of a header, with the number of the element of each array of tables in it."""
    path: Path = ()
    for depth, key in enumerate(keys):
        path = (*path, key)
        last = depth == len(keys) - 1
        if last and is_element:
            counts[path] = counts.get(path, -1) + 1
        if path in counts:
            path = (*path, counts[path])
    return path
