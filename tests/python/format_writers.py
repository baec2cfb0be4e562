"""Scans of setups written by other people's libraries, or by hand after the published layouts."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import laspy
import numpy as np
import pye57
from numpy.typing import NDArray
from plyfile import PlyData, PlyElement
from pyquaternion import Quaternion

from results import Array

STEP = 1e-4  # of the coordinates that all formats hold [m]
SHIFT = np.array([300_000.0, 5_000_000.0, 0.0])  # as in a map's frame


@dataclass(frozen=True)
class Setups:
    """The scan as it was made: points of each setup, and where its scanner stood."""

    points: list[Array]
    origins: list[Array]

    def all(self) -> Array:
        return np.concatenate(self.points)

    def labels(self) -> NDArray[np.uint16]:
        counts = [len(p) for p in self.points]
        return np.repeat(np.arange(len(counts), dtype=np.uint16), counts)


def write_las(path: Path, scan: Setups, version: str, point_format: int) -> Path:
    header = laspy.LasHeader(version=version, point_format=point_format)
    header.scales, header.offsets = np.full(3, STEP), SHIFT
    las = laspy.LasData(header)
    las.x, las.y, las.z = scan.all().T
    las.point_source_id = scan.labels()
    las.write(str(path))
    return path


def write_ply(path: Path, scan: Setups, order: str) -> Path:
    rows = np.rec.fromarrays(
        [*scan.all().T, np.zeros(len(scan.all()), "u1"), scan.labels()],
        names=["x", "y", "z", "red", "scan_id"],
    )
    faces = np.array([([0, 1, 2],)], dtype=[("vertex_indices", "i4", (3,))])
    elements = [PlyElement.describe(rows, "vertex"), PlyElement.describe(faces, "face")]
    PlyData(elements, text=order == "=", byte_order=order).write(str(path))
    return path


def write_rows(path: Path, scan: Setups, separator: str, header: str) -> Path:
    rows = np.column_stack([scan.labels(), scan.all()])
    with path.open("w", newline="") as file:
        file.write(header + "\r\n" if header else "")
        np.savetxt(file, rows, fmt=["%d", "%.17g", "%.17g", "%.17g"], delimiter=separator)
    return path


def write_pts(path: Path, scan: Setups) -> Path:
    with path.open("w") as file:
        for points in scan.points:
            file.write(f"{len(points)}\n")
            np.savetxt(file, np.column_stack([points, np.zeros((len(points), 4))]), fmt="%.17g")
    return path


def poses() -> list[Array]:
    """A turn of each scanner about its vertical, and a little about another axis."""
    turns = []
    for angle, lean in ((0.3, 0.0), (2.0, 0.01), (-1.2, -0.02)):
        c, s, cl, sl = np.cos(angle), np.sin(angle), np.cos(lean), np.sin(lean)
        turns.append(
            np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ [[1, 0, 0], [0, cl, -sl], [0, sl, cl]]
        )
    return turns


def write_ptx(path: Path, scan: Setups) -> Path:
    """Leica's layout: the matrix stands for row vectors; a grid with beams that did not return."""
    with path.open("w") as file:
        for points, origin, turn in zip(scan.points, scan.origins, poses(), strict=True):
            rows = 100
            columns = len(points) // rows + 1
            own = np.zeros((rows * columns, 3))
            own[: len(points)] = (points - origin) @ turn  # turn's inverse is its transpose
            file.write(f"{columns}\n{rows}\n")
            np.savetxt(file, [origin], fmt="%.12f")
            np.savetxt(file, turn.T, fmt="%.15f")
            matrix = np.eye(4)
            matrix[:3, :3], matrix[3, :3] = turn.T, origin
            np.savetxt(file, matrix, fmt="%.15f")
            np.savetxt(file, np.column_stack([own, np.full(len(own), 0.5)]), fmt="%.9f")
    return path


def in_floats(scan: Setups) -> Setups:
    """The points that 4-byte floats in each scanner's own frame hold, as pye57 writes them."""
    points = [
        ((p - origin) @ turn).astype(np.float32).astype(np.float64) @ turn.T + origin
        for p, origin, turn in zip(scan.points, scan.origins, poses(), strict=True)
    ]
    return Setups(points, scan.origins)


def write_e57(path: Path, scan: Setups, names: Sequence[str]) -> Path:
    """Each scan in the scanner's own frame, beside its pose; pye57 stores 4-byte floats."""
    with pye57.E57(str(path), "w") as file:
        for points, origin, turn, name in zip(
            scan.points, scan.origins, poses(), names, strict=True
        ):
            own = (points - origin) @ turn
            columns = {f"cartesian{axis}": own[:, i] for i, axis in enumerate("XYZ")}
            rotation = Quaternion(matrix=turn).elements
            file.write_scan_raw(columns, name=name, rotation=rotation, translation=origin)
    return path


WRITERS: dict[str, Callable[[Path, Setups], Path]] = {
    "las_1.2": lambda path, scan: write_las(path, scan, "1.2", 1),
    "las_1.4": lambda path, scan: write_las(path, scan, "1.4", 6),
    "ply_little": lambda path, scan: write_ply(path, scan, "<"),
    "ply_big": lambda path, scan: write_ply(path, scan, ">"),
    "ply_ascii": lambda path, scan: write_ply(path, scan, "="),
    "pts": write_pts,
    "csv": lambda path, scan: write_rows(path, scan, ",", "setup,x,y,z"),
    "tab": lambda path, scan: write_rows(path, scan, "\t", "scan_id\tEasting\tNorthing\tElevation"),
    "semicolon": lambda path, scan: write_rows(
        path, scan, "; ", "Point_Source_Id;X [m];Y [m];Z [m]"
    ),
}
