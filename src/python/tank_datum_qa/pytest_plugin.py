"""pytest --tank-datum-cases FILE: every case of the file is a test; a fixture runs one by name."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from tank_datum_qa import RunCase
from tank_datum_qa._cases import Case, CasesError, named, read_cases
from tank_datum_qa._run import (
    Outcome,
    default_command,
    programs_of,
    refuse_unused,
    run_case,
)


class CaseFailed(Exception):
    """What moved too far, as a table."""


def pytest_addoption(parser: pytest.Parser) -> None:
    group = parser.getgroup("tank_datum")
    group.addoption(
        "--tank-datum-cases",
        action="append",
        default=[],
        metavar="FILE",
        help="run the cases of a file of tank_datum_qa; may be given again",
    )
    group.addoption(
        "--tank-datum-command",
        default=None,
        metavar="PATH",
        help="the tank_datum that they run; default: beside Python, else on the path",
    )


def _files(config: pytest.Config) -> list[Path]:
    """In the folder that pytest was started in, or else, as addopts are read, in its root folder."""
    given = config.getoption("--tank-datum-cases") or []
    here, root = config.invocation_params.dir, config.rootpath
    return [
        named(here / name if (here / name).is_file() else root / name) for name in given
    ]


def pytest_configure(config: pytest.Config) -> None:
    here = config.invocation_params.dir
    chosen = {named(here / argument.partition("::")[0]) for argument in config.args}
    given = config.getoption("--tank-datum-cases") or []
    for name, path in zip(given, _files(config), strict=True):
        if not path.is_file():
            raise pytest.UsageError(f"--tank-datum-cases {name}, expected a file")
        if path not in chosen:  # file::case is that case alone
            config.args.append(str(path))


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> CasesFile | None:
    if file_path in _files(parent.config):
        return CasesFile.from_parent(parent, path=file_path)
    return None


def _run(case: Case, config: pytest.Config, folder: Path) -> Outcome:
    command = config.getoption("--tank-datum-command") or default_command()
    return run_case(case, programs_of(command), folder, update=False)


class CasesFile(pytest.File):
    """A file of cases."""

    def __init__(self, **more: Any) -> None:
        super().__init__(**more)
        self.count = 0
        self.outcomes: list[Outcome] = []

    def collect(self) -> Iterator[CaseItem]:
        try:
            cases = read_cases(self.path)
        except CasesError as error:
            raise self.CollectError(str(error)) from None
        self.count = len(cases)
        for case in cases:
            yield CaseItem.from_parent(self, name=case.name, case=case)


class CaseItem(pytest.Item):
    """One case."""

    def __init__(self, *, case: Case, parent: CasesFile, **more: Any) -> None:
        super().__init__(parent=parent, **more)
        self.case = case
        self.file = parent

    def runtest(self) -> None:
        factory = pytest.TempPathFactory.from_config(self.config, _ispytest=True)
        folder = factory.mktemp("tank_datum_qa")
        outcome = _run(self.case, self.config, folder)
        self.file.outcomes.append(outcome)
        if not outcome.passed:
            raise CaseFailed("\n".join(outcome.lines(failed_only=True)))
        if (
            len(self.file.outcomes) == self.file.count
        ):  # what no case needs shows with the last
            try:
                refuse_unused(self.file.outcomes)
            except CasesError as error:
                raise CaseFailed(str(error)) from None

    def repr_failure(self, excinfo: Any, style: Any = None) -> str:
        if isinstance(excinfo.value, CaseFailed):
            return str(excinfo.value)
        return str(super().repr_failure(excinfo, style))

    def reportinfo(self) -> tuple[Path, None, str]:
        return self.path, None, self.name


@pytest.fixture
def tank_datum_qa(request: pytest.FixtureRequest, tmp_path: Path) -> RunCase:
    """tank_datum_qa(file, name): runs a case of a file; `.passed` says whether it holds.

    The file is beside the test's own, or in pytest's root folder. `.changes` are what moved,
    `.lines()` their table. Raises KeyError without such a case.
    """

    def run(file: str | Path, name: str) -> Outcome:
        beside = request.path.parent / file
        path = beside if beside.exists() else request.config.rootpath / file
        cases = {case.name: case for case in read_cases(path)}
        if name not in cases:
            raise KeyError(f"{name!r} in {path}, expected one of: {', '.join(cases)}")
        return _run(cases[name], request.config, tmp_path)

    return run
