"""The accuracy table: scans of known truth, their datums, and whether they are as good as required.

Every scene is scanned anew with each seed. A second table is about setups that disagree.
"""

from __future__ import annotations

import argparse
import json
import math
import sys
import tempfile
from dataclasses import asdict
from pathlib import Path
from typing import Any

from accuracy_figures import Figures, compare, figures_of
from accuracy_rows import COLUMNS, REQUIRED, Row
from built import ROOT, call
from setup_rates import print_table as print_setups
from setup_surveys import KINDS

SCENES = ROOT / "tests" / "scenes"


SYNTH_OPTIONS = {"small12": ["--double"]}
DATUM_OPTIONS = {"three_tanks": ["--all"]}


def without_nan(value: Any) -> Any:
    """The same for JSON: what is not a finite number is null."""
    if isinstance(value, dict):
        return {key: without_nan(v) for key, v in value.items()}
    if isinstance(value, list):
        return [without_nan(v) for v in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def simulated(scene: str, seed: int, folder: Path) -> Path:
    """The scan of a scene; one that is kept from an earlier run is taken again."""
    scan = folder / f"{scene}_{seed}.pcd"
    source = SCENES / f"{scene}.json"
    if not (scan.exists() and scan.stat().st_mtime > source.stat().st_mtime):
        options = ["--set", f"seed={seed}", *SYNTH_OPTIONS.get(scene, [])]
        call("tank_datum_synth", "--scene", source, *options, "-o", scan, "--quiet")
    return scan


def read_json(path: Path) -> dict[str, Any]:
    result: dict[str, Any] = json.loads(path.read_text())
    return result


def found_tanks(out: Path) -> list[tuple[Path, dict[str, Any]]]:
    folders = sorted(out.glob("tank_*")) or [out]
    return [(folder, read_json(folder / "datum.json")) for folder in folders]


def distance(datum: dict[str, Any], truth: dict[str, Any]) -> float:
    """Between the centre found and the true one [m]; without limit when none was found."""
    tank = datum["tank"]
    return math.inf if tank is None else math.dist(tank["center"], truth["center"])


def measure(scene: str, seed: int, folder: Path, *, keep: bool) -> tuple[int, list[Figures], str]:
    """Points of a scan, the figures of its tanks in the truth's order, and what is wrong."""
    scan = simulated(scene, seed, folder)
    out = scan.with_suffix(".datum")
    call("tank_datum", scan, "-o", out, "--quiet", *DATUM_OPTIONS.get(scene, []), accepted=(0, 1))
    truth = read_json(scan.with_suffix(".truth.json"))
    if not keep:
        scan.unlink()
    found = found_tanks(out)

    runs, problem = [], ""
    for index, tank in enumerate(truth["tanks"]):
        distances = [distance(datum, tank) for _, datum in found]
        part, datum = found[distances.index(min(distances))]
        runs.append(figures_of(compare(part, datum, truth, index)))
        if min(distances) > 0.1 * tank["radius"]:
            problem = f"seed {seed}: no tank found at {tank['center']}"
    if len(found) != len(runs):
        problem = f"seed {seed}: {len(found)} tanks found, not {len(runs)}"
    return found[0][1]["input"]["files"][0]["points"], runs, problem


def rows_of(scene: str, seeds: list[int], folder: Path, *, keep: bool) -> list[Row]:
    scans = [measure(scene, seed, folder, keep=keep) for seed in seeds]
    problems = [problem for _, _, problem in scans if problem]
    rows = []
    for tank, required in enumerate(REQUIRED[scene]):
        name = scene if len(REQUIRED[scene]) == 1 else f"{scene} ({tank + 1})"
        runs = [figures[tank] for _, figures, _ in scans]
        rows.append(Row(name, required, scans[0][0], seeds, runs, problems))
    return rows


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="scripts/accuracy", description=__doc__)
    parser.add_argument("--seeds", type=int, default=3, help="scans of each scene (%(default)s)")
    parser.add_argument("--scenes", default=",".join(REQUIRED), help="of %(default)s")
    parser.add_argument(
        "--setups",
        type=int,
        default=20,
        metavar="N",
        help="surveys of each kind of setups that disagree, 0 for none (%(default)s)",
    )
    parser.add_argument("--json", type=Path, help="file for every figure")
    parser.add_argument("--keep", type=Path, help="folder that scans and results stay in")
    args = parser.parse_args()
    args.scenes = args.scenes.split(",")
    unknown = set(args.scenes) - set(REQUIRED)
    if unknown or args.seeds < 1:
        parser.error(f"scenes of {', '.join(REQUIRED)} and at least one seed are expected")
    args.seeds = list(range(1, args.seeds + 1))
    return args


def report(rows: list[Row]) -> str:
    every = [asdict(row) | {"failures": row.failures()} for row in rows]
    return json.dumps(without_nan(every), indent=1) + "\n"


def main() -> int:
    args = arguments()
    rows: list[Row] = []
    print(f"| {' | '.join(COLUMNS)} |\n{'|---' * len(COLUMNS)}|", flush=True)
    with tempfile.TemporaryDirectory(prefix="tank_datum_accuracy_") as temporary:
        folder = args.keep or Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        for scene in args.scenes:
            for row in rows_of(scene, args.seeds, folder, keep=args.keep is not None):
                rows.append(row)
                print(f"| {' | '.join(row.cells())} |", flush=True)
    failed = [row for row in rows if row.failures()]
    print("\nmm; errors of the measured stations, nothing removed; the worst of the seeds.")
    print("\n".join(row.explanation() for row in failed))
    if args.json:
        args.json.write_text(report(rows))
    setups_pass = True
    if args.setups:
        print()
        setups_pass = print_setups(list(KINDS), range(1, args.setups + 1))
    return 1 if failed or not setups_pass else 0


if __name__ == "__main__":
    sys.exit(main())
