"""The order in which cases rewrite their fixtures: a fixture comes before what reads it."""

from __future__ import annotations

import os
from graphlib import CycleError, TopologicalSorter

from tank_datum_qa._cases import Case, CasesError


def rounds_of(cases: list[Case]) -> list[list[Case]]:
    """The cases that may run together, round after round. Raises CasesError for a circle."""
    fixtures = {os.path.realpath(case.fixture): case.name for case in cases}
    order = TopologicalSorter(
        {case.name: _sources(case, fixtures) - {case.name} for case in cases}
    )
    try:
        order.prepare()
    except CycleError as error:
        circle = " reads ".join(repr(name) for name in reversed(error.args[1]))
        raise CasesError(
            f"--update, {circle}, expected a fixture that comes before what reads it"
        ) from None
    rounds = []
    while names := order.get_ready():
        rounds.append([case for case in cases if case.name in names])
        order.done(*names)
    return rounds


def _sources(case: Case, fixtures: dict[str, str]) -> set[str]:
    """The cases in whose fixtures an input, or a file that an option names, lies."""
    words = [*case.inputs, *case.options]
    words += [word.partition("=")[2] for word in case.options]
    places = {os.path.realpath(case.root / word) for word in words if word}
    return {
        name
        for fixture, name in fixtures.items()
        if any(f"{place}/".startswith(f"{fixture}/") for place in places)
    }
