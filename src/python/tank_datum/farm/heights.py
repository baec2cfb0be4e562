"""Datums of a tank's epochs in one height: as scanned, by benchmarks, or by what stands still."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

import tank_datum
from tank_datum import _files
from tank_datum.farm.campaign import FarmTank
from tank_datum.farm.lines import student

SHARED_DEG = 6.0  # arc within which stations are taken to share their errors
HALF_TURN = 180.0
MARK_ERROR = (
    0.001  # of a benchmark as a scan shows it, where nothing is said of it [m, 1 sigma]
)
MARK_DEGREES = 3  # values that it is as well known as a variance of
LEVEL = 0.975  # one side of the 95 % that a wider standard error stands for
NORMAL = 1.959964  # of it, of the normal distribution


@dataclass(frozen=True)
class Shift:
    """Taken to the heights of an epoch: dz + x-slope * x + y-slope * y [m, m/m], and what is left
    of an error common to all stations [m, 1 sigma]. sigma_slope: of either slope [m/m, 1 sigma],
    None where they were not adjusted; note: what could not be done, or was assumed."""

    dz: float = 0.0
    slope_x: float = 0.0
    slope_y: float = 0.0
    sigma: float = 0.0
    sigma_slope: float | None = None
    note: str = ""


def datum_of(content: bytes | str, source: str) -> tank_datum.Datum:
    """A datum of the text of datum.json: its azimuths and heights, no clouds."""
    text = content.encode() if isinstance(content, str) else content
    record = json.loads(text)
    return tank_datum.Datum(
        record,
        _files._stations(record.get("stations", [])),
        np.empty((0, 3)),
        np.empty(0),
        files={"datum.json": text},
        source=source,
    )


def directions(datum: tank_datum.Datum) -> NDArray[np.float64]:
    """Of the stations, counter-clockwise from +x [rad]."""
    stations = datum.to_dict()["stations"]
    return np.radians([float(station["direction_deg"]) for station in stations])


def reduced(
    datum: tank_datum.Datum, above: float | None, error: float
) -> tank_datum.Datum:
    """A levelling's elevations at the datum, with standard errors where it has none [m].

    above: of the rod's foot above the datum, None where it is not known.
    """
    record = datum.to_dict()
    for station in record["stations"]:
        if station["z"] is not None:
            station["z"] -= above or 0.0
            station["sigma_z"] = station["sigma_z"] or error or None
    return datum_of(json.dumps(record), datum.source)


def shifted(datum: tank_datum.Datum, shift: Shift) -> tank_datum.Datum:
    """The datum at its new heights."""
    if shift.dz == 0.0 and shift.slope_x == 0.0 and shift.slope_y == 0.0:
        return datum
    record = datum.to_dict()
    radius = record["tank"]["radius"]
    lift = shift.dz + radius * (
        shift.slope_x * np.cos(directions(datum))
        + shift.slope_y * np.sin(directions(datum))
    )
    for station, dz in zip(record["stations"], lift, strict=True):
        if station["z"] is not None:
            station["z"] += float(dz)
    return datum_of(json.dumps(record), datum.source)


def shift_of(
    tank: FarmTank,
    base: tank_datum.Datum,
    datum: tank_datum.Datum,
    marks: dict[str, Any],
    sigma: float,
) -> Shift:
    """What brings an epoch to the heights of the first. marks: elevations measured with it;
    sigma: of its registration, of one mark [m]."""
    if tank.height_reference == "marks":
        return _by_marks(tank.marks, marks, sigma)
    if tank.height_reference == "stable":
        return _by_stable(tank, base, datum)
    return Shift()


def _by_marks(
    nominal: dict[str, float], measured: dict[str, Any], sigma: float
) -> Shift:
    """The mean over the marks; its error from their scatter where that is larger, of which few
    marks tell little. Where nothing is said of a mark's error, a usual one and the scatter."""
    shared = sorted(nominal.keys() & measured.keys())
    if not shared:
        return Shift(note="no benchmark was measured")
    apart = np.array([nominal[name] - measured[name] for name in shared])
    squares = float(np.sum((apart - apart.mean()) ** 2))
    degrees = len(apart) - 1
    note = ""
    if sigma > 0.0:
        sigma = max(sigma, math.sqrt(squares / degrees) if degrees else 0.0)
    else:
        squares += MARK_DEGREES * MARK_ERROR**2
        degrees += MARK_DEGREES
        sigma = _as_normal(math.sqrt(squares / degrees), degrees)
        note = "no registration_error: 1 mm of a benchmark and their scatter are taken"
    return Shift(dz=float(apart.mean()), sigma=sigma / math.sqrt(len(apart)), note=note)


