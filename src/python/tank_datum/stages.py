"""The single stages of the chain on arrays of points (n, 3).

Every point must be finite: results number the points as the array does. A refused option is an
OptionError that names it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tank_datum import _core
from tank_datum._arguments import indices, real, whole
from tank_datum._errors import short
from tank_datum._points import as_points

__all__ = [
    "EdgePoints",
    "Normals",
    "candidates",
    "edge_points",
    "neighbours",
    "normals",
]

Search = Literal["flann", "buckets"]


class Normals(NamedTuple):
    """Neighbours (n, k), nearest first and the point itself among them, and unit normals (n, 3)."""

    neighbours: NDArray[np.int32]
    normals: NDArray[np.float32]

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Normals) and _same(self, other)

    def __ne__(self, other: object) -> bool:
        return not self == other


class EdgePoints(NamedTuple):
    """Candidates near the circle of the datum, in order round it."""

    indices: NDArray[np.int32]
    azimuth_deg: NDArray[np.float64]
    center: tuple[float, float]
    radius: float
    """NaN, and no indices, when the candidates determine no circle [m]"""
    tolerance: float
    """distance from the circle within which they lie [m]"""

    def __eq__(self, other: object) -> bool:
        return isinstance(other, EdgePoints) and _same(self, other)

    def __ne__(self, other: object) -> bool:
        return not self == other


def _same(a: Sequence[Any], b: Sequence[Any]) -> bool:
    """Whether all fields are equal, NaN where NaN."""
    return all(np.array_equal(x, y, equal_nan=True) for x, y in zip(a, b, strict=True))


def neighbours(
    points: NDArray[Any], k: int = 20, *, search: Search = "flann", threads: int = 0
) -> NDArray[np.int32]:
    """Indices (n, k) of the k nearest of every point, itself included, nearest first."""
    return normals(points, k, search=search, threads=threads).neighbours


def normals(
    points: NDArray[Any], k: int = 20, *, search: Search = "flann", threads: int = 0
) -> Normals:
    """Steps 1 and 2 of the method: neighbours, and normals whose sign means nothing.

    The normal is the eigenvector of the smallest eigenvalue of the neighbours' covariance (ISPRS
    Archives 2018). Raises OptionError for k below 3 or above the number of points.
    """
    array = np.asarray(as_points(points), dtype=np.float64)
    if not isinstance(search, str):
        raise TypeError(f"search = {short(search)}, expected flann or buckets")
    return Normals(
        *_core.normals(array, whole("k", k), search, whole("threads", threads))
    )


def candidates(
    found: Normals, angle_deg: float = 45.0, *, threads: int = 0
) -> NDArray[np.int32]:
    """Step 3: indices, ascending, of points on a crease.

    Their normal is further than the angle from that of a point whose neighbour they are.
    """
    if not isinstance(found, Normals):
        raise TypeError(f"found = {short(found)}, expected the Normals of points")
    near = indices("neighbours", found.neighbours)
    normal = np.asarray(found.normals)
    if normal.dtype.kind not in "iuf":
        said = f"an array of shape {normal.shape} in {normal.dtype}"
        raise TypeError(f"normals = {said}, expected (n, 3) of numbers")
    angle = real("angle_deg", angle_deg)
    return _core.candidates(near, normal, angle, whole("threads", threads))


def _circle(tank: Any) -> tuple[float, ...]:
    shape = (len(tank),) if isinstance(tank, Sequence) else np.shape(tank)
    if shape != (3,):
        raise TypeError(f"tank = {short(tank)}, expected (x, y, radius)")
    return tuple(real("tank", part) for part in tank)


def edge_points(
    points: NDArray[Any],
    chosen: NDArray[np.integer[Any]],
    *,
    tank: tuple[float, float, float] | None = None,
    tolerance: float = 0.0,
) -> EdgePoints:
    """Step 4: the candidates whose distance from the circle is within a tolerance.

    tank: x, y, radius of the circle when known; without it it is searched among the candidates.
    tolerance: [m]; 0 is 0.1 m or a tenth of the radius, whichever is less.
    """
    array = np.asarray(as_points(points), dtype=np.float64)
    kept = indices("candidates", chosen)
    if kept.ndim != 1:
        raise TypeError(f"candidates = shape {kept.shape}, expected (n,)")
    circle = None if tank is None else _circle(tank)
    within = real("tolerance", tolerance)
    return EdgePoints(**_core.edge_points(array, kept, circle, within))
