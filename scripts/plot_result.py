"""Results of tank_datum read for pictures, and the scan. Metres, degrees."""

from __future__ import annotations

import csv
import json
import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from length_units import METRES

Array = NDArray[np.float64]
SCHEMA = 1  # of datum.json: what this version knows
TEXT_COLUMNS = {"flag", "reason"}  # of stations.csv
FULL = ("full_x", "full_y", "full_z")  # fields of a result's PCD beside x, y, z near an origin
CLOUD_POINTS = 200_000
"""the most points of a scan that are drawn"""


class PlotError(Exception):
    """A file that is missing or is not what it should be; the message is one line."""


@dataclass(frozen=True)
class Result:
    """One result; without a usable datum the arrays are empty."""

    datum: dict[str, Any]
    columns: dict[str, Array]
    """of stations.csv; an empty cell is NaN"""
    flags: list[str]
    edge_points: Array
    """n x 3 [m]"""

    @property
    def usable(self) -> bool:
        return "datum" in self.datum

    def azimuth(self, points: Array) -> Array:
        """Of points about the tank's centre, as the stations count it, 0 to 360 [deg]."""
        x, y = (points[:, :2] - self.datum["tank"]["center"]).T
        stations = self.datum["options"]["stations"]
        turn = np.degrees(np.arctan2(y, x)) - stations["zero_azimuth_deg"]
        return np.mod(-turn if stations["clockwise"] else turn, 360.0)

    def radial(self, points: Array) -> Array:
        """Distance from the shell's circle, positive outside [m]."""
        tank = self.datum["tank"]
        return np.hypot(*(points[:, :2] - tank["center"]).T) - tank["radius"]

    def at(self, name: str, azimuth: Array) -> Array:
        """A column between its stations; NaN further than a station's spacing from a known one."""
        known = np.isfinite(self.columns[name])
        if not known.any():
            return np.full(len(azimuth), np.nan)
        stations = self.columns["azimuth_deg"][known]
        values = np.interp(azimuth, stations, self.columns[name][known], period=360.0)
        away = np.abs(azimuth[:, None] - stations[None, :])
        nearest = np.minimum(away, 360.0 - away).min(axis=1)
        return np.where(nearest <= 360.0 / len(self.flags), values, np.nan)


def _text(path: Path) -> str:
    try:
        return path.read_text()
    except (OSError, UnicodeDecodeError) as error:
        reason = error.strerror if isinstance(error, OSError) else "no text"
        raise PlotError(f"{path}, {reason}, expected a result of tank_datum") from None


def read_result(folder: Path) -> Result:
    try:
        datum = json.loads(_text(folder / "datum.json"))
        usable = datum["status"] in ("ok", "partial") and "datum" in datum
    except (json.JSONDecodeError, KeyError, TypeError):
        what = "not as tank_datum writes it"
        raise PlotError(f"{folder}/datum.json, {what}, expected its JSON") from None
    if datum.get("schema", 0) > SCHEMA:
        schema = datum["schema"]
        raise PlotError(f"{folder}/datum.json, schema {schema}, expected {SCHEMA} or older")
    if not usable:
        return Result(datum, {}, [], np.empty((0, 3)))
    rows = list(csv.DictReader(_text(folder / "stations.csv").splitlines()))
    try:
        names = [name for name in rows[0] if name not in TEXT_COLUMNS]
        columns = {name: np.array([float(row[name] or "nan") for row in rows]) for name in names}
        flags = [row["flag"] for row in rows]
    except (IndexError, KeyError, TypeError, ValueError):
        what = "not as tank_datum writes it"
        raise PlotError(f"{folder}/stations.csv, {what}, expected a row per station") from None
    return Result(datum, columns, flags, read_pcd(folder / "datum_points.pcd", 10**9))


def read_pcd(path: Path, most: int) -> Array:
    """Finite x, y, z of a PCD (ascii or binary); every n-th row, so that at most `most` remain.

    In the scan's own frame: full_x, full_y, full_z where they are, else about a comment's origin.
    """
    header: dict[str, list[str]] = {}
    origin = np.zeros(3)
    try:
        with path.open("rb") as file:
            while "DATA" not in header and (line := file.readline()):
                words = line.decode("ascii", "replace").split()
                if words[:3] == ["#", "tank_datum:", "origin"]:
                    origin = np.array([float(word) for word in words[3:6]])
                header[words[0] if words else ""] = words[1:]
            start = file.tell()
        step = max(1, math.ceil(int(header["POINTS"][0]) / most))
        full = all(name in header["FIELDS"] for name in FULL)
        xyz = _rows(path, header, start, step, FULL if full else tuple("xyz"))
        xyz = xyz if full else xyz + origin
    except OSError as error:
        raise PlotError(f"{path}, {error.strerror}, expected a PCD") from None
    except (KeyError, IndexError, ValueError, TypeError):
        raise PlotError(
            f"{path}, its header or length, expected a whole PCD with x, y, z"
        ) from None
    return xyz[np.isfinite(xyz).all(axis=1)]


def _rows(
    path: Path, header: dict[str, list[str]], start: int, step: int, names: Sequence[str]
) -> Array:
    fields, kind, points = header["FIELDS"], header["DATA"][0], int(header["POINTS"][0])
    if kind == "ascii":
        columns = [fields.index(name) for name in names]
        with path.open("rb") as file:
            file.seek(start)
            lines = [line for i, line in enumerate(file) if i % step == 0]
        return np.loadtxt(lines, usecols=columns, ndmin=2)
    if kind != "binary":
        raise PlotError(f"{path}, DATA {kind}, expected ascii or binary")
    kinds = {"F": "f", "I": "i", "U": "u"}
    counts = header.get("COUNT", ["1"] * len(fields))
    described = zip(fields, header["TYPE"], header["SIZE"], counts, strict=True)
    row = np.dtype(
        [
            (f if f in names else f"{f}{i}", f"<{kinds[t]}{s}", (int(c),))
            for i, (f, t, s, c) in enumerate(described)
        ]
    )
    if points == 0:
        return np.empty((0, 3))
    table = np.memmap(path, row, "r", start, (points,))[::step]
    return np.column_stack([table[name][:, 0].astype(np.float64) for name in names])


def read_cloud(result: Result, folder: Path, scans: list[Path]) -> Array:
    """The scan, thinned: where datum.json says, beside the folder, or as named."""
    recorded = [Path(file["path"]) for file in result.datum["input"]["files"]]
    found = scans or [p if p.exists() else folder.resolve().parent / p.name for p in recorded]
    most = CLOUD_POINTS // max(1, len(found))
    clouds = [read_pcd(path, most) for path in found]
    return METRES[result.datum["input"]["units"]] * np.vstack([np.empty((0, 3)), *clouds])
