"""Results read back from files."""

from __future__ import annotations

import csv
import io
import json
import math
import os
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from tank_datum_qa._regular_file import read_regular

from tank_datum import _core
from tank_datum._arguments import path_bytes
from tank_datum._datum import Datum
from tank_datum._errors import FileError, file_error, refused_by_system
from tank_datum._record import Misfit, record_of
from tank_datum._records import Results

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
_SHELL = ["azimuth_deg", "height", "radius", "deviation", "sigma", "n", "offset"]
_NEEDED = ["station", "azimuth_deg", "z", "sigma_z", "flag"]  # of the stations
_TEXTS = {"flag": "U12", "reason": "U13"}
_COUNTS = {"station": "i8"}
_WANTED = "a datum.json of tank_datum"


def load(path: str | os.PathLike[str]) -> Datum:
    """A result that was written before: its folder, or its datum.json alone.

    A datum.json of another name stands for itself: then only azimuth_deg, z, sigma_z and flag of
    the stations are known, and there is no report. Raises FileError, also for a folder whose files
    are damaged or do not belong together.
    """
    encoded = path_bytes("load", "path", path)
    given = Path(os.fsdecode(encoded))
    _core.settle(encoded)
    main = given / "datum.json" if given.is_dir() else given
    names = _NAMES if main.name == "datum.json" else ()
    files = {n: _bytes(main.parent / n) for n in names if (main.parent / n).is_file()}
    files["datum.json"] = _bytes(main)
    record = _record(main, files["datum.json"])
    stations = _stations(record.get("stations") or [])
    if "stations.csv" in files:
        place = main.parent / "stations.csv"
        table = _table(place, files["stations.csv"], _NEEDED)
        _require_same(place, table, stations)
        stations = table
    loaded = Datum(
        record,
        stations,
        _cloud(main.parent / "datum_points.pcd", files.get("datum_points.pcd")),
        _shell(main.parent / "shell.csv", files.get("shell.csv"), record),
        files=files,
        source=os.fsdecode(encoded),
    )
    try:
        loaded._errors()
    except (KeyError, TypeError, ValueError):
        raise _refused(main, "covariance of another shape", _WANTED) from None
    return loaded


def _bytes(path: Path) -> bytes:
    try:
        return read_regular(path)
    except OSError as error:
        expected = "a datum.json or a folder with one"
        raise refused_by_system("load", str(path), error, expected) from None


def _record(path: Path, content: bytes) -> dict[str, Any]:
    try:
        record = json.loads(content, parse_constant=_no_number, parse_float=_finite)
    except (ValueError, RecursionError) as error:
        said = str(error) if isinstance(error, ValueError) else "nested too deep"
        said = "no text" if isinstance(error, UnicodeDecodeError) else said
        raise _refused(path, said, _WANTED) from None
    if (
        not isinstance(record, dict)
        or not {"schema", "status", "input"} <= record.keys()
    ):
        raise _refused(path, "other JSON", _WANTED)
    schema = record["schema"]
    if isinstance(schema, bool) or schema != SCHEMA:
        raise _refused(path, f"schema {json.dumps(schema)}", f"schema {SCHEMA}")
    try:
        typed = record_of(Results, record)
        named = all(isinstance(file["path"], str) for file in typed.input["files"])
    except Misfit as error:
        value = f"{error.kind} at {error.place}"
        raise _refused(path, value, f"{error.wanted} there") from None
    except (KeyError, TypeError):
        named = False
    if not named or record["status"] is None or "message" not in record:
        raise _refused(path, "without status or the files' paths", _WANTED)
    return record


def _no_number(word: str) -> float:
    raise ValueError(f"{word}, which is no JSON")


def _finite(digits: str) -> float:
    number = float(digits)
    if not math.isfinite(number):
        raise ValueError(f"{digits}, beyond all numbers")
    return number


def _dtype(names: list[str]) -> np.dtype[Any]:
    kinds = {**_TEXTS, **_COUNTS}
    return np.dtype([(name, kinds.get(name, "f8")) for name in names])


