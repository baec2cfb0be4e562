"""A rate with its interval and the date at which a limit is reached."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tank_datum.farm.dates import date_of
from tank_datum.farm.lines import LEVEL, Line, crossing

TESTS = 8  # of one tank: rate and last change of four quantities, which share its 5 %
HORIZON = 200.0  # years after the epochs, beyond which no date is given
QUANTITIES = ("settlement", "tilt", "station", "out_of_plane")


@dataclass(frozen=True)
class Reaching:
    """When a limit is reached, as dates of an interval. latest None: perhaps never, and not before
    the earliest. A date beyond two centuries is empty."""

    limit: float
    earliest: str
    latest: str | None

    @property
    def words(self) -> str:
        if self.latest is None:
            return f"not before {self.earliest}" if self.earliest else "not in sight"
        return f"{self.earliest or '?'} to {self.latest or 'later'}"


@dataclass(frozen=True)
class Trend:
    """A rate [unit of the quantity a year] with its 95 % interval; chance: that nothing that moves
    shows one as large. azimuth_deg: of the station; per_level: slope by the liquid's level [m],
    with its standard error, where it could be told apart."""

    quantity: str
    rate: float
    low: float
    high: float
    chance: float
    azimuth_deg: float | None = None
    value: float | None = None
    low_value: float | None = None
    per_level: float | None = None
    sigma_per_level: float | None = None
    reaching: Reaching | None = None

    @property
    def has_moved(self) -> bool:
        """Whether the last change is beyond what errors alone show."""
        return (self.low_value or 0.0) > 0.0

    @property
    def moves(self) -> bool:
        """Beyond what errors alone show anywhere on 95 % of unmoved tanks."""
        return self.chance * TESTS < 1.0 - LEVEL


def family(chance: float) -> float:
    """The chance for one of the tests of a tank, so that all together keep it."""
    return chance / TESTS


def quantile(chance: float) -> float:
    return Line(0.0, 0.0, 0.0, np.zeros((2, 2))).quantile(chance)


def reaching(line: Line, limit: float | None, chance: float) -> Reaching | None:
    if limit is None:
        return None
    earliest, latest = crossing(line, limit, chance)
    first, last = (
        None if time is None or time > line.at + HORIZON else date_of(time)
        for time in (earliest, latest)
    )
    words = first.isoformat() if first else ""
    return Reaching(
        limit, words, None if latest is None else (last.isoformat() if last else "")
    )
