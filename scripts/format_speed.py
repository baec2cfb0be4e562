"""Seconds that a scan takes in each format, beside the same in PCD or a plain read of the file.

Scans are made of one that is simulated, repeated with noise, one format after the other; each is
removed after its runs. The command is the one that is installed beside this Python; a plain read
takes every coordinate through the package that the command reads the format by, and drops it.
Both are run in turn, and the fastest run of each counts. "locate + crop" are the two stages that
read the scan; others take as long whatever its size. The last column is their rows in a second.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import laspy
import lazrs
import numpy as np
from pye57 import libe57

from format_scans import COMMANDS, SUFFIXES, WRITERS, write

BLOCK = 1 << 20  # rows of a plain read


@dataclass(frozen=True)
class Took:
    seconds: float
    of_processors: float
    megabytes: float
    """at most, of memory"""
    passes: float = 0.0
    """seconds of the two stages that read the scan, locate and crop"""


# ---- plain reads ----


def plain_e57(path: str) -> int:
    image = libe57.ImageFile(path, "r")
    buffers = libe57.VectorSourceDestBuffer()
    columns = [np.empty(BLOCK) for _ in "XYZ"]
    for axis, column in zip("XYZ", columns, strict=True):
        name = f"cartesian{axis}"
        buffers.append(libe57.SourceDestBuffer(image, name, column, BLOCK, True, True))
    reader = image.root()["data3D"][0]["points"].reader(buffers)
    done = 0
    while rows := reader.read():
        done += rows
    reader.close()
    return done


def plain_laz(path: str) -> int:
    """By lazrs alone, in all threads, into one buffer."""
    with open(path, "rb") as file:
        header = laspy.LasReader(file, closefd=False).header
        record = header.vlrs[header.vlrs.index("LasZipVlr")].record_data
        file.seek(header.offset_to_point_data)
        reader = lazrs.ParLasZipDecompressor(file, record)
        rows = np.empty((BLOCK, header.point_format.size), np.uint8)
        for done in range(0, header.point_count, BLOCK):
            reader.decompress_many(rows[: header.point_count - done].reshape(-1))
        return int(header.point_count)


PLAIN: dict[str, Callable[[str], int]] = {"e57": plain_e57, "laz": plain_laz, "laz7": plain_laz}


def read_plainly(kind: str, path: str) -> None:
    """In a process of its own, whose start is not counted."""
    began, used = time.perf_counter(), time.process_time()
    points = PLAIN[kind](path)
    took = time.perf_counter() - began, time.process_time() - used
    print(json.dumps({"points": points, "seconds": took[0], "processors": took[1]}))


# ---- runs ----


def run(words: list[str]) -> tuple[Took, str]:
    began = time.perf_counter()
    process = subprocess.Popen(words, stdout=subprocess.PIPE, text=True)
    assert process.stdout
    said = process.stdout.read()
    _, status, used = os.wait4(process.pid, 0)
    seconds = time.perf_counter() - began
    if status != 0:
        raise SystemExit(f"format_speed: {' '.join(words)}: status {status}")
    return Took(seconds, used.ru_utime + used.ru_stime, used.ru_maxrss / 1024), said


def command(path: Path) -> Took:
    timings = path.with_suffix(".json")
    words = [str(COMMANDS / "tank_datum"), str(path), "-o", str(path.with_suffix(".datum"))]
    took, _ = run([*words, "--quiet", "--timings", str(timings)])
    stages = json.loads(timings.read_text())["stages"]
    return Took(took.seconds, took.of_processors, took.megabytes, stages["locate"] + stages["crop"])


def plain(path: Path) -> Took:
    words = [sys.executable, __file__, "--plain", path.suffix[1:], str(path)]
    took, said = run(words)
    told: dict[str, Any] = json.loads(said)
    return Took(told["seconds"], told["processors"], took.megabytes)


def figures(kind: str, points: int, folder: Path, repeats: int) -> list[str]:
    """Of the command, of what stands beside it, and how many times that the command takes."""
    path = folder / f"scan.{SUFFIXES.get(kind, kind)}"
    write(path, kind, points)
    beside = path
    if kind not in PLAIN:
        beside = folder / "scan.pcd"
        write(beside, "pcd", points)
    runs = [
        (command(path), plain(path) if kind in PLAIN else command(beside)) for _ in range(repeats)
    ]
    for file in {path, beside}:
        file.unlink()
    took, other = (min(column, key=lambda t: t.seconds) for column in zip(*runs, strict=True))
    times = took.seconds / other.seconds, took.of_processors / other.of_processors
    passes = took.passes / (other.passes or other.seconds)
    return [
        f"{kind} beside {'a plain read' if kind in PLAIN else 'PCD'}",
        f"{points / 1e6:.0f} M",
        *(f"{t.seconds:.2f} ({t.of_processors:.2f})" for t in (took, other)),
        f"{times[0]:.2f} ({times[1]:.2f})",
        f"{passes:.2f}",
        f"{took.megabytes:.0f}",
        f"{2 * points / took.passes / 1e6:.1f}",
    ]


def main() -> None:
    parser = argparse.ArgumentParser(prog="scripts/format_speed.py", description=__doc__)
    parser.add_argument("--points", type=float, default=1e7, help="of each scan")
    parser.add_argument("--formats", default=",".join(WRITERS), help="separated by commas")
    parser.add_argument("--repeats", type=int, default=2, help="of each run")
    parser.add_argument("--folder", type=Path, help="for the scans; 10^8 points of LAS need 3.2 GB")
    parser.add_argument("--plain", nargs=2, metavar=("FORMAT", "FILE"), help="read a file plainly")
    given = parser.parse_args()
    if given.plain:
        return read_plainly(*given.plain)
    kinds = given.formats.split(",")
    if not set(kinds) <= set(WRITERS):
        parser.error(f"--formats: {given.formats}, expected some of {', '.join(WRITERS)}")
    columns = ("scan", "points", "seconds (of processors)", "beside", "times", "locate + crop")
    print(f"| {' | '.join((*columns, 'peak MB', 'M points/s'))} |\n|{' --- |' * 8}")
    with tempfile.TemporaryDirectory(dir=given.folder) as folder:
        for kind in kinds:
            row = figures(kind, int(given.points), Path(folder), given.repeats)
            print(f"| {' | '.join(row)} |", flush=True)


if __name__ == "__main__":
    main()