def _table(path: Path, content: bytes, needed: list[str]) -> NDArray[Any]:
    """A CSV file as a structured array; an empty cell is NaN."""
    try:
        lines = csv.reader(io.StringIO(content.decode("utf-8")), strict=True)
        header, *rows = list(lines) or [[]]
    except (csv.Error, UnicodeDecodeError) as error:
        raise _refused(path, str(error), "a table as tank_datum writes it") from None
    if not content.endswith(b"\n"):
        raise _refused(path, "a last line without an end", "all of the table")
    lacking = [name for name in needed if name not in header]
    if lacking or len(set(header)) < len(header):
        said = f"no column {lacking[0]}" if lacking else "a column twice"
        raise _refused(path, said, "a table as tank_datum writes it")
    table = np.zeros(len(rows), dtype=_dtype(header))
    try:
        if any(len(row) != len(header) for row in rows):
            raise ValueError("rows of other lengths than the header's")
        for at, name in enumerate(header):
            column = [row[at] for row in rows]
            number = name not in _TEXTS and name not in _COUNTS
            table[name] = (
                [float(cell or "nan") for cell in column] if number else column
            )
    except (ValueError, OverflowError) as error:
        raise _refused(path, str(error), "a row per station") from None
    return table


def _shell(path: Path, content: bytes | None, record: dict[str, Any]) -> NDArray[Any]:
    if content is None:
        return np.zeros(0, dtype=_dtype(_SHELL))
    table = _table(path, content, _SHELL)
    for row in (record.get("shell") or {}).get("roundness", []):
        rows = np.count_nonzero(table["height"] == row["height"])
        if rows != row["n"]:
            said = f"{rows} rows at a height of {row['height']} m"
            raise _refused(path, said, f"{row['n']}, as datum.json has")
    return table


def _stations(listed: list[dict[str, Any]]) -> NDArray[Any]:
    """What datum.json has of the stations; the rest is NaN."""
    table = np.zeros(len(listed), dtype=_dtype(_NEEDED))
    table["station"] = np.arange(len(listed))
    for name in ("azimuth_deg", "z", "sigma_z"):
        known = [row.get(name) for row in listed]
        table[name] = [np.nan if value is None else value for value in known]
    table["flag"] = [row.get("flag") or "" for row in listed]
    return table


def _require_same(path: Path, table: NDArray[Any], listed: NDArray[Any]) -> None:
    """Both files are of one run."""
    if len(table) != len(listed):
        raise _refused(
            path, f"{len(table)} stations", f"{len(listed)}, as datum.json has"
        )
    if not np.allclose(
        table["z"], listed["z"], rtol=0.0, atol=1e-6, equal_nan=True
    ) or not np.allclose(
        table["azimuth_deg"], listed["azimuth_deg"], rtol=0.0, atol=1e-6
    ):
        raise _refused(path, "other stations", "those of datum.json")


def _cloud(path: Path, content: bytes | None) -> NDArray[np.float64]:
    """The points of a PCD that tank_datum wrote."""
    if content is None:
        return np.empty((0, 3))
    head, _, data = content.partition(b"DATA binary\n")
    rows = [line.split() for line in head.decode("ascii", "replace").splitlines()]
    words = {row[0]: row[1:] for row in rows if row}
    fields, sizes = words.get("FIELDS", []), words.get("SIZE", [])
    full = any(name.startswith("full_") for name in fields)
    axes = [f"full_{axis}" for axis in "xyz"] if full else list("xyz")
    try:
        row = np.dtype(
            [(name, f"<f{size}") for name, size in zip(fields, sizes, strict=True)]
        )
        points = int(words["POINTS"][0])
        if len(data) != points * row.itemsize:
            raise ValueError("cut short")
        table = np.frombuffer(data, dtype=row)
        return np.column_stack([table[name].astype(np.float64) for name in axes])
    except (KeyError, IndexError, TypeError, ValueError):
        expected = "x, y and z as binary floats"
        raise _refused(path, "not as tank_datum writes it", expected) from None


def _refused(path: Path, value: str, expected: str) -> FileError:
    return file_error("load", str(path), value, expected)
