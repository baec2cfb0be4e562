"""A campaign: the tanks of a site and the scans that were made of them.

campaign_file.py reads it from the TOML file that src/doc/farm.md describes. Lengths are metres, angles
degrees, steel in MPa. A campaign that was read has passed every check that needs no scan.
"""

from __future__ import annotations

import datetime
import pathlib
from dataclasses import dataclass, field
from typing import Any

from tank_datum.farm.toml_lines import Path

FIND = "find"  # the tank of a scan that shows several
COMPARISON = (  # options that are asked of comparisons alone
    "azimuth_offset_deg",
    "estimate_azimuth_offset",
    "correlation_deg",
    "radius_difference",
    "centre_distance",
)
HEIGHTS = ("common", "marks", "stable", "mean", "tilt")


@dataclass(frozen=True)
class Limits:
    """What a tank may come to; None: not judged.

    settlement: of the mean [m]; tilt: change of the plane's slope [m/m]; out_of_plane: change out
    of the plane [m]; station: movement of any station [m]; each `_rate`: the same a year.
    """

    settlement: float | None = None
    settlement_rate: float | None = None
    tilt: float | None = None
    tilt_rate: float | None = None
    out_of_plane: float | None = None
    out_of_plane_rate: float | None = None
    station: float | None = None
    station_rate: float | None = None

    def over(self, wider: Limits) -> Limits:
        """These, and those of the wider scope where these say nothing."""
        own = {name: getattr(self, name) for name in self.__dataclass_fields__}
        return Limits(
            **{k: getattr(wider, k) if v is None else v for k, v in own.items()}
        )


@dataclass(frozen=True)
class FarmTank:
    """A tank of the site. steel: the options of extract_datum about it; centre, radius [m].

    height_reference: how surveys hang together: "common" benchmarks in one frame, "marks" measured
    with each scan, "stable" sectors that do not move, or "mean" or "tilt" taken out.
    stable_deg: sectors (from, to) of azimuth [deg]; marks: elevations of benchmarks [m].
    """

    name: str
    steel: dict[str, Any] = field(default_factory=dict)
    centre: tuple[float, float] | None = None
    radius: float | None = None
    drawing_north_deg: float = 0.0
    height_reference: str = "common"
    stable_deg: tuple[tuple[float, float], ...] = ()
    marks: dict[str, float] = field(default_factory=dict)
    limits: Limits = Limits()
    options: dict[str, Any] = field(default_factory=dict)

    @property
    def comparison(self) -> dict[str, Any]:
        """Options of comparisons."""
        return {
            name: value for name, value in self.options.items() if name in COMPARISON
        }

    @property
    def place(self) -> tuple[float, float, float] | None:
        """x, y and radius, where they are known [m]."""
        return (
            None if not self.centre or not self.radius else (*self.centre, self.radius)
        )


@dataclass(frozen=True)
class Survey:
    """One epoch of one tank, or of all tanks that stand in its scans.

    files: paths, globs or URLs, as written; tank: a name or "find"; fill_level of the liquid [m];
    hydrotest: name of the test that it belongs to, empty for none; registration_error [m] and
    registration_tilt_arcsec: 1 sigma of its frame; marks: measured elevations [m].
    levelled: the one file is a table of elevations; above_datum: how far the rod stood above the
    datum, None where nobody knows; elevation_error: of each elevation, where the table has none,
    1 sigma [m]. place, line: where the campaign's file has it.
    """

    files: tuple[str, ...]
    tank: str
    date: str
    epoch: str
    fill_level: float | None = None
    hydrotest: str = ""
    registration_error: float = 0.0
    registration_tilt_arcsec: float = 0.0
    marks: dict[str, float] = field(default_factory=dict)
    options: dict[str, Any] = field(default_factory=dict)
    levelled: bool = False
    above_datum: float | None = None
    elevation_error: float = 0.0
    place: Path = ()
    line: int = 0

    @property
    def job(self) -> str:
        """What a run calls it."""
        return f"{self.tank}/{self.epoch}"


@dataclass(frozen=True)
class Campaign:
    """A site. results, pages: folders or fsspec URLs; database: URL of SQLAlchemy."""

    path: pathlib.Path
    site: str
    results: str
    database: str
    pages: str
    outside: bool
    limits: Limits
    options: dict[str, Any]
    tanks: tuple[FarmTank, ...]
    surveys: tuple[Survey, ...]

    @property
    def folder(self) -> pathlib.Path:
        return self.path.parent

    def tank(self, name: str) -> FarmTank:
        return next(tank for tank in self.tanks if tank.name == name)

    def limits_of(self, tank: FarmTank) -> Limits:
        return tank.limits.over(self.limits)


def day_of(date: str) -> datetime.date:
    return datetime.date.fromisoformat(date)
