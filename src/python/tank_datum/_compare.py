"""Surveys of one tank compared: what moved, and how fast."""

from __future__ import annotations

import datetime
import hashlib
import os
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tank_datum import _core, _html
from tank_datum._arguments import path_bytes, real
from tank_datum._datum import Datum, same
from tank_datum._errors import option_error, short
from tank_datum._files import load
from tank_datum._options import MovementOptions, Unpack
from tank_datum._record import record_of
from tank_datum._survey_records import Movement

Survey = Datum | str | os.PathLike[str]
Date = str | float | datetime.date | np.datetime64


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
    _surveys: list[tuple[bytes, str, str]] = field(repr=False)
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
        to = path_bytes("report", "folder", folder)
        _core.Compared(self._surveys, self.dates, self._options).save(to)

    def __repr__(self) -> str:
        return f"<tank_datum.Comparison of {len(self.names)} surveys, rates in {self.unit}>"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Comparison):
            return NotImplemented
        return self.to_json() == other.to_json() and same(self.trend, other.trend)

    __hash__ = None  # type: ignore[assignment]

    def _repr_html_(self) -> str:
        return _html.movements_of(self)


def compare(
    epochs: Iterable[Survey],
    dates: Iterable[Date] | None = None,
    **options: Unpack[MovementOptions],
) -> Comparison:
    """The movement of a tank's datum since the first of its surveys, scanned or levelled.

    epochs: results, or paths of their folders or datum.json, in time order, two at least.
    dates: one a survey, as a date of datetime or NumPy, "2024-05-31" or 2024.41: trends become metres per year.
    options: those of extract_datum about movement: remove, registration_error, ...

    Raises OptionError for what cannot be compared, FileError for what cannot be read.
    """
    alone = isinstance(epochs, str | bytes | os.PathLike | Datum)
    given: list[Any] = [epochs] if alone else _listed("epochs", epochs)
    if len(given) < 2:
        raise option_error("movement", "epochs", epochs, "two surveys or more")
    surveys = [_survey(epoch) for epoch in given]
    texts = [] if dates is None else [_date(date) for date in _listed("dates", dates)]
    made = _core.Compared(surveys, texts, dict(options))
    record = made.record()
    return Comparison(
        names=[name.decode("utf-8", "replace") for name, _, _ in surveys],
        dates=texts,
        movements=[
            record_of(Movement, movement, "movements")
            for movement in record["movements"]
        ],
        stations=made.movements(),
        trend=made.trend(),
        unit=record["trend"]["unit"],
        _surveys=surveys,
        _options=dict(options),
    )


def _listed(name: str, given: Any) -> list[Any]:
    if not isinstance(given, Iterable):
        raise TypeError(f"{name} = {short(given)}, expected one a survey")
    return list(given)


def _survey(epoch: Survey) -> tuple[bytes, str, str]:
    if not isinstance(epoch, Datum | str | bytes | os.PathLike):
        wanted = "a Datum, or the path of a folder or datum.json"
        raise TypeError(f"epochs = {short(epoch)}, expected {wanted}")
    datum = epoch if isinstance(epoch, Datum) else load(epoch)
    text = datum.to_json()
    return os.fsencode(datum.source), text, hashlib.sha256(text.encode()).hexdigest()


def _date(date: Date) -> str:
    """As the library reads it: "2024-05-31" or 2024.41."""
    if isinstance(date, np.datetime64):
        return str(date.astype("datetime64[D]"))
    if isinstance(date, datetime.date):
        return date.isoformat()[:10]
    if isinstance(date, str):
        return date
    try:
        return f"{real('dates', date):.10g}"
    except TypeError:
        wanted = 'datetime.date, numpy.datetime64, "2024-05-31" or 2024.41'
        raise TypeError(f"dates = {short(date)}, expected {wanted}") from None
