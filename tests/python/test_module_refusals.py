"""What the Python module refuses: by name, in one line, and without harm to the interpreter."""

from __future__ import annotations

import os
import pickle
import shutil
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from module_fixtures import two_setups
from report_pages import SAMPLE

tank_datum = pytest.importorskip("tank_datum", reason="the module is not installed")
stages = tank_datum.stages if tank_datum else None
CLOUD = np.random.default_rng(1).random((200, 3))


def with_one(value: float) -> Any:
    cloud = CLOUD.copy()
    cloud[7, 1] = value
    return cloud


WRONG: dict[str, tuple[Callable[[], Any], type[Exception], str]] = {
    "far": (lambda: stages.normals(with_one(1e39)), ValueError, "row 7 of points"),
    "far buckets": (
        lambda: stages.normals(with_one(1e12), search="buckets"),
        ValueError,
        "row 7 of points",
    ),
    "k fraction": (lambda: stages.normals(CLOUD, 3.5), TypeError, "k = 3.5, expected a whole"),
    "k truth": (lambda: stages.normals(CLOUD, True), TypeError, "k = True, expected a whole"),
    "k large": (lambda: stages.normals(CLOUD, 2**40), ValueError, "options: k, 1099511627776"),
    "mask": (
        lambda: stages.edge_points(CLOUD, np.ones(200, bool)),
        TypeError,
        "candidates = an array of shape (200,) in bool",
    ),
    "fractions": (
        lambda: stages.edge_points(CLOUD, np.array([0.5])),
        TypeError,
        "in float64, expected whole numbers",
    ),
    "wide index": (
        lambda: stages.edge_points(CLOUD, np.array([2**32])),
        ValueError,
        "stages: candidates, 4294967296",
    ),
    "tank": (
        lambda: stages.edge_points(CLOUD, np.array([0]), tank=(0, 0, -5)),
        ValueError,
        "options: tank, 0,0,-5",
    ),
    "tank nan": (
        lambda: stages.edge_points(CLOUD, np.array([0]), tank=(0, 0, np.nan)),
        ValueError,
        "options: tank, 0,0,nan",
    ),
    "scene": (
        lambda: tank_datum.simulate({"scanner": {"step": float("inf")}}),
        ValueError,
        "scene: scene.scanner.step, not finite",
    ),
    "threads": (lambda: tank_datum.simulate({}, threads=-1), ValueError, "threads, -1"),
    "line": (lambda: tank_datum.compare_curves("abc"), TypeError, "line = 'abc', expected"),
    "height": (
        lambda: tank_datum.extract_datum(CLOUD, height="26 cubits"),
        ValueError,
        "options: height, 26 cubits, expected a length as 8, 8m, 26.25ft",
    ),
    "clockwise": (
        lambda: tank_datum.extract_datum(CLOUD, clockwise=2),
        TypeError,
        "clockwise = 2, expected True or False",
    ),
    "baseline": (
        lambda: tank_datum.extract_datum(CLOUD, baseline=""),
        ValueError,
        'options: baseline, "", expected a path',
    ),
}


@pytest.mark.parametrize("case", WRONG)
def test_wrong_arguments_are_refused_by_name(case: str) -> None:
    call, kind, said = WRONG[case]
    with pytest.raises(kind) as caught:
        call()
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)


def test_dates_of_all_kinds_are_taken(datum: Any) -> None:
    texts = tank_datum.compare([datum, datum], dates=["2020-01-01", "2021-06-01"])
    for dates in (
        np.array(["2020-01-01", "2021-06-01"], dtype="datetime64[D]"),
        iter(["2020-01-01", "2021-06-01"]),
    ):
        made = tank_datum.compare(iter([datum, datum]), dates=dates)
        assert (made.dates, made) == (texts.dates, texts)
    assert "0 of 360 stations moved" in made._repr_html_()
    with pytest.raises(TypeError, match="dates = None, expected"):
        tank_datum.compare([datum, datum], dates=[None, None])
    with pytest.raises(tank_datum.OptionError, match="dates, 3, expected"):
        tank_datum.compare([datum, datum], dates=["2020", "2021", "2022"])


