"""Scans of places without a tank, simulated: none may be taken for one. See ./scripts/negatives."""

from __future__ import annotations

import argparse
import json
import math
import random
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

from built import BIN, call

Object = dict[str, Any]
Scene = dict[str, Any]


def box(x: float, y: float, size: tuple[float, float, float], yaw: float = 0.0) -> Object:
    length, width, height = size
    return {
        "kind": "box",
        "place": "world",
        "x": x,
        "y": y,
        "yaw_deg": yaw,
        "length": length,
        "width": width,
        "height": height,
    }


def pole(draw: random.Random, x: float, y: float) -> Object:
    radius, height = draw.uniform(0.04, 0.3), draw.uniform(2.0, 8.0)
    return {
        "kind": "pipe_vertical",
        "place": "world",
        "x": x,
        "y": y,
        "radius": radius,
        "height": height,
    }


def tree(draw: random.Random, x: float, y: float) -> Object:
    return {"kind": "tree", "place": "world", "x": x, "y": y, "height": draw.uniform(4.0, 10.0)}


def car(draw: random.Random, x: float, y: float, yaw: float) -> list[Object]:
    """Body and cabin."""
    body, cabin = (4.4, 1.8, 0.8), (2.4, 1.6, draw.uniform(1.3, 1.9))
    return [box(x, y, body, yaw), box(x, y, cabin, yaw)]


def street(draw: random.Random) -> tuple[list[Object], list[tuple[float, float]]]:
    objects: list[Object] = []
    half = draw.uniform(5.0, 14.0)
    for side in (-1, 1):
        x = -60.0
        while x < 60.0:
            length, depth = draw.uniform(6.0, 25.0), draw.uniform(8.0, 14.0)
            y = side * (half + 0.5 * depth + draw.uniform(0.0, 1.5))
            size = (length, depth, draw.uniform(5.0, 18.0))
            objects.append(box(x + 0.5 * length, y, size, draw.uniform(-3.0, 3.0)))
            x += length + draw.choice([0.0, 0.0, draw.uniform(1.0, 8.0)])
        objects.append(box(0.0, side * (half - 1.0), (120.0, 2.0, 0.13)))
        for _ in range(draw.randint(2, 10)):
            along = draw.uniform(-40.0, 40.0)
            objects += car(draw, along, side * (half - 3.2), draw.uniform(-4.0, 4.0))
        for _ in range(draw.randint(0, 6)):
            make = draw.choice([pole, tree])
            objects.append(make(draw, draw.uniform(-40.0, 40.0), side * (half - 1.6)))
    count = draw.randint(1, 3)
    return objects, [(draw.uniform(-20.0, 20.0), draw.uniform(-1.5, 1.5)) for _ in range(count)]


def crescent(draw: random.Random) -> tuple[list[Object], list[tuple[float, float]]]:
    """Houses along an arc: planes that a large circle fits."""
    objects: list[Object] = []
    radius, at, end = draw.uniform(15.0, 45.0), 0.0, draw.uniform(80.0, 300.0)
    while at < end:
        length = draw.uniform(5.0, 12.0)
        turn = math.degrees(length / radius)
        middle = math.radians(at + 0.5 * turn)
        distance = radius + 5.0 + draw.uniform(0.0, 0.8)
        x, y = distance * math.cos(middle), distance * math.sin(middle)
        size = (length, 10.0, draw.uniform(5.0, 12.0))
        objects.append(box(x, y, size, math.degrees(middle) + 90.0))
        at += turn
    objects += [tree(draw, draw.uniform(-8.0, 8.0), draw.uniform(-8.0, 8.0)) for _ in range(3)]
    return objects, [(draw.uniform(-5.0, 5.0), draw.uniform(-5.0, 5.0)) for _ in range(2)]


def walls(half_x: float, half_y: float, height: float, thick: float = 0.2) -> list[Object]:
    return [
        box(0.0, half_y + 0.5 * thick, (2 * half_x, thick, height)),
        box(0.0, -half_y - 0.5 * thick, (2 * half_x, thick, height)),
        box(half_x + 0.5 * thick, 0.0, (thick, 2 * half_y, height)),
        box(-half_x - 0.5 * thick, 0.0, (thick, 2 * half_y, height)),
    ]


def room(draw: random.Random) -> tuple[list[Object], list[tuple[float, float]]]:
    half_x, half_y = draw.uniform(2.5, 12.0), draw.uniform(2.5, 12.0)
    objects = walls(half_x, half_y, draw.uniform(2.4, 6.0))
    for _ in range(draw.randint(3, 25)):
        x, y = draw.uniform(-half_x, half_x), draw.uniform(-half_y, half_y)
        size = (draw.uniform(0.3, 2.0), draw.uniform(0.3, 1.0), draw.uniform(0.4, 2.2))
        if math.hypot(x, y) > 1.6:
            objects.append(box(x, y, size, draw.uniform(0.0, 90.0)))
    return objects, [(0.0, 0.0)]


def corridor(draw: random.Random) -> tuple[list[Object], list[tuple[float, float]]]:
    half_x, half_y = draw.uniform(8.0, 25.0), draw.uniform(0.9, 2.5)
    objects = walls(half_x, half_y, draw.uniform(2.4, 3.5))
    for _ in range(draw.randint(4, 12)):
        side = draw.choice([-1, 1])
        x = draw.uniform(-half_x, half_x)
        objects.append(box(x, side * (half_y - 0.15), (draw.uniform(0.5, 2.0), 0.3, 2.0)))
    for step in range(draw.randint(0, 12)):
        objects.append(box(half_x - 0.3 * step, 0.0, (0.3, 2 * half_y, 0.17 * (12 - step))))
    return objects, [(draw.uniform(-4.0, 4.0), 0.0), (draw.uniform(-4.0, 4.0), 0.2)]


