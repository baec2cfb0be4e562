"""LAZ and COPC by laspy and lazrs, chunk by chunk: memory does not grow with the scan."""

from __future__ import annotations

import logging
import os
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from itertools import accumulate

import laspy
import lazrs
import numpy as np
from numpy.typing import NDArray

from tank_datum import _core
from tank_datum._foreign import (
    BLOCK,
    Block,
    Place,
    Unreadable,
    refusing,
    sizes,
)
from tank_datum._laz_layout import (
    HEADER,
    Chunks,
    check_records,
    check_scales,
    even_chunks,
    read_at,
    read_table,
)

# What laspy logs it raises too.
logging.getLogger("laspy").addHandler(logging.NullHandler())

Records = NDArray[np.uint8]  # of shape (points, bytes of a point)

# What of a point is decompressed, where its format allows to choose.
NEEDED = (
    laspy.DecompressionSelection.XY_RETURNS_CHANNEL
    | laspy.DecompressionSelection.Z
    | laspy.DecompressionSelection.CLASSIFICATION
    | laspy.DecompressionSelection.FLAGS
    | laspy.DecompressionSelection.POINT_SOURCE_ID
)

HELD = 1 << 29  # bytes at most of what every() decompressed, for the next pass
_stderr = threading.Lock()


@contextmanager
def _without_panics() -> Iterator[None]:
    """lazrs panics at some damaged data, and prints a trace besides raising what is told then."""
    with _stderr:
        try:
            kept = os.dup(2)
        except OSError:  # closed: nothing is printed
            yield
            return
        try:
            nowhere = os.open(os.devnull, os.O_WRONLY)
            os.dup2(nowhere, 2)
            os.close(nowhere)
            yield
        finally:
            os.dup2(kept, 2)
            os.close(kept)


class LazFile:
    """The points of a file; the point source id says their setup, and 0 is the file itself."""

    tells_setups = True
    lists_setups = False

    def __init__(self, path: str, classes: Sequence[int]) -> None:
        self._path = path
        self._source = open(path, "rb")  # noqa: SIM115  stays open: every pass sees the same file
        # several chunks at once, each whole in memory: not those larger than a block
        self._backend = laspy.LazBackend.LazrsParallel
        size = os.fstat(self._source.fileno()).st_size
        check_records(self._source.read(HEADER), size, path)
        header = self._begin().header
        check_scales(header, path)
        self._chunks = None
        if header.point_count > 0:
            table = read_table(self._source, header, path)
            self._chunks = even_chunks(table, header)
            if max(rows for rows, _ in table.listed) > BLOCK:
                self._backend = laspy.LazBackend.Lazrs
        self.parts = len(self._chunks.offsets) - 1 if self._chunks else 0
        self.size = int(header.point_count)
        self.step = float(max(header.scales))
        self.setups: dict[int, tuple[str, Place | None]] = {0: ("", None)}
        self._classes = classes
        self._held: dict[int, Records] = {}  # chunks

    def _begin(self) -> laspy.LasReader:
        self._source.seek(0)
        return laspy.LasReader(
            self._source,
            closefd=False,
            laz_backend=self._backend,
            read_evlrs=False,
            decompression_selection=NEEDED,
        )

    def blocks(self, wanted: Sequence[int] | None) -> Iterator[Block]:
        with refusing(self._path, "LAZ"):
            header = self._begin().header
            runs = self._of_chunks(self._chunks) if self._chunks else self._in_order()
            for records in runs:
                yield self._block(records, header)

    def every(self, n: int) -> Iterator[Block]:
        """Every n-th chunk, as many at once as make a block. They are held for the next pass."""
        assert self._chunks is not None
        header = self._begin().header
        at_once = n * max(1, BLOCK // self._chunks.rows)
        for first in range(0, self.parts, at_once):
            behind = min(self.parts, first + at_once)
            numbers = range(first, behind, n)
            with refusing(self._path, "LAZ"):
                records = self._decompressed(self._chunks, numbers)
                self._hold(self._chunks, numbers, records)
            rows = (
                min(self.size, behind * self._chunks.rows) - first * self._chunks.rows
            )
            yield self._block([records], header, rows - len(records))

    def _in_order(self) -> Iterator[list[Records]]:
        """All points, through a reader to which the chunks do not matter."""
        reader = self._begin()
        for rows in sizes(self.size):
            with _without_panics():
                points = reader.read_points(rows)
            if len(points) != rows:
                done = reader.points_read - rows + len(points)
                raise Unreadable(
                    f"points of {self._path}", done, f"{self.size} of the header"
                )
            yield [points.array.view(np.uint8).reshape(rows, -1)]

    def _of_chunks(self, chunks: Chunks) -> Iterator[list[Records]]:
        """All points, those of held chunks without another look at the file."""
        first, at_once = 0, 1  # a look at the beginning should not take long
        while first < self.parts:
            numbers = range(first, min(self.parts, first + at_once))
            fresh = [i for i in numbers if i not in self._held]
            read = self._divided(chunks, fresh, self._decompressed(chunks, fresh))
            yield [self._held.pop(i) if i in self._held else read[i] for i in numbers]
            first, at_once = first + at_once, max(1, BLOCK // chunks.rows)

    def _divided(
        self, chunks: Chunks, numbers: Sequence[int], records: Records
    ) -> dict[int, Records]:
        """The rows of each chunk."""
        behind = accumulate(chunks.of(i, self.size) for i in numbers)
        return {
            i: records[end - chunks.of(i, self.size) : end]
            for i, end in zip(numbers, behind, strict=True)
        }

    def _decompressed(self, chunks: Chunks, wanted: Sequence[int]) -> Records:
        compressed, table = bytearray(), []
        for i in wanted:
            begin, end = chunks.offsets[i : i + 2]
            compressed += read_at(self._source, begin, end - begin, self._path)
            table.append((chunks.of(i, self.size), end - begin))
        records = _core.las_records(sum(rows for rows, _ in table), chunks.row_bytes)
        with _without_panics():
            lazrs.decompress_points_with_chunk_table(
                compressed, chunks.record, records.reshape(-1), table, NEEDED.to_lazrs()
            )
        return records

    def _hold(self, chunks: Chunks, numbers: Sequence[int], records: Records) -> None:
        room = HELD - sum(held.nbytes for held in self._held.values())
        if records.nbytes <= room:
            self._held |= self._divided(chunks, numbers, records)

    def _block(
        self, records: Sequence[Records], header: laspy.LasHeader, left_out: int = 0
    ) -> Block:
        return _core.LasBlock(
            records,
            header.point_format.id,
            header.point_format.size,
            header.scales,
            header.offsets,
            self._classes,
            left_out,
        )


def open_blocks(path: str, classes: Sequence[int]) -> LazFile:
    """Opens a file; `classes`: the codes of the points that are wanted, none: all."""
    return LazFile(path, classes)
