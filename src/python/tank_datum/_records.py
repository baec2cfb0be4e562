"""Small typed results. Each is a dict with the keys of datum.json, which are attributes too."""

from __future__ import annotations

from typing import Any


class Record(dict[str, Any]):
    """A dict whose keys are attributes: `tilt.slope` is `tilt["slope"]`."""

    def __getattr__(self, name: str) -> Any:
        try:
            return self[name]
        except KeyError:
            raise AttributeError(f"{type(self).__name__} has no {name!r}") from None

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self]

    def __repr__(self) -> str:
        shown = ", ".join(f"{key}={_short(value)}" for key, value in self.items())
        return f"{type(self).__name__}({shown})"


def _short(value: object) -> str:
    if isinstance(value, list) and len(value) > 4:
        return f"[{len(value)} values]"
    return f"{value:.6g}" if isinstance(value, float) else repr(value)


class Tank(Record):
    """The tank of a datum: a circle in the scan's own frame [m]."""

    center: list[float]
    radius: float
    sigma_radius: float | None
    rms: float | None
    coverage_deg: float | None
    side: str | None


class FoundTank(Record):
    """A tank that the search found, to the accuracy of a thinned sample [m]."""

    center: tuple[float, float]
    radius: float
    rms: float
    coverage_deg: float
    height: float
    """seen of the shell"""
    side: str
    foot: float | None
    """elevation of the shell's foot, coarse"""
    has_foundation: bool

    @property
    def circle(self) -> tuple[float, float, float]:
        """x, y, radius: what the option `tank` takes."""
        return (*self.center, self.radius)


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


class Check(Record):
    """A figure beside the limit of a code, in `unit`."""

    code: str
    clause: str
    name: str
    value: float | None
    sigma: float | None
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
    utilisation_95: list[float | None]
    """95 % interval of the same"""
    sentence: str


class Movement(Record):
    """Movement since an earlier survey [m]; `message` says why there is none."""

    baseline: str
    removed: str
    message: str
    matched: int
    significant: int
    mean: dict[str, Any]
    tilt_change: dict[str, Any]
    max: float | None
    max_azimuth_deg: float | None
    rms: float | None
    stations: list[dict[str, Any]]


class Shell(Record):
    """The shell above the datum."""

    roundness: list[dict[str, Any]]
    plumbness: list[dict[str, Any]]
    plumbness_max: float | None
    lean: dict[str, Any] | None


class OutOfPlane(Record):
    """Settlement out of the plane of the tilt."""

    order: int
    adjusted_r2: float | None
    max_abs_u: float | None
    max_curvature: float | None
    second_differences: dict[str, Any]


class Limit(Record):
    """A row of the limits of the codes: factor times powers of D H Y E L S, at most `at_most`."""

    code: str
    clause: str
    name: str
    quantity: str
    judged: bool
    factor: float
    powers: dict[str, int]
    at_most: float | None
    unit: str
    diameter_from: float
    diameter_to: float | None
    roof: str | None
    foundation: str | None
    service: str | None
    trust: str
    citation: str


class Curve(Record):
    """How well one of the paper's curves goes through the stations between its points [m]."""

    kind: str
    """Lagrange, Bezier, polynomial or B-spline"""
    rms: float
    largest: float
    overshoot: float
