"""The table of calibration for setups that disagree: errors, and how often sigma covers them.

Every kind of survey is scanned with each seed and compared with its truth. Pairs of surveys of an
unmoved tank tell the rate of false movement.
"""

from __future__ import annotations

import argparse
import json
import math
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

from setup_surveys import KINDS, Survey, call, run_survey


@dataclass(frozen=True)
class Required:
    """Figures to reach; lengths in mm, shares in %."""

    out_of_plane: float = math.inf
    """of the worst survey, RMS"""
    largest: float = math.inf
    """of the worst survey, out of plane"""
    measured: int = 0
    """of the worst survey"""
    within: tuple[float, float] = (0.0, 100.0)
    """of the stations, the mean of the surveys"""
    tilt: float = 0.0
    """of the surveys, within 2 sigma"""
    sigma_setup: float = math.inf
    """median"""
    named: float = 0.0
    """of the surveys, a setup that is named bad"""
    said: float = 0.0
    """of the surveys, a message"""


ADJUSTED = Required(out_of_plane=0.5, largest=2, measured=352, within=(90, 98), tilt=90)
ONE_BAD = Required(within=(88, 98), named=90)
REQUIRED = {
    "separate": ADJUSTED,
    "labelled": ADJUSTED,
    "merged": ADJUSTED,
    "shuffled": Required(within=(88, 100), said=100),
    "perfect": Required(out_of_plane=0.25, sigma_setup=0.1),
    "one_high": ONE_BAD,
    "one_tilted": ONE_BAD,
    "twice": Required(out_of_plane=0.25, said=100),
}

COLUMNS = (
    "surveys",
    "number",
    "RMS",
    "RMS out of plane",
    "largest out of plane",
    "measured",
    "within 2 sigma",
    "tilt within 2 sigma",
    "median sigma_z",
    "median sigma_setup",
    "a setup named bad",
    "a message",
    "verdict",
)


@dataclass(frozen=True)
class Row:
    """All surveys of a kind: the worst of them, and means of shares and sigmas."""

    kind: str
    surveys: list[Survey]

    def worst(self, name: str) -> float:
        return max(float(getattr(s, name)) for s in self.surveys)

    def mean(self, name: str) -> float:
        return sum(float(getattr(s, name)) for s in self.surveys) / len(self.surveys)

    @property
    def measured(self) -> int:
        return min(s.measured for s in self.surveys)

    @property
    def tilts(self) -> float:
        return 100 * sum(abs(s.tilt) <= 2 for s in self.surveys) / len(self.surveys)

    @property
    def named(self) -> float:
        return 100 * sum(bool(s.bad) for s in self.surveys) / len(self.surveys)

    @property
    def said(self) -> float:
        return 100 * sum(bool(s.message) for s in self.surveys) / len(self.surveys)

    def failures(self) -> list[str]:
        """What is not as required, in words; empty when the row passes."""
        need = REQUIRED[self.kind]
        out, largest = self.worst("out_of_plane"), self.worst("largest")
        within, sigma = self.mean("within"), self.mean("sigma_setup")
        checks = [
            (f"RMS out of plane {out:.2f} > {need.out_of_plane}", out <= need.out_of_plane),
            (f"largest error {largest:.2f} > {need.largest}", largest <= need.largest),
            (f"{self.measured} stations < {need.measured}", self.measured >= need.measured),
            (f"{within:.1f} % within 2 sigma", need.within[0] <= within <= need.within[1]),
            (f"tilt within 2 sigma in {self.tilts:.0f} %", self.tilts >= need.tilt),
            (f"sigma_setup {sigma:.2f} > {need.sigma_setup}", sigma <= need.sigma_setup),
            (f"a bad setup is named in {self.named:.0f} %", self.named >= need.named),
            (f"a message in {self.said:.0f} %", self.said >= need.said),
        ]
        return [text for text, passed in checks if not passed]

    def cells(self) -> list[str]:
        """In the order of COLUMNS."""
        return [
            self.kind,
            str(len(self.surveys)),
            f"{self.worst('rms'):.2f}",
            f"{self.worst('out_of_plane'):.2f}",
            f"{self.worst('largest'):.2f}",
            str(self.measured),
            f"{self.mean('within'):.1f} %",
            f"{self.tilts:.0f} %",
            f"{self.mean('sigma'):.2f}",
            f"{self.mean('sigma_setup'):.2f}",
            f"{self.named:.0f} %",
            f"{self.said:.0f} %",
            "; ".join(self.failures()) or "PASS",
        ]


def print_table(kinds: list[str], seeds: range) -> bool:
    """A row a kind, as soon as it is known. Returns whether all pass."""
    print(f"| {' | '.join(COLUMNS)} |\n{'|---' * len(COLUMNS)}|", flush=True)
    passed = True
    for kind in kinds:
        row = Row(kind, [run_survey(kind, seed) for seed in seeds])
        print(f"| {' | '.join(row.cells())} |", flush=True)
        passed = passed and not row.failures()
    print("\nmm; errors of the measured stations; the worst survey, means of shares and sigmas.")
    return passed


def false_movement(pairs: int, first_seed: int) -> str:
    """How many pairs of surveys of an unmoved tank have a station, a mean or a tilt that moved."""
    stations = means = tilts = 0
    for pair in range(pairs):
        with tempfile.TemporaryDirectory(prefix="tank_datum_pairs_") as temporary:
            folder = Path(temporary)
            run_survey("separate", first_seed + 2 * pair, folder / "before")
            run_survey("separate", first_seed + 2 * pair + 1, folder / "after")
            result = folder / "movement"
            compared = (folder / "before", folder / "after", "-o", result)
            call("tank_datum_compare", *compared, accepted=(0, 1))
            (moved,) = json.loads((result / "movement.json").read_text())["movements"]
            stations += any(s["significant"] for s in moved["stations"])
            means += moved["mean"]["significant"]
            tilts += moved["tilt_change"]["significant"]
    return f"false movement, of {pairs} pairs: {stations} stations, {means} means, {tilts} tilts"


def main() -> int:
    parser = argparse.ArgumentParser(prog="scripts/setup_rates.py", description=__doc__)
    parser.add_argument("--seeds", type=int, default=20, help="surveys of each kind (%(default)s)")
    parser.add_argument("--first-seed", type=int, default=1, help="(%(default)s)")
    parser.add_argument("--kinds", default=",".join(KINDS), help="of %(default)s")
    parser.add_argument("--pairs", type=int, default=0, help="pairs for movement (%(default)s)")
    args = parser.parse_args()
    seeds = range(args.first_seed, args.first_seed + args.seeds)
    passed = print_table(args.kinds.split(","), seeds)
    if args.pairs:
        print(false_movement(args.pairs, args.first_seed + 1000))
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
