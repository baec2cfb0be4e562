from collections.abc import Callable, Sequence
from os import PathLike
from typing import Any, Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

__version__: str

class OptionError(ValueError): ...
class FileError(OSError): ...

_Points: TypeAlias = NDArray[np.float32] | NDArray[np.float64]
_Path: TypeAlias = str | PathLike[str]

class Datum:
    stations: NDArray[Any]
    edge_points: NDArray[np.float64]
    @property
    def status(
        self,
    ) -> Literal[
        "ok",
        "partial",
        "no_tank",
        "no_crease",
        "too_few_points",
        "fit_failed",
        "doubtful",
    ]: ...
    @property
    def message(self) -> str: ...
    @property
    def usable(self) -> bool: ...
    @property
    def tank(self) -> dict[str, Any] | None: ...
    @property
    def tilt(self) -> dict[str, Any] | None: ...
    @property
    def antipodal(self) -> dict[str, Any] | None: ...
    @property
    def movement(self) -> dict[str, Any] | None: ...
    @property
    def shell(self) -> dict[str, Any] | None: ...
    @property
    def harmonics(self) -> list[dict[str, Any]]: ...
    @property
    def out_of_plane(self) -> dict[str, Any] | None: ...
    @property
    def checks(self) -> list[dict[str, Any]]: ...
    @property
    def setups(self) -> list[dict[str, Any]]: ...
    def covariance(self) -> NDArray[np.float64]: ...
    def to_dict(self) -> dict[str, Any]: ...
    def to_json(self) -> str: ...
    def summary(self) -> str: ...

def defaults() -> dict[str, Any]: ...
def extract_datum(
    points: _Points | _Path | Sequence[_Points] | Sequence[_Path],
    *,
    progress: Callable[[str], object] | None = ...,
    method: Literal["refined", "paper"] = ...,
    k: int = ...,
    angle_deg: float = ...,
    centre_tolerance: float = ...,
    control_points: int = ...,
    search: Literal["flann", "buckets"] = ...,
    stations: int = ...,
    zero_azimuth_deg: float = ...,
    clockwise: bool = ...,
    heights: Sequence[float] = ...,
    height_step: float = ...,
    tank: tuple[float, float, float] | None = ...,
    pick: int = ...,
    search_points: int = ...,
    fit_points: int = ...,
    setup_error: float = ...,
    setup_tilt_arcsec: float = ...,
    bad_setups: Literal["free", "drop", "keep"] = ...,
    setup_origins: _Path | dict[str, tuple[float, float, float]] | None = ...,
    min_radius: float = ...,
    units: Literal["m", "mm", "ft", "in"] = ...,
    height: float | None = ...,
    yield_mpa: float | None = ...,
    modulus_mpa: float | None = ...,
    roof: Literal["open", "fixed"] | None = ...,
    service: Literal["new", "rebuilt", "in-service"] = ...,
    foundation: Literal["ringwall", "earth"] | None = ...,
    classic_points: int = ...,
    limits: _Path | None = ...,
    baseline: str | PathLike[str] = ...,
    remove: Literal["none", "mean", "tilt"] = ...,
    registration_error: float = ...,
    registration_tilt_arcsec: float = ...,
    azimuth_offset_deg: float = ...,
    estimate_azimuth_offset: bool = ...,
    correlation_deg: float = ...,
    radius_difference: float = ...,
    centre_distance: float = ...,
    threads: int = ...,
) -> Datum: ...
