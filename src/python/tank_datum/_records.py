"""Small typed results. Each is a dict with the keys of datum.json, which are attributes too.

Any number may be None where it is not known.
"""

from __future__ import annotations

from typing import Any

from tank_datum._record import Record
from tank_datum._survey_records import (
    Agreement,
    Input,
    Lean,
    Movement,
    Setup,
    StationRow,
    TankTest,
)
from tank_datum._tank_records import Mark, Shell, SurveyPoint, Tank


class Spline(Record):
    """The paper's closed B-spline through the edge points [m]."""

    degree: int
    closed: bool
    control_points: int
    rms: float | None
    max_residual: float | None
    check_points: int


class Levels(Record):
    """The datum's elevations in short [m]."""

    surface: str | None
    other_surface_deg: list[list[float]] | None
    shell_below_deg: list[list[float]] | None
    in_doubt_deg: list[list[float]] | None
    measured: int
    interpolated: int
    missing: int
    mean: float
    min: float
    max: float
    range: float
    min_azimuth_deg: float
    max_azimuth_deg: float
    curve: Spline


class Tilt(Record):
    """The plane through the datum."""

    slope: float
    angle_arcsec: float
    direction_deg: float
    """towards the highest point"""
    sigma_slope: float | None
    standard_error: float | None
    r2: float | None
    p_value: float | None


class Antipodal(Record):
    """The paper's inclination: the largest difference of two opposite stations."""

    max_h: float | None
    diameter: float | None
    angle_deg: float | None
    angle_arcsec: float | None
    azimuth_deg: float | None
    h: list[float | None]
    """of every diameter [m]"""


class Harmonic(Record):
    """A wave of the datum round the tank."""

    n: int
    amplitude: float
    phase_deg: float | None
    sigma: float | None


class WorstPlace(Record):
    """A figure where it is largest, in m unless said otherwise."""

    value: float | None
    sigma: float | None
    azimuth_deg: float | None
    length: float | None
    """of the arc, where it is one of `arcs` [m]"""


class SecondDifferences(Record):
    """The classic out-of-plane rule's; the number of values is ["values"]."""

    points: int
    starts: int
    spacing: float | None
    worst: WorstPlace
    message: str


class OutOfPlane(Record):
    """Settlement out of the plane of the tilt [m, 1/m]."""

    order: int
    message: str
    adjusted_r2: float | None
    rms: float | None
    max_abs_u: float | None
    max_abs_u_azimuth_deg: float | None
    max_abs_u_95: list[float | None]
    max_curvature: float | None
    max_curvature_azimuth_deg: float | None
    max_curvature_95: list[float | None]
    sigma_curvature: float | None
    curvature_limit: float | None
    top_ovality: WorstPlace | None
    longest_gap: float
    """between stations [rad]"""
    u_fit_sigma: list[float | None]
    curvature_sigma: list[float | None]
    second_differences: SecondDifferences
    arcs: list[WorstPlace]


class LocalSettlement(Record):
    """A local shape of the datum, a dip or a rise [m]."""

    azimuth_deg: float
    width_deg: float
    height: float
    sigma: float


class Foundation(Record):
    """Differences of level along the shell within 9 m, 3 m, and in all."""

    level_9m: WorstPlace
    level_3m: WorstPlace
    level_total: WorstPlace


class Check(Record):
    """A figure beside the limit of a code, in `unit`."""

    code: str
    clause: str
    name: str
    value: float | None
    sigma: float | None
    low95: float | None
    high95: float | None
    limit: float | None
    unit: str
    azimuth_deg: float | None
    verdict: str
    """pass, fail, undecided, not_applicable or not_evaluated"""
    role: str
    source: str
    citation: str
    note: str


class Verdict(Record):
    """What all checks come to: FAIL, UNDECIDED, INCOMPLETE or PASS."""

    word: str
    governing: str
    utilisation: float | None
    utilisation_95: list[float | None] | None
    """95 % interval of the same"""
    sentence: str


class Results(Record):
    """The whole of datum.json; the covariance is Datum.covariance's."""

    schema: int
    version: str
    input: Input
    options: dict[str, Any] | None
    status: str
    message: str
    service: str | None
    advice: list[str] | None
    about: dict[str, Any] | None
    marks: list[Mark] | None
    survey_points: list[SurveyPoint] | None
    tank: Tank | None
    tests: list[TankTest] | None
    lean: Lean | None
    datum: Levels | None
    tilt: Tilt | None
    antipodal: Antipodal | None
    harmonics: list[Harmonic] | None
    out_of_plane: OutOfPlane | None
    local_settlements: list[LocalSettlement] | None
    foundation: Foundation | None
    checks: list[Check] | None
    verdict: Verdict | None
    notes: list[str] | None
    setups: list[Setup] | None
    agreement: Agreement | None
    stations: list[StationRow] | None
    shell: Shell | None
    movement: Movement | None
