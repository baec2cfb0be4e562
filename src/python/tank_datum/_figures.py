"""The figures of a result, by name."""

from __future__ import annotations

from typing import Any, TypeVar

from tank_datum._record import Record, record_of
from tank_datum._records import (
    Antipodal,
    Check,
    Foundation,
    Harmonic,
    Levels,
    LocalSettlement,
    OutOfPlane,
    Tilt,
    Verdict,
)
from tank_datum._survey_records import (
    Agreement,
    Input,
    Lean,
    Movement,
    Setup,
    TankTest,
)
from tank_datum._tank_records import Mark, Shell, SurveyPoint, Tank

R = TypeVar("R", bound=Record)


class Figures:
    """What datum.json says, as small typed results by its own keys."""

    _record: dict[str, Any]

    def _known(self, key: str, kind: type[R]) -> R | None:
        found = self._record.get(key)
        return None if found is None else record_of(kind, found, key)

    def _all(self, key: str, kind: type[R]) -> list[R]:
        return [record_of(kind, one, key) for one in self._record.get(key) or []]

    @property
    def status(self) -> str:
        """ok, partial, doubtful, no_tank, no_crease, too_few_points or fit_failed."""
        return str(self._record["status"])

    @property
    def message(self) -> str:
        """Why there is no datum, or what of it is missing."""
        return str(self._record["message"])

    @property
    def usable(self) -> bool:
        """Whether there is a datum: status ok or partial."""
        return self.status in ("ok", "partial")

    @property
    def schema(self) -> int:
        """Of datum.json."""
        return int(self._record["schema"])

    @property
    def version(self) -> str:
        """Of tank_datum, that the result is of."""
        return str(self._record.get("version", ""))

    @property
    def service(self) -> str:
        """Whose rules it is judged by: new, rebuilt or in-service."""
        return str(self._record.get("service", ""))

    @property
    def input(self) -> Input:
        """The files and their hashes, units, counts of points that were passed over."""
        return record_of(Input, self._record["input"], "input")

    @property
    def options(self) -> dict[str, Any]:
        """Every option of the run, by stage."""
        return record_of(Record, self._record.get("options") or {}, "options")

    @property
    def setups(self) -> list[Setup]:
        """One entry a setup of the scanner: its correction, and how it agreed with others."""
        return self._all("setups", Setup)

    @property
    def agreement(self) -> Agreement | None:
        """How well the setups agree with each other; None without a datum."""
        return self._known("agreement", Agreement)

    @property
    def tank(self) -> Tank | None:
        """Center [m], radius [m], coverage_deg, side; None without a tank."""
        return self._known("tank", Tank)

    @property
    def tests(self) -> list[TankTest]:
        """By which the circle is a tank, each with its outcome."""
        return self._all("tests", TankTest)

    @property
    def lean(self) -> Lean | None:
        """How the shell leans by the points about its foot; None without a tank."""
        return self._known("lean", Lean)

    @property
    def datum(self) -> Levels | None:
        """Mean, min, max and range of the elevations [m], counts of stations; None without one."""
        return self._known("datum", Levels)

    @property
    def tilt(self) -> Tilt | None:
        """Slope [m/m], angle_arcsec, direction_deg (towards the highest point), sigma_slope, ..."""
        return self._known("tilt", Tilt)

    @property
    def antipodal(self) -> Antipodal | None:
        """The paper's inclination: max_h [m] over a diameter [m], angle_deg, azimuth_deg."""
        return self._known("antipodal", Antipodal)

    @property
    def movement(self) -> Movement | None:
        """Per station dz, lod95 [m] and significance since the baseline; None without one."""
        return self._known("movement", Movement)

    @property
    def shell(self) -> Shell | None:
        """Roundness, plumbness, lean; None when no shell above the foot was seen."""
        return self._known("shell", Shell)

    @property
    def harmonics(self) -> list[Harmonic]:
        """n, amplitude [m], phase_deg, sigma [m]; empty when they were not fitted."""
        return self._all("harmonics", Harmonic)

    @property
    def out_of_plane(self) -> OutOfPlane | None:
        """Order, adjusted_r2, max_abs_u [m], max_curvature [1/m], second_differences, ..."""
        return self._known("out_of_plane", OutOfPlane)

    @property
    def local_settlements(self) -> list[LocalSettlement]:
        """Dips and rises of the datum, each with azimuth, width, height [m] and sigma [m]."""
        return self._all("local_settlements", LocalSettlement)

    @property
    def foundation(self) -> Foundation | None:
        """Differences of level along the shell within 9 m, 3 m and in all [m]."""
        return self._known("foundation", Foundation)

    @property
    def checks(self) -> list[Check]:
        """Rules of the codes with value, limit and verdict; empty when none were made."""
        return self._all("checks", Check)

    @property
    def verdict(self) -> Verdict | None:
        """What all checks come to; None when none were made."""
        return self._known("verdict", Verdict)

    @property
    def notes(self) -> list[str]:
        """What bounds the verdict."""
        return list(self._record.get("notes") or [])

    @property
    def advice(self) -> list[str]:
        """What to try when there is no datum."""
        return list(self._record.get("advice") or [])

    @property
    def about(self) -> dict[str, Any]:
        """The survey's identity, as the option `about` gave it."""
        return dict(self._record.get("about") or {})

    @property
    def marks(self) -> list[Mark]:
        """Places at the shell that readers know."""
        return self._all("marks", Mark)

    @property
    def survey_points(self) -> list[SurveyPoint]:
        """The points listed with their elevations [m], numbered clockwise from north."""
        return self._all("survey_points", SurveyPoint)
