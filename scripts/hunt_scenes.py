"""A whole scene drawn at random from wide ranges; the same of the same seed."""

from __future__ import annotations

import math
import random
from typing import Any

Scene = dict[str, Any]


def foundation(draw: random.Random) -> dict[str, Any]:
    kind = draw.choice(["pad", "annular_plate", "crown"])
    made: dict[str, Any] = {
        "kind": kind,
        "weld": draw.choice([0.0, draw.uniform(0.004, 0.012)]),
        "roughness": draw.uniform(0.0, 0.002),
        "roughness_length": draw.uniform(0.01, 0.1),
    }
    if kind == "pad":
        made |= {"pad_width": draw.uniform(0.3, 2.0), "pad_fall": draw.uniform(0.0, 0.05)}
    if kind != "pad":
        made |= {
            "plate_width": draw.uniform(0.045, 0.1),
            "plate_thickness": draw.uniform(0.006, 0.02),
        }
    if kind != "pad" and draw.random() < 0.5:
        made |= {
            "plate_slope": draw.uniform(-0.05, 0.02),
            "plate_slope_waves": [
                {"n": draw.randint(1, 5), "amplitude": draw.uniform(0.0, 0.02), "phase_deg": 40.0}
            ],
        }
    if kind != "pad":
        made["concentric"] = draw.random() < 0.5
    if kind != "pad" and draw.random() < 0.3:
        sector = {"azimuth_deg": draw.uniform(0, 360), "width_deg": draw.uniform(20, 120)}
        made["sectors"] = [sector | {"rise": draw.uniform(-0.01, 0.006)}]
    if kind == "annular_plate":
        made["ringwall_width"] = draw.uniform(0.15, 0.6)
    if kind == "crown":
        inner = made["plate_width"] + draw.uniform(0.01, 0.1)
        made |= {
            "crown_inner": inner,
            "crown_outer": inner + draw.uniform(0.04, 0.12),
            "crown_height": draw.uniform(0.005, 0.03),
            "slab_drop": draw.uniform(0.01, 0.08),
        }
    return made


def heaped(soil: list[dict[str, Any]], made: dict[str, Any]) -> list[dict[str, Any]]:
    """The soil, reaching no further than the foundation does."""
    widths = {"pad": "pad_width", "annular_plate": "ringwall_width", "crown": "slab_width"}
    reach = min(0.3, made.get(widths[made["kind"]], 0.3))
    return [heap | {"reach": reach} for heap in soil]


def tank(draw: random.Random) -> dict[str, Any]:
    radius = math.exp(draw.uniform(math.log(3.0), math.log(50.0)))
    waves = [
        {"n": n, "amplitude": draw.uniform(0.0, radius / 4000.0), "phase_deg": draw.uniform(0, 360)}
        for n in range(2, draw.randint(2, 7))
    ]
    dips = [
        {
            "azimuth_deg": draw.uniform(0, 360),
            "width_deg": draw.uniform(6, 40),
            "depth": draw.uniform(0.002, 0.03),
        }
        for _ in range(draw.choice([0, 0, 1, 2]))
    ]
    soil = [
        {
            "azimuth_deg": draw.uniform(0, 360),
            "width_deg": draw.uniform(5, 60),
            "depth": draw.uniform(0.01, 0.1),
        }
        for _ in range(draw.choice([0, 0, 0, 1, 2]))
    ]
    out_of_round = min(0.05, 0.006 * radius) * draw.choice([0.0, draw.random()])
    made = {
        "radius": radius,
        "height": min(20.0, radius * draw.uniform(0.4, 2.0)),
        "tilt_slope": draw.uniform(0.0, 0.004),
        "tilt_direction_deg": draw.uniform(0, 360),
        "harmonics": waves,
        "dips": dips,
        "soil": soil,
        "lobes": {
            "amplitude": out_of_round,
            "min_length": 3.0,
            "max_length": max(4.0, 0.8 * radius),
        },
        "roof": draw.choice(["none", "cone", "dome"]),
        "foundation": foundation(draw),
    }
    return made | {"soil": heaped(soil, made["foundation"])}


def chairs(draw: random.Random, radius: float) -> list[dict[str, Any]]:
    """Anchor chairs against the shell, evenly round the tank."""
    depth, width = draw.uniform(0.08, 0.3), draw.uniform(0.1, 0.4)
    count = draw.randint(6, max(7, int(2.0 * math.pi * radius / max(1.5, 3.0 * width))))
    height, first = draw.uniform(0.3, 0.9), draw.uniform(0, 360)  # above the ground
    return [
        {
            "kind": "box",
            "azimuth_deg": first + 360.0 * i / count,
            "gap": depth / 2.0,
            "length": depth,
            "width": width,
            "height": height,
        }
        for i in range(count)
    ]


