"""The readers of E57, LAZ and COPC against pye57 and laspy, which read whole files."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import laspy
import numpy as np
import pye57
import pytest

from results import Array

tank_datum = pytest.importorskip("tank_datum", reason="the module is not installed")

from tank_datum import _foreign  # noqa: E402


def blocks_of(path: Path, kind: str) -> tuple[Any, Array]:
    """What the reader says, and all points."""
    reader = _foreign.open_blocks(str(path), kind, [])
    points, rows = [np.empty((0, 3))], 0
    for block, _, invalid, left_out in reader.blocks(None):
        points.append(block)
        rows += len(block) + invalid + left_out
    assert rows == reader.size
    return reader, np.concatenate(points)


def test_real_e57(data: Path) -> None:
    """Counts and points against scans that pye57 reads whole."""
    files = sorted((data / "formats" / "e57").glob("*.e57"))
    assert len(files) == 21
    for path in files:
        reader, points = blocks_of(path, "E57")
        with pye57.E57(str(path)) as file:
            assert reader.size == sum(
                file.get_header(i).point_count for i in range(file.scan_count)
            )
            scans = [file.read_scan(i, ignore_missing_fields=True) for i in range(file.scan_count)]
        whole = np.concatenate(
            [np.stack([s[f"cartesian{a}"] for a in "XYZ"], axis=1) for s in scans]
        )
        np.testing.assert_allclose(points, whole, rtol=0, atol=1e-9, err_msg=path.name)


def test_real_laz(data: Path) -> None:
    """Every bit is what laspy makes of the whole file; COPC among them."""
    files = sorted((data / "formats" / "laz").glob("*.laz"))
    assert len(files) == 9
    for path in files:
        reader, points = blocks_of(path, "LAZ")
        whole = laspy.read(path)
        assert reader.size == len(whole.points)
        np.testing.assert_array_equal(points, whole.xyz[np.asarray(whole.withheld) == 0], path.name)


def test_blocks_of_a_large_scan(tmp_path: Path) -> None:
    """More rows than a block, rows without a point, and a scan that is passed over."""
    rows = _foreign.FIRST_BLOCK + _foreign.BLOCK + 1000
    columns = {f"cartesian{axis}": np.arange(rows, dtype=float) + i for i, axis in enumerate("XYZ")}
    columns["cartesianInvalidState"] = (np.arange(rows) % 100 == 7).astype(np.int8)
    path = tmp_path / "large.e57"
    with pye57.E57(str(path), "w") as file:
        for _ in range(2):
            file.write_scan_raw(columns, name="twice")
    reader, points = blocks_of(path, "E57")
    assert reader.setups == {0: ("twice 0", None), 1: ("twice 1", None)}
    kept = np.arange(rows)[np.arange(rows) % 100 != 7]
    np.testing.assert_array_equal(points[:, 2], np.tile(kept + 2.0, 2))
    left_out = [(len(p), left) for p, _, _, left in reader.blocks([1])]
    assert left_out[0] == (0, rows)
    assert sum(n for n, _ in left_out) == len(kept)
    assert max(n for n, _ in left_out) <= _foreign.BLOCK


def test_checksums_are_looked_at_until_a_pass_was_whole(tmp_path: Path) -> None:
    """Passes behind a sound one give the same bits; one that was given up proves nothing."""
    rows = 3 * _foreign.FIRST_BLOCK
    random = np.random.default_rng(1)
    path = tmp_path / "large.e57"
    with pye57.E57(str(path), "w") as file:
        file.write_scan_raw({f"cartesian{axis}": random.random(rows) for axis in "XYZ"})
    reader: Any = _foreign.open_blocks(str(path), "E57", [])
    first, second = (np.concatenate([b for b, *_ in reader.blocks(None)]) for _ in range(2))
    np.testing.assert_array_equal(first, second)
    whole = bytearray(path.read_bytes())
    whole[len(whole) * 3 // 4] ^= 1
    path.write_bytes(whole)
    broken: Any = _foreign.open_blocks(str(path), "E57", [])
    for _ in range(2):
        next(iter(broken.blocks(None)))
        with pytest.raises(_foreign.Unreadable, match="checksum"):
            list(broken.blocks(None))


def chunked(path: Path, rows: int) -> laspy.LasData:
    """A file in chunks of 50 000 points."""
    header = laspy.LasHeader(point_format=6, version="1.4")
    header.scales = [0.001] * 3
    cloud = laspy.LasData(header)
    cloud.x, cloud.y, cloud.z = (np.arange(rows) * 0.01 + i for i in range(3))
    cloud.classification = np.where(np.arange(rows) % 10 == 3, 7, 2)
    cloud.write(path)
    return cloud


def test_every_nth_chunk_of_laz(tmp_path: Path) -> None:
    """The rows of those chunks, the last and shorter one among them; the others are left out."""
    rows = 2 * _foreign.BLOCK + 70_000
    cloud = chunked(tmp_path / "cloud.laz", rows)
    reader: Any = _foreign.open_blocks(str(tmp_path / "cloud.laz"), "LAZ", [2])
    assert reader.parts == -(-rows // 50_000)
    kept = np.asarray(cloud.classification) == 2
    for n in (1, 2, 5, 1000):
        blocks = list(reader.every(n))
        assert max(len(block) for block, *_ in blocks) <= _foreign.BLOCK
        wanted = kept & (np.arange(rows) // 50_000 % n == 0)
        np.testing.assert_array_equal(np.concatenate([b for b, *_ in blocks]), cloud.xyz[wanted])
        assert sum(len(block) + left_out for block, _, _, left_out in blocks) == rows


@pytest.mark.parametrize(("held", "read_again"), [(1 << 29, 0), (0, 3)])
def test_chunks_that_were_looked_at_are_decompressed_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, held: int, read_again: int
) -> None:
    """Where there is room to hold them; each point comes once, in order, in later passes too."""
    from tank_datum import _laz

    monkeypatch.setattr(_laz, "HELD", held)
    cloud = chunked(tmp_path / "cloud.laz", 430_000)  # 9 chunks
    reader: Any = _laz.open_blocks(str(tmp_path / "cloud.laz"), [])
    list(reader.every(4))
    read: list[int] = []
    decompressed = reader._decompressed

    def counting(chunks: Any, wanted: Any) -> Any:
        read.extend(wanted)
        return decompressed(chunks, wanted)

    monkeypatch.setattr(reader, "_decompressed", counting)
    for again in (read_again, 3):
        read.clear()
        points = np.concatenate([block for block, *_ in reader.blocks(None)])
        np.testing.assert_array_equal(points, cloud.xyz)
        assert sorted(read) == [i for i in range(9) if i % 4 or again]


@pytest.mark.parametrize("bytes_of_a_point", [19, 0])
def test_records_shorter_than_their_format(bytes_of_a_point: int) -> None:
    from tank_datum import _core

    ones = np.ones(3)
    with pytest.raises(ValueError, match="shorter than their point format"):
        _core.LasBlock([], 0, bytes_of_a_point, ones, ones, [], 0)
    with pytest.raises(ValueError, match="another length"):
        _core.LasBlock([np.zeros((2, 21), np.uint8)], 0, 20, ones, ones, [], 0)
    with pytest.raises(ValueError, match="shorter than their point format"):
        _core.LasBlock([], 11, 200, ones, ones, [], 0)


def test_chunks_of_other_sizes_are_all_read(data: Path) -> None:
    """Of COPC they are places, of which none may be left out."""
    files = [p for p in (data / "formats" / "laz").glob("*.laz") if "copc" in p.name]
    assert files
    for path in files:
        assert _foreign.open_blocks(str(path), "LAZ", []).parts == 0, path.name
