"""Where the chunks of LAZ are, checked before anybody claims the memory that they say."""

from __future__ import annotations

import os
import struct
from dataclasses import dataclass
from itertools import accumulate
from typing import BinaryIO

import laspy
import lazrs
import numpy as np

from tank_datum._foreign import BLOCK, FORMATS, Unreadable

HEADER = 227  # bytes, of versions 1.0 to 1.2
RECORD = 54  # bytes that a variable length record has at least

LAYERED = 3  # LASzip's compressor of point formats 6 to 10
LAYERS = {
    10: 9,
    11: 1,
    12: 2,
    13: 1,
}  # of its items by their kind; of extra bytes one each


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


def read_at(source: BinaryIO, offset: int, count: int, path: str) -> bytes:
    source.seek(max(0, offset))
    read = source.read(count)
    if len(read) < count:
        raise Unreadable(
            f"LAZ data of {path}", f"cut short at byte {offset}", FORMATS["LAZ"][2]
        )
    return read


@dataclass(frozen=True)
class ChunkTable:
    """The chunks as the file lists them."""

    record: bytes  # of LASzip
    begin: int  # of the first in the file
    listed: list[
        tuple[int, int]
    ]  # rows and bytes of each; of the last maybe fewer rows


@dataclass(frozen=True)
class Chunks:
    """Where the chunks of a file are that all have so many rows, but for the last."""

    record: bytes  # of LASzip
    row_bytes: int
    rows: int
    offsets: list[int]  # of their bytes in the file, and of the end of the last

    def of(self, i: int, points: int) -> int:
        """Rows of the i-th, of so many points in all."""
        return min(self.rows, points - i * self.rows)


def _place_of_table(source: BinaryIO, begin: int, point_bytes: int, path: str) -> int:
    """The offset of the table, which is the end of the chunks' bytes."""
    size = os.fstat(source.fileno()).st_size
    (table,) = struct.unpack("<q", read_at(source, begin, 8, path))
    # of a file that was written without going back it stands at the end
    if table == -1:
        (table,) = struct.unpack("<q", read_at(source, size - 8, 8, path))
    if not begin + 8 <= table <= size - 8:
        expected = f"{begin + 8} to {size - 8}, since the file has {size} bytes"
        raise Unreadable(f"LASzip chunk table of {path}", f"at byte {table}", expected)
    _, chunks = struct.unpack("<II", read_at(source, table, 8, path))
    room = table - begin - 8
    most = room // point_bytes  # a chunk begins with a point that is not compressed
    if chunks > most:
        raise Unreadable(
            f"LASzip chunks of {path}", chunks, f"at most {most}, for {room} bytes"
        )
    return int(table)


def read_table(source: BinaryIO, header: laspy.LasHeader, path: str) -> ChunkTable:
    """Refuses chunks that are not the file's: lazrs claims what memory they say."""
    record_data = header.vlrs[header.vlrs.index("LasZipVlr")].record_data
    record = lazrs.LazVlr(record_data)
    if record.item_size() != header.point_format.size:
        expected = f"{header.point_format.size}, the bytes of a point"
        raise Unreadable(
            f"LASzip record of {path}", f"{record.item_size()} bytes", expected
        )
    begin = header.offset_to_point_data
    room = _place_of_table(source, begin, header.point_format.size, path) - begin - 8
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
    table = ChunkTable(record_data, begin + 8, listed)
    _check_layers(source, table, path)
    return table


def even_chunks(table: ChunkTable, header: laspy.LasHeader) -> Chunks | None:
    """The chunks, if they are of one size that a block has room for."""
    record = lazrs.LazVlr(table.record)
    rows = 0 if record.uses_variable_size_chunks() else record.chunk_size()
    if not 0 < rows <= BLOCK or len(table.listed) != -(-header.point_count // rows):
        return None
    held = (held for _, held in table.listed)
    return Chunks(
        table.record,
        record.item_size(),
        rows,
        list(accumulate(held, initial=table.begin)),
    )


def _layers_of(record: bytes) -> int:
    """How many layers the head of a chunk gives the sizes of."""
    compressor, items = (struct.unpack_from("<H", record, at)[0] for at in (0, 32))
    if compressor != LAYERED:
        return 0
    listed = [struct.unpack_from("<HH", record, 34 + 6 * i) for i in range(items)]
    return sum(LAYERS.get(kind, size) for kind, size in listed)


def _check_layers(source: BinaryIO, table: ChunkTable, path: str) -> None:
    """Refuses chunks whose layers are not within their bytes."""
    layers = _layers_of(table.record)
    if layers == 0:
        return
    head = lazrs.LazVlr(table.record).item_size() + 4  # a point, and how many there are
    begin = table.begin
    for i, (rows, held) in enumerate(table.listed):
        needed = head + 4 * layers
        if rows > 0 and needed <= held:
            told = read_at(source, begin + head, 4 * layers, path)
            needed += sum(struct.unpack(f"<{layers}I", told))
        if rows > 0 and needed > held:
            raise Unreadable(
                f"LASzip layers of chunk {i} of {path}",
                f"{needed} bytes",
                f"at most {held}, the bytes of the chunk",
            )
        begin += held