def yard(draw: random.Random) -> tuple[list[Object], list[tuple[float, float]]]:
    """Containers, trees and poles standing about, at times in a ring."""
    objects: list[Object] = []
    ring = draw.uniform(6.0, 20.0) if draw.random() < 0.5 else 0.0
    for _ in range(draw.randint(6, 30)):
        turn, away = draw.uniform(0.0, 360.0), ring or draw.uniform(5.0, 30.0)
        x, y = away * math.cos(math.radians(turn)), away * math.sin(math.radians(turn))
        kind = draw.random()
        if kind < 0.6:
            size = (draw.choice([6.1, 12.2, 2.5]), 2.44, draw.choice([2.6, 5.2]))
            objects.append(box(x, y, size, turn + 90.0 + draw.uniform(-15.0, 15.0)))
        else:
            objects.append(tree(draw, x, y) if kind < 0.8 else pole(draw, x, y))
    return objects, [(0.0, 0.0), (draw.uniform(-3.0, 3.0), draw.uniform(-3.0, 3.0))]


def planter(draw: random.Random) -> tuple[Object, list[tuple[float, float]]]:
    """A round wall, lower than a tank is, that soil fills: to the simulator its roof."""
    radius, height = draw.uniform(3.0, 20.0), draw.uniform(0.3, 0.4) * draw.uniform(1.0, 2.7)
    wall = {
        "radius": radius,
        "height": height,
        "roof": draw.choice(["cone", "dome"]),
        "roof_rise": draw.uniform(0.05, 0.6),
        "foundation": {"kind": "pad", "pad_width": draw.uniform(1.0, 4.0)},
    }
    count, away = draw.randint(2, 5), radius + draw.uniform(3.0, 8.0)
    turns = [math.tau * (i + draw.uniform(-0.2, 0.2)) / count for i in range(count)]
    return wall, [(away * math.cos(turn), away * math.sin(turn)) for turn in turns]


PLACES: dict[str, Callable[[random.Random], tuple[list[Object], list[tuple[float, float]]]]] = {
    "street": street,
    "crescent": crescent,
    "room": room,
    "corridor": corridor,
    "yard": yard,
}
KINDS = [*PLACES, "planter"]
FAR_TANK: Object = {"x": 5000.0, "radius": 5.0, "height": 5.0}


def scene_of(kind: str, seed: int) -> Scene:
    """A scene whose only tank stands kilometres beyond the scanner's range, or is a planter."""
    draw = random.Random(seed)
    objects: list[Object] = []
    tank = FAR_TANK
    if kind == "planter":
        tank, places = planter(draw)
    else:
        objects, places = PLACES[kind](draw)
    step = draw.choice([0.25, 0.3, 0.4])
    scanner = {
        "stations": [{"x": x, "y": y} for x, y in places],
        "step_deg": step,
        "min_elevation_deg": -50,
        "max_elevation_deg": 50,
        "max_range": 60,
    }
    return {
        "seed": seed,
        "tanks": [tank],
        "ground": {"roughness": draw.choice([0.0, 0.005, 0.02]), "drop": 0.2},
        "objects": objects,
        "scanner": scanner,
        "measurement": {"range_sigma": draw.choice([0.001, 0.003, 0.01])},
    }


def run(kind: str, seed: int, folder: Path) -> tuple[int, str]:
    """The exit status of tank_datum on that place, and what it said."""
    scene, scan = folder / f"{kind}_{seed}.json", folder / f"{kind}_{seed}.pcd"
    scene.write_text(json.dumps(scene_of(kind, seed)))
    call("tank_datum_synth", "--scene", scene, "-o", scan, "--quiet")
    options = [
        "--no-report",
        "--no-checksum",
        "--quiet",
        "-o",
        str(folder / f"{kind}_{seed}.datum"),
    ]
    asked = [str(BIN / "tank_datum"), str(scan), *options]
    done = subprocess.run(asked, capture_output=True, text=True, check=False)
    scan.unlink()
    return done.returncode, done.stderr.strip()


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=200, help="places, in turn of every kind")
    parser.add_argument("--seed", type=int, default=1, help="of the first place")
    parser.add_argument("--only", type=int, help="this seed alone")
    parser.add_argument("--keep", type=Path, help="folder for scenes and results")
    given = parser.parse_args()
    seeds = [given.only] if given.only is not None else range(given.seed, given.seed + given.count)
    accepted, crashed, words = 0, 0, dict.fromkeys(KINDS, 0)
    with tempfile.TemporaryDirectory() as made:
        folder = given.keep or Path(made)
        folder.mkdir(parents=True, exist_ok=True)
        for seed in seeds:
            kind = KINDS[seed % len(KINDS)]
            status, said = run(kind, seed, folder)
            accepted += status == 0
            crashed += status not in (0, 1)
            words[kind] += 1
            if status != 1 or given.only is not None:
                print(
                    f"{kind} status {status} {said}   ./scripts/negatives --only {seed}", flush=True
                )
    print(f"{sum(words.values())} places {words}: {accepted} taken for a tank, {crashed} failed")
    return 1 if accepted or crashed else 0


if __name__ == "__main__":
    sys.exit(main())
