"""The Python API over arrays: results that are kept, compared and loaded, and what may be given."""

from __future__ import annotations

import copy
import errno
import inspect
import pickle
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from conftest import ROOT
from module_fixtures import same
from results import Array

tank_datum = pytest.importorskip("tank_datum", reason="the module is not installed")

SAMPLE = ROOT / "tests" / "data" / "sample.pcd"


# ---- a result is kept ----


def test_saved_files_are_the_commands(datum: Any, command: Path, tmp_path: Path) -> None:
    datum.save(tmp_path / "out")
    for file in sorted(command.iterdir()):
        assert (tmp_path / "out" / file.name).read_bytes() == file.read_bytes(), file.name


def test_saving_keeps_what_is_not_its_own(datum: Any, tmp_path: Path) -> None:
    (tmp_path / "notes.txt").write_text("mine")
    (tmp_path / "datum.json").write_text("mine too")
    datum.save(tmp_path)
    assert (tmp_path / "notes.txt").read_text() == "mine"
    assert any(path.read_bytes() == b"mine too" for path in tmp_path.iterdir())
    assert tank_datum.load(tmp_path) == datum


def test_loaded_is_equal(datum: Any, command: Path, tmp_path: Path) -> None:
    for path in (command, command / "datum.json"):
        loaded = tank_datum.load(path)
        assert loaded == datum and hash(loaded) == hash(datum)
        assert loaded.files().keys() == datum.files().keys()
    loaded.report(tmp_path / "page.html")
    assert (tmp_path / "page.html").read_bytes() == (command / "report.html").read_bytes()
    assert "verdict        INCOMPLETE: " in loaded.summary()


def test_datum_json_alone(datum: Any, tmp_path: Path) -> None:
    (tmp_path / "spring.json").write_text(datum.to_json())
    loaded = tank_datum.load(tmp_path / "spring.json")
    assert loaded.to_dict() == datum.to_dict() and loaded != datum
    for name in ("azimuth_deg", "z", "sigma_z", "flag"):
        same(loaded.stations[name], datum.stations[name])
    same(loaded.covariance(), datum.covariance())
    with pytest.raises(tank_datum.OptionError, match="report.html, not with the result loaded"):
        loaded.report(tmp_path / "page.html")


@pytest.mark.parametrize("way", ["pickle", "copy", "deepcopy"])
def test_copies_are_equal(datum: Any, way: str) -> None:
    ways = {
        "pickle": lambda: pickle.loads(pickle.dumps(datum)),
        "copy": lambda: copy.copy(datum),
        "deepcopy": lambda: copy.deepcopy(datum),
    }
    other = ways[way]()
    assert other == datum and other is not datum
    assert other.summary() == datum.summary() and other.tilt.slope == datum.tilt.slope


def test_another_result_is_not_equal(datum: Any) -> None:
    other = copy.deepcopy(datum)
    other.stations = other.stations.copy()
    other.stations["z"][5] += 1e-9
    assert other != datum and datum != "datum"


def test_keys_are_attributes(datum: Any) -> None:
    assert datum.tilt.slope == datum.tilt["slope"]
    assert datum.verdict.word == "INCOMPLETE"
    assert datum.checks[0].code == datum.to_dict()["checks"][0]["code"]
    with pytest.raises(AttributeError, match="Tilt has no 'height'"):
        _ = datum.tilt.height
    assert pickle.loads(pickle.dumps(datum.tilt)) == datum.tilt


def test_shell_points_are_shell_csv(datum: Any, command: Path) -> None:
    rows = np.genfromtxt(command / "shell.csv", delimiter=",", names=True)
    assert datum.shell_points.dtype.names == rows.dtype.names
    for name in rows.dtype.names:
        same(datum.shell_points[name], rows[name])


def test_shown_in_a_notebook(datum: Any) -> None:
    page = datum._repr_html_()
    assert "<strong>INCOMPLETE</strong>" in page and "<svg" in page
    assert page.count(",") > 360  # a point a station
    other = copy.deepcopy(datum)
    other._record["message"] = "<b>"
    assert "<b>" not in other._repr_html_()


def test_plots(datum: Any) -> None:
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    drawn = [line.get_ydata() for line in datum.plot().lines]
    z = datum.stations["z"]
    np.testing.assert_allclose(drawn[0], 1e3 * (z - z.mean()), atol=1e-9)
    for kind in ("out_of_plane", "sigma", "plan", "residuals", "roundness", "covariance"):
        assert datum.plot(kind).has_data(), kind
    for kind, why in (("movement", "not compared"), ("plumbness", "two heights")):
        with pytest.raises(tank_datum.OptionError, match=why):
            datum.plot(kind)
    with pytest.raises(tank_datum.OptionError, match="plot: kind, pie, expected elevation, "):
        datum.plot("pie")
    plt.close("all")


