"""A result as rows of the history: its extraction, stations, setups and checks."""

from __future__ import annotations

import json
from typing import Any

from sqlalchemy import select
from sqlalchemy.orm import Session

from tank_datum.farm.models import Check, Extraction, Input, Result, Setup, Station
from tank_datum.farm.store import DATUM, Store
from tank_datum.farm.task import Row, TankRow


def put_extraction(session: Session, run_id: int, row: Row) -> None:
    """The extraction and its inputs; one that is there already stays."""
    if session.get(Extraction, row.key) is not None:
        return
    inputs = [
        Input(number=number, url=i["url"], size=i["size"], hash=i["hash"])
        for number, i in enumerate(row.inputs)
    ]
    session.add(
        Extraction(
            key=row.key,
            run_id=run_id,
            job=row.job,
            outcome=row.outcome,
            reason=row.reason,
            version=row.version,
            seconds=row.seconds,
            points=row.points,
            worker=row.worker,
            inputs=inputs,
        )
    )
    session.flush()


def _result_of(session: Session, key: str, epoch: int) -> int | None:
    there = select(Result.id).where(
        Result.extraction_key == key, Result.epoch_id == epoch
    )
    return session.scalars(there).first()


def put_result(
    session: Session, store: Store, row: Row, tank: TankRow, epoch: int
) -> None:
    """A tank's result with its stations, setups and checks; one that is there already stays."""
    if _result_of(session, row.key, epoch) is not None:
        return
    datum = json.loads(store.read(row.key, f"{tank.folder}/{DATUM}"))
    session.add(
        Result(
            extraction_key=row.key,
            epoch_id=epoch,
            folder=tank.folder,
            status=tank.status,
            message=tank.message,
            centre_x=tank.centre[0] if tank.centre else None,
            centre_y=tank.centre[1] if tank.centre else None,
            radius=tank.radius,
            **_figures(datum),
            stations=_stations(datum),
            setups=_setups(datum),
            checks=_checks(datum),
        )
    )
    session.flush()


def _figures(datum: dict[str, Any]) -> dict[str, Any]:
    verdict, level = datum.get("verdict") or {}, datum.get("datum") or {}
    tilt, shape = datum.get("tilt") or {}, datum.get("out_of_plane") or {}
    return {
        "verdict": verdict.get("word"),
        "governing": verdict.get("governing"),
        "utilisation": verdict.get("utilisation"),
        "mean_z": level.get("mean"),
        "sigma_z": _median(s["sigma_z"] for s in datum.get("stations", [])),
        "measured": level.get("measured"),
        "interpolated": level.get("interpolated"),
        "missing": level.get("missing"),
        "tilt_slope": tilt.get("slope"),
        "tilt_direction_deg": tilt.get("direction_deg"),
        "sigma_tilt": tilt.get("sigma_slope"),
        "out_of_plane": shape.get("max_abs_u"),
    }


def _median(values: Any) -> float | None:
    known = sorted(value for value in values if value is not None)
    return known[len(known) // 2] if known else None


def _stations(datum: dict[str, Any]) -> list[Station]:
    return [
        Station(
            number=number,
            azimuth_deg=s["azimuth_deg"],
            z=s["z"],
            sigma_z=s["sigma_z"],
            flag=s["flag"],
        )
        for number, s in enumerate(datum.get("stations", []))
    ]


def _setups(datum: dict[str, Any]) -> list[Setup]:
    names = ("name", "points", "dz", "sigma_dz", "verdict")
    return [
        Setup(number=number, **{name: s.get(name) for name in names})
        for number, s in enumerate(datum.get("setups") or [])
    ]


def _checks(datum: dict[str, Any]) -> list[Check]:
    names = ("code", "clause", "name", "value", "unit", "verdict", "role")
    return [
        Check(number=number, limit_value=c.get("limit"), **{n: c.get(n) for n in names})
        for number, c in enumerate(datum.get("checks") or [])
    ]
