"""A tank's epochs in time: what settled, how fast, and when a limit is reached.

The core compares each epoch with the first (tank_datum.compare: movement.md says how); lines
through its figures give rates. Settlement is positive downwards.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace

import numpy as np

import tank_datum
from tank_datum.farm.campaign import FarmTank, Limits, Survey
from tank_datum.farm.heights import Shift, reduced, shift_of, shifted
from tank_datum.farm.quantities import Change, compared
from tank_datum.farm.rates import trends_of
from tank_datum.farm.trend import Trend

USABLE = ("ok", "partial")
NO_ERRORS = "a levelling without standard errors: a column sigma, or elevation_error"


@dataclass(frozen=True)
class EpochDatum:
    """An epoch with its datum. result_id: in the history, 0 without one."""

    survey: Survey
    datum: tank_datum.Datum
    result_id: int = 0


@dataclass(frozen=True)
class TankHistory:
    """A tank over time. changes: of each epoch since the first, that one included; trends: by the
    name of the quantity; notes: what was left out, and why."""

    tank: FarmTank
    epochs: tuple[EpochDatum, ...] = ()
    changes: tuple[Change, ...] = ()
    trends: dict[str, Trend] = field(default_factory=dict)
    notes: tuple[str, ...] = ()


def history_of(tank: FarmTank, epochs: list[EpochDatum], limits: Limits) -> TankHistory:
    """What moved between the epochs of dates, those of a hydrotest left out but for its first.

    epochs: in time order, of one tank. Epochs that cannot be compared are named in the notes.
    """
    usable, notes = _usable(tank, epochs)
    tank = seen_from(tank, usable, notes)
    if len(usable) < 2:
        return TankHistory(tank, tuple(usable), notes=tuple(notes))
    found, refused = compared(tank, usable)
    notes += refused
    if found is None:
        return TankHistory(tank, tuple(usable), notes=tuple(notes))
    trends = trends_of(found, limits)
    return TankHistory(tank, tuple(usable), found.changes, trends, tuple(notes))


def _usable(
    tank: FarmTank, epochs: list[EpochDatum]
) -> tuple[list[EpochDatum], list[str]]:
    """Of the epochs those that count in time, at one height; why others do not."""
    kept: list[EpochDatum] = []
    notes: list[str] = []
    tests: set[str] = set()
    for epoch in epochs:
        survey = epoch.survey
        if epoch.datum.to_dict()["status"] not in USABLE:
            notes.append(f"{survey.epoch}: no usable datum")
        elif not _has_errors(epoch):
            notes.append(f"{survey.epoch}: {NO_ERRORS}")
        elif survey.hydrotest and survey.hydrotest in tests:
            continue
        elif kept and kept[-1].survey.date == survey.date:
            notes.append(f"{survey.epoch}: of the same day as {kept[-1].survey.epoch}")
        else:
            kept.append(epoch)
        tests |= {survey.hydrotest} - {""}
    return at_one_height(tank, kept, notes), notes


def at_one_height(
    tank: FarmTank, epochs: list[EpochDatum], notes: list[str]
) -> list[EpochDatum]:
    """The epochs with their heights adjusted as the tank's height_reference says."""
    made: list[EpochDatum] = []
    epochs = [_at_the_datum(epoch) for epoch in epochs]
    for epoch in epochs:
        survey, base = epoch.survey, epochs[0].datum
        sigma = survey.registration_error
        shift = (
            Shift()
            if _is_base(tank, epoch, epochs)
            else shift_of(tank, base, epoch.datum, survey.marks, sigma)
        )
        if shift.note:
            notes.append(f"{survey.epoch}: {shift.note}")
        if tank.height_reference in ("marks", "stable"):
            survey = replace(survey, registration_error=shift.sigma)
        if shift.sigma_slope is not None:
            tilt = math.degrees(shift.sigma_slope) * 3600.0
            survey = replace(survey, registration_tilt_arcsec=tilt)
        made.append(replace(epoch, survey=survey, datum=shifted(epoch.datum, shift)))
    return made


def seen_from(tank: FarmTank, epochs: list[EpochDatum], notes: list[str]) -> FarmTank:
    """The tank, without its mean where rods stood at an unknown height above the scans' datum."""
    unknown = {e.survey.levelled and e.survey.above_datum is None for e in epochs}
    if len(unknown) < 2 or tank.height_reference not in ("common", "marks"):
        return tank
    notes.append(
        "levellings without above_datum: the mean is taken out, and settlement is not seen"
    )
    return replace(tank, height_reference="mean")


def _has_errors(epoch: EpochDatum) -> bool:
    survey = epoch.survey
    if not survey.levelled or survey.elevation_error:
        return True
    return bool(np.any(epoch.datum.stations["sigma_z"] > 0.0))


def _at_the_datum(epoch: EpochDatum) -> EpochDatum:
    survey = epoch.survey
    if not survey.levelled:
        return epoch
    datum = reduced(epoch.datum, survey.above_datum, survey.elevation_error)
    return replace(epoch, datum=datum)


def _is_base(tank: FarmTank, epoch: EpochDatum, epochs: list[EpochDatum]) -> bool:
    return tank.height_reference == "stable" and epoch is epochs[0]
