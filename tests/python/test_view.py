"""The viewer on a virtual display: what it draws, and what it says when it cannot."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path

import matplotlib.image
import numpy as np
import pytest
from numpy.typing import NDArray

from conftest import ROOT
from results import Run, read_points, write_xyz

Pixels = NDArray[np.float64]
VIEWER = Path(os.environ.get("TANK_DATUM_BIN", ROOT / "build" / "bin")) / "tank_datum_view"
SAMPLE = ROOT / "tests" / "data" / "sample.pcd"
RGB = {"curve": (0.2, 1.0, 0.5), "picked": (1.0, 0.2, 1.0), "edge": (1.0, 0.75, 0.1)}


pytestmark = pytest.mark.skipif(not VIEWER.exists(), reason="tank_datum_view is not built")


@pytest.fixture(scope="module")
def display() -> Iterator[str]:
    """A virtual X display."""
    read, write = os.pipe()
    command = ["Xvfb", "-displayfd", str(write), "-screen", "0", "1400x900x24"]
    with subprocess.Popen(command, pass_fds=[write], stderr=subprocess.DEVNULL) as server:
        os.close(write)
        with os.fdopen(read) as number:
            name = number.readline().strip()
        yield f":{name}"
        server.terminate()


@pytest.fixture(scope="module")
def folder(run: Callable[..., Run], tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Results of the sample."""
    out = tmp_path_factory.mktemp("view") / "out"
    assert run(SAMPLE, "-o", out).returncode == 0
    return out


def view(display: str | None, *args: object) -> Run:
    environment = {k: v for k, v in os.environ.items() if k != "DISPLAY"}
    if display is not None:
        environment["DISPLAY"] = display
    command = [str(VIEWER), *map(str, args)]
    return subprocess.run(command, capture_output=True, text=True, env=environment, timeout=120)


@pytest.fixture(scope="module")
def shot(
    display: str, folder: Path, tmp_path_factory: pytest.TempPathFactory
) -> Callable[..., Pixels]:
    """shot(*options, path=folder): the pixels of a screenshot, rows x columns x RGB."""

    png = tmp_path_factory.mktemp("shots") / "shot.png"

    def call(*args: object, path: Path = folder) -> Pixels:
        result = view(display, path, "--screenshot", png, *args)
        assert (result.returncode, result.stdout, result.stderr) == (0, "", "")
        pixels = np.asarray(matplotlib.image.imread(png), dtype=np.float64)[:, :, :3]
        png.unlink()
        return pixels

    return call


@pytest.fixture(scope="module")
def plain(shot: Callable[..., Pixels]) -> Pixels:
    """The picture without any option."""
    return shot()


def count(pixels: Pixels, name: str) -> int:
    return int((np.abs(pixels - RGB[name]).max(axis=2) < 0.02).sum())


def shaded(pixels: Pixels, name: str) -> int:
    """How many pixels have a colour, or one that eye-dome lighting darkened."""
    brightness = pixels.max(axis=2, keepdims=True)
    hue = pixels / np.maximum(brightness, 1e-6)
    wanted = np.array(RGB[name]) / max(RGB[name])
    return int(((np.abs(hue - wanted).max(axis=2) < 0.03) & (brightness[:, :, 0] > 0.3)).sum())


def changed(a: Pixels, b: Pixels) -> int:
    return int((np.abs(a - b).max(axis=2) > 0.02).sum())


def test_everything_is_drawn(shot: Callable[..., Pixels], plain: Pixels) -> None:
    pixels = shot("--station", 30)
    assert pixels.shape == (800, 1280, 3)
    assert len(np.unique(pixels.reshape(-1, 3), axis=0)) > 200
    assert count(pixels, "curve") > 300
    assert count(pixels, "picked") > 50
    assert shaded(pixels, "edge") > 150  # the curve lies over some
    assert changed(pixels, plain) > 500  # the values and the mark


def test_points_before_others_are_set_off(shot: Callable[..., Pixels]) -> None:
    """Eye-dome lighting leaves pixels darker than every colour of the cloud, above the ground."""
    brightness = shot("--keys", "etld").max(axis=2)
    assert ((brightness > 0.13) & (brightness < 0.35)).sum() > 2000


def test_the_colours_key_is_read_beside_the_shading(shot: Callable[..., Pixels]) -> None:
    """The figures of its ticks, in white, where the cloud is on and where it is off."""
    corner = (slice(700, 760), slice(690, 1280))
    white = [(shot(*keys)[corner].min(axis=2) > 0.8).sum() for keys in ((), ("--keys", "c"))]
    assert white[0] > 150 and white[1] < white[0] / 4


def test_the_cloud_does_not_hide_the_datum(shot: Callable[..., Pixels], plain: Pixels) -> None:
    assert count(plain, "curve") > 0.95 * count(shot("--keys", "c"), "curve")


@pytest.mark.parametrize(
    ("option", "value", "least"),
    [
        ("--colour", "radial", 5000),
        ("--colour", "distance", 5000),
        ("--range", 0.02, 5000),
        ("--exaggeration", 100, 2000),
        ("--points", 2000, 5000),
        ("--labels", 0, 500),
        ("--station", 200, 500),
        ("--scan", "thin", 2000),
        *(("--keys", key, 500) for key in "23+-cedtlh"),
    ],
)
def test_options_and_keys_change_the_picture(
    shot: Callable[..., Pixels],
    plain: Pixels,
    tmp_path: Path,
    option: str,
    value: object,
    least: int,
) -> None:
    if value == "thin":
        value = write_xyz(tmp_path / "thin.pcd", np.array([[5.0, 0, 0], [0, 5.0, 0.3]]))
    assert changed(plain, shot(option, value)) > least


