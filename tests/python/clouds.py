"""Point sets without a tank, and the smallest with one."""

from __future__ import annotations

import numpy as np

from results import Array


def floor(seed: int = 1, side: float = 20.0, count: int = 40_000) -> Array:
    """A flat floor with 1 mm of noise."""
    random = np.random.default_rng(seed)
    plan = random.uniform(-side / 2, side / 2, (count, 2))
    return np.column_stack([plan, random.normal(0.0, 0.001, count)])


def box_room(seed: int = 1, half: float = 5.0, height: float = 3.0, count: int = 40_000) -> Array:
    """The inside of a square room: floor, ceiling and four walls, 1 mm of noise."""
    random = np.random.default_rng(seed)
    flat = random.uniform(-half, half, (count // 2, 2))
    level = np.where(random.random(count // 2) < 0.5, 0.0, height)
    along = random.uniform(-half, half, count // 2)
    up = random.uniform(0.0, height, count // 2)
    side = random.integers(0, 4, count // 2)
    sign = np.where(side % 2 == 0, half, -half)
    walls = np.where(
        (side < 2)[:, None],
        np.column_stack([sign, along, up]),
        np.column_stack([along, sign, up]),
    )
    points = np.vstack([np.column_stack([flat, level]), walls])
    return points + random.normal(0.0, 0.001, points.shape)


def collinear(count: int = 5_000) -> Array:
    t = np.linspace(0.0, 10.0, count)
    return np.column_stack([t, 2.0 * t, 0.5 * t])


def tank(
    radius: float = 3.0,
    height: float = 1.5,
    spacing: float = 0.02,
    z: float = 0.25,
    noise: float = 0.0005,
) -> Array:
    """A shell on a floor, points on a grid with noise; the datum is level at z."""
    turns = np.arange(0.0, 2.0 * np.pi, spacing / radius)
    rings = []
    for up in np.arange(0.0, height, spacing):
        circle = np.column_stack([radius * np.cos(turns), radius * np.sin(turns)])
        rings.append(np.column_stack([circle, np.full(len(turns), z + up)]))
    for r in np.arange(radius, radius + 1.0, spacing):
        around = np.arange(0.0, 2.0 * np.pi, spacing / r)
        circle = np.column_stack([r * np.cos(around), r * np.sin(around)])
        rings.append(np.column_stack([circle, np.full(len(around), z)]))
    points = np.vstack(rings)
    return points + np.random.default_rng(1).normal(0.0, noise, points.shape)