def test_frame_of_pandas(datum: Any) -> None:
    pytest.importorskip("pandas")
    frame = datum.to_pandas()
    assert list(frame.columns) == list(datum.stations.dtype.names)
    same(frame["z"], datum.stations["z"])


# ---- what may be given ----


@pytest.mark.parametrize("kind", [">f8", ">f4", "<f8", "longdouble"])
def test_other_floats_give_the_same(datum: Any, points: Array, kind: str) -> None:
    same(tank_datum.extract_datum(points.astype(kind)).stations["z"], datum.stations["z"])


@pytest.mark.parametrize("kind", ["i4", ">i8", "u2", "f2"])
def test_integers_and_halves_are_converted(points: Array, kind: str) -> None:
    given = (points * 1000 + 8000 if kind != "f2" else points).astype(kind)
    units = "mm" if kind != "f2" else "m"
    got = tank_datum.extract_datum(given, units=units)
    wanted = tank_datum.extract_datum(given.astype(np.float64), units=units)
    assert got.tank is not None and got == wanted


def test_masked_rows_are_dropped(datum: Any, points: Array) -> None:
    holes = np.ma.masked_array(np.insert(points, [5, 700], 1.0, axis=0), mask=False)
    holes[5, 1] = holes[701] = np.ma.masked
    assert tank_datum.extract_datum(holes) == tank_datum.extract_datum(points)


def test_blocks_of_an_iterator_are_one_scan(points: Array) -> None:
    def blocks() -> Iterator[Array]:
        yield from np.array_split(points, 301)

    assert tank_datum.extract_datum(blocks()) == tank_datum.extract_datum(points)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (np.zeros((7, 2), ">i2"), "shape (7, 2) in >i2"),
        (np.zeros(9), "shape (9,) in float64"),
        (np.zeros((4, 3), complex), "shape (4, 3) in complex128"),
        (np.zeros((4, 3), bool), "shape (4, 3) in bool"),
        (np.array([["a", "b", "c"]]), "shape (1, 3) in <U1"),
    ],
    ids=["two columns", "one dimension", "complex", "bool", "text"],
)
def test_shape_errors_say_what_was_given(given: Any, said: str) -> None:
    with pytest.raises(TypeError) as caught:
        tank_datum.extract_datum(given)
    assert f"points = an array of {said}, expected an array of shape (n, 3)" in str(caught.value)


def test_progress_tells_rows(points: Array) -> None:
    told: list[tuple[str, int, int]] = []
    tank_datum.extract_datum(
        points, progress=lambda stage, rows, total: told.append((stage, rows, total))
    )
    assert {total for _, _, total in told} == {len(points)}
    assert [stage for stage, rows, _ in told if rows == 0][:3] == ["locate", "crop", "setups"]
    assert max(rows for _, rows, _ in told) == len(points)


# ---- errors ----


def test_option_errors_carry_their_parts() -> None:
    with pytest.raises(tank_datum.OptionError) as caught:
        tank_datum.extract_datum(SAMPLE, k=2)
    error = pickle.loads(pickle.dumps(caught.value))
    assert (error.stage, error.name, error.value, error.expected) == ("options", "k", "2", ">= 3")
    assert str(error) == "options: k, 2, expected >= 3"


def test_file_errors_carry_number_and_name(tmp_path: Path) -> None:
    missing = tmp_path / "none of these.pcd"
    for call in (tank_datum.extract_datum, tank_datum.load):
        with pytest.raises(OSError) as caught:
            call(missing)
        assert caught.value.errno == errno.ENOENT
        assert caught.value.filename == str(missing)
    short = tmp_path / "short.pcd"
    short.write_bytes(SAMPLE.read_bytes()[:4000])
    with pytest.raises(tank_datum.FileError) as caught:
        tank_datum.extract_datum(short)
    assert (caught.value.errno, caught.value.filename) == (None, str(short))
    assert caught.value.stage == "io"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("[", "Expecting value"),
        ("{}", "other JSON"),
        ('{"schema": 2, "status": "ok", "input": {}}', "schema 2"),
        ('{"schema": 0, "status": "ok", "input": {}}', "schema 0"),
    ],
)
def test_loading_other_files_is_refused(tmp_path: Path, text: str, said: str) -> None:
    (tmp_path / "datum.json").write_text(text)
    with pytest.raises(tank_datum.FileError, match=said):
        tank_datum.load(tmp_path)


def test_signature_and_help_list_every_option() -> None:
    signature = inspect.signature(tank_datum.extract_datum)
    defaults = tank_datum.defaults()
    assert {n: p.default for n, p in signature.parameters.items() if n in defaults} == defaults
    for name, value in defaults.items():
        assert (
            f"; default {value!r}\n" in tank_datum.extract_datum.__doc__.split(f"    {name}: ")[1]
        )