def bushes(draw: random.Random) -> list[dict[str, Any]]:
    """Plants that grow beside the shell, their leaves in balls."""
    return [
        {
            "kind": "tree",
            "azimuth_deg": draw.uniform(0, 360),
            "gap": draw.uniform(0.1, 1.0),
            "height": draw.uniform(0.05, 0.3),
            "radius": 0.01,
            "width": draw.uniform(0.2, 1.0),
            "count": draw.randint(20, 150),
        }
        for _ in range(draw.randint(3, 40))
    ]


def beside(seed: int, radius: float) -> list[dict[str, Any]]:
    """What stands at the foot of one tank in three, drawn apart from the rest of the scene."""
    draw = random.Random(seed + 2_000_003)
    made = chairs(draw, radius) if draw.random() < 0.2 else []
    return made + (bushes(draw) if draw.random() < 0.2 else [])


def registration(seed: int) -> dict[str, float]:
    """How badly the setups of one scene in three are registered, drawn apart from the rest."""
    draw = random.Random(seed + 3_000_003)
    if draw.random() > 1.0 / 3.0:
        return {}
    height = math.exp(draw.uniform(math.log(0.0005), math.log(0.005)))
    return {
        "sigma_dz": height,
        "sigma_plan": height * draw.uniform(0.5, 1.5),
        "sigma_tilt_arcsec": draw.uniform(0.0, 20.0),
    }


def beam(seed: int) -> dict[str, Any]:
    """How wide the beams of one scene in four are, drawn apart; else they are lines."""
    draw = random.Random(seed + 5_000_003)
    if draw.random() > 0.25:
        return {}
    return {
        "beam_diameter": draw.uniform(0.002, 0.01),
        "beam_divergence": draw.uniform(0.0001, 0.0006),
        "blend_probability": draw.random(),
        "angle_sigma_deg": draw.uniform(0.0, 0.004),
    }


def narrow_plate(seed: int, kind: str) -> dict[str, float]:
    """A plate that ends close to the shell, as one scene in six has it, drawn apart."""
    draw = random.Random(seed + 6_000_003)
    if kind == "pad" or draw.random() > 1.0 / 6.0:
        return {}
    return {"plate_width": draw.uniform(0.015, 0.045)}


def has_files(seed: int) -> bool:
    """Whether each setup is a file of its own; else one file holds all, without labels."""
    return random.Random(seed + 4_000_003).random() < 0.5


def scene_of(seed: int) -> Scene:
    draw = random.Random(seed)
    made = tank(draw)
    made["foundation"] |= narrow_plate(seed, made["foundation"]["kind"])
    radius = made["radius"]
    distance = draw.uniform(3.0, 8.0) + 0.3 * radius * draw.random()
    count = max(1, draw.randint(3, 5) + int(radius / 8.0))
    # rays millimetres apart at the foot of small tanks, centimetres at that of large ones
    step = max(0.06, 0.07 * math.sqrt(count))
    return {
        "seed": seed,
        "offset": draw.choice([[0, 0, 0], [512034.25, 4012877.5, 35.0]]),
        "tanks": [made],
        "ground": {
            "drop": draw.uniform(0.05, 0.4),
            "slope": draw.uniform(0.0, 0.02),
            "roughness": draw.uniform(0.0, 0.02),
        },
        "objects": beside(seed, radius),
        "clutter": {"boxes": draw.choice([0, 4, 12]), "pipes": draw.choice([0, 3, 8])},
        "scanner": {
            "count": count,
            "distance": distance,
            "first_azimuth_deg": draw.uniform(0, 360),
            "arc_deg": draw.choice([360, 360, 360, 240, 150]),
            "height": draw.uniform(1.2, 2.2),
            "field": "tank",
            "step_deg": step,
            "row_step_deg": step * draw.uniform(0.5, 1.0),
            "min_elevation_deg": -45,
            "max_elevation_deg": 15,
            "max_range": distance + radius,
            "registration": registration(seed),
        },
        "measurement": {
            "range_sigma": draw.uniform(0.0005, 0.004),
            "incidence_gain": draw.uniform(0.0, 0.4),
            "mixed_pixels": draw.random() < 0.3,
            "outliers": draw.choice([0.0, 0.0, 0.002]),
        }
        | beam(seed),
        "frame_tilt_deg": draw.choice([0.0, 0.0, 0.0, 0.0, draw.uniform(0.1, 2.0)]),
        "frame_tilt_direction_deg": draw.uniform(0.0, 360.0),
    }


def units_of(seed: int) -> str:
    """The unit in which the scan is written."""
    return random.Random(seed + 1_000_003).choice(["m", "m", "m", "mm", "ft", "us-ft"])
