"""Days as decimal years, as the core counts them, and back."""

from __future__ import annotations

import datetime
import math

from tank_datum import _core


def year_of(date: str) -> float:
    """2024-07-02 is 2024.5."""
    return _core.year_of(date)


def date_of(year: float) -> datetime.date | None:
    """The day of a decimal year; None where the calendar ends."""
    whole = math.floor(year)
    if not 1 <= whole <= 9998:
        return None
    first = datetime.date(whole, 1, 1)
    days = (datetime.date(whole + 1, 1, 1) - first).days
    return first + datetime.timedelta(days=math.floor((year - whole) * days))


def date_ticks(low: float, high: float, most: int = 6) -> list[tuple[float, str]]:
    """Between two decimal years: whole years, months or days, each with its words."""
    for years in (1, 2, 5, 10, 20, 50):
        found = range(math.ceil(low / years), math.floor(high / years) + 1)
        if 2 <= len(found) <= most:
            return [(float(k * years), str(k * years)) for k in found]
    for months in (1, 2, 3, 6):
        found = range(math.ceil(12 * low / months), math.floor(12 * high / months) + 1)
        if 2 <= len(found) <= most:
            at = [divmod(k * months, 12) for k in found]
            days = [f"{year:04d}-{month + 1:02d}" for year, month in at]
            return [(year_of(f"{day}-01"), day) for day in days]
    some = {str(date_of(low + share * (high - low))) for share in (0.1, 0.5, 0.9)}
    return [(year_of(day), day) for day in sorted(some)]
