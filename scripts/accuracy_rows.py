"""What is required of each scene, and a row of the accuracy table. Millimetres and degrees.

A row is the worst of its seeds, save the share within two standard errors, which is that of all.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

from accuracy_figures import Figures


@dataclass(frozen=True)
class Required:
    """Figures to reach; lengths in mm.

    Of 360 stations, those that no scanner sees need not be measured; of the others as many may be
    missing as the figure allows.
    """

    rms: float = math.inf
    largest: float = math.inf
    measured: int = 0
    bridged: int = 0
    """measured or interpolated, of all stations"""
    harmonic: float = math.inf

    def __str__(self) -> str:
        named = {"RMS": self.rms, "largest": self.largest, "each harmonic": self.harmonic}
        words = [f"{name} {limit}" for name, limit in named.items() if limit < math.inf]
        words += [f"{self.measured} measured"] if self.measured else []
        words += [f"{self.bridged} measured or interpolated"] if self.bridged else []
        return ", ".join(words)


PAD = Required(rms=0.4, largest=2, measured=360)
PLATE = Required(rms=0.5, largest=2, measured=355)
REQUIRED = {  # one figure per tank
    "pad60": [PAD],
    "plate60": [PLATE],
    "clutter60": [Required(rms=0.6, largest=3, measured=330)],
    "three_stations": [Required(rms=0.5, largest=2)],
    "small12": [Required(rms=0.5, largest=2, measured=360)],
    "tilt60": [Required(rms=0.4, largest=2, measured=360)],
    "lobes": [Required(rms=0.5, largest=2, measured=360)],
    "crown": [Required(rms=0.7, largest=3, measured=360)],
    "soil60": [Required(rms=0.5, largest=2)],
    "density60": [Required(measured=360, harmonic=0.1)],
    "inside": [Required(rms=0.5, largest=2, measured=360)],
    "three_tanks": [PLATE, PAD, PLATE],
    "sloping_lip": [Required(rms=0.5, largest=2.5, measured=355)],
    "round_crown": [Required(rms=0.7, largest=3)],
    "foot120": [Required(rms=0.5, largest=2, measured=354)],
    "foot40": [Required(rms=0.5, largest=2, measured=358)],
    "coarse_lip": [Required(rms=0.35, bridged=355)],
    "sectors": [Required(rms=0.5, largest=2, measured=355)],
}
WITHIN = (90.0, 98.0)  # % of the errors below two standard errors
SIGMA_FACTOR = 1.5  # between the median sigma and the RMS
CIRCLE = 1.0  # error of centre and radius [mm]

COLUMNS = (
    "scene",
    "seeds",
    "points",
    "RMS",
    "largest error",
    "measured",
    "in view, not measured",
    "interpolated",
    "measured though hidden",
    "within 2 sigma",
    "median sigma / RMS",
    "centre",
    "radius",
    "false harmonics n = 1..4",
    "paper: mean (std)",
    "required",
    "verdict",
)


def worst(values: Iterable[float]) -> float:
    """The largest in size, and an unknown one before all."""
    return max((abs(v) for v in values), key=lambda v: math.inf if math.isnan(v) else v)


@dataclass
class Row:
    """A tank of a scene, over all seeds."""

    scene: str
    required: Required
    points: int
    """of the first scan"""
    seeds: list[int]
    runs: list[Figures]
    problems: list[str]
    """what was found in place of the tanks"""

    @property
    def rms(self) -> float:
        return worst(run.rms for run in self.runs)

    @property
    def largest(self) -> float:
        return worst(run.largest for run in self.runs)

    @property
    def unmeasured(self) -> int:
        return max(len(run.in_view_not_measured_deg) for run in self.runs)

    @property
    def bridged(self) -> int:
        return min(run.measured + run.interpolated for run in self.runs)

    @property
    def hidden(self) -> int:
        return max(len(run.measured_but_hidden_deg) for run in self.runs)

    @property
    def within(self) -> float:
        return sum(run.within_2_sigma for run in self.runs) / len(self.runs)

    @property
    def sigma_ratio(self) -> float:
        """The median sigma in RMS errors, the furthest from 1."""
        ratios = [run.median_sigma / run.rms for run in self.runs]
        return max(ratios, key=lambda r: math.inf if math.isnan(r) else abs(math.log(r)))

    @property
    def centre(self) -> float:
        return worst(run.centre for run in self.runs)

    @property
    def radius(self) -> float:
        return worst(run.radius for run in self.runs)

    @property
    def harmonics(self) -> list[float]:
        return [worst(each) for each in zip(*(r.false_harmonics for r in self.runs), strict=True)]

    def failures(self) -> list[str]:
        """What is not as required, in words; empty when the row passes."""
        need, false = self.required, worst(self.harmonics)
        ratio_ok = 1 / SIGMA_FACTOR <= self.sigma_ratio <= SIGMA_FACTOR
        checks = [
            (f"RMS {self.rms:.3f} > {need.rms}", self.rms <= need.rms),
            (f"largest error {self.largest:.2f} > {need.largest}", self.largest <= need.largest),
            (f"{self.unmeasured} in view, not measured", self.unmeasured <= 360 - need.measured),
            (f"{self.bridged} measured or interpolated", self.bridged >= need.bridged),
            (f"{self.hidden} stations are measured though hidden", self.hidden == 0),
            (f"false harmonic {false:.3f} > {need.harmonic}", not need.harmonic < false),
            (f"{self.within:.1f} % within 2 sigma", WITHIN[0] <= self.within <= WITHIN[1]),
            (f"median sigma / RMS {self.sigma_ratio:.2f}", ratio_ok),
            (f"centre off by {self.centre:.2f}", self.centre <= CIRCLE),
            (f"radius off by {self.radius:.2f}", self.radius <= CIRCLE),
        ]
        return self.problems + [text for text, passed in checks if not passed]

    def cells(self) -> list[str]:
        """In the order of COLUMNS."""
        runs = self.runs
        paper_mean = sum(run.paper_mean for run in runs) / len(runs)
        return [
            self.scene,
            str(len(runs)),
            f"{self.points / 1e6:.1f} M",
            f"{self.rms:.3f}",
            f"{self.largest:.2f}",
            str(min(run.measured for run in runs)),
            str(self.unmeasured),
            str(max(run.interpolated for run in runs)),
            str(self.hidden),
            f"{self.within:.1f} %",
            f"{self.sigma_ratio:.2f}",
            f"{self.centre:.2f}",
            f"{self.radius:.2f}",
            " ".join(f"{amplitude:.3f}" for amplitude in self.harmonics),
            f"{paper_mean:+.1f} ({worst(run.paper_std for run in runs):.1f})",
            str(self.required),
            "FAIL" if self.failures() else "PASS",
        ]

    def explanation(self) -> str:
        """Why the row fails, and where the errors are."""
        lines = [f"{self.scene}: {'; '.join(self.failures())}"]
        for seed, run in zip(self.seeds, self.runs, strict=True):
            errors = [
                f"{w['azimuth_deg']:g} deg {w['error']:+.2f} (sigma {w['sigma']:.2f})"
                for w in run.worst
            ]
            lines.append(f"    seed {seed}: {', '.join(errors)}")
            for what, azimuths in (
                ("in view, not measured", run.in_view_not_measured_deg),
                ("measured though hidden", run.measured_but_hidden_deg),
            ):
                if azimuths:
                    lines.append(f"    {what}: {', '.join(f'{a:g}' for a in azimuths)}")
        return "\n".join(lines)
