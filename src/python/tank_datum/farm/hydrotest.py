"""A hydrotest: what a tank did while it was filled and emptied again.

Its first epoch is the reference. Settlement is positive downwards.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from tank_datum.farm.campaign import FarmTank
from tank_datum.farm.lines import fit_line
from tank_datum.farm.over_time import USABLE, EpochDatum, at_one_height, seen_from
from tank_datum.farm.quantities import Array, Change, Series, compared

SAME_LEVEL = 0.05  # of the highest level: the tank counts as empty again, or as before


@dataclass(frozen=True)
class Figure:
    """With its standard error."""

    value: float
    sigma: float


@dataclass(frozen=True)
class Hydrotest:
    """steps in the order of the campaign. per_metre: settlement of the mean a metre of liquid,
    while it rises; lasting: what is left at the first level again; hysteresis: the largest
    settlement, at one level, of emptying above that of filling [m]. None: not to be told."""

    name: str
    steps: tuple[Change, ...] = ()
    highest: float | None = None
    per_metre: Figure | None = None
    lasting: Figure | None = None
    hysteresis: Figure | None = None
    notes: tuple[str, ...] = ()


def hydrotests_of(tank: FarmTank, epochs: list[EpochDatum]) -> list[Hydrotest]:
    """Every hydrotest of a tank. epochs: in the order of the campaign."""
    names = dict.fromkeys(epoch.survey.hydrotest for epoch in epochs)
    return [
        _of_one(
            tank, name, [epoch for epoch in epochs if epoch.survey.hydrotest == name]
        )
        for name in names
        if name
    ]


def _of_one(tank: FarmTank, name: str, epochs: list[EpochDatum]) -> Hydrotest:
    usable = [e for e in epochs if e.datum.to_dict()["status"] in USABLE]
    notes = [f"{e.survey.epoch}: no usable datum" for e in epochs if e not in usable]
    if len(usable) < 2:
        return Hydrotest(name, notes=(*notes, "fewer than two usable surveys"))
    usable = at_one_height(tank, usable, notes)
    found, refused = compared(seen_from(tank, usable, notes), usable, dated=False)
    notes += refused
    if found is None:
        return Hydrotest(name, notes=tuple(notes))
    series = found.series.get("settlement")
    if series is None:
        notes.append("the settlement of the mean is taken out by height_reference")
        return Hydrotest(
            name, found.changes, float(np.max(found.levels)), notes=tuple(notes)
        )
    top = int(np.argmax(found.levels))
    return Hydrotest(
        name,
        found.changes,
        float(found.levels[top]),
        _per_metre(found.levels[: top + 1], series),
        _lasting(found.levels, series, top),
        _hysteresis(found.levels, series, top),
        tuple(notes),
    )


def _per_metre(rising: Array, series: Series) -> Figure | None:
    count = len(rising)
    line = fit_line(rising, series.values[:count], series.sigmas[:count])
    return None if line is None else Figure(line.rate, line.sigma_rate())


def _lasting(levels: Array, series: Series, top: int) -> Figure | None:
    """At the last step after the highest, when its level is the first one's again."""
    last = len(levels) - 1
    if last <= top or abs(levels[last] - levels[0]) > SAME_LEVEL * levels[top]:
        return None
    sigma = math.hypot(series.sigmas[0], series.sigmas[last])
    return Figure(float(series.values[last] - series.values[0]), sigma)


def _hysteresis(levels: Array, series: Series, top: int) -> Figure | None:
    """At the levels of emptying that lie between two of filling; interpolated there."""
    rising = np.argsort(levels[: top + 1], kind="stable")
    at, values = levels[: top + 1][rising], series.values[: top + 1][rising]
    best: Figure | None = None
    for step in range(top + 1, len(levels)):
        if not at[0] <= levels[step] <= at[-1] or len(np.unique(at)) < 2:
            continue
        between = float(np.interp(levels[step], at, values))
        error = float(np.interp(levels[step], at, series.sigmas[: top + 1][rising]))
        figure = Figure(
            float(series.values[step]) - between,
            math.hypot(error, float(series.sigmas[step])),
        )
        best = figure if best is None or figure.value > best.value else best
    return best
