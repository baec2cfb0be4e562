"""Draws scenes, runs tank_datum on them and lists the worst. See ./scripts/hunt."""

from __future__ import annotations

import argparse
import csv
import json
import math
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

from built import BIN, call
from hunt_scenes import has_files, scene_of, units_of
from length_units import METRES


def in_units(scan: Path, units: str) -> None:
    """Rewrites an ascii scan's coordinates, and where its scanner stood, in other units."""
    lines = scan.read_text().splitlines()
    begin = next(i for i, line in enumerate(lines) if line.startswith("DATA")) + 1
    place = next(i for i, line in enumerate(lines) if line.startswith("VIEWPOINT"))
    for i, first in [(place, 1), *((row, 0) for row in range(begin, len(lines)))]:
        cells = lines[i].split()
        metres = cells[first : first + 3]
        cells[first : first + 3] = [repr(float(cell) / METRES[units]) for cell in metres]
        lines[i] = " ".join(cells)
    scan.write_text("\n".join(lines) + "\n")


def errors_of(folder: Path, truth: dict[str, Any]) -> list[tuple[float, float]]:
    """Error and standard error of every measured station [m]."""
    by_azimuth = {round(s["azimuth_deg"]): s for s in truth["stations"]}
    errors = []
    with (folder / "stations.csv").open() as stations:
        for row in csv.DictReader(stations):
            if row["flag"] != "measured":
                continue
            z = by_azimuth[round(float(row["azimuth_deg"])) % 360]["z"]
            errors.append((float(row["z"]) - z, float(row["sigma_z"])))
    return errors


def result_of(seed: int, folder: Path) -> dict[str, Any]:
    """One line of the list: what the scene is, and how far off its stations are."""
    scene = scene_of(seed)
    units = units_of(seed)
    description, scan, out = folder / "scene.json", folder / "scan.pcd", folder / "datum"
    description.write_text(json.dumps(scene))
    options = ["--double", *(["--per-setup"] if has_files(seed) else [])]
    options += [] if units == "m" else ["--ascii"]
    call("tank_datum_synth", "--scene", description, "-o", scan, "--quiet", *options)
    scans = sorted(folder.glob("scan*.pcd"))
    if units != "m":
        for one in scans:
            in_units(one, units)
    begun = time.monotonic()
    asked = [str(BIN / "tank_datum"), *map(str, scans), "-o", str(out), "--units", units]
    done = subprocess.run(
        [*asked, "--no-report", "--no-checksum", "--quiet"],
        capture_output=True,
        text=True,
        check=False,
    )
    truth = json.loads((folder / "scan.truth.json").read_text())["tanks"][0]
    result: dict[str, Any] = {
        "seed": seed,
        "kind": scene["tanks"][0]["foundation"]["kind"],
        "radius": scene["tanks"][0]["radius"],
        "registered": not scene["scanner"]["registration"],
        "seconds": time.monotonic() - begun,
        "visible": sum(bool(s["visible"]) for s in truth["stations"]),
        "status": done.returncode,
        "said": done.stderr.strip(),
        "errors": [],
    }
    if done.returncode == 0:
        result["errors"] = errors_of(out, truth)
    return result


def share(errors: list[tuple[float, float]], sigmas: float) -> float:
    within = sum(abs(error) <= sigmas * sigma for error, sigma in errors)
    return 100.0 * within / max(1, len(errors))


def rms(errors: list[tuple[float, float]]) -> float:
    return (sum(error**2 for error, _ in errors) / max(1, len(errors))) ** 0.5


def worst(results: list[dict[str, Any]], title: str, key: Any, text: Any, count: int = 8) -> None:
    print(f"\nworst by {title}")
    for r in sorted(results, key=key, reverse=True)[:count]:
        scene = f"R {r['radius']:5.1f} {r['kind']:13}"
        print(f"  {text(r):>12}  {scene} ./scripts/hunt --only {r['seed']}")


def report(results: list[dict[str, Any]]) -> None:
    found = [r for r in results if r["errors"]]
    if found:
        worst(
            found,
            "error over sigma",
            lambda r: max(abs(e) / s for e, s in r["errors"]),
            lambda r: f"{max(abs(e) / s for e, s in r['errors']):.1f}",
        )
        worst(
            found,
            "error [mm]",
            lambda r: max(abs(e) for e, _ in r["errors"]),
            lambda r: f"{1e3 * max(abs(e) for e, _ in r['errors']):.2f}",
        )
    worst(
        results,
        "visible stations not measured",
        lambda r: r["visible"] - len(r["errors"]),
        lambda r: f"{r['visible'] - len(r['errors'])}",
    )
    worst(results, "seconds", lambda r: r["seconds"], lambda r: f"{r['seconds']:.1f}", 3)
    every = [e for r in found for e in r["errors"]]
    low = sum(share(r["errors"], 2.0) < 80.0 for r in found)
    print(f"\n{len(results)} scenes, {len(results) - len(found)} refused, {len(every)} stations")
    print(
        f"within 2 sigma {share(every, 2.0):.1f} %, within 4 sigma {share(every, 4.0):.2f} %, "
        f"{low} scenes below 80 % within 2 sigma"
    )
    for registered in (True, False):
        some = [r for r in found if r["registered"] == registered]
        print("setups registered perfectly" if registered else "setups that disagree")
        for kind in sorted({r["kind"] for r in some}):
            errors = [e for r in some if r["kind"] == kind for e in r["errors"]]
            print(
                f"  {kind:13} RMS {1e3 * rms(errors):.2f} mm, "
                f"within 2 sigma {share(errors, 2.0):.1f} %"
            )


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "--minutes", type=float, help="10 where --scenes is not given, else no limit"
    )
    parser.add_argument("--scenes", type=int, help="at most so many")
    parser.add_argument("--seed", type=int, default=1, help="of the first scene")
    parser.add_argument("--only", type=int, help="this seed alone")
    parser.add_argument("--json", type=Path, help="file for what every scene gave")
    given = parser.parse_args()
    results: list[dict[str, Any]] = []
    first = given.seed if given.only is None else given.only
    minutes = given.minutes or (math.inf if given.scenes else 10.0)
    count = (given.scenes or 1_000_000) if given.only is None else 1
    end = time.monotonic() + 60.0 * minutes
    while len(results) < count and (not results or time.monotonic() < end):
        with tempfile.TemporaryDirectory() as folder:
            results.append(result_of(first + len(results), Path(folder)))
        last = results[-1]
        print(
            f"{last['seed']}: {last['kind']} R {last['radius']:.1f} m, {len(last['errors'])} of "
            f"{last['visible']} visible, RMS {1e3 * rms(last['errors']):.2f} mm, within 2 sigma "
            f"{share(last['errors'], 2.0):.0f} %, {last['seconds']:.1f} s {last['said']}",
            flush=True,
        )
    report(results)
    if given.json:
        given.json.write_text(json.dumps(results))
    return 0


if __name__ == "__main__":
    sys.exit(main())
