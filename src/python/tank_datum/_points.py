"""Points as callers have them, as the compiled part takes them."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float32] | NDArray[np.float64]
EXPECTED = "an array of shape (n, 3) of numbers, the path of a scan, or a function that returns blocks"


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
        raise TypeError(f"points = {given!r}, expected {EXPECTED}")
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


def split(points: Any) -> tuple[list[str], list[Array]]:
    """Paths, or arrays: of one source, of a list of them, or of an iterator of blocks."""
    sources: Iterable[Any]
    if isinstance(points, list | tuple | Iterator):
        sources = points
    else:
        sources = [points]
    paths: list[str] = []
    arrays: list[Array] = []
    for source in sources:
        if isinstance(source, str | os.PathLike):
            paths.append(os.fspath(source))
        else:
            arrays.append(as_points(source))
    if paths and arrays:
        raise TypeError(
            "points = paths and arrays together, expected the one or the other"
        )
    if not paths and not arrays and isinstance(points, list | tuple):
        raise TypeError("points = [], expected an array or a path")
    return paths, arrays
