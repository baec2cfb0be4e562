"""Rates of what changes in time, with intervals, and the dates at which limits are reached."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from tank_datum.farm.campaign import Limits
from tank_datum.farm.lines import LEVEL, Line, fit_line, fit_line_and_level
from tank_datum.farm.places import trend_of_places
from tank_datum.farm.quantities import Compared
from tank_datum.farm.trend import Trend, family, quantile, reaching


def trends_of(found: Compared, limits: Limits) -> dict[str, Trend]:
    """By the name of the quantity. value: the last change; low_value: what it surely exceeds."""
    made: list[Trend | None] = []
    if "settlement" in found.series:
        made.append(_of_settlement(found, limits.settlement))
    if "tilt_x" in found.series:
        made.append(_of_tilt(found, limits.tilt))
    for name, comparison in (
        ("station", found.station),
        ("out_of_plane", found.out_of_plane),
    ):
        if comparison is not None:
            made.append(trend_of_places(found, name, comparison, limits))
    return {trend.quantity: trend for trend in made if trend is not None}


def _of_settlement(found: Compared, limit: float | None) -> Trend | None:
    series, extra = found.series["settlement"], {}
    line = fit_line(found.times, series.values, series.sigmas)
    known = bool(np.isfinite(found.levels).all())
    both = (
        fit_line_and_level(found.times, found.levels, series.values, series.sigmas)
        if known
        else None
    )
    if both:
        line, slope, sigma = both
        extra = {"per_level": slope, "sigma_per_level": sigma}
    if line is None:
        return None
    last = found.changes[-1]
    value, error = last.settlement or 0.0, last.sigma_settlement or 0.0
    return _trend("settlement", line, value, error, limit, **extra)


def _trend(
    name: str, line: Line, value: float, error: float, limit: float | None, **extra: Any
) -> Trend:
    low, high = line.interval()
    chance = min(line.chance(), 1.0)
    reach = quantile(family(1.0 - LEVEL)) * error
    return Trend(
        name,
        line.rate,
        low,
        high,
        chance,
        value=value,
        low_value=max(0.0, abs(value) - reach),
        reaching=reaching(line, limit, 1.0 - LEVEL),
        **extra,
    )


def _of_tilt(found: Compared, limit: float | None) -> Trend | None:
    """Its rate is a vector: the interval of its length is that of a circle of 95 %, the chance
    that of chi-square on 2 degrees of freedom; a limit is reached along its direction."""
    x, y = found.series["tilt_x"], found.series["tilt_y"]
    lines = [fit_line(found.times, s.values, s.sigmas) for s in (x, y)]
    if lines[0] is None or lines[1] is None:
        return None
    rate = math.hypot(lines[0].rate, lines[1].rate)
    sigma = max(lines[0].sigma_rate(), lines[1].sigma_rate())
    chance = _chance_of_length(rate, sigma, lines)
    reach = sigma * _radius(1.0 - LEVEL, lines)
    direction = math.atan2(lines[1].rate, lines[0].rate)
    along = math.cos(direction) * x.values + math.sin(direction) * y.values
    line = fit_line(found.times, along, x.sigmas)
    if line is None:
        return None
    last = found.changes[-1]
    value, error = last.tilt or 0.0, last.sigma_tilt or 0.0
    low_value = max(
        0.0, value - error * math.sqrt(-2.0 * math.log(family(1.0 - LEVEL)))
    )
    return Trend(
        "tilt",
        rate,
        max(0.0, rate - reach),
        rate + reach,
        chance,
        math.degrees(direction) % 360.0,
        value,
        low_value,
        reaching=reaching(line, limit, 1.0 - LEVEL),
    )


def _chance_of_length(rate: float, sigma: float, lines: list[Any]) -> float:
    """Of a vector of two equal normal errors: Rayleigh's; with the errors from the scatter, that of
    F on 2 and the lines' degrees of freedom."""
    if sigma == 0.0:
        return 1.0
    square = (rate / sigma) ** 2
    degrees = (
        min(line.degrees for line in lines if line.degrees) if _scattered(lines) else 0
    )
    if degrees:
        return float((1.0 + square / degrees) ** (-degrees / 2.0))
    return math.exp(-square / 2.0)


def _radius(chance: float, lines: list[Any]) -> float:
    degrees = (
        min(line.degrees for line in lines if line.degrees) if _scattered(lines) else 0
    )
    if degrees:
        return math.sqrt(degrees * (chance ** (-2.0 / degrees) - 1.0))
    return math.sqrt(-2.0 * math.log(chance))


def _scattered(lines: list[Any]) -> bool:
    return any(line.degrees for line in lines)