def _as_normal(sigma: float, degrees: int) -> float:
    """The standard error of a normal distribution with the 95 % of Student's t [sigma's unit]."""
    return sigma * student(LEVEL, degrees) / NORMAL


def _by_stable(
    tank: FarmTank, base: tank_datum.Datum, datum: tank_datum.Datum
) -> Shift:
    """Height and, where the stable sectors stand round more than half of the tank, tilt of the
    differences at their stations."""
    few, many, sign = datum, base, 1.0
    if len(base.stations) < len(
        datum.stations
    ):  # between far stations nothing is known
        few, many, sign = base, datum, -1.0
    azimuth, angles = few.stations["azimuth_deg"], directions(few)
    apart = sign * (few.stations["z"] - _heights_at(many, np.degrees(angles)))
    inside = np.zeros(len(azimuth), dtype=bool)
    for first, last in tank.stable_deg:
        inside |= (azimuth - first) % 360.0 <= last - first
    known = inside & np.isfinite(apart)
    if known.sum() < 3:
        return Shift(note="fewer than 3 stable stations were seen")
    angles, apart = angles[known], apart[known]
    radius = datum.to_dict()["tank"]["radius"]
    columns = [np.ones_like(apart)]
    if _widest_gap(angles) < HALF_TURN:
        columns += [radius * np.cos(angles), radius * np.sin(angles)]
    design = np.column_stack(columns)
    found, *_ = np.linalg.lstsq(design, apart, rcond=None)
    of_stations = _sigmas_at(many, np.degrees(angles)) ** 2 + np.square(
        np.nan_to_num(few.stations["sigma_z"][known])
    )
    left = apart - design @ found
    arcs = len(angles) * min(1.0, 360.0 / len(azimuth) / SHARED_DEG)
    degrees = max(1, math.floor(arcs) - len(columns))
    scatter = float(np.sum(left**2)) / len(angles) * max(1.0, arcs / degrees)
    sigma = _as_normal(math.sqrt(max(scatter, float(np.mean(of_stations)))), degrees)
    factor = sigma**2 * len(angles) / arcs
    covariance = np.asarray(factor * np.linalg.inv(design.T @ design), np.float64)
    height, slope = _held(covariance, radius)
    slopes = [*found[1:], 0.0, 0.0]
    return Shift(-float(found[0]), -float(slopes[0]), -float(slopes[1]), height, slope)


def _held(covariance: NDArray[np.float64], radius: float) -> tuple[float, float | None]:
    """Errors of height and slope, independent of each other, that are at no station less than
    those of the covariance [m, m/m]; of the slope None where it is not among them."""
    height = math.sqrt(covariance[0, 0])
    if len(covariance) == 1:
        return height, None
    slope = math.sqrt(float(np.linalg.eigvalsh(covariance[1:, 1:])[-1]))
    round_ = np.radians(np.arange(360.0))
    design = np.column_stack(
        [np.ones(360), radius * np.cos(round_), radius * np.sin(round_)]
    )
    most = float(np.max(np.einsum("ij,jk,ik->i", design, covariance, design)))
    wider = max(1.0, math.sqrt(most) / math.hypot(height, radius * slope))
    return wider * height, wider * slope


def _heights_at(
    datum: tank_datum.Datum, wanted_deg: NDArray[np.float64]
) -> NDArray[np.float64]:
    """At directions of another epoch's stations, between its own."""
    return _between(datum, datum.stations["z"], wanted_deg)


def _sigmas_at(
    datum: tank_datum.Datum, wanted_deg: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Standard errors of the same; 0 where the epoch gives none."""
    return np.nan_to_num(_between(datum, datum.stations["sigma_z"], wanted_deg))


def _between(
    datum: tank_datum.Datum,
    values: NDArray[np.float64],
    wanted_deg: NDArray[np.float64],
) -> NDArray[np.float64]:
    at = np.degrees(directions(datum)) % 360.0
    order = np.argsort(at)
    known = order[np.isfinite(values[order])]
    if len(known) < 3:
        return np.full(len(wanted_deg), np.nan)
    found: NDArray[np.float64] = np.interp(
        wanted_deg % 360.0, at[known], values[known], period=360.0
    )
    return found


def _widest_gap(angles: NDArray[np.float64]) -> float:
    """Between neighbours round the turn [deg]."""
    around = np.sort(np.degrees(angles) % 360.0)
    return float(np.max(np.diff(np.append(around, around[0] + 360.0))))
