"""Which constants no test holds: halves and doubles each named number of src/ and tests the result.

    python3 scripts/mutants.py [--only foot/] [--list] [--build build-mutants]

It works in a copy of the sources below the build folder; the checkout is not touched. A mutant that
no unit test and no case of tests/data/qa notices survives: its constant changes no result that is
looked at, or lacks a test. Exit status 1 when one survives. Long: a minute a constant and more.
"""

from __future__ import annotations

import argparse
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
NUMBER = r"-?\d[\d']*(?:\.\d*)?(?:[eE][+-]?\d+)?"
CONSTANT = re.compile(
    rf"^\s*(?:static |inline )*constexpr (?:double|float|int|std::size_t|std::u?int\d+_t) "
    rf"(?P<names>k[A-Z]\w* = {NUMBER}[fFuUlL]*(?:, k[A-Z]\w* = {NUMBER}[fFuUlL]*)*);",
    re.MULTILINE,
)
ONE = re.compile(rf"(?P<name>k[A-Z]\w*) = (?P<number>{NUMBER})")
NOT_TUNED = {"kPi"}


@dataclass(frozen=True)
class Mutant:
    """One number of one file, replaced."""

    path: Path
    line: int
    start: int
    end: int
    name: str
    old: str
    new: str

    def __str__(self) -> str:
        return f"{self.path}:{self.line}: {self.name} = {self.old} -> {self.new}"


def scaled(number: str, factor: float) -> str | None:
    """The number times the factor, in the same kind of literal; None where that changes nothing."""
    plain = number.replace("'", "")
    if re.fullmatch(r"-?\d+", plain):
        value = int(int(plain) * factor)
        return None if value == int(plain) or value == 0 else str(value)
    value = float(plain) * factor
    return None if value == float(plain) else repr(value)


def mutants_of(path: Path) -> list[Mutant]:
    text = path.read_text()
    found = []
    for declaration in CONSTANT.finditer(text):
        for one in ONE.finditer(text, declaration.start("names"), declaration.end("names")):
            if one["name"] in NOT_TUNED:
                continue
            line = text.count("\n", 0, one.start()) + 1
            for factor in (0.5, 2.0):
                new = scaled(one["number"], factor)
                if new is not None:
                    found.append(
                        Mutant(
                            path.relative_to(ROOT), line, one.start("number"), one.end("number"),
                            one["name"], one["number"], new,
                        )
                    )  # fmt: skip
    return found


def all_mutants(only: str) -> list[Mutant]:
    paths = [*sorted((ROOT / "src").rglob("*.cpp")), *sorted((ROOT / "src").rglob("*.h"))]
    return [m for path in paths if only in str(path.relative_to(ROOT)) for m in mutants_of(path)]


def quiet(*command: object) -> bool:
    done = subprocess.run([str(word) for word in command], capture_output=True, check=False)
    return done.returncode == 0


def is_caught(build: Path) -> bool:
    """Whether the build or a test fails."""
    if not quiet("cmake", "--build", build):
        return True
    return not quiet("ctest", "--test-dir", build, "-L", "unit|qa", "--stop-on-failure", "-j", 2)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--only", default="", help="files whose path holds this text")
    parser.add_argument("--list", action="store_true", help="name the mutants and stop")
    parser.add_argument("--build", type=Path, default=ROOT / "build-mutants")
    options = parser.parse_args()
    mutants = all_mutants(options.only)
    if options.list:
        print("\n".join(map(str, mutants)))
        constants = {(m.path, m.line, m.name) for m in mutants}
        print(f"{len(mutants)} mutants of {len(constants)} constants")
        return 0
    copy, build = options.build / "sources", options.build / "objects"
    shutil.rmtree(copy, ignore_errors=True)
    shutil.copytree(ROOT, copy, ignore=shutil.ignore_patterns("build*", ".git", ".venv", "*.datum"))
    if not quiet("cmake", "-S", copy, "-B", build, "-G", "Ninja", "-DTANK_DATUM_VIEWER=OFF"):
        raise SystemExit("mutants: cmake failed: run ./scripts/test first")
    if is_caught(build):
        raise SystemExit("mutants: the tests fail without a mutant")
    survivors = []
    for number, mutant in enumerate(mutants, start=1):
        path = copy / mutant.path
        text = path.read_text()
        path.write_text(text[: mutant.start] + mutant.new + text[mutant.end :])
        caught = is_caught(build)
        path.write_text(text)
        print(
            f"{number}/{len(mutants)} {'caught  ' if caught else 'SURVIVES'} {mutant}", flush=True
        )
        survivors += [] if caught else [mutant]
    share = 100.0 * len(survivors) / max(1, len(mutants))
    print(f"{len(survivors)} of {len(mutants)} survive, {share:.1f} %")
    return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main())
