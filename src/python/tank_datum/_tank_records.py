"""What datum.json says of the tank: its circle, its shell, places that readers know."""

from __future__ import annotations

from tank_datum._record import Record


class Tank(Record):
    """The tank of a datum: a circle in the scan's own frame [m]."""

    center: list[float]
    radius: float
    sigma_radius: float | None
    rms: float | None
    coverage_deg: float | None
    foot_points_per_degree: float | None
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


class Roundness(Record):
    """Of the shell at one height above the datum [m]."""

    height: float
    radius: float
    max_deviation: float
    min_deviation: float
    azimuth_deg: float
    """of the larger of the two"""
    sigma: float | None
    n: int
    """azimuths where it is known"""
    widest_gap: float
    """[rad]"""
    tolerance: float | None
    verdict: str


class Plumbness(Record):
    """Of the shell at one azimuth: how far its top is outwards of its foot [m]."""

    azimuth_deg: float
    height: float
    offset: float
    sigma: float | None
    slope: float
    sigma_slope: float | None


class ShellLean(Record):
    """How the shell leans as a whole."""

    slope: float
    sigma_slope: float | None
    direction_deg: float
    height: float
    offset: float


class Shell(Record):
    """The shell above the datum."""

    roundness: list[Roundness]
    plumbness: list[Plumbness]
    plumbness_max: float | None
    plumbness_sigma: float | None
    plumbness_height: float | None
    plumbness_azimuth_deg: float | None
    lean: ShellLean | None


class Mark(Record):
    """A place at the shell that readers know."""

    name: str
    azimuth_deg: float


class SurveyPoint(Record):
    """A point of the list of survey points [m]."""

    number: int
    azimuth_deg: float
    z: float | None
    sigma_z: float | None
    u: float | None
