"""How often movement between two scans is said rightly: simulated scans of one tank, through the
whole chain, tank_datum_synth - tank_datum - tank_datum_compare.

Each run scans the scene three times with fresh noise: as baseline, unmoved with the scanners set up
elsewhere, and so again with a dip. Prints the share of unmoved pairs with any significant station,
and of dips that are found (a significant station within the dip's width). tank_datum_rates movement
answers the same for thousands of simulated surveys without scans.
"""

from __future__ import annotations

import argparse
import csv
import json
import statistics
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

from built import ROOT, call

SCENE = ROOT / "tests" / "scenes" / "movement30.json"
AZIMUTH = 200  # of the dip [deg]


def survey(scene: Path, out: Path, seed: int, *options: object) -> Path:
    """The datum of a scan of the scene."""
    scan = out.with_suffix(".pcd")
    call("tank_datum_synth", "--scene", scene, "--seed", seed, *options, "-o", scan, "--quiet")
    call("tank_datum", scan, "-o", out, "--quiet")
    scan.unlink()
    return out


def significant(baseline: Path, later: Path) -> list[float]:
    """Azimuths of the significant stations [deg]."""
    out = later.with_suffix(".movement")
    call("tank_datum_compare", baseline, later, "-o", out)
    (movement,) = json.loads((out / "movement.json").read_text())["movements"]
    return [s["azimuth_deg"] for s in movement["stations"] if s["significant"]]


@dataclass(frozen=True)
class Run:
    alarms: int  # significant stations of the unmoved pair
    inside: int  # of the pair with a dip, within the dip's width
    elsewhere: int  # and further than that from its middle
    points: float  # median number of points on the foundation behind a station
    sigma: float  # median standard error [m]


def one_run(scene: Path, folder: Path, seed: int, depth: float, width: float, turn: float) -> Run:
    other = ("--first-azimuth-deg", turn)
    before = survey(scene, folder / "before", 3 * seed)
    still = survey(scene, folder / "still", 3 * seed + 1, *other)
    dips = ("--dips", f"{AZIMUTH}:{width}:{depth}")
    moved = survey(scene, folder / "moved", 3 * seed + 2, *other, *dips)
    found = significant(before, moved)
    off = [abs((a - AZIMUTH + 180) % 360 - 180) for a in found]
    with (before / "stations.csv").open(newline="") as file:
        rows = [row for row in csv.DictReader(file) if row["flag"] == "measured"]
    return Run(
        len(significant(before, still)),
        sum(a <= width / 2 for a in off),
        sum(a > width for a in off),
        statistics.median(float(row["n_foundation"]) for row in rows),
        statistics.median(float(row["sigma_z"]) for row in rows),
    )


def main(arguments: list[str]) -> int:
    parser = argparse.ArgumentParser(prog="movement_rates.py", description=__doc__.split("\n")[0])
    parser.add_argument("--runs", type=int, default=20)
    parser.add_argument("--first-seed", type=int, default=1)
    parser.add_argument("--scene", type=Path, default=SCENE)
    parser.add_argument("--dip-mm", type=float, default=2.0)
    parser.add_argument("--dip-width-deg", type=float, default=10.0)
    parser.add_argument("--turn-deg", type=float, default=25.0, help="of the later scanners")
    given = parser.parse_args(arguments)
    if given.runs < 1:
        parser.error(f"argument --runs: {given.runs}, expected >= 1")
    runs: list[Run] = []
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(given.first_seed, given.first_seed + given.runs):
            depth, width = given.dip_mm / 1000, given.dip_width_deg
            runs.append(one_run(given.scene, Path(folder), seed, depth, width, given.turn_deg))
            print(f"seed {seed}: {runs[-1]}", file=sys.stderr)
    points = statistics.median(r.points for r in runs)
    sigma = 1000 * statistics.median(r.sigma for r in runs)
    print(f"{given.scene.stem}: {points:.0f} points on the foundation behind a station", end="")
    print(f" (median), standard error {sigma:.2f} mm")
    print(f"dip {given.dip_mm:g} mm deep, {given.dip_width_deg:g} deg wide")
    for what, count in (
        ("unmoved: any significant station", sum(r.alarms > 0 for r in runs)),
        ("dip: found", sum(r.inside > 0 for r in runs)),
        ("dip: significant elsewhere too", sum(r.elsewhere > 0 for r in runs)),
    ):
        print(f"{what:<34} {count:5d} of {given.runs}  {100 * count / given.runs:6.2f} %")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
