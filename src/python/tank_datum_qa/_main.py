"""The command tank_datum_qa."""

from __future__ import annotations

import argparse
import io
import os
import shlex
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import tank_datum_qa
from tank_datum_qa._cases import Case, CasesError, read_cases
from tank_datum_qa._junit import write_junit
from tank_datum_qa._order import rounds_of
from tank_datum_qa._programs import stop_programs
from tank_datum_qa._result_folder import OutputIsInputError, require_apart
from tank_datum_qa._result_journal import ResultError
from tank_datum_qa._run import (
    Outcome,
    default_command,
    programs_of,
    refuse_unused,
    run_case,
)
from tank_datum_qa._scratch import exit_on_signals, scratch

PASSED, FAILED, WRONG_USE = 0, 1, 2


def parsed(arguments: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="tank_datum_qa",
        description=tank_datum_qa.__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("cases", type=Path, help="TOML file")
    parser.add_argument(
        "-k", metavar="WORD", default="", help="only cases with this in their name"
    )
    parser.add_argument("--list", action="store_true", help="print the cases and stop")
    parser.add_argument(
        "--update", action="store_true", help="rewrite fixtures that differ"
    )
    parser.add_argument("--junit", type=Path, metavar="FILE", help="write JUnit XML")
    parser.add_argument(
        "--jobs", type=int, default=os.cpu_count() or 1, help="runs at a time"
    )
    parser.add_argument(
        "--command", default=default_command(), help="the tank_datum to run"
    )
    options = parser.parse_args(arguments)
    if options.jobs < 1:
        parser.error(f"--jobs {options.jobs}, expected at least 1")
    return options


def files_of(path: Path, cases: list[Case]) -> list[Path]:
    """What a run reads."""
    inputs = [case.root / scan for case in cases for scan in case.inputs]
    return [
        path,
        *inputs,
        *(case.fixture / file for case in cases for file in case.files),
    ]


def chosen(options: argparse.Namespace) -> list[Case]:
    """The cases to run. Raises CasesError."""
    every = read_cases(options.cases)
    cases = [case for case in every if options.k.casefold() in case.name.casefold()]
    if not cases:
        names = ", ".join(case.name for case in every)
        raise CasesError(f"-k, {options.k!r}, expected a part of one of: {names}")
    if options.junit:
        require_apart(files_of(options.cases, every), [options.junit])
    return cases


def run_all(cases: list[Case], options: argparse.Namespace) -> list[Outcome]:
    """The outcomes in the order of the cases. Raises CasesError."""
    programs = programs_of(options.command)
    rounds = rounds_of(cases) if options.update else [cases]
    outcomes: dict[str, Outcome] = {}
    with scratch() as place, ThreadPoolExecutor(options.jobs) as pool:
        try:
            for together in rounds:
                jobs = [
                    pool.submit(run_case, case, programs, place, update=options.update)
                    for case in together
                ]
                outcomes |= {job.result().case.name: job.result() for job in jobs}
            return [outcomes[case.name] for case in cases]
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            stop_programs()
            raise


def print_table(outcomes: list[Outcome]) -> None:
    """A line per case, and below it what moved."""
    for outcome in outcomes:
        print(f"{'PASS' if outcome.passed else 'FAIL'}  {outcome.case.name}")
        for line in outcome.lines():
            print(f"      {line}")
        if outcome.updated:
            print(f"      rewritten: {', '.join(outcome.updated)}")


def say_hint(outcomes: list[Outcome], options: argparse.Namespace) -> None:
    """How to accept what moved."""
    if options.update or not any(not o.passed and not o.error for o in outcomes):
        return
    only = f" -k {shlex.quote(options.k)}" if options.k else ""
    cases = shlex.quote(str(options.cases))
    print(f"when these changes are wanted: tank_datum_qa {cases}{only} --update")


def junit_failure(options: argparse.Namespace, outcomes: list[Outcome]) -> str:
    """Writes the JUnit file when one is asked for; what went wrong, or nothing."""
    try:
        if options.junit:
            write_junit(options.junit, outcomes)
    except ResultError as error:
        return str(error)
    except OSError as error:
        return f"{options.junit}, {error.strerror}, expected a writable file"
    return ""


def escape_what_cannot_be_shown() -> None:
    """A character that the terminal has no place for ends no run."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")


def main(arguments: list[str] | None = None) -> int:
    try:
        status = run(arguments)
        sys.stdout.flush()
        return status
    except OSError as error:  # those of cases are theirs
        place = error.filename or "standard output"
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # what waits goes nowhere
        print(f"qa: {place}, {error.strerror}, expected room there", file=sys.stderr)
        return WRONG_USE


def run(arguments: list[str] | None) -> int:
    escape_what_cannot_be_shown()
    options = parsed(sys.argv[1:] if arguments is None else arguments)
    exit_on_signals()
    try:
        cases = chosen(options)
        if options.list:
            for case in cases:
                print(f"{case.name}: {case.command} {' '.join(case.inputs)}")
            return PASSED
        outcomes = run_all(cases, options)
        try:
            if not options.k:
                refuse_unused(outcomes)
        except CasesError:  # nothing has passed, but what was rewritten has been
            print_table([outcome for outcome in outcomes if outcome.changes])
            raise
        print_table(outcomes)
    except (CasesError, OutputIsInputError) as error:
        print(f"qa: cases: {error}", file=sys.stderr)
        return WRONG_USE
    say_hint(outcomes, options)
    if failure := junit_failure(options, outcomes):
        print(f"qa: junit: {failure}", file=sys.stderr)
        return WRONG_USE
    if options.update:
        return FAILED if any(o.error for o in outcomes) else PASSED
    return PASSED if all(o.passed for o in outcomes) else FAILED
