"""LAZ and COPC by laspy and lazrs, chunk by chunk: memory does not grow with the scan."""

from __future__ import annotations

import logging
import os
import struct
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import accumulate
from typing import BinaryIO

import laspy
import lazrs
import numpy as np

from tank_datum._foreign import (
    BLOCK,
    FORMATS,
    Block,
    Place,
    Unreadable,
    refusing,
    sizes,
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

HEADER = 227  # bytes, of versions 1.0 to 1.2
RECORD = 54  # bytes that a variable length record has at least


def check_records(head: bytes, size: int, path: str) -> None:
    """Refuses more records before the points than there is room for: laspy would make them all."""
    if len(head) < HEADER:
        raise Unreadable(
            f"LAS header of {path}", f"{len(head)} bytes", f"at least {HEADER}"
        )
    header, points, records = struct.unpack_from("<HII", head, 94)
    if not HEADER <= header <= points <= size:
        expected = (
            f"at least {HEADER} and the header size, {header}, and at most {size}"
        )
        raise Unreadable(f"LAS offset to the points of {path}", points, expected)
    most = (points - header) // RECORD
    if records > most:
        raise Unreadable(
            f"LAS records of {path}", records, f"at most {most} before the points"
        )


def check_scales(header: laspy.LasHeader, path: str) -> None:
    """Refuses scales and offsets as the library does those of LAS."""
    for axis, scale, offset in zip("xyz", header.scales, header.offsets, strict=True):
        if not (scale > 0 and np.isfinite(scale * 2.0**31)):
            expected = "a number > 0, such as 0.001"
            raise Unreadable(f"LAS scale of {axis} of {path}", f"{scale:f}", expected)
        if not np.isfinite(abs(offset) + scale * 2.0**31):
            raise Unreadable(
                f"LAS offset of {axis} of {path}", f"{offset:f}", "a number"
            )


@dataclass(frozen=True)
class Chunks:
    """Where the chunks of a file are that all have so many rows, but for the last."""

    record: bytes  # of LASzip
    rows: int
    offsets: list[int]  # of their bytes in the file, and of the end of the last

    def of(self, i: int, points: int) -> int:
        """Rows of the i-th, of so many points in all."""
        return min(self.rows, points - i * self.rows)


def checked_chunks(
    source: BinaryIO, header: laspy.LasHeader, path: str
) -> Chunks | None:
    """The chunks, if they are of one size. Refuses a table that is not the file's: lazrs claims
    what memory it says.
    """
    size = os.fstat(source.fileno()).st_size
    record_data = header.vlrs[header.vlrs.index("LasZipVlr")].record_data
    record = lazrs.LazVlr(record_data)
    if record.item_size() != header.point_format.size:
        expected = f"{header.point_format.size}, the bytes of a point"
        raise Unreadable(
            f"LASzip record of {path}", f"{record.item_size()} bytes", expected
        )
    begin = header.offset_to_point_data
    (table,) = struct.unpack("<q", read_at(source, begin, 8, path))
    # of a file that was written without going back it stands at the end
    if table == -1:
        (table,) = struct.unpack("<q", read_at(source, size - 8, 8, path))
    if not begin + 8 <= table <= size - 8:
        expected = f"{begin + 8} to {size - 8}, since the file has {size} bytes"
        raise Unreadable(f"LASzip chunk table of {path}", f"at byte {table}", expected)
    _, chunks = struct.unpack("<II", read_at(source, table, 8, path))
    room = table - begin - 8
    most = (
        room // header.point_format.size
    )  # a chunk begins with a point that is not compressed
    if chunks > most:
        raise Unreadable(
            f"LASzip chunks of {path}", chunks, f"at most {most}, for {room} bytes"
        )
    source.seek(begin)
    listed = lazrs.read_chunk_table(source, record)
    points, held = (
        (sum(column) for column in zip(*listed, strict=True)) if listed else (0, 0)
    )
    spare = 0 if record.uses_variable_size_chunks() else record.chunk_size() - 1
    if held > room or not header.point_count <= points <= header.point_count + spare:
        expected = f"{header.point_count} points, as the header says, in {room} bytes"
        raise Unreadable(
            f"LASzip chunks of {path}", f"{points} in {held} bytes", expected
        )
    rows = 0 if record.uses_variable_size_chunks() else record.chunk_size()
    if not 0 < rows <= BLOCK or len(listed) != -(-header.point_count // rows):
        return None
    sizes_held = (size_held for _, size_held in listed)
    return Chunks(record_data, rows, list(accumulate(sizes_held, initial=begin + 8)))


def read_at(source: BinaryIO, offset: int, count: int, path: str) -> bytes:
    source.seek(max(0, offset))
    read = source.read(count)
    if len(read) < count:
        raise Unreadable(
            f"LAZ data of {path}", f"cut short at byte {offset}", FORMATS["LAZ"][2]
        )
    return read


class LazFile:
    """The points of a file; the point source id says their setup, and 0 is the file itself."""

    tells_setups = True
    lists_setups = False

    def __init__(self, path: str, classes: Sequence[int]) -> None:
        self._path = path
        self._source = open(path, "rb")  # noqa: SIM115  stays open: every pass sees the same file
        size = os.fstat(self._source.fileno()).st_size
        check_records(self._source.read(HEADER), size, path)
        header = self._begin().header
        check_scales(header, path)
        self._chunks = None
        if header.point_count > 0:
            self._chunks = checked_chunks(self._source, header, path)
        self.parts = len(self._chunks.offsets) - 1 if self._chunks else 0
        self.size = int(header.point_count)
        self.step = float(max(header.scales))
        self.setups: dict[int, tuple[str, Place | None]] = {0: ("", None)}
        self._wanted = np.full(256, not classes)
        self._wanted[list(classes)] = True

    def _begin(self) -> laspy.LasReader:
        self._source.seek(0)
        return laspy.LasReader(
            self._source,
            closefd=False,
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
        kept = self._wanted[np.asarray(points.classification)]
        kept &= np.asarray(points.withheld) == 0
        xyz = np.empty((int(kept.sum()), 3))
        for i, axis in enumerate("XYZ"):
            stored = points.array[axis][kept]
            xyz[:, i] = stored * header.scales[i] + header.offsets[i]
        labels = np.asarray(points.point_source_id)[kept].astype(np.uint32)
        return xyz, labels, 0, len(kept) - len(xyz)


def open_blocks(path: str, classes: Sequence[int]) -> LazFile:
    """Opens a file; `classes`: the codes of the points that are wanted, none: all."""
    return LazFile(path, classes)
