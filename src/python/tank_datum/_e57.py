"""E57 by pye57, block by block: memory does not grow with the scan."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pye57 import libe57

from tank_datum import _core
from tank_datum._e57_pose import Array, pose_of
from tank_datum._foreign import (
    FIRST_BLOCK,
    Block,
    Place,
    Unreadable,
    refusing,
)

CARTESIAN = ("cartesianX", "cartesianY", "cartesianZ")
SPHERICAL = ("sphericalRange", "sphericalAzimuth", "sphericalElevation")
PAGE = 1024  # bytes
LOOKED_AT = 1 << 16  # pages at once, between which a run may be given up
READ_BLOCK = 1 << 16  # rows; what is made of them stays in a core's cache


def cartesian(ranges: Array, azimuths: Array, elevations: Array) -> list[Array]:
    """Of a range, an azimuth from x towards y and an elevation above their plane."""
    level = ranges * np.cos(elevations)
    return [
        level * np.cos(azimuths),
        level * np.sin(azimuths),
        ranges * np.sin(elevations),
    ]


class E57Scan:
    """One of the scans of a file: a setup of the scanner."""

    def __init__(self, file: E57File, index: int) -> None:
        self._file, self._index = file, index
        self._node = file.image.root()["data3D"][index]
        name = self._node["name"].value() if self._node.isDefined("name") else ""
        self.name = " ".join(name.split()) or str(index)
        self.what = f"scan {index} of {file.path}"
        self._points = self._node["points"]
        self.size: int = self._points.childCount()
        self._pose = pose_of(self._node, self.what)
        self._columns, self._state = self._find_columns()

    def _find_columns(self) -> tuple[tuple[str, ...], str]:
        """The coordinates, and the column that says which are none."""
        self._prototype = libe57.StructureNode(self._points.prototype())
        for columns, state in (
            (CARTESIAN, "cartesianInvalidState"),
            (SPHERICAL, "sphericalInvalidState"),
        ):
            if all(self._prototype.isDefined(name) for name in columns):
                return columns, state if self._prototype.isDefined(state) else ""
        there = [
            self._prototype[i].elementName()
            for i in range(self._prototype.childCount())
        ]
        expected = f"{', '.join(CARTESIAN)} or {', '.join(SPHERICAL)}"
        raise Unreadable(
            f"columns of {self.what}", ", ".join(there) or "none", expected
        )

    @property
    def place(self) -> Place | None:
        """Where the scanner stood; zeros stand for what is not known."""
        x, y, z = map(float, self._pose.shift)
        return (x, y, z) if self._pose.shift.any() else None

    def _column_step(self, name: str, largest: float) -> float:
        """Between neighbouring values of a column that reaches so far."""
        node = self._prototype[name]
        if isinstance(node, libe57.ScaledIntegerNode):
            return abs(float(node.scale()))
        single = (
            isinstance(node, libe57.FloatNode) and node.precision() == libe57.E57_SINGLE
        )
        return float(np.spacing(np.float32(largest) if single else np.float64(largest)))

    def step(self) -> float:
        """Between neighbouring coordinates, at the far end of the scan's first points."""
        columns, _ = next(self._read(min(FIRST_BLOCK, self.size)), (None, 0))
        if columns is None or not len(columns[0]):
            return 0.0
        largest = [float(np.nanmax(np.abs(column), initial=0.0)) for column in columns]
        steps = [
            self._column_step(name, far)
            for name, far in zip(self._columns, largest, strict=True)
        ]
        spherical = self._columns == SPHERICAL
        return max(steps[0], largest[0] * max(steps[1:])) if spherical else max(steps)

    def _read(self, capacity: int) -> Iterator[tuple[list[Array], int]]:
        """Columns of the points that are valid, which the next ones replace, and how many are not."""
        if capacity == 0:
            return
        image = self._file.image
        points = image.root()["data3D"][self._index]["points"]
        buffers = libe57.VectorSourceDestBuffer()
        columns: list[NDArray[Any]] = [np.empty(capacity) for _ in self._columns]
        states: NDArray[Any] = np.zeros(capacity, np.int8)
        named = [*zip(self._columns, columns, strict=True)]
        for name, values in [*named, (self._state, states)]:
            if name:
                buffers.append(
                    libe57.SourceDestBuffer(image, name, values, capacity, True, True)
                )
        reader = points.reader(buffers)
        try:
            done = 0
            while rows := reader.read():
                done += rows
                valid = states[:rows] == 0
                if valid.all():
                    yield [column[:rows] for column in columns], 0
                else:
                    invalid = rows - int(np.count_nonzero(valid))
                    yield [column[:rows][valid] for column in columns], invalid
        finally:
            reader.close()
        if done != self.size:
            raise Unreadable(
                f"points of {self.what}", done, f"{self.size}, as its header says"
            )

    def blocks(self) -> Iterator[tuple[Array, int]]:
        """Points in the file's frame, and how many rows hold none."""
        for columns, invalid in self._read(min(READ_BLOCK, self.size)):
            if self._columns == SPHERICAL:
                columns = cartesian(*columns)
            yield self._pose.apply(columns), invalid


class E57File:
    """The scans of a file, each a setup."""

    lists_setups = True
    parts = 0

    def __init__(self, path: str) -> None:
        self.path = path
        self.image = libe57.ImageFile(path, "r")
        self._pages_known = 0  # how many from the first on are sound
        root = self.image.root()
        count = root["data3D"].childCount() if root.isDefined("data3D") else 0
        if count == 0:
            raise Unreadable(f"scans of {path}", "none", "at least one")
        self._scans = [E57Scan(self, i) for i in range(count)]
        self.size = sum(scan.size for scan in self._scans)
        self.step = max(scan.step() for scan in self._scans)
        self.tells_setups = count > 1
        names = [scan.name for scan in self._scans]
        self.setups = {
            i: (
                scan.name if names.count(scan.name) == 1 else f"{scan.name} {i}",
                scan.place,
            )
            for i, scan in enumerate(self._scans)
        }

    def _look_at_pages(self) -> Iterator[None]:
        """Looks at all checksums, with a pause after some; once they are sound the reader need not.

        Its own look takes longer than the rest of reading. It stays where one is wrong: not all
        pages need be read.
        """
        path = os.fsencode(self.path)
        pages = -(-os.stat(path).st_size // PAGE)
        while self._pages_known < pages:
            if not _core.e57_pages_are_sound(path, self._pages_known, LOOKED_AT):
                return
            self._pages_known += LOOKED_AT
            if self._pages_known >= pages:
                self.image = libe57.ImageFile(
                    self.path, "r", libe57.CHECKSUM_POLICY_NONE
                )
            yield

    def blocks(self, wanted: Sequence[int] | None) -> Iterator[Block]:
        with refusing(self.path, "E57"):
            for _ in self._look_at_pages():
                yield np.empty((0, 3)), np.zeros((), np.uint32), 0, 0
            for i, scan in enumerate(self._scans):
                setup = np.array(i, np.uint32)
                if wanted is not None and i not in wanted:
                    yield np.empty((0, 3)), setup, 0, scan.size
                    continue
                for points, invalid in scan.blocks():
                    yield points, setup, invalid, 0


def open_blocks(path: str, classes: Sequence[int]) -> E57File:
    """Opens a file; the classes are those of LAS."""
    return E57File(path)
