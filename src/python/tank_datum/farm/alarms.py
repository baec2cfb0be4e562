"""Alarms of a tank: a limit or a rate that is passed, or a movement that is no error."""

from __future__ import annotations

import math
from dataclasses import dataclass

from tank_datum.farm.campaign import Limits
from tank_datum.farm.lines import LEVEL
from tank_datum.farm.over_time import TankHistory
from tank_datum.farm.trend import QUANTITIES, Trend, family, quantile

ALARM, WATCH = "alarm", "watch"
NAMES = {
    "settlement": "settlement of the mean",
    "tilt": "tilt",
    "station": "worst station",
    "out_of_plane": "worst station out of the plane",
}
UNITS = {"settlement": "mm", "tilt": "mm/m", "station": "mm", "out_of_plane": "mm"}


@dataclass(frozen=True)
class Alarm:
    """level: "alarm", passed with 95 % of certainty; "watch", the figure is beyond and its interval
    is not, or something moves that no limit is given for."""

    level: str
    quantity: str
    words: str


def alarms_of(history: TankHistory, limits: Limits) -> list[Alarm]:
    """The alarms first. All tests of an unmoved tank together alarm in at most 5 %."""
    found: list[Alarm] = []
    for name in QUANTITIES:
        trend = history.trends.get(name)
        if trend is not None:
            found += _of_value(trend, getattr(limits, name))
            found += _of_rate(trend, getattr(limits, f"{name}_rate"))
    return sorted(found, key=lambda alarm: alarm.level != ALARM)


def _of_value(trend: Trend, limit: float | None) -> list[Alarm]:
    name, unit = NAMES[trend.quantity], UNITS[trend.quantity]
    if limit is None and trend.has_moved and not trend.moves:
        words = f"has moved: {name} {1e3 * (trend.value or 0.0):+.1f} {unit}"
        return [Alarm(WATCH, trend.quantity, words)]
    if limit is None or trend.value is None or abs(trend.value) <= limit:
        return []
    level = ALARM if (trend.low_value or 0.0) > limit else WATCH
    words = f"{name} {1e3 * trend.value:.1f} {unit}, limit {1e3 * limit:.1f}"
    return [Alarm(level, trend.quantity, words)]


def _of_rate(trend: Trend, limit: float | None) -> list[Alarm]:
    """Without a limit: whether it moves at all."""
    name, unit = NAMES[trend.quantity], UNITS[trend.quantity] + " a year"
    half = 1e3 * (trend.high - trend.low) / 2.0
    digits = min(5, max(2, -math.floor(math.log10(half)))) if half > 0.0 else 2
    rate = f"{name} {1e3 * trend.rate:+.{digits}f} ± {half:.{digits}f} {unit}"
    if limit is None:
        return [Alarm(WATCH, trend.quantity, f"moves: {rate}")] if trend.moves else []
    if abs(trend.rate) <= limit:
        return []
    sure = trend.moves and _least(trend) > limit
    return [
        Alarm(
            ALARM if sure else WATCH, trend.quantity, f"{rate}, limit {1e3 * limit:.2f}"
        )
    ]


def _least(trend: Trend) -> float:
    """What the rate surely exceeds, the interval widened for the family of tests."""
    wider = quantile(family(1.0 - LEVEL)) / quantile(1.0 - LEVEL)
    return abs(trend.rate) - wider * (trend.high - trend.low) / 2.0
