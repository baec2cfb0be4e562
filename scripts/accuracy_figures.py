"""A datum beside its truth: the figures of one tank in one scan. Millimetres and degrees."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

MM = 1e3
HARMONICS = (1, 2, 3, 4)
WIDEST_GAP = 45.0  # half the shortest wave [deg]


@dataclass(frozen=True)
class Comparison:
    """The stations of one tank with their errors; an unknown value is NaN."""

    azimuth: Array
    """[deg]"""
    error: Array
    """z - truth [mm]"""
    sigma: Array
    """[mm]"""
    paper: Array
    """z_paper - truth [mm]"""
    measured: Mask
    interpolated: Mask
    in_view: Mask
    """nothing covers the crease, and a scanner that sees it lays rays on the shell there"""
    hidden: Mask
    """the crease is covered, or neither it nor its two neighbours are seen by a scanner"""
    centre: float
    """distance of the centres [mm]"""
    radius: float
    """error of the radius [mm]"""


def fit_circle(x: Array, y: Array) -> tuple[Array, float]:
    """Centre and radius of the geometric least-squares circle."""
    x0, y0 = float(x.mean()), float(y.mean())
    algebraic = np.column_stack([2 * (x - x0), 2 * (y - y0), np.ones(len(x))])
    a, b, c = np.linalg.lstsq(algebraic, (x - x0) ** 2 + (y - y0) ** 2)[0]
    r = float(np.sqrt(c + a * a + b * b))
    for _ in range(10):
        distance = np.hypot(x - x0 - a, y - y0 - b)
        design = np.column_stack(
            [(x - x0 - a) / distance, (y - y0 - b) / distance, np.ones(len(x))]
        )
        step = np.linalg.lstsq(design, distance - r)[0]
        a, b, r = a + step[0], b + step[1], r + float(step[2])
    return np.array([x0 + a, y0 + b]), r


def columns_on_shell(scene: dict[str, Any], tank: int) -> Array:
    """How many columns of rays the best placed scanner lays on each station's stretch of the shell.

    Along its tangents a scanner sees the foundation while the shell slips between two rays.
    """
    truth = scene["tanks"][tank]
    foot = np.array([[s["x"], s["y"]] for s in truth["stations"]])
    outwards = (foot - truth["center"]) / np.array([[s["radius"]] for s in truth["stations"]])
    facing = -outwards if truth["side"] == "inside" else outwards
    scanners = np.array([[s["x"], s["y"]] for s in scene["scanners"]])
    ways = scanners[:, None, :] - foot[None, :, :]
    distance = np.linalg.norm(ways, axis=2)
    arc = 2 * np.pi * truth["radius"] / len(foot)
    width = arc * np.einsum("kij,ij->ki", ways, facing) / distance
    step = np.radians(scene["options"]["scanner"]["step_deg"])
    return np.asarray(np.max(width / (distance * step), axis=0))


def compare(folder: Path, datum: dict[str, Any], scene: dict[str, Any], tank: int) -> Comparison:
    """The results in a folder with the truth of a tank of the scene.

    The centre and the radius are compared with those of the circle through the true datum, which
    an out-of-round shell has too.
    """
    truth = scene["tanks"][tank]
    with (folder / "stations.csv").open(newline="") as file:
        reader = csv.DictReader(file)
        rows = list(reader)
    if not rows:  # no datum
        rows = [dict.fromkeys(reader.fieldnames or [], "")] * len(truth["stations"])
    true = {name: np.array([s[name] for s in truth["stations"]]) for name in truth["stations"][0]}

    def column(name: str) -> Array:
        return np.array([float(row[name] or "nan") for row in rows])

    azimuth = true["azimuth_deg"]
    if np.any(np.abs(column("azimuth_deg") - azimuth) > 1e-6):
        raise ValueError(f"{folder}: stations at other azimuths than the truth's")
    unseen = ~true["visible"]
    centre, radius = fit_circle(true["x"], true["y"])
    unknown = float("nan")
    tank_found = datum["tank"] or {"center": [unknown, unknown], "radius": unknown}
    return Comparison(
        azimuth=azimuth,
        error=(column("z") - true["z"]) * MM,
        sigma=column("sigma_z") * MM,
        paper=(column("z_paper") - true["z"]) * MM,
        measured=np.array([row["flag"] == "measured" for row in rows]),
        interpolated=np.array([row["flag"] == "interpolated" for row in rows]),
        in_view=true["visible"] & ~true["covered"] & (columns_on_shell(scene, tank) >= 1),
        hidden=true["covered"] | (unseen & np.roll(unseen, 1) & np.roll(unseen, -1)),
        centre=float(np.hypot(*(np.array(tank_found["center"]) - centre))) * MM,
        radius=(tank_found["radius"] - radius) * MM,
    )


def rms(values: Array) -> float:
    return float(np.sqrt(np.mean(values**2))) if len(values) else float("nan")


def false_harmonics(azimuth: Array, error: Array) -> list[float]:
    """Amplitudes n = 1..4 of the harmonic fit of an error; unknown where a gap is wide."""
    gaps = np.diff(azimuth, append=azimuth[:1] + 360.0)
    if len(error) <= 2 * len(HARMONICS) or max(gaps) > WIDEST_GAP:
        return [float("nan")] * len(HARMONICS)
    turn = np.radians(azimuth)
    waves = [wave(n * turn) for n in HARMONICS for wave in (np.cos, np.sin)]
    fit = np.linalg.lstsq(np.column_stack([np.ones(len(turn)), *waves]), error)[0]
    return [float(a) for a in np.hypot(fit[1::2], fit[2::2])]


@dataclass(frozen=True)
class Figures:
    """Of one tank in one scan; errors are those of the measured stations, nothing removed."""

    rms: float
    mean: float
    largest: float
    measured: int
    interpolated: int
    missing: int
    in_view_not_measured_deg: list[float]
    measured_but_hidden_deg: list[float]
    within_2_sigma: float
    """[%]"""
    median_sigma: float
    interpolated_rms: float
    interpolated_within_2_sigma: float
    """[%]"""
    centre: float
    radius: float
    false_harmonics: list[float]
    """amplitudes of n = 1..4"""
    paper_mean: float
    paper_std: float
    worst: list[dict[str, float]]
    """the largest errors, each with its sigma"""


def within_2_sigma(error: Array, sigma: Array) -> float:
    return 100.0 * float(np.mean(np.abs(error) < 2 * sigma)) if len(error) else float("nan")


def worst_stations(c: Comparison, count: int = 5) -> list[dict[str, float]]:
    order = np.argsort(np.where(c.measured, -np.abs(c.error), np.inf))[:count]
    return [
        {"azimuth_deg": float(c.azimuth[i]), "error": float(c.error[i]), "sigma": float(c.sigma[i])}
        for i in order
        if c.measured[i]
    ]


def figures_of(c: Comparison) -> Figures:
    m, bridged = c.measured, c.interpolated
    error, sigma = c.error[m], c.sigma[m]
    paper = c.paper[np.isfinite(c.paper)]
    some = len(error) > 0
    return Figures(
        rms=rms(error),
        mean=float(error.mean()) if some else float("nan"),
        largest=float(np.abs(error).max()) if some else float("nan"),
        measured=int(m.sum()),
        interpolated=int(bridged.sum()),
        missing=int((~m & ~bridged).sum()),
        in_view_not_measured_deg=c.azimuth[c.in_view & ~m].tolist(),
        measured_but_hidden_deg=c.azimuth[m & c.hidden].tolist(),
        within_2_sigma=within_2_sigma(error, sigma),
        median_sigma=float(np.median(sigma)) if some else float("nan"),
        interpolated_rms=rms(c.error[bridged]),
        interpolated_within_2_sigma=within_2_sigma(c.error[bridged], c.sigma[bridged]),
        centre=c.centre,
        radius=c.radius,
        false_harmonics=false_harmonics(c.azimuth[m], error),
        paper_mean=float(paper.mean()) if len(paper) else float("nan"),
        paper_std=float(paper.std()) if len(paper) else float("nan"),
        worst=worst_stations(c),
    )
