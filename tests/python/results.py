"""Results read back, and PCD files written and read, with nothing of the project itself."""

from __future__ import annotations

import csv
import json
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Run = subprocess.CompletedProcess[str]

HEADER = (
    "station,azimuth_deg,x,y,z,sigma_z,radius,sigma_radius,n_shell,n_foundation,flag,"
    "z_paper,z_tilt,u,u_fit,curvature,n_setups,sigma_setup,reason"
)
NO_FIGURES = ("station", "flag", "reason")  # columns of numbers and words
RESULTS = (
    "datum.json",
    "stations.csv",
    "shell.csv",
    "datum_points.pcd",
    "datum_curve.pcd",
    "datum_nodes.csv",
    "report.html",
)
FOLDER = (*RESULTS, "manifest.json")


@dataclass(frozen=True)
class Stations:
    """stations.csv as columns; an empty cell is NaN."""

    columns: dict[str, Array]
    flag: list[str]

    def __getitem__(self, name: str) -> Array:
        return self.columns[name]

    def __len__(self) -> int:
        return len(self.flag)

    def where(self, flag: str) -> NDArray[np.bool_]:
        return np.array([f == flag for f in self.flag], dtype=bool)


def read_stations(folder: Path) -> Stations:
    with (folder / "stations.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    names = [name for name in HEADER.split(",") if name not in NO_FIGURES[1:]]
    columns = {n: np.array([float(row[n] or "nan") for row in rows]) for n in names}
    return Stations(columns, [row["flag"] for row in rows])


def _no_constant(name: str) -> float:
    raise AssertionError(f"{name} in JSON")


def read_datum(folder: Path) -> dict[str, Any]:
    """datum.json, which must hold no NaN or Infinity."""
    text = (folder / "datum.json").read_text()
    result: dict[str, Any] = json.loads(text, parse_constant=_no_constant)
    return result


def read_truth(scan: Path) -> dict[str, Any]:
    result: dict[str, Any] = json.loads(scan.with_suffix(".truth.json").read_text())
    return result


def write_pcd(
    path: Path, columns: dict[str, NDArray[Any]], *, data: str = "binary", points: int | None = None
) -> Path:
    """A PCD of named columns, each with the type of its array; `points` lies in the header."""
    kinds = {"f": "F", "i": "I", "u": "U"}
    arrays = list(columns.values())
    count = len(arrays[0]) if points is None else points
    header = (
        "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n"
        f"FIELDS {' '.join(columns)}\n"
        f"SIZE {' '.join(str(a.dtype.itemsize) for a in arrays)}\n"
        f"TYPE {' '.join(kinds[a.dtype.kind] for a in arrays)}\n"
        f"COUNT {' '.join('1' for _ in arrays)}\n"
        f"WIDTH {count}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {count}\nDATA {data}\n"
    )
    if data == "ascii":
        rows = (" ".join(repr(v.item()) for v in row) for row in zip(*arrays, strict=True))
        path.write_text(header + "".join(row + "\n" for row in rows))
        return path
    table = np.rec.fromarrays(arrays, names=list(columns))
    path.write_bytes(header.encode() + table.tobytes())
    return path


def write_xyz(path: Path, points: NDArray[Any], kind: str = "<f8") -> Path:
    columns = {name: points[:, i].astype(kind) for i, name in enumerate("xyz")}
    return write_pcd(path, columns)


def read_pcd(path: Path) -> dict[str, NDArray[Any]]:
    """A binary PCD, as tank_datum and tank_datum_synth write it."""
    raw = path.read_bytes()
    end = raw.index(b"DATA binary\n") + len(b"DATA binary\n")
    header = {
        words[0]: words[1:]
        for line in raw[:end].decode().splitlines()
        if (words := line.split()) and words[0] != "#"
    }
    kinds = {"F": "f", "I": "i", "U": "u"}
    types = [
        (name, f"<{kinds[kind]}{size}")
        for name, size, kind in zip(header["FIELDS"], header["SIZE"], header["TYPE"], strict=True)
    ]
    table = np.frombuffer(raw[end:], dtype=types)
    assert len(table) == int(header["POINTS"][0])
    return {name: table[name] for name in header["FIELDS"]}


def read_points(path: Path) -> Array:
    """In the scan's frame, which a result's PCD has in fields of their own."""
    columns = read_pcd(path)
    names = [f"full_{n}" if f"full_{n}" in columns else n for n in "xyz"]
    return np.column_stack([columns[n].astype(np.float64) for n in names])
