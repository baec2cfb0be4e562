"""Types of the keywords that functions share; scripts/option_docs.py writes them."""

from __future__ import annotations

from collections.abc import Sequence
from os import PathLike
from typing import TYPE_CHECKING, Any, Literal, TypeAlias, TypedDict, Unpack

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from tank_datum._datum import Datum

__all__ = ["MovementOptions", "Options", "Unpack"]

_Path: TypeAlias = str | PathLike[str]


class MovementOptions(TypedDict, total=False):
    """Those of compare."""

    # options of a comparison
    remove: Literal["auto", "none", "mean", "tilt"]
    registration_error: float
    registration_tilt_arcsec: float
    azimuth_offset_deg: float
    estimate_azimuth_offset: bool
    correlation_deg: float
    radius_difference: float
    centre_distance: float
    # end of options


class Options(MovementOptions, total=False):
    """Keywords of extract_datum, whose documentation says what they are."""

    # options of a run
    method: Literal["refined", "paper"]
    k: int
    angle_deg: float
    centre_tolerance: float
    control_points: int
    search: Literal["flann", "buckets"]
    stations: int
    zero_azimuth_deg: float
    clockwise: bool
    longest_bridge_deg: float
    heights: Sequence[float] | NDArray[np.floating[Any]]
    height_step: float
    tank: tuple[float, float, float] | None
    pick: int
    search_points: int
    fit_points: int
    setup_error: float
    setup_tilt_arcsec: float
    setup_origins: _Path | dict[str, tuple[float, float, float]] | None
    bad_setups: Literal["free", "drop", "keep"]
    min_radius: float
    accept: bool
    up: Literal["x", "y", "z", "-x", "-y", "-z"]
    level: bool
    units: Literal["ft", "in", "m", "mm", "us-ft"]
    las_classes: Sequence[int] | NDArray[np.integer[Any]]
    setups: Sequence[str]
    baseline: Datum | _Path | None
    threads: int
    checksum: Literal["xxh3", "sha256", "none"]
    no_checksum: bool
    height: float | str | None
    yield_mpa: float | None
    modulus_mpa: float | None
    roof: Literal["open", "fixed"] | None
    foundation: Literal["ringwall", "earth"] | None
    service: Literal["new", "rebuilt", "in-service"]
    classic_points: int
    limits: _Path | None
    about: _Path | None
    mark: Sequence[str]
    north_deg: float | None
    survey_points: int
    display_units: Literal["mm", "in", "ft"]
    language: Literal["en", "de", "es", "zh", "ru"]
    # end of options
