"""A case is run, compared, and where it is asked for its fixture rewritten."""

from __future__ import annotations

import os
import shutil
import sys
import tempfile
import time
from dataclasses import dataclass, field
from pathlib import Path

from tank_datum_qa._cases import Case, CasesError, unused_rules
from tank_datum_qa._compare import Change, compare, values_of
from tank_datum_qa._fixture import rewrite
from tank_datum_qa._programs import run as run_program
from tank_datum_qa._result_journal import ResultError, settle_to_read

HEADER = ("file", "key", "what", "values", "largest", "allowed", "where", "verdict")


@dataclass
class Outcome:
    """What a case came to."""

    case: Case
    error: str = ""  # the run itself went wrong
    changes: list[Change] = field(default_factory=list)
    updated: list[str] = field(default_factory=list)
    values: set[tuple[str, str]] = field(default_factory=set)
    seconds: float = 0.0

    @property
    def passed(self) -> bool:
        return not self.error and not any(change.failed for change in self.changes)

    def lines(self, *, failed_only: bool = False) -> list[str]:
        """What went wrong or moved, as a table."""
        rows = [
            change.row() for change in self.changes if change.failed or not failed_only
        ]
        lines = [self.error] if self.error else []
        if rows:
            widths = [
                max(len(row[i]) for row in [HEADER, *rows]) for i in range(len(HEADER))
            ]
            for row in [HEADER, *rows]:
                cells = [
                    cell.ljust(width) for cell, width in zip(row, widths, strict=True)
                ]
                lines.append("  ".join(cells).rstrip())
        return lines


def default_command() -> str:
    """tank_datum: in TANK_DATUM_BIN, beside tank_datum_qa or Python, else the one on the path."""
    program = Path(sys.argv[0])
    beside = program.parent if program.name == "tank_datum_qa" else None
    folders = [os.environ.get("TANK_DATUM_BIN"), beside, Path(sys.executable).parent]
    for folder in (str(folder) for folder in folders if folder):
        if (found := Path(folder) / "tank_datum").is_file():
            return str(found)
    return "tank_datum"


def programs_of(command: str) -> dict[str, str]:
    """The program of each kind of case; tank_datum_compare stands beside tank_datum."""
    found = shutil.which(command)
    main = os.path.abspath(found or command) if found or "/" in command else command
    beside = os.path.join(os.path.dirname(main), "tank_datum_compare")
    other = (
        beside
        if os.path.exists(beside)
        else shutil.which("tank_datum_compare") or beside
    )
    return {"extract": main, "levelling": main, "compare": other}


def words_of(case: Case, program: str, results: Path) -> list[str]:
    """The command line of a case."""
    if case.command == "compare":
        return [program, *case.inputs, *case.options, "-o", str(results)]
    given = (
        ["--stations-csv", *case.inputs]
        if case.command == "levelling"
        else [*case.inputs]
    )
    return [program, *given, *case.options, "--quiet", "-o", str(results)]


def run_case(
    case: Case, programs: dict[str, str], folder: Path, *, update: bool
) -> Outcome:
    """Runs a case into a new folder in this one, and compares; with `update` the fixture follows."""
    outcome = Outcome(case)
    began = time.monotonic()
    try:
        results = (
            Path(tempfile.mkdtemp(prefix="tank_datum_qa-", dir=folder)) / "results"
        )
        _run_and_compare(outcome, programs[case.command], results, update=update)
    except ResultError as error:
        outcome.error = str(error)
    except OSError as error:
        outcome.error = f"{error.filename}: {error.strerror}"
    outcome.seconds = time.monotonic() - began
    return outcome


def _run_and_compare(
    outcome: Outcome, program: str, results: Path, *, update: bool
) -> None:
    case = outcome.case
    call = words_of(case, program, results)
    status, said = run_program(call, case.root)
    if status != case.status:
        said = said or "nothing on stderr"
        outcome.error = f"exit status {status}, expected {case.status}: {said}"
        return
    settle_to_read(case.fixture, "qa")
    outcome.changes = compare(case, results)
    outcome.values = set(values_of(case, results))
    own = [pattern for pattern, _ in case.tolerances.rules[: case.tolerances.own]]
    unused = unused_rules(own, outcome.values)
    if unused:
        outcome.error = f"tolerance {unused[0]!r}, for no value of {', '.join(case.files)}, expected"
        outcome.error += " a pattern that is for some"
        return
    if update and outcome.changes:
        lacking = [file for file in case.files if not (results / file).is_file()]
        if lacking:
            outcome.error = f"files {lacking[0]!r}, expected what is among the results"
            return
        outcome.updated = rewrite(case, results)


def refuse_unused(outcomes: list[Outcome]) -> None:
    """Raises CasesError for a common tolerance that is for no value of any case."""
    if any(outcome.error for outcome in outcomes):
        return  # whose values are not known
    values = set().union(*(outcome.values for outcome in outcomes))
    tolerances = outcomes[0].case.tolerances
    common = [pattern for pattern, _ in tolerances.rules[tolerances.own :]]
    for pattern in unused_rules(common, values):
        raise CasesError(
            f"tolerance.{pattern}, for no value of any case, expected a pattern that is for some"
        )