def test_a_height_has_a_unit_and_arrays_are_heights() -> None:
    made = tank_datum.extract_datum(SAMPLE, height="26ft", heights=np.array([0.3, 0.5]))
    assert made.options["analysis"]["height"] == pytest.approx(26 * 0.3048)
    assert made.options["shell"]["heights"] == [0.3, 0.5]


def test_equal_results_of_stages_are_equal() -> None:
    same, other = stages.normals(CLOUD), stages.normals(CLOUD, 5)
    assert stages.normals(CLOUD) == same
    assert same != other
    turn = np.linspace(0.0, 2.0 * np.pi, 36, endpoint=False)
    ring = np.column_stack([5.0 * np.cos(turn), 5.0 * np.sin(turn), 0.0 * turn])
    near = [stages.edge_points(ring, np.arange(n), tank=(0, 0, 5)) for n in (36, 36, 35)]
    assert len(near[0].indices) == 36
    assert near[0] == near[1]
    assert near[0] != near[2]


def test_arrays_of_a_result_are_its_files() -> None:
    made = tank_datum.extract_datum(SAMPLE)
    for array in (made.stations, made.edge_points, made.shell_points):
        assert not array.flags.writeable
    changed = made.stations.copy()
    changed["z"] = 0.0
    assert made.to_pandas()["z"].iloc[0] != 0.0


def test_blocks_with_setups_may_be_a_list_or_an_iterator(points: Any) -> None:
    blocks = [(seen, setup) for setup, seen in enumerate(two_setups(points), 1)]
    made = [tank_datum.extract_datum(given) for given in (blocks, iter(blocks), lambda: blocks)]
    assert len(made[0].setups) == 2
    assert made[0].setups[0].dz == made[1].setups[0].dz == made[2].setups[0].dz


def test_names_that_are_no_utf_8_work(tmp_path: Path, datum: Any) -> None:
    folder = os.fsdecode(os.fsencode(tmp_path) + b"/of \xff in")
    os.mkdir(folder)
    scan, out = os.path.join(folder, "scan of.pcd"), os.path.join(folder, "out")
    shutil.copy(SAMPLE, scan)
    made = tank_datum.extract_datum(scan)
    made.save(out)
    loaded = tank_datum.load(out)
    assert loaded == made
    tank_datum.compare([loaded, out]).save(os.path.join(folder, "moved"))
    again = tank_datum.extract_datum(scan, baseline=out)
    assert again.movement.matched == 360
    with pytest.raises(tank_datum.FileError) as caught:
        tank_datum.extract_datum(os.path.join(folder, "none of.pcd"))
    str(caught.value).encode("utf-8")
    for error in (caught.value, pickle.loads(pickle.dumps(caught.value))):
        assert error.filename == os.path.join(folder, "none of.pcd")
        assert error.errno == 2


LONG = {
    "normals": "stages.normals(np.random.default_rng(1).random((3_000_000, 3)))",
    "simulate": "tank_datum.simulate({})",
    "simulate a file": "tank_datum.simulate({}, 'scan.pcd')",
}


@pytest.mark.parametrize("call", LONG)
def test_ctrl_c_ends_long_calls(call: str, tmp_path: Path) -> None:
    """How long it takes is no matter here, but that the call ends by it and leaves nothing."""
    program = (
        "import signal, sys, numpy as np, tank_datum\n"
        "from tank_datum import stages\n"
        "signal.signal(signal.SIGINT, signal.default_int_handler)\n"  # a shell's job ignores it
        "print('ready', flush=True)\n"
        f"try:\n    {LONG[call]}\n"
        "except KeyboardInterrupt:\n    sys.exit(7)\n"
    )
    process = subprocess.Popen(
        [sys.executable, "-c", program], cwd=tmp_path, stdout=subprocess.PIPE
    )
    assert process.stdout is not None and process.stdout.readline() == b"ready\n"
    try:
        process.wait(0.5)
    except subprocess.TimeoutExpired:
        process.send_signal(signal.SIGINT)
    assert process.wait(60) == 7
    process.stdout.close()
    assert list(tmp_path.iterdir()) == []
