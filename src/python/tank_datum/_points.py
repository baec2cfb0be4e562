"""Points as callers have them, as the compiled part takes them."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from io import IOBase
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tank_datum._arguments import path_bytes
from tank_datum._errors import short

Array = NDArray[np.float32] | NDArray[np.float64]
EXPECTED = "an array of shape (n, 3) of numbers, the path of a scan, or a function that returns blocks"


Setups = int | np.integer[Any] | NDArray[np.integer[Any]]
Block = NDArray[Any] | tuple[NDArray[Any], Setups]
Scans = str | os.PathLike[str]
Points = (
    Scans
    | NDArray[Any]
    | Sequence[
        Scans | Block
    ]  # of one kind; mypy takes two Sequences for a list of objects
    | Iterator[Block]
    | Callable[[], Iterable[Block]]
)
"""What functions take as points; arrays may be of other libraries that NumPy converts."""


def as_points(given: Any) -> Array:
    """An array of shape (n, 3): as it is in native float32 or float64, else converted to float64.

    Integers, other byte orders, float16 and longer floats are converted; masked rows are dropped.

    Raises TypeError naming the shape and the type of anything else.
    """
    try:
        array = np.asanyarray(given)
    except (TypeError, ValueError) as error:
        raise TypeError(
            f"points = {type(given).__name__}, {error}, expected {EXPECTED}"
        ) from None
    if array.ndim == 0 and array.dtype.kind in "OUSMm":
        raise TypeError(f"points = {short(given)}, expected {EXPECTED}")
    if array.ndim != 2 or array.shape[1] != 3 or array.dtype.kind not in "iuf":
        raise TypeError(
            f"points = an array of shape {array.shape} in {array.dtype}, expected {EXPECTED}"
        )
    array = np.asarray(unmasked(array, array))
    if array.dtype in (np.dtype(np.float32), np.dtype(np.float64)):
        return array
    return array.astype(np.float64)


def unmasked(values: Any, points: Any) -> Any:
    """Of values of each point, or of all of them at once, those of the points that are not masked."""
    if not isinstance(points, np.ma.MaskedArray) or np.ndim(values) == 0:
        return values
    return np.ma.getdata(values)[~np.ma.getmaskarray(points).any(axis=1)]


def sources_of(points: Any) -> list[Any]:
    """One source, those of a list, or the blocks of an iterator."""
    if isinstance(points, IOBase):  # its lines are no blocks
        raise TypeError(f"points = {short(points)}, expected {EXPECTED}")
    if not isinstance(points, list | tuple | Iterator):
        return [points]
    sources = list(points)
    if not sources and not isinstance(points, Iterator):
        raise TypeError("points = [], expected an array or a path")
    return sources


def tell_setups(sources: Sequence[Any]) -> bool:
    """Whether they are blocks with their setups."""
    return bool(sources) and isinstance(sources[0], tuple) and len(sources[0]) == 2


def split(sources: Sequence[Any]) -> tuple[list[bytes], list[Array]]:
    """Paths, or arrays."""
    paths: list[bytes] = []
    arrays: list[Array] = []
    for source in sources:
        if isinstance(source, str | bytes | os.PathLike):
            paths.append(path_bytes("scan", "points", source))
        else:
            arrays.append(as_points(source))
    if paths and arrays:
        raise TypeError(
            "points = paths and arrays together, expected the one or the other"
        )
    return paths, arrays
