"""What datum.json says of a survey: what was read, its setups, what moved since an earlier one."""

from __future__ import annotations

from tank_datum._record import Record


class FileHash(Record):
    """Of a scan's bytes."""

    algorithm: str
    value: str


class InputFile(Record):
    """A file of the scan."""

    path: str
    sha256: str | None
    hash: FileHash | None
    points: int


class Input(Record):
    """What was read."""

    files: list[InputFile]
    kind: str
    """scan or levelling"""
    units: str
    origin: list[float]
    """near the points [m]"""
    invalid_points: int
    left_out_points: int
    far_points: int | None


class TankTest(Record):
    """One of the tests by which a circle is a tank."""

    name: str
    value: float
    limit: float
    unit: str
    outcome: str
    """pass, doubtful or fail"""
    finding: str | None


class Lean(Record):
    """How the shell leans by the points about its foot."""

    slope_x: float
    slope_y: float
    sigma: float
    sentence: str | None


class StationRow(Record):
    """What datum.json has of a station."""

    azimuth_deg: float
    direction_deg: float
    z: float | None
    sigma_z: float | None
    window_deg: float | None
    flag: str
    reason: str | None


class Setup(Record):
    """A setup of the scanner: its correction, and how it agrees with the others [m, deg]."""

    name: str
    origin: list[float] | None
    """where it stood, when known [m]"""
    turned_about: list[float]
    """[m]"""
    points: int
    stations: int
    sees_deg: list[list[float]]
    """arcs of the foot, from and to"""
    dz: float
    sigma_dz: float | None
    tilt_x: float
    sigma_tilt_x: float | None
    tilt_y: float
    sigma_tilt_y: float | None
    dx: float
    sigma_dx: float | None
    dy: float
    sigma_dy: float | None
    rms_before: float | None
    rms_after: float | None
    verdict: str


class Agreement(Record):
    """How well the setups agree with each other [m]."""

    rms_before: float | None
    rms_after: float | None
    repeated_points: int | None
    unlabelled_discrepancy: float | None
    groups_apart: float | None
    """what two groups of setups differ by in height; 0 where there are none"""
    told_apart_by: str | None
    """whence the setups are known: labels, or the order of the points"""
    sigma_height: float | None
    sigma_tilt_arcsec: float | None
    sigma_plan: float | None
    height_from: str | None
    """whence that sigma is"""
    tilt_from: str | None
    plan_from: str | None


class MeanMovement(Record):
    """Of all stations [m]."""

    value: float
    sigma: float | None
    significant: bool


class TiltChange(Record):
    """Of the plane through the datum."""

    slope: float
    sigma: float | None
    angle_arcsec: float
    direction_deg: float
    """in the scan's frame"""
    azimuth_deg: float
    """as stations are counted"""
    p_value: float | None
    significant: bool


class RestMovement(Record):
    """The largest movement beside mean and tilt [m]."""

    value: float | None
    sigma: float | None
    azimuth_deg: float | None
    significant: bool


class StationMovement(Record):
    """Of one station [m]."""

    azimuth_deg: float
    dz: float | None
    rest: float | None
    """beside mean and tilt"""
    lod95: float | None
    significant: bool


class MovementErrors(Record):
    """What was learnt of the surveys' errors."""

    over_given: float | None
    """their size by that which the surveys say"""
    used: float | None
    """what those were multiplied by"""
    shared_deg: float | None


class LimitRate(Record):
    """How a figure moves towards the limit of its rule."""

    code: str
    clause: str
    name: str
    unit: str
    value: float | None
    limit: float | None
    rate: float | None
    """a year, or a survey without dates"""
    sigma: float | None
    approach: str
    expected: str | None
    """a date; earliest and latest are its 95 % interval"""
    earliest: str | None
    latest: str | None


class LimitRates(Record):
    """When limits are reached at this rate; `none` says why that is not known."""

    rates: list[LimitRate]
    none: str | None


class Movement(Record):
    """Movement since an earlier survey [m]; `message` says why there is none."""

    baseline: str
    removed: str
    registration_error: float
    registration_tilt_arcsec: float
    azimuth_offset_deg: float
    sigma_azimuth_offset_deg: float | None
    centre_apart: float | None
    message: str
    matched: int
    significant: int
    threshold: float | None
    errors: MovementErrors
    mean: MeanMovement
    tilt_change: TiltChange
    out_of_plane: RestMovement
    moved: bool
    not_given: list[str]
    max: float | None
    max_azimuth_deg: float | None
    rms: float | None
    stations: list[StationMovement]
    limits: LimitRates | None
