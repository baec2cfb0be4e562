"""Surveys whose setups disagree, scanned anew with their seeds, and their results beside the truth.

Six setups registered with 2 mm, 10 arc-seconds and 2 mm in plan, one file each; the same with
labels in one file; merged without labels, in order and shuffled; perfectly registered; one setup
10 mm too high, or tilted by 60 arc-seconds; one file given twice.
"""

from __future__ import annotations

import csv
import json
import math
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from built import ROOT, call

SCENE = ROOT / "tests" / "scenes" / "setups60.json"
MM = 1e3

Array = NDArray[np.float64]
Files = list[Path]


@dataclass(frozen=True)
class Survey:
    """Figures of one survey; lengths in mm."""

    measured: int
    rms: float
    out_of_plane: float
    largest: float
    within: float
    tilt: float
    sigma: float
    sigma_setup: float
    message: str
    bad: list[str]


def scanned(folder: Path, seed: int, *options: object) -> Files:
    """The files of one survey, one a setup or one in all."""
    scan = folder / f"survey_{seed}.pcd"
    call("tank_datum_synth", "--scene", SCENE, "-o", scan, "--seed", seed, "--quiet", *options)
    return sorted(folder.glob(f"survey_{seed}_*.pcd")) or [scan]


def column(rows: list[dict[str, str]], name: str) -> Array:
    return np.array([float(row[name]) if row[name] else math.nan for row in rows])


def compared(out: Path, truth_file: Path) -> Survey:
    """A result beside its truth."""
    with (out / "stations.csv").open() as file:
        rows = list(csv.DictReader(file))
    datum: dict[str, Any] = json.loads((out / "datum.json").read_text())
    truth = json.loads(truth_file.read_text())["tanks"][0]
    measured = np.array([row["flag"] == "measured" for row in rows])
    x, y, z = (column(rows, name) for name in ("x", "y", "z"))
    azimuth = np.arctan2(y - truth["center"][1], x - truth["center"][0])
    true_azimuth = np.radians([s["azimuth_deg"] for s in truth["stations"]])
    true_z = np.array([s["z"] for s in truth["stations"]])
    error = (z - np.interp(azimuth, true_azimuth, true_z, period=2 * math.pi))[measured]
    at = azimuth[measured]
    plane = np.column_stack([np.ones(len(at)), np.cos(at), np.sin(at)])
    left = error - plane @ np.linalg.lstsq(plane, error)[0]
    true_plane = np.linalg.lstsq(plane, np.interp(at, true_azimuth, true_z, period=2 * math.pi))[0]
    sigma = column(rows, "sigma_z")[measured]
    shared = column(rows, "sigma_setup")[measured]
    return Survey(
        measured=int(measured.sum()),
        rms=MM * float(np.sqrt(np.mean(error**2))),
        out_of_plane=MM * float(np.sqrt(np.mean(left**2))),
        largest=MM * float(np.abs(left).max()),
        within=100 * float(np.mean(np.abs(error) <= 2 * sigma)),
        tilt=tilt_error(datum["tilt"], true_plane[1:] / truth["radius"]),
        sigma=MM * float(np.median(sigma)),
        sigma_setup=MM * float(np.median(shared)),
        message=datum["message"],
        bad=[s["name"] for s in datum["setups"] if s["verdict"] == "bad"],
    )


def tilt_error(found: dict[str, Any] | None, true: Array) -> float:
    """Error of the slope along that of the truth's best plane, in sigmas; NaN without a tilt."""
    if found is None:
        return math.nan
    direction = math.radians(found["direction_deg"])
    slope = found["slope"] * np.array([math.cos(direction), math.sin(direction)])
    return float((slope @ true / np.hypot(*true) - np.hypot(*true)) / found["sigma_slope"])


ERRORS = ("--setup-sigma-dz", 0.002, "--setup-sigma-plan", 0.002, "--setup-sigma-tilt-arcsec", 10)


def separate(folder: Path, seed: int) -> Files:
    return scanned(folder, seed, "--per-setup", *ERRORS)


def labelled(folder: Path, seed: int) -> Files:
    return scanned(folder, seed, "--label-setups", *ERRORS)


def merged(folder: Path, seed: int) -> Files:
    return scanned(folder, seed, *ERRORS)


def shuffled(folder: Path, seed: int) -> Files:
    """The merged scan with its points in any order, as filters of point clouds leave them."""
    (scan,) = merged(folder, seed)
    head, marker, data = scan.read_bytes().partition(b"DATA binary\n")
    points = int(head.split(b"POINTS ")[1].split()[0])
    rows = np.frombuffer(data, np.uint8).reshape(points, -1)
    scan.write_bytes(head + marker + np.random.default_rng(seed).permutation(rows).tobytes())
    return [scan]


def perfect(folder: Path, seed: int) -> Files:
    return scanned(folder, seed, "--per-setup")


def one_high(folder: Path, seed: int) -> Files:
    bad = 'scanner/registration/errors=[{"scanner": 2, "dz": 0.010}]'
    return scanned(folder, seed, "--per-setup", *ERRORS, "--set", bad)


def one_tilted(folder: Path, seed: int) -> Files:
    bad = 'scanner/registration/errors=[{"scanner": 2, "tilt_x_arcsec": 60}]'
    return scanned(folder, seed, "--per-setup", *ERRORS, "--set", bad)


def twice(folder: Path, seed: int) -> Files:
    files = perfect(folder, seed)
    again = files[0].with_name(files[0].stem + "_again.pcd")
    again.write_bytes(files[0].read_bytes())
    return [*files, again]


KINDS: dict[str, Callable[[Path, int], Files]] = {
    kind.__name__: kind
    for kind in (separate, labelled, merged, shuffled, perfect, one_high, one_tilted, twice)
}


def run_survey(kind: str, seed: int, keep: Path | None = None) -> Survey:
    with tempfile.TemporaryDirectory(prefix="tank_datum_setups_") as temporary:
        folder = Path(temporary)
        files = KINDS[kind](folder, seed)
        out = keep if keep else folder / "out"
        options = ("-o", out, "--no-report", "--no-checksum", "--quiet")
        call("tank_datum", *files, *options, accepted=(0, 1))
        return compared(out, folder / f"survey_{seed}.truth.json")
