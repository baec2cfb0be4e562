"""Writes one simulated scan of any number of points in each format, for scripts/format_speed.py."""

from __future__ import annotations

import multiprocessing
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import laspy
import numpy as np
import pye57
from numpy.typing import NDArray

COMMANDS = Path(sys.executable).parent
STEP = 1e-4  # of the coordinates of LAS and LAZ [m]

Array = NDArray[np.float64]


def simulated(folder: Path) -> Array:
    path = folder / "base.pcd"
    words = ["-o", path, "--radius", "20", "--step-deg", "0.12", "--quiet"]
    subprocess.run([COMMANDS / "tank_datum_synth", *words], check=True)
    head, rows = path.read_bytes().split(b"DATA binary\n", 1)
    assert b"FIELDS x y z intensity\nSIZE 4 4 4 4\n" in head
    return np.frombuffer(rows, "<f4").reshape(-1, 4)[:, :3].astype(np.float64)


def blocks_of(base: Array, points: int) -> Iterator[Array]:
    """The scan once with the noise it has, then again with another millimetre."""
    for repeat, begin in enumerate(range(0, points, len(base))):
        block = base[: points - begin]
        noise = np.random.default_rng(repeat).normal(0.0, 1e-3, block.shape)
        yield block + noise if repeat else block


def write_pcd(path: Path, base: Array, points: int) -> None:
    head = (
        "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
        f"WIDTH {points}\nHEIGHT 1\nPOINTS {points}\nDATA binary\n"
    )
    with path.open("wb") as file:
        file.write(head.encode())
        for block in blocks_of(base, points):
            block.astype(np.float32).tofile(file)


def write_las(path: Path, base: Array, points: int) -> None:
    """20 bytes a point; compressed where the name ends so."""
    write_records(path, laspy.LasHeader(version="1.2", point_format=0), blocks_of(base, points))


def write_laz7(path: Path, base: Array, points: int) -> None:
    """With times, intensities and colours, as scanners of today write them: 36 bytes a point."""
    write_records(path, laspy.LasHeader(version="1.4", point_format=7), blocks_of(base, points))


def write_records(path: Path, header: laspy.LasHeader, blocks: Iterator[Array]) -> None:
    header.scales, header.offsets = np.full(3, STEP), np.zeros(3)
    with laspy.open(path, mode="w", header=header) as file:
        for number, block in enumerate(blocks):
            rows = laspy.ScaleAwarePointRecord.zeros(len(block), header=header)
            rows.x, rows.y, rows.z = block.T
            if header.point_format.id == 7:
                random = np.random.default_rng(number)
                rows.gps_time = 1e4 * number + 2e-6 * np.arange(len(block))
                for name in ("intensity", "red", "green", "blue"):
                    rows[name] = random.normal(20_000.0, 300.0, len(block))
            file.write_points(rows)


def write_e57(path: Path, base: Array, points: int) -> None:
    """One scan of 4-byte floats, as pye57 writes them."""
    columns = np.empty((3, points), np.float32)
    done = 0
    for block in blocks_of(base, points):
        columns[:, done : done + len(block)] = block.T
        done += len(block)
    named = {f"cartesian{axis}": columns[i] for i, axis in enumerate("XYZ")}
    with pye57.E57(str(path), "w") as file:
        file.write_scan_raw(named)


def write_text(path: Path, base: Array, points: int) -> None:
    with path.open("w") as file:
        for block in blocks_of(base, points):
            np.savetxt(file, block, fmt="%.4f")


WRITERS = {
    "las": write_las,
    "laz": write_las,
    "laz7": write_laz7,
    "e57": write_e57,
    "text": write_text,
}
SUFFIXES = {"text": "xyz", "laz7": "laz"}


def write(path: Path, kind: str, points: int) -> None:
    """In a process of its own: the peak of a process is that of its parent at least."""
    words = (write_pcd if kind == "pcd" else WRITERS[kind], path, points)
    process = multiprocessing.get_context("spawn").Process(target=write_simulated, args=words)
    process.start()
    process.join()
    if process.exitcode != 0:
        raise SystemExit(f"format_speed: {path} was not written")


def write_simulated(writer: Callable[..., None], path: Path, points: int) -> None:
    base = simulated(path.parent)
    evenly = np.linspace(0, len(base) - 1, min(points, len(base))).astype(np.int64)
    writer(path, base[evenly], points)
