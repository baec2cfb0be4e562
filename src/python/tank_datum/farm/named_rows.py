"""Rows that have a name: tanks of a site, and epochs of a tank."""

from __future__ import annotations

from typing import Any

from sqlalchemy import select
from sqlalchemy.dialects import postgresql, sqlite
from sqlalchemy.orm import Session

from tank_datum.farm.campaign import FarmTank, Survey, day_of
from tank_datum.farm.models import Epoch, Tank


def upsert(
    session: Session, model: Any, unique: tuple[str, ...], **values: Any
) -> None:
    """Inserts a row; one with the same unique columns takes the other values."""
    dialect = postgresql if session.get_bind().dialect.name == "postgresql" else sqlite
    made = dialect.insert(model).values(**values)
    rest = {name: value for name, value in values.items() if name not in unique}
    session.execute(made.on_conflict_do_update(index_elements=list(unique), set_=rest))


def tank_id(session: Session, site: str, tank: FarmTank) -> int:
    """The tank's row, as the campaign says it is."""
    facts = tank.steel | {
        "centre": tank.centre,
        "radius": tank.radius,
        "drawing_north_deg": tank.drawing_north_deg,
        "height_reference": tank.height_reference,
    }
    upsert(session, Tank, ("site", "name"), site=site, name=tank.name, facts=facts)
    found = select(Tank.id).where(Tank.site == site, Tank.name == tank.name)
    return session.scalars(found).one()


def facts_of(survey: Survey) -> dict[str, Any]:
    """The columns of an epoch that the campaign says."""
    return {
        "date": day_of(survey.date),
        "kind": "levelling" if survey.levelled else "scan",
        "fill_level": survey.fill_level,
        "hydrotest": survey.hydrotest,
        "registration_error": survey.registration_error,
        "registration_tilt_arcsec": survey.registration_tilt_arcsec,
        "marks": survey.marks,
    }


def epoch_id(session: Session, tank: int, survey: Survey) -> int:
    """The epoch's row of a tank."""
    keys = ("tank_id", "label")
    facts = facts_of(survey)
    upsert(session, Epoch, keys, tank_id=tank, label=survey.epoch, **facts)
    found = select(Epoch.id).where(Epoch.tank_id == tank, Epoch.label == survey.epoch)
    return session.scalars(found).one()
