"""What changed at each epoch since the first, by the core's comparison, with standard errors."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

import tank_datum
from tank_datum.farm.campaign import FarmTank
from tank_datum.farm.dates import year_of

if TYPE_CHECKING:
    from tank_datum.farm.over_time import EpochDatum

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Change:
    """Of an epoch since the first. settlement: of the mean, downwards [m]; tilt: change of slope
    [m/m], towards the part that rose; station: the largest movement of one, up positive [m];
    out_of_plane: the same with height and tilt taken out. sigma_*: standard errors of the change.
    None: not seen, or taken out."""

    epoch: str
    date: str
    fill_level: float | None
    hydrotest: str
    result_id: int
    settlement: float | None = None
    sigma_settlement: float | None = None
    tilt: float | None = None
    sigma_tilt: float | None = None
    tilt_direction_deg: float | None = None
    tilt_chance: float | None = None
    station: float | None = None
    station_azimuth_deg: float | None = None
    stations_moved: int | None = None
    matched: int | None = None
    out_of_plane: float | None = None
    out_of_plane_azimuth_deg: float | None = None


@dataclass(frozen=True)
class Series:
    """One figure of every epoch, the first one's included. sigmas: each epoch's own, independent
    of the others [the figure's unit]."""

    values: Array
    sigmas: Array


@dataclass(frozen=True)
class Compared:
    """times [years]; levels: of the liquid [m], NaN where unknown; series by name: settlement,
    tilt_x, tilt_y. station, out_of_plane: the core's comparisons; None with one date alone."""

    times: Array
    levels: Array
    changes: tuple[Change, ...]
    series: dict[str, Series]
    station: tank_datum.Comparison | None
    out_of_plane: tank_datum.Comparison
    shares: Array


def compared(
    tank: FarmTank, epochs: list[EpochDatum], *, dated: bool = True
) -> tuple[Compared | None, list[str]]:
    """Each epoch with the first that others can be compared with, and why others cannot be.

    dated: dates increase; else trends are not asked for.
    """
    notes: list[str] = []
    sees_height = tank.height_reference not in ("mean", "tilt")
    remove = "none" if sees_height else tank.height_reference
    shape = _shape(tank, epochs, dated)
    if shape is None:
        epochs, notes = _comparable(tank, epochs)
        shape = _shape(tank, epochs, dated) if len(epochs) > 1 else None
    if shape is None:
        return None, notes
    whole = _compare(tank, epochs, remove, dated) if remove != "tilt" else None
    changes = [_first(epochs[0])]
    for number, epoch in enumerate(epochs[1:]):
        given = whole.movements[number] if whole else None
        changes.append(_change(epoch, given, shape.movements[number], sees_height))
    shares = np.array([_share(epochs[0], epoch) for epoch in epochs[1:]])
    series = {} if whole is None else _series_of(whole, shares, sees_height)
    levels = [e.survey.fill_level for e in epochs]
    found = Compared(
        np.array([year_of(e.survey.date) for e in epochs]),
        np.array([math.nan if level is None else level for level in levels]),
        tuple(changes),
        series,
        whole,
        shape,
        shares,
    )
    return found, notes


def _series_of(
    whole: tank_datum.Comparison, shares: Array, sees_height: bool
) -> dict[str, Series]:
    series = {}
    if sees_height:
        means = [m["mean"] for m in whole.movements]
        values = [0.0 - mean["value"] for mean in means]  # no negative zero
        series["settlement"] = _series(
            values, [mean["sigma"] for mean in means], shares
        )
    tilts = [m["tilt_change"] for m in whole.movements]
    for name, function in (("tilt_x", math.cos), ("tilt_y", math.sin)):
        values = [
            t["slope"] * function(math.radians(t["direction_deg"])) for t in tilts
        ]
        series[name] = _series(values, [t["sigma"] for t in tilts], shares)
    return series


def _compare(
    tank: FarmTank, epochs: list[EpochDatum], remove: str, dated: bool
) -> tank_datum.Comparison:
    """The errors of registration are the largest of the pairs: that of none is made too small."""
    pairs = [_of_pair(epochs[0], epoch) for epoch in epochs[1:]]
    given: dict[str, Any] = {"remove": remove, **tank.comparison}
    if remove == "none":
        given["registration_error"] = max(error for error, _ in pairs)
    if remove != "tilt":
        given["registration_tilt_arcsec"] = max(tilt for _, tilt in pairs)
    dates = [epoch.survey.date for epoch in epochs] if dated else None
    return tank_datum.compare([epoch.datum for epoch in epochs], dates, **given)


def _of_pair(a: EpochDatum, b: EpochDatum) -> tuple[float, float]:
    return (
        math.hypot(a.survey.registration_error, b.survey.registration_error),
        math.hypot(
            a.survey.registration_tilt_arcsec, b.survey.registration_tilt_arcsec
        ),
    )


def _shape(
    tank: FarmTank, epochs: list[EpochDatum], dated: bool
) -> tank_datum.Comparison | None:
    """Without height and tilt; None where the core refuses an epoch."""
    try:
        found = _compare(tank, epochs, "tilt", dated)
    except tank_datum.OptionError:
        return None
    return None if found.message else found


def _comparable(
    tank: FarmTank, epochs: list[EpochDatum]
) -> tuple[list[EpochDatum], list[str]]:
    """Without those that the core refuses to compare with the first; and without the first when it
    refuses all the others."""
    refused = [(epoch, _refusal(tank, epochs[0], epoch)) for epoch in epochs[1:]]
    kept = [epochs[0], *(epoch for epoch, reason in refused if not reason)]
    if len(kept) == 1 and len(epochs) > 2:
        found, notes = _comparable(tank, epochs[1:])
        first = f"{epochs[0].survey.epoch}: {refused[0][1]}"
        return found, [first, *notes]
    return kept, [f"{e.survey.epoch}: {reason}" for e, reason in refused if reason]


def _refusal(tank: FarmTank, first: EpochDatum, epoch: EpochDatum) -> str:
    try:
        return tank_datum.compare([first.datum, epoch.datum], **tank.comparison).message
    except tank_datum.OptionError as error:
        return str(error)


def _share(first: EpochDatum, epoch: EpochDatum) -> float:
    """The first epoch's part of the variance of a difference."""
    own = [_variance(e) for e in (first, epoch)]
    return own[0] / sum(own) if sum(own) > 0.0 else 0.5


def _variance(epoch: EpochDatum) -> float:
    sigma = float(np.nanmedian(epoch.datum.stations["sigma_z"]))
    return sigma**2 + epoch.survey.registration_error**2


def _series(values: list[float], sigmas: list[float], shares: Array) -> Series:
    variance = np.array(sigmas) ** 2
    own = np.sqrt(variance * (1.0 - shares))
    base = float(np.sqrt(np.mean(variance * shares)))
    return Series(np.array([0.0, *values]), np.array([base, *own]))


def _first(epoch: EpochDatum) -> Change:
    survey = epoch.survey
    return Change(
        survey.epoch, survey.date, survey.fill_level, survey.hydrotest, epoch.result_id
    )


def _change(epoch: EpochDatum, whole: Any, shape: Any, sees_height: bool) -> Change:
    survey = epoch.survey
    given: dict[str, Any] = {}
    if whole is not None:
        tilt = whole["tilt_change"]
        given = {
            "tilt": tilt["slope"],
            "sigma_tilt": tilt["sigma"],
            "tilt_direction_deg": tilt["direction_deg"],
            "tilt_chance": tilt["p_value"],
            "station": whole["max"],
            "station_azimuth_deg": whole["max_azimuth_deg"],
            "stations_moved": whole["significant"],
        }
    if whole is not None and sees_height:
        given |= {
            "settlement": 0.0 - whole["mean"]["value"],
            "sigma_settlement": whole["mean"]["sigma"],
        }
    return Change(
        survey.epoch,
        survey.date,
        survey.fill_level,
        survey.hydrotest,
        epoch.result_id,
        matched=shape["matched"],
        out_of_plane=shape["max"],
        out_of_plane_azimuth_deg=shape["max_azimuth_deg"],
        **given,
    )
