"""How often tanks that do not move raise an alarm, and how often moving ones do.

Draws surveys without scans: the datum of one simulated tank, to which each epoch adds errors of the
covariance that the datum states, and of the registration. Each tank's epochs go through the same
functions as those of a campaign. Prints the share of tanks with any alarm or watch, of surveys

  independent  of one cloud: the stations' own errors alone, and no error of registration
  registered   the same, and a height of registration that is common to a survey
  setups       of five setups, each with errors of its own height and levelling, which the stations
               that it sees share
  scans        the same, each survey a simulated scan of its own, which takes 2 s a survey
"""

from __future__ import annotations

import argparse
import json
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import cache, partial
from typing import Any

import numpy as np
import tank_datum
from tank_datum.farm.alarms import ALARM, alarms_of
from tank_datum.farm.campaign import FarmTank, Limits, Survey
from tank_datum.farm.heights import datum_of
from tank_datum.farm.over_time import EpochDatum, history_of

SCENE = {
    "seed": 11,
    "tanks": [{"radius": 6, "height": 3, "harmonics": [{"n": 2, "amplitude": 0.003}]}],
    "scanner": {"count": 5, "distance": 6, "step_deg": 0.25, "max_range": 20},
    "near_datum": 0.8,
    "measurement": {"range_sigma": 0.0015},
}
FIRST = 2015
SETUP_MM, SETUP_ARCSEC = 1.0, 20.0  # 1 sigma of the height and of the levelling of a setup
KINDS = ("independent", "registered", "setups", "scans")


@dataclass(frozen=True)
class Farm:
    """kind: of surveys; registration: 1 sigma of a survey's height [m]; settling: of the mean
    [m an epoch]; tilting [m/m an epoch]; limits: of settlement and rate."""

    kind: str
    epochs: int
    registration: float
    settling: float
    tilting: float
    limits: Limits


@cache
def base(kind: str) -> tank_datum.Datum:
    made = tank_datum.simulate(SCENE)
    if kind != "setups":
        return tank_datum.extract_datum(made.points)
    return of_setups([made.points[made.setups == k] for k in np.unique(made.setups)])


def of_setups(clouds: list[np.ndarray]) -> tank_datum.Datum:
    errors = {"setup_error": SETUP_MM / 1e3, "setup_tilt_arcsec": SETUP_ARCSEC}
    return tank_datum.extract_datum(clouds, threads=1, **errors)


def scanned(seed: int, number: int) -> dict[str, Any]:
    """A scan of its own, whose setups stand and lean each a little wrong."""
    random = np.random.default_rng([2027, seed, number])
    made = tank_datum.simulate(SCENE | {"seed": 1000 * seed + number}, threads=1)
    clouds = []
    for k in np.unique(made.setups):
        cloud = made.points[made.setups == k].copy()
        lean = np.radians(SETUP_ARCSEC / 3600) * random.standard_normal(2)
        middle = cloud[:, :2].mean(axis=0)
        cloud[:, :3] += SETUP_MM / 1e3 * random.standard_normal(3)
        cloud[:, 2] += (cloud[:, :2] - middle) @ lean
        clouds.append(cloud)
    return of_setups(clouds).to_dict()


def drawn(kind: str, random: np.random.Generator) -> dict[str, Any]:
    """The base's record with errors of its stated covariance."""
    record = base(kind).to_dict()
    covariance = record["covariance"]
    own = np.array([s or 0.0 for s in covariance["independent"]])
    shared = np.array([[f or 0.0 for f in factor] for factor in covariance["factors"]])
    errors = own * random.standard_normal(len(own))
    if len(shared):
        errors += shared.T @ random.standard_normal(len(shared))
    lift(record, errors)
    return record


def lift(record: dict[str, Any], heights: np.ndarray) -> None:
    for station, height in zip(record["stations"], heights, strict=True):
        if station["z"] is not None:
            station["z"] += float(height)


def epoch(farm: Farm, seed: int, number: int) -> EpochDatum:
    """One survey: what the tank did, and the errors."""
    random = np.random.default_rng([2026, seed, number])
    record = scanned(seed, number) if farm.kind == "scans" else drawn(farm.kind, random)
    sigma = 0.0 if farm.kind == "independent" else farm.registration
    azimuth = np.radians([s["azimuth_deg"] for s in record["stations"]])
    moved = number * (farm.tilting * record["tank"]["radius"] * np.cos(azimuth) - farm.settling)
    lift(record, moved + sigma * random.standard_normal())
    date = f"{FIRST + 2 * number}-06-01"
    survey = Survey(("drawn",), "T", date, str(number), registration_error=sigma)
    return EpochDatum(survey, datum_of(json.dumps(record), f"epoch {number}"))


def levels_of(farm: Farm, seed: int) -> list[str]:
    """The levels of a tank's alarms."""
    epochs = [epoch(farm, seed, number) for number in range(farm.epochs)]
    history = history_of(FarmTank("T"), epochs, farm.limits)
    return [alarm.level for alarm in alarms_of(history, farm.limits)]


def parsed() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--tanks", type=int, default=200)
    parser.add_argument("--epochs", type=int, default=5, help="two years apart")
    parser.add_argument("--kind", choices=KINDS, action="append", help="all but scans")
    parser.add_argument("--registration-mm", type=float, default=0.5)
    parser.add_argument("--settling-mm", type=float, default=0.0, help="of the mean, an epoch")
    parser.add_argument("--tilting-mm-m", type=float, default=0.0, help="an epoch")
    parser.add_argument("--limit-mm", type=float, help="of the settlement")
    parser.add_argument("--jobs", type=int, default=2)
    return parser.parse_args()


def main() -> None:
    given = parsed()
    limits = Limits(settlement=None if given.limit_mm is None else given.limit_mm / 1e3)
    moving = (given.settling_mm / 1e3, given.tilting_mm_m / 1e3)
    print(
        f"{given.tanks} tanks, {given.epochs} epochs: tanks with   an alarm   an alarm or a watch"
    )
    for kind in given.kind or KINDS[:-1]:
        farm = Farm(kind, given.epochs, given.registration_mm / 1e3, *moving, limits)
        with ProcessPoolExecutor(given.jobs) as pool:
            found = list(pool.map(partial(levels_of, farm), range(given.tanks), chunksize=5))
        alarms = sum(ALARM in levels for levels in found)
        either = sum(bool(levels) for levels in found)
        shares = [f"{count:3d} {count / given.tanks:7.2%}" for count in (alarms, either)]
        print(f"{kind:12}  {shares[0]:>29}  {shares[1]:>20}", flush=True)


if __name__ == "__main__":
    main()
