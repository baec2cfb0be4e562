"""The unit tests of the copy: what constants each asks for, and whether a mutant is noticed."""

from __future__ import annotations

import hashlib
import json
import math
import os
import subprocess
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

ROOMS = (
    "core fit io search edge stations limits locate setups foot shell shape trust . "
    "pcl movement options report"
).split()
QUICK = 1.0  # [s]: cases up to here are run before the others of their room


@dataclass(frozen=True)
class Case:
    """One test case, what it took and which constants it asked for."""

    program: str
    folder: str
    name: str
    source: str
    seconds: float = 0.0
    touched: frozenset[str] = frozenset()
    passed: bool = True


def room_of(path: str) -> int:
    """Rank of the room that a source or a test lies in."""
    parts = Path(path).parts
    room = "." if len(parts) < 3 else parts[2] if parts[0] == "include" else parts[1]
    return ROOMS.index(room) if room in ROOMS else len(ROOMS)


def listed_cases(build: Path, sources: Path) -> list[Case]:
    """The cases that ctest knows of the unit tests that are built."""
    text = subprocess.run(
        ["ctest", "--test-dir", str(build), "-L", "unit", "--show-only=json-v1"],
        capture_output=True, text=True, check=True,
    ).stdout  # fmt: skip
    stands = {p.stem: p for p in sorted((sources / "tests").rglob("*_test.cpp"))}
    found = []
    for test in json.loads(text)["tests"]:
        command = test.get("command", [])
        if len(command) < 2 or not command[1].startswith("--gtest_filter="):
            continue
        folder = {p["name"]: p["value"] for p in test["properties"]}["WORKING_DIRECTORY"]
        source = stands[Path(command[0]).name].relative_to(sources)
        found.append(Case(command[0], folder, command[1].split("=", 1)[1], str(source)))
    return found


def run_cases(cases: list[Case], limit: float, **environment: str) -> tuple[bool, float]:
    """Whether the cases, all of one program, pass in the limit, and what they took.

    Both in seconds of the processor: by the clock a busy machine would fail them.
    """
    names = ":".join(case.name for case in cases)
    options = ["--gtest_filter=" + names, "--gtest_fail_fast", "--gtest_brief=1"]
    limited = ["nice", "-n", "10", "prlimit", f"--cpu={math.ceil(limit)}"]
    process = subprocess.Popen(
        [*limited, cases[0].program, *options],
        cwd=cases[0].folder, env={**os.environ, "OMP_NUM_THREADS": "1", **environment},
        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
    )  # fmt: skip
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode == 0, used.ru_utime + used.ru_stime


def with_coverage(case: Case, scratch: Path) -> Case:
    """The case after one run without a mutant."""
    name = hashlib.sha1((case.program + case.name).encode()).hexdigest()
    keys = scratch / f"{name}.keys"
    passed, seconds = run_cases([case], 300.0, TANK_DATUM_TOUCHED=str(keys))
    touched = frozenset(keys.read_text().split("\n")[:-1]) if keys.exists() else frozenset()
    keys.unlink(missing_ok=True)
    return Case(case.program, case.folder, case.name, case.source, seconds, touched, passed)


def merge_into(file: Path, entries: dict[str, dict]) -> None:
    """Adds the entries to those of a JSON file, which another run may have written meanwhile."""
    kept = json.loads(file.read_text()) if file.exists() else {}
    part = file.with_suffix(f".{os.getpid()}")
    part.write_text(json.dumps({**kept, **entries}, indent=0))
    part.replace(file)


class Coverage:
    """Cases with what they ask for, kept in a file; a case runs again when its program changed."""

    def __init__(self, file: Path) -> None:
        self.file = file
        self.kept = json.loads(file.read_text()) if file.exists() else {}

    def of(self, cases: Sequence[Case], jobs: int) -> list[Case]:
        digests: dict[str, str] = {}
        for case in cases:
            if case.program not in digests:
                digests[case.program] = hashlib.sha1(Path(case.program).read_bytes()).hexdigest()

        def one(case: Case) -> Case:
            kept = self.kept.get(f"{case.program} {case.name}")
            if kept is None or kept["digest"] != digests[case.program]:
                return with_coverage(case, self.file.parent)
            return Case(case.program, case.folder, case.name, case.source,
                        kept["seconds"], frozenset(kept["touched"]), kept["passed"])  # fmt: skip

        with ThreadPoolExecutor(jobs) as pool:
            done = list(pool.map(one, cases))
        entries = {
            f"{case.program} {case.name}": {
                "digest": digests[case.program], "seconds": case.seconds,
                "touched": sorted(case.touched), "passed": case.passed,
            }
            for case in done
        }  # fmt: skip
        merge_into(self.file, entries)
        return done


def in_order(cases: list[Case], key: str, budget: float) -> list[list[Case]]:
    """The cases that ask for the constant, in runs of one program.

    Those of its own room come first, and of these the programs whose cases ask for the fewest
    constants, which are closest to it.
    """
    room, stem = room_of(key), Path(key.split(":")[0]).stem
    asking = [case for case in cases if case.passed and key in case.touched]
    nearest: dict[str, int] = {}
    for case in asking:
        asked = 0 if stem in Path(case.source).stem else len(case.touched)
        nearest[case.program] = min(asked, nearest.get(case.program, asked))

    def rank(case: Case) -> tuple[bool, bool, int, str]:
        return (
            room_of(case.source) != room,
            case.seconds > QUICK,
            nearest[case.program],
            case.program,
        )

    asking.sort(key=lambda case: (rank(case), case.seconds))
    runs: list[list[Case]] = []
    total = 0.0
    for case in asking:
        total += case.seconds
        if total > budget and runs:
            break
        if runs and rank(runs[-1][0]) == rank(case):
            runs[-1].append(case)
        else:
            runs.append([case])
    return runs


def noticed_by(cases: list[Case], key: str, factor: float, budget: float) -> str | None:
    """The test that fails with the constant scaled; None where all pass or none asks for it."""
    for run in in_order(cases, key, budget):
        limit = 10.0 + 10.0 * sum(case.seconds for case in run)
        passed, _ = run_cases(run, limit, TANK_DATUM_MUTANT=f"{key} {factor}")
        if not passed:
            return run[0].source
    return None
