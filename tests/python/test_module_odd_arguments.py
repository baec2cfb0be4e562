"""Arguments that no caller means: refused by name, and nothing hangs."""

from __future__ import annotations

import os
import pickle
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import tank_datum as td

from report_pages import SAMPLE
from results import read_points

POINTS = read_points(SAMPLE)


@pytest.fixture(scope="module")
def datum() -> td.Datum:
    return td.extract_datum(POINTS)


@pytest.fixture(scope="module")
def saved(datum: td.Datum, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("odd") / "saved"
    datum.save(folder)
    return folder


NO_PATHS = ["a\0b", b"a\0b", "a\ud800", ""]


@pytest.mark.parametrize("path", NO_PATHS, ids=["nul", "nul in bytes", "surrogate", "empty"])
@pytest.mark.parametrize(
    "function",
    ["load", "extract_datum", "save", "report", "compare", "limits", "simulate", "simulate to"],
)
def test_what_is_no_name_of_a_file(datum: td.Datum, function: str, path: Any) -> None:
    called: dict[str, Callable[[Any], object]] = {
        "load": td.load,
        "extract_datum": td.extract_datum,
        "save": datum.save,
        "report": datum.report,
        "compare": lambda given: td.compare([datum, given]),
        "limits": td.limits,
        "simulate": td.simulate,
        "simulate to": lambda given: td.simulate({}, given),
    }
    with pytest.raises(td.FileError, match="no name of a file, expected a path") as refused:
        called[function](path)
    assert refused.value.stage and refused.value.value and refused.value.expected


def test_paths_may_be_bytes(saved: Path, datum: td.Datum) -> None:
    assert td.load(os.fsencode(saved)).to_json() == datum.to_json()
    assert td.compare([os.fsencode(saved), saved]).message == ""


def test_a_page_is_not_written_into_a_pipe(datum: td.Datum, tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "fifo")
    with pytest.raises(td.FileError, match="a pipe, expected a file"):
        datum.report(tmp_path / "fifo")


@pytest.mark.parametrize("value", ["nan", "NaN", "-nan", "nanft", float("nan"), np.nan])
def test_a_height_that_is_no_number(value: Any) -> None:
    with pytest.raises(td.OptionError, match="height, -?(nan|NaN)"):
        td.extract_datum(POINTS, height=value)


@pytest.mark.parametrize("name", ["yield_mpa", "modulus_mpa", "north_deg"])
def test_a_figure_that_is_no_number(name: str) -> None:
    with pytest.raises(td.OptionError, match=f"{name}, -?nan"):
        td.extract_datum(POINTS, **{name: float("nan")})


@pytest.mark.parametrize("value", [10**30, -(10**30), 2**31])
def test_whole_numbers_that_are_too_large(value: int) -> None:
    with pytest.raises(td.OptionError, match="k, .*, expected >= 3"):
        td.extract_datum(POINTS, k=value)


def test_no_setups_are_no_places_of_setups() -> None:
    with pytest.raises(TypeError, match="setup_origins = {}, expected a path, a dict"):
        td.extract_datum(POINTS, setup_origins={})


@pytest.mark.parametrize(
    ("dates", "error", "words"),
    [
        ([np.timedelta64(3), 4], TypeError, "dates = np.timedelta64"),
        ([10**400, 5], td.OptionError, "dates, 1000"),
        ([True, 2], TypeError, "dates = True"),
        (2024, TypeError, "dates = 2024, expected one a survey"),
    ],
    ids=["difference", "too large", "truth", "one"],
)
def test_dates_that_are_none(
    datum: td.Datum, dates: Any, error: type[Exception], words: str
) -> None:
    with pytest.raises(error, match=words):
        td.compare([datum, datum], dates)


@pytest.mark.parametrize("epochs", [None, 5])
def test_surveys_that_are_no_list(epochs: Any) -> None:
    with pytest.raises(TypeError, match="epochs = .*, expected one a survey"):
        td.compare(epochs)


def test_files_that_are_no_results(datum: td.Datum) -> None:
    with pytest.raises(td.FileError, match="no JSON at byte 1, expected a datum.json"):
        td.extract_datum(POINTS, baseline=SAMPLE)
    with pytest.raises(td.FileError, match="no text, expected a datum.json"):
        td.compare([datum, SAMPLE])


def test_functions_that_are_none(datum: td.Datum) -> None:
    with pytest.raises(TypeError, match="progress = 5, expected a function"):
        td.extract_datum(POINTS, progress=5)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="a function that returns None, expected"):
        td.extract_datum(lambda: None)  # type: ignore[arg-type, return-value]
    with pytest.raises(td.OptionError, match=r"kind, \[\], expected elevation"):
        datum.plot([])  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="axes = 5, expected Axes"):
        datum.plot("plan", 5)  # type: ignore[arg-type]


