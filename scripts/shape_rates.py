"""How often the verdict on the shape is right: made tanks with fresh noise, through tank_datum.

The trap: a sound tank bent to half the limit passes by trigonometric regression although the
classic second difference at one degree would fail most of its stations; one at twice the limit
fails; one at the limit is undecided. The waves: amplitudes within two standard errors, with a gap
of 60 degrees.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import random
import subprocess
import sys
import tempfile
from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
BIN = Path(os.environ.get("TANK_DATUM_BIN", ROOT / "build" / "bin"))

RADIUS, HEIGHT, YIELD, MODULUS = 30.0, 16.0, 235.0, 206_000.0  # m, m, MPa, MPa
CURVATURE_LIMIT = 11 * YIELD / (MODULUS * HEIGHT)  # 1/m
NOISE = 0.001  # m
STATIONS = 360
WAVES = {n: 0.001 * n for n in range(1, 7)}  # m
GAP = range(100, 160)  # degrees
CURVATURE = "curvature by trigonometric regression"


@dataclass(frozen=True)
class Rates:
    """Verdicts by name, and the share of stations that the classic rule fails at one degree."""

    verdicts: Counter[str]
    classic_failing: float


def bent(share: float, random_source: random.Random) -> list[float]:
    """Elevations whose waves 2 to 4 bend the tank to a share of the limit at one place."""
    crest = random_source.uniform(0, math.tau)
    waves = {n: share * CURVATURE_LIMIT / 3 * (RADIUS / n) ** 2 for n in (2, 3, 4)}
    return [
        sum(a * math.cos(n * (math.radians(i) - crest)) for n, a in waves.items())
        + 0.02 * math.cos(math.radians(i))
        + random_source.gauss(0, NOISE)
        for i in range(STATIONS)
    ]


def described(z: dict[int, float], folder: Path) -> dict[str, Any]:
    """datum.json of these elevations by degree."""
    table = folder / "stations.csv"
    rows = "".join(f"{i},{z[i]:.7f},{NOISE}\n" if i in z else f"{i},,\n" for i in range(STATIONS))
    table.write_text("azimuth_deg,elevation,sigma\n" + rows)
    steel = ["--height", HEIGHT, "--yield-mpa", YIELD, "--modulus-mpa", MODULUS]
    command = [BIN / "tank_datum", "--stations-csv", table, "--diameter", 2 * RADIUS, *steel]
    result = subprocess.run(
        [*map(str, command), "-o", str(folder / "out"), "--quiet", "--no-report"],
        capture_output=True,
        text=True,
    )
    if result.returncode != 0:
        raise SystemExit(f"shape_rates: {result.stderr.strip()}")
    datum: dict[str, Any] = json.loads((folder / "out" / "datum.json").read_text())
    return datum


def classic_failing(z: list[float]) -> float:
    """Share of stations whose second difference at one degree exceeds 11 L^2 Y / (2 E H)."""
    limit = CURVATURE_LIMIT / 2 * (math.tau * RADIUS / STATIONS) ** 2
    differences = [z[i] - (z[i - 1] + z[(i + 1) % STATIONS]) / 2 for i in range(STATIONS)]
    return sum(abs(s) > limit for s in differences) / STATIONS


def trap(share: float, seeds: int, folder: Path) -> Rates:
    verdicts: Counter[str] = Counter()
    failing = 0.0
    for seed in range(seeds):
        z = bent(share, random.Random(seed))
        checks = described(dict(enumerate(z)), folder)["checks"]
        verdicts[next(c["verdict"] for c in checks if c["name"] == CURVATURE)] += 1
        failing += classic_failing(z) / seeds
    return Rates(verdicts, failing)


def waves_held(seeds: int, folder: Path) -> dict[int, float]:
    """Per wave number, the share of seeds within two standard errors of the truth."""
    held = Counter[int]()
    for seed in range(seeds):
        source = random.Random(1000 + seed)
        crests = {n: source.uniform(0, math.tau) for n in WAVES}
        z = {
            i: sum(a * math.cos(n * math.radians(i) - crests[n]) for n, a in WAVES.items())
            + source.gauss(0, NOISE)
            for i in range(STATIONS)
            if i not in GAP
        }
        for wave in described(z, folder)["harmonics"]:
            n = wave["n"]
            if n in WAVES:
                held[n] += abs(wave["amplitude"] - WAVES[n]) <= 2 * wave["sigma"]
    return {n: held[n] / seeds for n in WAVES}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--seeds", type=int, default=200)
    seeds: int = parser.parse_args().seeds
    good = True
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        print(f"R {RADIUS:g} m, H {HEIGHT:g} m, {STATIONS} stations, noise 1 mm, {seeds} seeds")
        print("bent to   pass   fail   undecided   classic rule at one degree fails")
        for share, wanted, least in (
            (0.5, "pass", 1.0),
            (1.0, "undecided", 0.5),
            (2.0, "fail", 1.0),
        ):
            rates = trap(share, seeds, folder)
            counts = [100 * rates.verdicts[v] / seeds for v in ("pass", "fail", "undecided")]
            good = good and rates.verdicts[wanted] >= least * seeds
            print(
                f"{share:3g} limit  {counts[0]:3.0f} %  {counts[1]:3.0f} %       {counts[2]:3.0f} %"
                f"   {100 * rates.classic_failing:3.0f} % of stations"
            )
        held = waves_held(seeds, folder)
        print("amplitude within 2 sigma, 60 degrees missing")
        print("  ".join(f"n = {n}: {100 * share:.1f} %" for n, share in held.items()))
        overall = sum(held.values()) / len(held)
        print(f"all waves: {100 * overall:.1f} %")
        # three standard errors of a rate of 95.4 % below it
        good = good and overall >= 0.954 - 3 * math.sqrt(0.954 * 0.046 / (len(held) * seeds))
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
