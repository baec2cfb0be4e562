"""The fastest station of a tank, by the core's trends of every station."""

from __future__ import annotations

import math

import numpy as np

import tank_datum
from tank_datum.farm.campaign import Limits
from tank_datum.farm.lines import LEVEL, Line, fit_line
from tank_datum.farm.quantities import Array, Compared
from tank_datum.farm.trend import Trend, family, quantile, reaching

NEAR_DEG = 3.0  # within which a survey's station stands in the place of another's


def trend_of_places(
    found: Compared, name: str, comparison: tank_datum.Comparison, limits: Limits
) -> Trend | None:
    """The fastest station by the core's trends; its chance is that of the fastest of all (Sidak)."""
    trend = comparison.trend
    known = np.isfinite(trend["rate"]) & (trend["sigma"] > 0.0)
    if not known.any():
        return None
    rows = trend[known]
    worst = rows[np.argmax(np.abs(rows["rate"]) / rows["sigma"])]
    places = len(rows)
    one = math.erfc(abs(worst["rate"]) / worst["sigma"] / math.sqrt(2.0))
    chance = 1.0 if one >= 1.0 else -math.expm1(places * math.log1p(-one))
    each = -math.expm1(math.log1p(-(1.0 - LEVEL)) / places)
    reach = quantile(each) * float(worst["sigma"])
    azimuth, rate = float(worst["azimuth_deg"]), float(worst["rate"])
    line = _line_at(found, comparison, azimuth)
    value, low_value = _largest(comparison, places)
    limit = getattr(limits, name)
    return Trend(
        name,
        rate,
        rate - reach,
        rate + reach,
        chance,
        azimuth,
        value,
        low_value,
        reaching=None if line is None else reaching(line, limit, 1.0 - LEVEL),
    )


def _line_at(
    found: Compared, comparison: tank_datum.Comparison, azimuth: float
) -> Line | None:
    """The movement of the station nearest to an azimuth, through all epochs that saw it."""
    times, values, sigmas = [found.times[0]], [0.0], [0.0]
    bases: list[float] = []
    for number, rows in enumerate(comparison.stations):
        apart = np.abs((rows["azimuth_deg"] - azimuth + 180.0) % 360.0 - 180.0)
        row = rows[int(np.argmin(apart))]
        known = np.isfinite(row["dz"]) and row["sigma"] > 0.0
        if not known or np.min(apart) > NEAR_DEG:
            continue
        share = float(found.shares[number])
        times.append(found.times[number + 1])
        values.append(float(row["dz"]))
        sigmas.append(float(row["sigma"]) * math.sqrt(1.0 - share))
        bases.append(float(row["sigma"]) ** 2 * share)
    if not bases:
        return None
    sigmas[0] = math.sqrt(float(np.mean(bases)))
    return fit_line(times, values, sigmas) if min(sigmas) > 0.0 else None


def _largest(comparison: tank_datum.Comparison, places: int) -> tuple[float, float]:
    """The largest movement of the last epoch, and what some station surely moved: the quantile is
    that of the largest of all places, in the family of the tank's tests."""
    rows = comparison.stations[-1]
    rows = rows[np.isfinite(rows["dz"])]
    each = -math.expm1(math.log1p(-family(1.0 - LEVEL)) / places)
    sure = np.abs(rows["dz"]) - quantile(each) * rows["sigma"]
    largest: Array = rows["dz"][np.argmax(np.abs(rows["dz"]))]
    return float(largest), float(max(0.0, np.max(sure)))
