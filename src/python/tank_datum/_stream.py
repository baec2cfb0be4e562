"""Points that a function of the caller's gives block by block, anew in every pass."""

from __future__ import annotations

import zlib
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tank_datum._errors import option_error, short
from tank_datum._foreign import Block, Place, Unreadable
from tank_datum._points import Array, as_points, tell_setups, unmasked

Numbered = tuple[NDArray[np.float64], NDArray[np.uint32]]
SMALL = 1 << 14  # rows
SETUP = "a number from 0 to 4294967294, or one for each point"
FRESH = "a function that returns a fresh iterator over the same points each time"


class Stream:
    """Blocks of `source` as the library asks for them; see tank_datum._foreign.Blocks.

    An item of an iterator is an array of shape (n, 3), or such an array and its setup: a number,
    or one for each point. The first item tells for all whether there are setups.
    """

    size = 0  # not known: the library counts
    lists_setups = False
    parts = 0

    def __init__(self, source: Callable[[], Iterable[Any]]) -> None:
        self._source = source
        self.setups: dict[int, tuple[str, Place | None]] = {}
        self._rows: int | None = None
        self._sums: tuple[int, int] | None = None
        self.raised: BaseException | None = None  # by the caller's function
        first = next(self._pass(), np.empty((0, 3)))
        self.tells_setups = tell_setups([first])
        self.step = _step(as_points(self._parts(first)[0]))

    def _pass(self) -> Iterator[Any]:
        """The items of a pass, from the caller's function."""
        items = self._source()
        if not isinstance(items, Iterable):
            raise TypeError(
                f"points = a function that returns {short(items)}, expected {FRESH}"
            )
        return iter(items)

    def blocks(self, wanted: Sequence[int] | None) -> Iterator[Block]:
        """A pass. What the caller's function raises is kept in `raised`."""
        rows, sums = 0, (0, 0)
        try:
            for block, setups in _joined(self._numbered(item) for item in self._pass()):
                rows, sums = rows + len(block), _sums(block, setups, sums)
                yield block, setups, 0, 0
        except GeneratorExit:
            raise
        except BaseException as error:
            self.raised = error
            raise Unreadable("points", error, "blocks of points") from error
        if self._rows not in (None, rows):
            met = f"{rows} rows in a later pass, {self._rows} in the first"
            raise Unreadable("points", met, FRESH)
        if self._sums not in (None, sums):
            met = "other points or setups in a later pass than in the first"
            raise Unreadable("points", met, FRESH)
        self._rows, self._sums = rows, sums

    def _numbered(self, item: Any) -> Numbered:
        points, setups = self._parts(item)
        block = np.ascontiguousarray(as_points(points), dtype=np.float64)
        return block, _numbers(unmasked(setups, points), len(block))

    def _parts(self, item: Any) -> tuple[Any, Any]:
        """The points of an item, and what it says of their setups."""
        if not self.tells_setups:
            return item, 0
        if not isinstance(item, tuple) or len(item) != 2:
            raise TypeError(
                "points = a block without its setup, expected one, as in the first"
            )
        return item


def _joined(blocks: Iterable[Numbered]) -> Iterator[Numbered]:
    """Small ones together: each costs as much as thousands of rows. What waits is a copy."""
    waiting: list[Numbered] = []
    rows = 0
    for block, setups in blocks:
        if len(block) < SMALL:
            waiting.append((block.copy(), np.broadcast_to(setups, len(block)).copy()))
            rows += len(block)
        if waiting and (rows >= SMALL or len(block) >= SMALL):
            yield _together(waiting)
            waiting, rows = [], 0
        if len(block) >= SMALL:
            yield block, setups
    if waiting:
        yield _together(waiting)


def _together(blocks: list[Numbered]) -> Numbered:
    points, setups = zip(*blocks, strict=True)
    return np.concatenate(points), np.concatenate(setups)


def _sums(
    block: NDArray[np.float64], setups: NDArray[np.uint32], before: tuple[int, int]
) -> tuple[int, int]:
    """Of all points so far, and of their setups: however a pass divides them into blocks."""
    each = np.ascontiguousarray(np.broadcast_to(setups, len(block)))
    return zlib.adler32(block.data, before[0]), zlib.adler32(each.data, before[1])


def _step(points: Array) -> float:
    """Between neighbouring coordinates as they are stored, in units of the input; 0: too small to matter."""
    stored = points[np.isfinite(points).all(axis=1)]
    if stored.dtype != np.float32 or len(stored) == 0:
        return 0.0
    return float(np.spacing(np.abs(stored).max()))


def _numbers(setups: Any, rows: int) -> NDArray[np.uint32]:
    """One number for all points of a block, or one for each."""
    given = np.asarray(setups)
    if given.dtype.kind not in "iu" or given.shape not in ((), (rows,)):
        raise TypeError(
            f"points = a setup of shape {given.shape} in {given.dtype} for {rows} points, expected {SETUP}"
        )
    if given.size > 0 and not (0 <= given.min() and given.max() < 0xFFFFFFFF):
        range_given = f"setup {given.min()} to {given.max()}"
        raise option_error("options", "points", range_given, SETUP)
    return given.astype(np.uint32)
