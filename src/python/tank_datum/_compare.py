"""Surveys of one tank compared: what moved, and how fast."""

from __future__ import annotations

import datetime
import hashlib
import os
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tank_datum import _core
from tank_datum._datum import Datum, same
from tank_datum._errors import option_error
from tank_datum._files import load
from tank_datum._options import MovementOptions, Unpack
from tank_datum._records import Movement

Survey = Datum | str | os.PathLike[str]
Date = str | float | datetime.date


@dataclass(eq=False)
class Comparison:
    """Surveys of one tank in time order, each compared with the first [m].

    movements: one a survey after the first, with what is significant of the whole.
    stations: their structured arrays of azimuth_deg, direction_deg, dz, sigma, lod95, significant.
    trend: structured array of azimuth_deg, rate, sigma, lod95, significant, a place each; `unit`
    says what a rate is in, m/year with dates and m/survey without.
    """

    names: list[str]
    dates: list[str]
    movements: list[Movement]
    stations: list[NDArray[Any]]
    trend: NDArray[Any]
    unit: str
    _surveys: list[tuple[str, str, str]] = field(repr=False)
    _options: dict[str, Any] = field(repr=False)

    @property
    def message(self) -> str:
        """Why there is no comparison of one of the surveys; empty when there is."""
        return next((m.message for m in self.movements if m.message), "")

    def to_json(self) -> str:
        """The text of movement.json."""
        return _core.Compared(self._surveys, self.dates, self._options).json()

    def save(self, folder: str | os.PathLike[str]) -> None:
        """Writes movement.json, movement.csv and report.html, as tank_datum_compare does.

        Raises FileError, and OptionError when there is no comparison.
        """
        if self.message:
            raise option_error(
                "movement", "comparison", self.message, "surveys that can be compared"
            )
        _core.Compared(self._surveys, self.dates, self._options).save(os.fspath(folder))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Comparison):
            return NotImplemented
        return self.to_json() == other.to_json() and same(self.trend, other.trend)

    __hash__ = None  # type: ignore[assignment]


def compare(
    epochs: Sequence[Survey],
    dates: Sequence[Date] | None = None,
    **options: Unpack[MovementOptions],
) -> Comparison:
    """The movement of a tank's datum since the first of its surveys, scanned or levelled.

    epochs: results, or paths of their folders or datum.json, in time order, two at least.
    dates: one a survey, as datetime.date, "2024-05-31" or 2024.41: trends become metres per year.
    options: those of extract_datum about movement: remove, registration_error, ...

    Raises OptionError for what cannot be compared, FileError for what cannot be read.
    """
    if isinstance(epochs, str | os.PathLike) or len(epochs) < 2:
        raise option_error("movement", "epochs", epochs, "two surveys or more")
    surveys = [_survey(epoch) for epoch in epochs]
    texts = [_date(date) for date in dates or []]
    made = _core.Compared(surveys, texts, dict(options))
    record = made.record()
    return Comparison(
        names=[name for name, _, _ in surveys],
        dates=texts,
        movements=[Movement(movement) for movement in record["movements"]],
        stations=made.movements(),
        trend=made.trend(),
        unit=record["trend"]["unit"],
        _surveys=surveys,
        _options=dict(options),
    )


def _survey(epoch: Survey) -> tuple[str, str, str]:
    datum = epoch if isinstance(epoch, Datum) else load(epoch)
    text = datum.to_json()
    return datum.source, text, hashlib.sha256(text.encode()).hexdigest()


def _date(date: Date) -> str:
    if isinstance(date, datetime.date):
        return date.isoformat()[:10]
    return f"{date:.10g}" if isinstance(date, int | float | np.floating) else date
