"""The figures of a result, by name."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

from tank_datum._records import (
    Antipodal,
    Check,
    Harmonic,
    Movement,
    OutOfPlane,
    Shell,
    Tank,
    Tilt,
    Verdict,
)

T = TypeVar("T")


class Figures:
    """What datum.json says, as small typed results."""

    _record: dict[str, Any]

    def _known(self, key: str, kind: Callable[[Any], T]) -> T | None:
        found = self._record.get(key)
        return None if found is None else kind(found)

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
    def setups(self) -> list[dict[str, Any]]:
        """One entry a setup of the scanner: its correction, and how it agreed with others."""
        return list(self._record.get("setups") or [])

    @property
    def tank(self) -> Tank | None:
        """Center [m], radius [m], coverage_deg, side; None without a tank."""
        return self._known("tank", Tank)

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
        return [Harmonic(wave) for wave in self._record.get("harmonics", [])]

    @property
    def out_of_plane(self) -> OutOfPlane | None:
        """Order, adjusted_r2, max_abs_u [m], max_curvature [1/m], second_differences, ..."""
        return self._known("out_of_plane", OutOfPlane)

    @property
    def checks(self) -> list[Check]:
        """Rules of the codes with value, limit and verdict; empty when none were made."""
        return [Check(check) for check in self._record.get("checks", [])]

    @property
    def verdict(self) -> Verdict | None:
        """What all checks come to; None when none were made."""
        return self._known("verdict", Verdict)
