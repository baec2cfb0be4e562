"""Reads scans of formats that the library recognises but does not read itself: E57, LAZ and COPC.

What a reader of a format gives is written at Blocks. pye57 and laspy do the reading; they come with
`pip install 'tank_datum[formats]'`.
"""

from __future__ import annotations

import importlib
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Protocol, TypeAlias

import numpy as np
from numpy.typing import NDArray

from tank_datum import _core

FIRST_BLOCK = 1 << 16  # rows; a look at the beginning of a file should not take long
BLOCK = 1 << 20  # rows

Place = tuple[float, float, float]
Block: TypeAlias = (
    "tuple[NDArray[np.float64], NDArray[np.uint32], int, int] | _core.LasBlock"
)


class Unreadable(Exception):
    """Its arguments are those of the library's errors: the thing, its value, what was expected."""

    def __init__(self, thing: str, value: object, expected: str) -> None:
        super().__init__(thing, one_line(str(value)), expected)


class Blocks(Protocol):
    """A scan as the library asks for it."""

    size: int  # rows of all setups
    step: float  # between neighbouring coordinates as they are stored, in the file's units
    tells_setups: bool
    setups: dict[int, tuple[str, Place | None]]  # name, and where the scanner stood
    lists_setups: bool  # `setups` has them all, and blocks() can pass over some
    parts: int  # of the file that every() can leave unread; 0: there is no every()

    def blocks(self, wanted: Sequence[int] | None) -> Iterator[Block]:
        """A pass: points (n, 3) in the file's units, their setup or setups, rows without a point,
        rows that are not wanted. Rows of setups that are not wanted are among the last.
        """
        ...

    def every(self, n: int) -> Iterator[Block]:
        """A pass over every n-th part; rows of the others are not wanted."""
        ...


# The reader of a format, the package that it is built on, and what that is to be given.
FORMATS = {
    "E57": ("tank_datum._e57", "pye57", "E57 as ASTM E2807 has it, not cut short"),
    "LAZ": (
        "tank_datum._laz",
        "laspy[lazrs]",
        "LAS 1.0 to 1.4 compressed by LASzip, not cut short",
    ),
}


def one_line(text: str) -> str:
    """Printable ASCII, at most two hundred characters."""
    words = " ".join("".join(c if " " <= c <= "~" else " " for c in text).split())
    return words if len(words) <= 200 else f"{words[:200]}..."


def sizes(rows: int) -> Iterator[int]:
    """How the rows of a file are divided into blocks."""
    size = FIRST_BLOCK
    while rows > 0:
        yield min(size, rows)
        rows -= size
        size = BLOCK


@contextmanager
def refusing(path: str, kind: str) -> Iterator[None]:
    """What a reader of somebody else's raises inside becomes Unreadable."""
    try:
        yield
    except (Unreadable, MemoryError, GeneratorExit, KeyboardInterrupt):
        raise
    except BaseException as error:  # noqa: BLE001  a panic of lazrs is no Exception
        said = (
            one_line(next(iter(str(error).strip().splitlines()), ""))
            or type(error).__name__
        )
        raise Unreadable(f"{kind} data of {path}", said, FORMATS[kind][2]) from None


def open_blocks(path: str, kind: str, classes: Sequence[int]) -> Blocks:
    """Opens a scan of one of FORMATS. `classes`: the codes of LAS that are wanted; none: all.

    Raises Unreadable.
    """
    module, package, _ = FORMATS[kind]
    try:
        reader = importlib.import_module(module)
    except ImportError:
        needed = f"{package} to read it: pip install 'tank_datum[formats]'"
        raise Unreadable(f"format of {path}", kind, needed) from None
    with refusing(path, kind):
        opened: Blocks = reader.open_blocks(path, classes)
    return opened
