"""Which constants no test holds: halves and doubles each named number, runs the unit tests.

    scripts/mutants [--only foot/] [--tests foot/] [--list] [--seconds 30] [--jobs 2]

It works in a copy of the sources (see mutant_sources.py), built once; the checkout is not touched.
For each mutant those test cases run that ask for the constant, those of its own room and the quick
ones first, until one fails or --seconds of them, of the processor, have passed. A mutant that none
notices survives: its constant changes no result that is looked at, or lacks a test. Results are
kept in the build folder; again run are mutants whose file, or whose tests, changed. mutants.toml
names the constants that are left alone, and why. Exit status 1 when more than 5 % survive.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import subprocess
import sys
import tomllib
from collections import Counter
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass
from pathlib import Path

from mutant_sources import Constant, all_constants, write_copy
from mutant_tests import Case, Coverage, listed_cases, merge_into, noticed_by

ROOT = Path(__file__).resolve().parents[1]
MOST = 0.05  # of the mutants may survive


@dataclass(frozen=True)
class Mutant:
    constant: Constant
    factor: float

    def __str__(self) -> str:
        c = self.constant
        return f"{c.path}:{c.line}: {c.name} = {c.value} times {self.factor:g}"


def left_alone(root: Path) -> dict[str, dict[str, str]]:
    """The reasons of mutants.toml: {"compile_time": {key: reason}, "no_result": {...}}."""
    return tomllib.loads((root / "scripts/mutants.toml").read_text())


def stale(reasons: dict[str, dict[str, str]], constants: list[Constant]) -> list[str]:
    known = {constant.key for constant in constants}
    return [key for section in reasons.values() for key in section if key not in known]


def digest(*paths: Path) -> str:
    return hashlib.sha1(b"".join(path.read_bytes() for path in paths)).hexdigest()


class Results:
    """What is known of the mutants: who noticed each, and from which sources that was found."""

    def __init__(self, file: Path, cases: list[Case]) -> None:
        self.file, self.cases = file, cases
        self.kept = json.loads(file.read_text()) if file.exists() else {}
        self.new: dict[str, dict] = {}

    def state(self, mutant: Mutant, killer: str | None) -> str:
        """Digest of the mutant's file and of the test that noticed it, or of all that might."""
        tests = {c.source for c in self.cases if mutant.constant.key in c.touched}
        paths = [killer] if killer else sorted(tests)
        return digest(
            ROOT / mutant.constant.path, *(ROOT / p for p in paths if (ROOT / p).exists())
        )

    def of(self, mutant: Mutant, budget: float) -> str | None:
        key = f"{mutant.constant.key} {mutant.factor}"
        kept = self.kept.get(key)
        if kept is not None and kept["state"] == self.state(mutant, kept["noticed"]):
            if kept["noticed"] or kept["seconds"] >= budget:
                return kept["noticed"]
        noticed = noticed_by(self.cases, mutant.constant.key, mutant.factor, budget)
        self.kept[key] = {
            "noticed": noticed,
            "seconds": budget,
            "state": self.state(mutant, noticed),
        }
        self.new[key] = self.kept[key]
        return noticed

    def save(self) -> None:
        merge_into(self.file, self.new)


def built(copy: Path, compile_time: frozenset[str], wanted: list[str]) -> list[Case]:
    """Builds the unit tests whose paths hold one of the texts; their cases."""
    build = copy / "build"
    write_copy(ROOT, copy, compile_time)
    paths = [p for p in (copy / "tests").rglob("*_test.cpp") if p.parent.name != "apps"]
    tests = sorted(
        p.stem for p in paths if any(text in str(p.relative_to(copy)) for text in wanted)
    )
    configure = ["cmake", "-S", copy, "-B", build, "-G", "Ninja",
                 "-DTANK_DATUM_VIEWER=OFF", "-DTANK_DATUM_SINGLE_TESTS=ON"]  # fmt: skip
    for command in (configure, ["cmake", "--build", build, "--target", *tests]):
        done = subprocess.run(
            [str(w) for w in command], capture_output=True, text=True, check=False
        )
        if done.returncode != 0:
            raise SystemExit(
                f"mutants: {command[1]} failed:\n{done.stdout[-3000:]}{done.stderr[-3000:]}"
            )
    return [case for case in listed_cases(build, copy) if Path(case.program).name in tests]


def by_room(mutants: list[Mutant], survivors: list[Mutant]) -> str:
    def room(mutant: Mutant) -> str:
        return str(Path(mutant.constant.path).parent)

    constants = Counter(str(Path(c.path).parent) for c in {m.constant for m in mutants})
    tried, left = Counter(map(room, mutants)), Counter(map(room, survivors))
    lines = [
        f"{name:32s} {constants[name]:9d} {tried[name]:7d} {left[name]:9d}"
        for name in sorted(tried)
    ]
    return "\n".join(
        [f"{'folder':32s} {'constants':>9s} {'mutants':>7s} {'survivors':>9s}", *lines]
    )


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--only", default="", help="constants whose path and name hold this text")
    parser.add_argument(
        "--tests", default="tests/", help="tests whose path holds one of these, a,b"
    )
    parser.add_argument("--list", action="store_true", help="name the mutants and stop")
    parser.add_argument("--seconds", type=float, default=30.0, help="of test cases a mutant [s]")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--build", type=Path, default=ROOT / "build-mutants")
    options = parser.parse_args()
    options.build = options.build.resolve()
    reasons, constants = left_alone(ROOT), all_constants(ROOT)
    if stale(reasons, constants):
        raise SystemExit(
            f"mutants: no longer in the sources: {', '.join(stale(reasons, constants))}"
        )
    alone = {key: reason for section in reasons.values() for key, reason in section.items()}
    wanted = [c for c in constants if options.only in c.key]
    for constant in wanted:
        if constant.key in alone:
            print(f"left alone {constant.key}: {alone[constant.key]}")
    mutants = [Mutant(c, f) for c in wanted if c.key not in alone for f in c.factors()]
    if options.list:
        print("\n".join(map(str, mutants)))
        print(f"{len(mutants)} mutants of {len({m.constant for m in mutants})} constants")
        return 0
    cases = built(options.build, frozenset(reasons["compile_time"]), options.tests.split(","))
    cases = Coverage(options.build / "coverage.json").of(cases, options.jobs)
    for case in cases:
        if not case.passed:
            print(f"fails without a mutant, not used: {case.source} {case.name}")
    survivors = tried(mutants, Results(options.build / "results.json", cases), options)
    print(by_room(mutants, survivors))
    share = len(survivors) / max(1, len(mutants))
    print(f"{len(survivors)} of {len(mutants)} survive, {100.0 * share:.1f} %")
    return 1 if share > MOST else 0


def tried(mutants: list[Mutant], results: Results, options: argparse.Namespace) -> list[Mutant]:
    """Those that survive; says so of each as it is known."""
    survivors = []
    with ThreadPoolExecutor(options.jobs) as pool:
        waiting = {pool.submit(results.of, mutant, options.seconds): mutant for mutant in mutants}
        for number, future in enumerate(as_completed(waiting), start=1):
            mutant, noticed = waiting[future], future.result()
            asked = any(mutant.constant.key in case.touched for case in results.cases)
            survives = "SURVIVES" if asked else "SURVIVES, used by no test"
            word = f"noticed by {noticed}" if noticed else survives
            print(f"{number}/{len(mutants)} {mutant}: {word}", flush=True)
            survivors += [] if noticed else [mutant]
            if number % 10 == 0:
                results.save()
    results.save()
    return survivors


if __name__ == "__main__":
    sys.exit(main())