def test_a_screenshot_replaces_only_one_of_its_own(
    display: str, folder: Path, tmp_path: Path
) -> None:
    png = tmp_path / "shot.png"
    png.write_text("mine")
    first = view(display, folder, "--screenshot", png)
    assert first.returncode == 0
    assert first.stderr.endswith(f"kept as {tmp_path}/shot.kept.png\n")
    assert view(display, folder, "--screenshot", png).stderr == ""
    assert (tmp_path / "shot.kept.png").read_text() == "mine"
    assert sorted(p.name for p in tmp_path.iterdir()) == ["shot.kept.png", "shot.png"]
    scan = write_xyz(tmp_path / "scan.pcd", np.array([[5.0, 0, 0], [0, 5.0, 0.3]]))
    (tmp_path / "link.png").symlink_to(scan)
    refused = view(display, folder, "--scan", scan, "--screenshot", tmp_path / "link.png")
    assert (refused.returncode, refused.stderr.count("\n")) == (2, 1)
    assert "this is the scan" in refused.stderr


def test_keys_undo(shot: Callable[..., Pixels], plain: Pixels) -> None:
    """Twice is back; a layer hidden stays hidden when it is drawn anew."""
    assert changed(plain, shot("--keys", "+-ccddttllhh231r")) < 10  # rounding of the camera
    assert count(shot("--keys", "d"), "curve") == 0
    assert count(shot("--keys", "d+"), "curve") == 0


def test_a_scan_is_seen_as_its_results_are(shot: Callable[..., Pixels], plain: Pixels) -> None:
    assert changed(plain, shot(path=SAMPLE)) < 200


def test_units_are_those_of_a_scan(display: str, tmp_path: Path) -> None:
    png = tmp_path / "a.png"
    result = view(display, SAMPLE, "--units", "mm", "--screenshot", png)  # a tank of 5 mm is none
    assert result.returncode == 1
    assert result.stderr.startswith("tank_datum_view: no_tank: ")
    assert result.stderr.count("\n") == 1
    assert not png.exists()


@pytest.mark.parametrize("name", [None, ":987"], ids=["none", "dead"])
def test_without_a_display(folder: Path, name: str | None) -> None:
    result = view(name, folder)
    assert result.returncode == 2
    assert result.stderr.startswith("tank_datum_view: view: DISPLAY, ")
    assert result.stderr.count("\n") == 1


def test_on_paper_it_is_light_and_of_the_tank_alone(
    display: str, run: Callable[..., Run], shot: Callable[..., Pixels], tmp_path: Path
) -> None:
    """White, with dark words; a hill beside the tank is left out."""
    points = read_points(SAMPLE)
    hill = np.random.default_rng(1).uniform((6.5, -2, -0.1), (9, 2, 3), (5000, 3))
    scan = write_xyz(tmp_path / "hill.pcd", np.vstack([points, hill]))
    assert run(scan, "-o", tmp_path / "out").returncode == 0
    paper, screen = shot("--paper", path=tmp_path / "out"), shot(path=tmp_path / "out")
    assert (paper.min(axis=2) > 0.99).mean() > 0.6 and (screen.min(axis=2) > 0.99).mean() < 0.05
    ink = (paper[:100].max(axis=2) < 0.2).sum()  # of the words there, which paper has larger
    assert 1500 < ink < 5500
    colours = [(p.max(axis=2) - p.min(axis=2) > 0.3).sum() for p in (paper, screen)]
    assert colours[0] < 0.8 * colours[1]


@pytest.mark.parametrize(
    ("args", "status", "part"),
    [
        (["--colour", "taste"], 2, "--colour"),
        (["--units", "cubit"], 2, "--units"),
        (["--range", -1], 2, "--range, -1"),
        (["--exaggeration", 0], 2, "--exaggeration, 0"),
        (["--points", 10], 2, "--points, 10"),
        (["--labels", -2], 2, "--labels, -2"),
        (["--station", 360], 2, "--station, 360"),
        (["--station", -5], 2, "--station, -5"),
        (["--keys", "?"], 2, "--keys, ?"),
        (["--scan", "/none.pcd"], 3, "/none.pcd"),
        (["--screenshot", "a.jpg"], 2, "--screenshot, a.jpg"),
        (["--paper"], 2, "--paper, given"),
        (["--screenshot", ""], 2, "--screenshot, an empty value"),
        (["--screenshot", "/none/a.png"], 3, "/none/a.png"),
    ],
)
def test_refused(
    display: str, folder: Path, tmp_path: Path, args: list[object], status: int, part: str
) -> None:
    alone = "--screenshot" in args or args == ["--paper"]
    shot = [] if alone else ["--screenshot", tmp_path / "a.png"]
    result = view(display, folder, *args, *shot)
    assert result.returncode == status
    assert part in result.stderr
    assert result.stderr.count("\n") == 1


def test_no_results(display: str, tmp_path: Path) -> None:
    result = view(display, tmp_path)
    assert result.returncode == 3
    assert f"{tmp_path}/datum.json" in result.stderr
