"""Results read back from files."""

from __future__ import annotations

import csv
import io
import json
import os
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from tank_datum_qa._regular_file import read_regular

from tank_datum import _core
from tank_datum._datum import Datum
from tank_datum._errors import FileError, file_error

SCHEMA = 1  # of datum.json: what this version knows
_NAMES = (
    "datum.json",
    "stations.csv",
    "shell.csv",
    "datum_nodes.csv",
    "datum_points.pcd",
    "datum_curve.pcd",
    "report.html",
)
_SHELL = "azimuth_deg,height,radius,deviation,sigma,n,offset\n"
_TEXTS = {"flag": "U12", "reason": "U13"}
_COUNTS = {"station": "i8"}


def load(path: str | os.PathLike[str]) -> Datum:
    """A result that was written before: its folder, or its datum.json alone.

    A datum.json of another name stands for itself: then only azimuth_deg, z, sigma_z and flag of
    the stations are known, and there is no report. Raises FileError.
    """
    given = Path(path)
    _core.settle(os.fspath(path))
    main = given / "datum.json" if given.is_dir() else given
    names = _NAMES if main.name == "datum.json" else ()
    files = {n: _bytes(main.parent / n) for n in names if (main.parent / n).is_file()}
    files["datum.json"] = _bytes(main)
    record = _record(main, files["datum.json"])
    stations = (
        _table(main.parent / "stations.csv", files["stations.csv"].decode("utf-8"))
        if "stations.csv" in files
        else _stations(record.get("stations", []))
    )
    edge_points = _cloud(
        main.parent / "datum_points.pcd", files.get("datum_points.pcd")
    )
    shell_points = _table(
        main.parent / "shell.csv",
        files.get("shell.csv", _SHELL.encode()).decode("utf-8"),
    )
    return Datum(
        record, stations, edge_points, shell_points, files=files, source=os.fspath(path)
    )


def _bytes(path: Path) -> bytes:
    try:
        return read_regular(path)
    except OSError as error:
        raise file_error(
            "load",
            str(path),
            error.strerror or str(error),
            "a datum.json or a folder with one",
        ) from None


def _record(path: Path, content: bytes) -> dict[str, Any]:
    try:
        record = json.loads(content)
    except ValueError as error:
        raise file_error(
            "load", str(path), str(error), "a datum.json of tank_datum"
        ) from None
    if (
        not isinstance(record, dict)
        or not {"schema", "status", "input"} <= record.keys()
    ):
        raise file_error("load", str(path), "other JSON", "a datum.json of tank_datum")
    if record["schema"] != SCHEMA:
        raise file_error(
            "load", str(path), f"schema {record['schema']}", f"schema {SCHEMA}"
        )
    return record


def _dtype(names: list[str]) -> np.dtype[Any]:
    kinds = {**_TEXTS, **_COUNTS}
    return np.dtype([(name, kinds.get(name, "f8")) for name in names])


def _table(path: Path, text: str) -> NDArray[Any]:
    """stations.csv as a structured array; an empty cell is NaN."""
    header, *rows = list(csv.reader(io.StringIO(text))) or [[]]
    table = np.zeros(len(rows), dtype=_dtype(header))
    try:
        for at, name in enumerate(header):
            column = [row[at] for row in rows]
            number = name not in _TEXTS and name not in _COUNTS
            table[name] = (
                [float(cell or "nan") for cell in column] if number else column
            )
    except (IndexError, ValueError) as error:
        raise _refused(path, str(error), "a row per station") from None
    return table


def _stations(listed: list[dict[str, Any]]) -> NDArray[Any]:
    """What datum.json has of the stations; the rest is NaN."""
    table = np.zeros(
        len(listed), dtype=_dtype(["station", "azimuth_deg", "z", "sigma_z", "flag"])
    )
    table["station"] = np.arange(len(listed))
    for name in ("azimuth_deg", "z", "sigma_z"):
        table[name] = [np.nan if row[name] is None else row[name] for row in listed]
    table["flag"] = [row["flag"] for row in listed]
    return table


def _cloud(path: Path, content: bytes | None) -> NDArray[np.float64]:
    """The points of a PCD that tank_datum wrote."""
    if content is None:
        return np.empty((0, 3))
    head, _, data = content.partition(b"DATA binary\n")
    rows = [line.split() for line in head.decode("ascii", "replace").splitlines()]
    words = {row[0]: row[1:] for row in rows if row}
    fields, sizes = words.get("FIELDS", []), words.get("SIZE", [])
    axes: list[str] = [n for n in ("full_x", "full_y", "full_z") if n in fields] or [
        "x",
        "y",
        "z",
    ]
    try:
        row = np.dtype(
            [(name, f"<f{size}") for name, size in zip(fields, sizes, strict=True)]
        )
        table = np.frombuffer(data, dtype=row, count=int(words["POINTS"][0]))
        return np.column_stack([table[name].astype(np.float64) for name in axes])
    except (KeyError, IndexError, TypeError, ValueError):
        expected = "x, y and z as binary floats"
        raise _refused(path, "not as tank_datum writes it", expected) from None


def _refused(path: Path, value: str, expected: str) -> FileError:
    return file_error("load", str(path), value, expected)
