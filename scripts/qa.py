"""Runs tank_datum on scans and compares its results with fixtures.

    python scripts/qa.py CASES.toml [--update] [--junit FILE] [--jobs N] [--command PATH]

CASES.toml lists cases; paths in it are relative to it, and runs start in its folder. Fixtures and
files stay below it, and `options` name no outputs:

    [tolerance]                     # of every case; absolute, in the value's unit
    "*sigma*" = 1e-6
    "input.files.*.path" = "ignore"

    [[case]]
    name = "tank 7, spring"
    inputs = ["north.pcd", "south.pcd"]
    options = ["--stations", "180"]
    fixture = "tank7"               # folder with datum.json, stations.csv; default: the name
    status = 0                      # the exit status expected, 0 or 1
    files = ["datum.json", "stations.csv"]
    [case.tolerance]                # looked at before the common ones
    "stations.csv:z" = 0.00005

Prints what moved and by how much. Exit status: 0 all within tolerance; 1 a case failed; 2 wrong
use, or a file that cannot be written.
With --update the fixtures are rewritten after the differences have been shown; what stands there
that tank_datum did not write is kept under another name.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

from qa_cases import Case, CasesError, read_cases
from qa_compare import Change, compare
from result_folder import OutputIsInputError, ResultFolder, require_apart
from result_journal import ResultError, settle_to_read

ROOT = Path(__file__).resolve().parents[1]
PASSED, FAILED, WRONG_USE = 0, 1, 2


@dataclass
class Outcome:
    """What a case came to."""

    case: Case
    error: str = ""  # the run itself went wrong
    changes: list[Change] = field(default_factory=list)
    updated: list[str] = field(default_factory=list)

    @property
    def passed(self) -> bool:
        return not self.error and not any(change.failed for change in self.changes)


def default_command() -> str:
    """The built executable if there is one, else the one on the path."""
    built = Path(os.environ.get("TANK_DATUM_BIN", ROOT / "build" / "bin")) / "tank_datum"
    return str(built) if built.exists() else "tank_datum"


def run_case(case: Case, command: str, folder: Path, *, update: bool) -> Outcome:
    """Runs a case into a folder of its own and compares; with `update` the fixture follows."""
    outcome, results = Outcome(case), folder / "results"
    call = [command, *case.inputs, *case.options, "--quiet", "-o", str(results)]
    try:
        run = subprocess.run(call, cwd=case.root, capture_output=True, text=True)
    except OSError as error:
        outcome.error = f"{command}: {error.strerror}"
        return outcome
    if run.returncode != case.status:
        said = run.stderr.strip() or "nothing on stderr"
        outcome.error = f"exit status {run.returncode}, expected {case.status}: {said}"
        return outcome
    try:
        settle_to_read(case.fixture, "qa")
        outcome.changes = compare(case, results)
        if update and outcome.changes:
            outcome.updated = rewrite(case, results)
    except ResultError as error:
        outcome.error = str(error)
    except OSError as error:
        outcome.error = f"{error.filename}: {error.strerror}"
    return outcome


def rewrite(case: Case, results: Path) -> list[str]:
    """Puts the results in the fixture's place, all or none; others' files keep another name."""
    written = [file for file in case.files if (results / file).exists()]
    ours = is_result(case.fixture)
    with ResultFolder(case.fixture, "qa", own=lambda _: ours) as new:
        for file in written:
            shutil.copyfile(results / file, new / file)
    return written


def is_result(folder: Path) -> bool:
    """Whether a folder's datum.json is one of tank_datum."""
    try:
        table = json.loads((folder / "datum.json").read_bytes())
    except (OSError, ValueError):
        return False
    return isinstance(table, dict) and {"schema", "version", "input", "status"} <= table.keys()


