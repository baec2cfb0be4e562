"""The Python module on functions that return blocks: streamed anew in every pass."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest

from module_fixtures import two_setups
from results import Array

tank_datum = pytest.importorskip("tank_datum", reason="the module is not installed")

Blocks = Callable[[], Iterator[Any]]


def in_blocks(points: Array, number: int = 301) -> Blocks:
    def blocks() -> Iterator[Array]:
        yield from np.array_split(points, number)

    return blocks


def test_the_datum_is_that_of_the_array(points: Array) -> None:
    assert tank_datum.extract_datum(in_blocks(points)) == tank_datum.extract_datum(points)


def test_blocks_of_any_type_and_masked_ones(points: Array) -> None:
    wanted = tank_datum.extract_datum((points * 1000).astype(np.int32), units="mm")

    def blocks() -> Iterator[Any]:
        whole = (points * 1000).astype(np.int32)
        for block in np.array_split(whole, 7):
            holes = np.ma.masked_array(np.insert(block, 3, 1, axis=0), mask=False)
            holes[3] = np.ma.masked
            yield holes

    assert tank_datum.extract_datum(blocks, units="mm") == wanted


def test_float32_far_from_its_origin_warns_like_an_array(points: Array) -> None:
    far = (points + [3e5, 0, 0]).astype(np.float32)
    array, stream = tank_datum.extract_datum(far), tank_datum.extract_datum(in_blocks(far))
    assert "steps of 31.25 mm" in array.message
    assert stream.message == array.message


def test_memory_does_not_grow_with_the_scan() -> None:
    """A ring of 1.5 M points among 40 M of terrain: the terrain alone would take 960 MB."""
    program = """
import resource, numpy as np, tank_datum
def blocks():
    random = np.random.default_rng(1)
    turn = np.linspace(0, 2 * np.pi, 500_000)
    for z in np.linspace(0, 2, 3):
        yield np.column_stack([5 * np.cos(turn), 5 * np.sin(turn), z + 0 * turn])
    for part in range(80):
        block = random.random((500_000, 3)) * [400, 400, 3] - [200, 200, 0]
        yield block
tank_datum.find_tanks(blocks)
print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024)
"""
    words = [sys.executable, "-c", program]
    run = subprocess.run(words, capture_output=True, text=True, check=True)
    assert int(run.stdout) < 800, f"{run.stdout} MB"


def with_setups(points: Array, each: bool) -> Blocks:
    """Two setups, of which the second stands 2 cm too high."""

    def blocks() -> Iterator[tuple[Array, Any]]:
        for number, seen in enumerate(two_setups(points)):
            moved = seen + [0, 0, 0.02 * number]
            yield moved, np.full(len(moved), number) if each else number

    return blocks


@pytest.mark.parametrize("each", [False, True], ids=["of a block", "of each point"])
def test_setups_are_told_apart(points: Array, each: bool) -> None:
    setups = tank_datum.extract_datum(with_setups(points, each)).to_dict()["setups"]
    assert [setup["name"] for setup in setups] == ["0", "1"]
    assert abs(setups[0]["dz"] - setups[1]["dz"]) == pytest.approx(0.02, abs=0.002)


@pytest.mark.parametrize(
    ("item", "kind", "said"),
    [
        (np.zeros((3, 2)), TypeError, r"shape \(3, 2\) in float64"),
        ((np.zeros((3, 3)), 1.5), TypeError, r"a setup of shape \(\) in float64 for 3 points"),
        ((np.zeros((3, 3)), [1, 2]), TypeError, r"a setup of shape \(2,\) in int64 for 3 points"),
        ((np.zeros((3, 3)), -1), ValueError, "setup -1 to -1, expected a number from 0"),
        (7, TypeError, r"shape \(\) in int64"),
    ],
    ids=["two columns", "setup in float", "setups too few", "setup below 0", "a number"],
)
def test_bad_blocks_are_named(item: Any, kind: type[Exception], said: str) -> None:
    with pytest.raises(kind, match=said):
        tank_datum.extract_datum(lambda: iter([item]))


def test_what_the_function_raises_is_raised() -> None:
    def blocks() -> Iterator[Array]:
        yield np.zeros((5, 3))
        raise LookupError("the database went away")

    with pytest.raises(LookupError, match="the database went away"):
        tank_datum.extract_datum(blocks)


def test_an_iterator_that_is_used_up_is_refused(points: Array) -> None:
    spent = iter(np.array_split(points, 5))
    with pytest.raises(tank_datum.FileError, match="expected a function that returns a fresh"):
        tank_datum.extract_datum(lambda: spent)


@pytest.mark.parametrize("what", ["points", "order", "setups"])
def test_passes_that_differ_at_one_count_are_refused(points: Array, what: str) -> None:
    """One row of them all is enough; where blocks begin and end is free."""
    passes = 0

    def blocks() -> Iterator[Any]:
        nonlocal passes
        passes += 1
        setups = np.zeros(len(points), np.uint16)
        rows = np.arange(len(points))
        changed = points.copy()
        if passes > 2:  # the first ends at its first block
            setups[5] = what == "setups"
            rows[:2] = rows[1::-1] if what == "order" else rows[:2]
            changed[-1] += 0.001 * (what == "points")
        yield from (
            (block, number)
            for block, number in zip(
                np.array_split(changed[rows], passes), np.array_split(setups, passes), strict=True
            )
        )

    said = "other points or setups in a later pass than in the first, expected a function that"
    with pytest.raises(tank_datum.FileError, match=said):
        tank_datum.extract_datum(blocks)


def test_no_blocks_hold_no_tank() -> None:
    assert tank_datum.extract_datum(lambda: iter([])).status == "too_few_points"
