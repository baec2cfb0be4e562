"""LAZ and COPC by laspy and lazrs, chunk by chunk: memory does not grow with the scan."""

from __future__ import annotations

import logging
import os
from collections.abc import Iterator, Sequence

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

# What of a point is decompressed, where its format allows to choose.
NEEDED = (
    laspy.DecompressionSelection.XY_RETURNS_CHANNEL
    | laspy.DecompressionSelection.Z
    | laspy.DecompressionSelection.CLASSIFICATION
    | laspy.DecompressionSelection.FLAGS
    | laspy.DecompressionSelection.POINT_SOURCE_ID
)

FIRST_NEW = 6  # of the point formats
WITHHELD = 0x04  # of the flags of formats 6 to 10
OLD_CLASS, OLD_WITHHELD = 0x1F, 0x80  # of the byte that formats 0 to 5 have for both


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
        self._wanted = np.full(256, not classes)
        self._wanted[list(classes)] = True
        # formats 0 to 5 have the class and its flags in one byte
        bytes_of = np.arange(256)
        self._wanted_old = self._wanted[bytes_of & OLD_CLASS] & (
            bytes_of & OLD_WITHHELD == 0
        )

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
            reader = self._begin()
            for rows in sizes(self.size):
                points = reader.read_points(rows)
                if len(points) != rows:
                    done = reader.points_read - rows + len(points)
                    raise Unreadable(
                        f"points of {self._path}", done, f"{self.size} of the header"
                    )
                yield self._block(points, reader.header)

    def every(self, n: int) -> Iterator[Block]:
        """Every n-th chunk, as many at once as make a block."""
        assert self._chunks is not None
        header = self._begin().header
        at_once = n * max(1, BLOCK // self._chunks.rows)
        for first in range(0, self.parts, at_once):
            behind = min(self.parts, first + at_once)
            with refusing(self._path, "LAZ"):
                points = self._decompressed(
                    self._chunks, header, range(first, behind, n)
                )
            xyz, labels, invalid, left_out = self._block(points, header)
            rows = (
                min(self.size, behind * self._chunks.rows) - first * self._chunks.rows
            )
            yield xyz, labels, invalid, left_out + rows - len(points)

    def _decompressed(
        self, chunks: Chunks, header: laspy.LasHeader, wanted: Sequence[int]
    ) -> laspy.ScaleAwarePointRecord:
        compressed, table = bytearray(), []
        for i in wanted:
            begin, end = chunks.offsets[i : i + 2]
            compressed += read_at(self._source, begin, end - begin, self._path)
            table.append((chunks.of(i, self.size), end - begin))
        points = np.zeros(sum(rows for rows, _ in table), header.point_format.dtype())
        lazrs.decompress_points_with_chunk_table(
            compressed, chunks.record, points.view(np.uint8), table, NEEDED.to_lazrs()
        )
        return laspy.ScaleAwarePointRecord(
            points, header.point_format, header.scales, header.offsets
        )

    def _block(
        self, points: laspy.ScaleAwarePointRecord, header: laspy.LasHeader
    ) -> Block:
        kept = self._kept(points)
        rows = points.array if kept.all() else points.array[kept]
        columns = [rows[axis] for axis in "XYZ"]
        xyz = _core.scaled_points(columns, header.scales, header.offsets)
        labels = rows["point_source_id"].astype(np.uint32)
        return xyz, labels, 0, len(kept) - len(rows)

    def _kept(self, points: laspy.ScaleAwarePointRecord) -> NDArray[np.bool_]:
        """Which rows are of a class that is wanted, and not withheld."""
        rows = points.array
        kept: NDArray[np.bool_]
        if points.point_format.id < FIRST_NEW:
            kept = self._wanted_old[rows["raw_classification"]]
        else:
            kept = self._wanted[rows["classification"]]
            kept &= rows["classification_flags"] & WITHHELD == 0
        return kept


def open_blocks(path: str, classes: Sequence[int]) -> LazFile:
    """Opens a file; `classes`: the codes of the points that are wanted, none: all."""
    return LazFile(path, classes)