def print_table(outcomes: list[Outcome]) -> None:
    """A line per case, and below it what moved."""
    header = ("file", "key", "what", "values", "largest", "allowed", "where", "verdict")
    for outcome in outcomes:
        print(f"{'PASS' if outcome.passed else 'FAIL'}  {outcome.case.name}")
        if outcome.error:
            print(f"      {outcome.error}")
        rows = [change.row() for change in outcome.changes]
        if rows:
            widths = [max(len(row[i]) for row in [header, *rows]) for i in range(len(header))]
            for row in [header, *rows]:
                cells = [cell.ljust(width) for cell, width in zip(row, widths, strict=True)]
                print("      " + "  ".join(cells).rstrip())
        if outcome.updated:
            print(f"      rewritten: {', '.join(outcome.updated)}")


def write_junit(path: Path, outcomes: list[Outcome]) -> None:
    """JUnit XML: a testcase per case, the changes beyond tolerance as its failure."""
    suite = ElementTree.Element("testsuite", name="tank_datum qa", tests=str(len(outcomes)))
    suite.set("failures", str(sum(not o.passed for o in outcomes)))
    for outcome in outcomes:
        case = ElementTree.SubElement(suite, "testcase", classname="qa", name=outcome.case.name)
        if not outcome.passed:
            bad = [" ".join(filter(None, c.row())) for c in outcome.changes if c.failed]
            failure = ElementTree.SubElement(case, "failure", message=outcome.error or bad[0])
            failure.text = "\n".join(bad) or outcome.error
    with ResultFolder(path.parent, "qa", own=is_junit) as new:
        tree = ElementTree.ElementTree(suite)
        tree.write(new / path.name, encoding="utf-8", xml_declaration=True)


def is_junit(path: Path) -> bool:
    return b'<testsuite name="tank_datum qa"' in path.read_bytes()[:200]


def parsed(arguments: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="qa.py", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("cases", type=Path, help="TOML file")
    parser.add_argument("--update", action="store_true", help="rewrite fixtures that differ")
    parser.add_argument("--junit", type=Path, metavar="FILE", help="write JUnit XML")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="runs at a time")
    parser.add_argument("--command", default=default_command(), help="the tank_datum to run")
    options = parser.parse_args(arguments)
    if options.jobs < 1:
        parser.error(f"--jobs {options.jobs}, expected at least 1")
    return options


def files_of(path: Path, cases: list[Case]) -> list[Path]:
    """What a run reads."""
    inputs = [case.root / scan for case in cases for scan in case.inputs]
    return [path, *inputs, *(case.fixture / file for case in cases for file in case.files)]


def main(arguments: list[str]) -> int:
    options = parsed(arguments)
    signal.signal(signal.SIGTERM, lambda number, _: sys.exit(128 + number))
    try:
        cases = read_cases(options.cases)
        if options.junit:
            require_apart(files_of(options.cases, cases), [options.junit])
    except (CasesError, OutputIsInputError) as error:
        print(f"qa: cases: {error}", file=sys.stderr)
        return WRONG_USE
    with tempfile.TemporaryDirectory() as scratch, ThreadPoolExecutor(options.jobs) as pool:
        jobs = []
        for number, case in enumerate(cases):
            folder = Path(scratch) / str(number)
            folder.mkdir()
            command = shutil.which(options.command) or options.command
            jobs.append(
                pool.submit(run_case, case, os.path.abspath(command), folder, update=options.update)
            )
        outcomes = [job.result() for job in jobs]
    print_table(outcomes)
    if options.junit:
        try:
            write_junit(options.junit, outcomes)
        except ResultError as error:
            print(f"qa: junit: {error}", file=sys.stderr)
            return WRONG_USE
        except OSError as error:
            print(
                f"qa: junit: {options.junit}, {error.strerror}, expected a writable file",
                file=sys.stderr,
            )
            return WRONG_USE
    if options.update:
        return FAILED if any(o.error for o in outcomes) else PASSED
    return PASSED if all(o.passed for o in outcomes) else FAILED


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
