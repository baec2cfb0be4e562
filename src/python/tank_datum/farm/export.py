"""The history as tables, CSV and Parquet alike, and one JSON a tank."""

from __future__ import annotations

import csv
import json
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.parquet as pq
from sqlalchemy import select

from tank_datum.farm.campaign import Campaign
from tank_datum.farm.history import open_history
from tank_datum.farm.models import Result, Station
from tank_datum.farm.view import Plain, farm_view

STEERS = ("=", "+", "-", "@", "\t", "\r")  # begin a formula in a spreadsheet
TEXT, NUMBER, WHOLE, FLAG = pa.string(), pa.float64(), pa.int64(), pa.bool_()

EPOCHS = {
    "tank": TEXT,
    "epoch": TEXT,
    "date": TEXT,
    "fill_level": NUMBER,
    "hydrotest": TEXT,
    "status": TEXT,
    "message": TEXT,
    "verdict": TEXT,
    "governing": TEXT,
    "utilisation": NUMBER,
    "mean_z": NUMBER,
    "sigma_z": NUMBER,
    "measured": WHOLE,
    "interpolated": WHOLE,
    "missing": WHOLE,
    "tilt_slope": NUMBER,
    "tilt_direction_deg": NUMBER,
    "sigma_tilt": NUMBER,
    "out_of_plane": NUMBER,
    "version": TEXT,
    "key": TEXT,
    "kind": TEXT,
}
CHANGES = {
    "tank": TEXT,
    "epoch": TEXT,
    "date": TEXT,
    "fill_level": NUMBER,
    "hydrotest": TEXT,
    "settlement": NUMBER,
    "sigma_settlement": NUMBER,
    "tilt": NUMBER,
    "sigma_tilt": NUMBER,
    "tilt_direction_deg": NUMBER,
    "tilt_chance": NUMBER,
    "station": NUMBER,
    "station_azimuth_deg": NUMBER,
    "stations_moved": WHOLE,
    "matched": WHOLE,
    "out_of_plane": NUMBER,
    "out_of_plane_azimuth_deg": NUMBER,
}
TRENDS = {
    "tank": TEXT,
    "quantity": TEXT,
    "rate": NUMBER,
    "low": NUMBER,
    "high": NUMBER,
    "chance": NUMBER,
    "moves": FLAG,
    "azimuth_deg": NUMBER,
    "value": NUMBER,
    "low_value": NUMBER,
    "per_level": NUMBER,
    "sigma_per_level": NUMBER,
    "limit": NUMBER,
    "earliest": TEXT,
    "latest": TEXT,
}
ALARMS = {"tank": TEXT, "level": TEXT, "quantity": TEXT, "words": TEXT}
CHECKS = {
    "tank": TEXT,
    "epoch": TEXT,
    "code": TEXT,
    "clause": TEXT,
    "name": TEXT,
    "value": NUMBER,
    "limit_value": NUMBER,
    "unit": TEXT,
    "verdict": TEXT,
    "role": TEXT,
}
STATIONS = {
    "tank": TEXT,
    "epoch": TEXT,
    "station": WHOLE,
    "azimuth_deg": NUMBER,
    "z": NUMBER,
    "sigma_z": NUMBER,
    "flag": TEXT,
}
HYDROTESTS = CHANGES | {"test": TEXT}
SURVEYS = {
    "job": TEXT,
    "tank": TEXT,
    "epoch": TEXT,
    "date": TEXT,
    "state": TEXT,
    "reason": TEXT,
    "seconds": NUMBER,
    "version": TEXT,
    "key": TEXT,
}


def export_all(campaign: Campaign, folder: Path) -> list[Path]:
    """Writes every table as CSV and Parquet, and a JSON a tank. Raises FarmError, OSError."""
    views, state = farm_view(campaign)
    tables: list[tuple[str, dict[str, Any], list[Plain]]] = [
        ("epochs", EPOCHS, _rows(views, "epochs")),
        ("changes", CHANGES, _rows(views, "changes")),
        (
            "trends",
            TRENDS,
            [_trend(v["name"], t) for v in views for t in v["trends"].values()],
        ),
        ("alarms", ALARMS, _rows(views, "alarms")),
        ("hydrotests", HYDROTESTS, _steps(views)),
        ("checks", CHECKS, _checks(views)),
        ("stations", STATIONS, _stations(campaign, views)),
        ("surveys", SURVEYS, [vars(survey) for survey in state.surveys]),
    ]
    folder.mkdir(parents=True, exist_ok=True)
    written = []
    for name, columns, rows in tables:
        written += [folder / f"{name}.csv", folder / f"{name}.parquet"]
        write_csv(written[-2], columns, rows)
        arrays = {column: [row.get(column) for row in rows] for column in columns}
        pq.write_table(
            pa.table(arrays, schema=pa.schema(list(columns.items()))), written[-1]
        )
    for view in views:
        written.append(folder / f"tank_{view['slug']}.json")
        written[-1].write_text(json.dumps(view, indent=1) + "\n", encoding="utf-8")
    return written


def write_csv(path: Path, columns: dict[str, Any], rows: list[Plain]) -> None:
    """Unknown is empty. A text that a spreadsheet would take for a formula begins with '."""
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows([_cell(row.get(column)) for column in columns] for row in rows)


def _cell(value: object) -> object:
    if isinstance(value, str) and value.startswith(STEERS):
        return f"'{value}"
    return "" if value is None else repr(value) if isinstance(value, float) else value


def _rows(views: list[Plain], name: str) -> list[Plain]:
    return [{"tank": view["name"], **row} for view in views for row in view[name]]


def _trend(tank: str, trend: Plain) -> Plain:
    return {"tank": tank, **trend, **(trend["reaching"] or {})}


def _steps(views: list[Plain]) -> list[Plain]:
    return [
        {"tank": view["name"], "test": test["name"], **step}
        for view in views
        for test in view["hydrotests"]
        for step in test["steps"]
    ]


def _checks(views: list[Plain]) -> list[Plain]:
    return [
        {"tank": view["name"], "epoch": epoch["epoch"], **check}
        for view in views
        for epoch in view["epochs"]
        for check in epoch["checks"]
    ]


def _stations(campaign: Campaign, views: list[Plain]) -> list[Plain]:
    names = {
        e["result_id"]: (v["name"], e["epoch"]) for v in views for e in v["epochs"]
    }
    history = open_history(campaign)
    try:
        with history.session() as session:
            asked = (
                select(Station)
                .join(Result, Result.id == Station.result_id)
                .order_by(Station.result_id, Station.number)
            )
            return [
                {
                    "tank": names[s.result_id][0],
                    "epoch": names[s.result_id][1],
                    "station": s.number,
                    "azimuth_deg": s.azimuth_deg,
                    "z": s.z,
                    "sigma_z": s.sigma_z,
                    "flag": s.flag,
                }
                for s in session.scalars(asked)
                if s.result_id in names
            ]
    finally:
        history.close()