def test_a_copy_through_pickle_cannot_be_changed_either(datum: td.Datum) -> None:
    copied = pickle.loads(pickle.dumps(datum))
    assert copied == datum
    for array in (copied.stations, copied.edge_points, copied.shell_points):
        assert not array.flags.writeable


def test_small_blocks_of_one_buffer_are_the_points(datum: td.Datum) -> None:
    """They are joined, so what the caller writes over is copied before."""
    buffer = np.empty((1000, 3))

    def blocks() -> Iterator[Any]:
        for begin in range(0, len(POINTS), len(buffer)):
            rows = POINTS[begin : begin + len(buffer)]
            buffer[: len(rows)] = rows
            yield buffer[: len(rows)]
            buffer[:] = 0.0

    assert td.extract_datum(blocks) == datum


def test_setups_of_small_blocks_stay_with_their_points() -> None:
    around = POINTS[np.argsort(np.arctan2(POINTS[:, 1], POINTS[:, 0]))]
    parts = np.array_split(around, 300)
    setup_of = [(i * 7 // 300 + i % 2) % 7 for i in range(300)]  # each sees 100 degrees

    def blocks(whole: bool) -> Iterator[Any]:
        for rows, setup in zip(parts, setup_of, strict=True):
            yield rows, np.full(len(rows), setup) if whole else setup

    with_numbers = td.extract_datum(lambda: blocks(False))
    assert with_numbers == td.extract_datum(lambda: blocks(True))
    assert len(with_numbers.setups) == 7
    setups = np.repeat(setup_of, [len(rows) for rows in parts])
    assert with_numbers == td.extract_datum(lambda: [(around, setups)])


@pytest.mark.parametrize("scale", [1e8, 1e12, 1e39])
def test_a_scan_in_no_unit_ends(scale: float) -> None:
    """Tables by height were of the scan's size: hours, or all memory."""
    datum = td.extract_datum(scale * POINTS)
    assert datum.status == "ok" and "is the scan in mm?" in datum.message


def test_an_open_file_is_no_blocks() -> None:
    """Its lines are no paths."""
    with SAMPLE.open("rb") as file, pytest.raises(TypeError, match="expected an array of shape"):
        td.extract_datum(file)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    "call",
    [
        lambda n: td.stages.normals(POINTS, search=5),  # type: ignore[arg-type]
        lambda n: td.stages.candidates(None),  # type: ignore[arg-type]
        lambda n: td.stages.candidates(n._replace(normals=n.normals.astype(complex))),
        lambda n: td.stages.candidates(n._replace(normals=n.normals.astype(str))),
        lambda n: td.stages.edge_points(POINTS, [0], tank=5),  # type: ignore[arg-type]
        lambda n: td.stages.edge_points(POINTS, [0], tank=()),  # type: ignore[arg-type]
        lambda n: td.compare_curves(np.zeros((99, 2), complex)),
        lambda n: td.extract_datum(POINTS, heights=np.array(5)),
        lambda n: td.extract_datum(POINTS, tank=np.array(5)),
        lambda n: td.extract_datum(POINTS, k="x" * 10_000),
    ],
    ids=[
        "search",
        "found",
        "complex",
        "texts",
        "tank",
        "no tank",
        "line",
        "heights",
        "tank 0-d",
        "long",
    ],
)
def test_other_types_are_refused_in_a_line(call: Callable[[Any], object]) -> None:
    with pytest.raises(TypeError, match="^[a-z]+ = .*, expected ") as refused:
        call(td.stages.normals(POINTS[:50], 5))
    assert len(str(refused.value)) < 250


@pytest.mark.parametrize("path", ["a\0b", "a\ud800"], ids=["nul", "surrogate"])
@pytest.mark.parametrize("name", ["baseline", "limits", "about", "setup_origins"])
def test_options_that_are_no_path(name: str, path: str) -> None:
    with pytest.raises(td.OptionError, match="expected a path, or None") as refused:
        td.extract_datum(POINTS, **{name: path})  # type: ignore[arg-type]
    assert refused.value.name == name


def test_a_comparison_is_shown_in_a_line(datum: td.Datum) -> None:
    compared = td.compare([datum, datum])
    assert repr(compared) == "<tank_datum.Comparison of 2 surveys, rates in m/survey>"
    with pytest.raises(TypeError, match="epochs = <tank_datum.Comparison of 2"):
        td.compare([datum, compared])  # type: ignore[list-item]


def test_a_setup_beyond_all_numbers_has_its_parts() -> None:
    with pytest.raises(td.OptionError, match="setup -1 to -1, expected a number") as refused:
        td.extract_datum([(POINTS, -1)])
    assert (refused.value.name, refused.value.stage) == ("points", "options")
