"""The pictures for documents: of a whole result, one with gaps, one of no tank, and broken ones."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import matplotlib.image
import numpy as np
import pytest

from conftest import ROOT
from results import Run, write_pcd, write_xyz

sys.path.insert(0, str(ROOT / "scripts"))
from length_units import METRES  # noqa: E402
from plot_figures import curve_residuals, elevation  # noqa: E402
from plot_result import PlotError, read_cloud, read_pcd, read_result  # noqa: E402

SAMPLE = ROOT / "tests" / "data" / "sample.pcd"
PICTURES = ("cloud", "datum_points", "residuals", "elevation")
Runner = Callable[..., Run]


def plot(*args: object) -> Run:
    command = [sys.executable, str(ROOT / "scripts" / "plot.py"), *map(str, args)]
    return subprocess.run(command, capture_output=True, text=True, timeout=120)


def pages(pdf: Path) -> int:
    return len(re.findall(rb"/Type /Page\b", pdf.read_bytes()))


@pytest.fixture(scope="module")
def whole(run: Runner, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Results of the sample."""
    out = tmp_path_factory.mktemp("plot") / "out"
    assert run(SAMPLE, "-o", out).returncode == 0
    return out


@pytest.fixture
def copy(whole: Path, tmp_path: Path) -> Path:
    """A copy to spoil."""
    return Path(shutil.copytree(whole, tmp_path / "copy"))


@pytest.fixture
def gap(run: Runner, tmp_path: Path) -> Path:
    """Results of the sample without its points from 100 to 130 and from 200 to 205 deg."""
    points = read_pcd(SAMPLE, 10**9)
    azimuth = np.mod(np.degrees(np.arctan2(points[:, 1], points[:, 0])), 360)
    seen = ~((azimuth > 100) & (azimuth < 130)) & ~((azimuth > 200) & (azimuth < 205))
    scan = write_xyz(tmp_path / "gap.pcd", points[seen])
    assert run(scan, "-o", tmp_path / "gap").returncode == 0
    return tmp_path / "gap"


def test_of_a_whole_result(whole: Path, tmp_path: Path) -> None:
    result = plot(whole, "-o", tmp_path)
    assert (result.returncode, result.stdout, result.stderr) == (0, "", "")
    wanted = {f"{name}.{kind}" for name in PICTURES for kind in ("pdf", "svg", "png")}
    assert {p.name for p in tmp_path.iterdir()} == wanted | {"manifest.json"}
    for name in PICTURES:
        pixels = matplotlib.image.imread(tmp_path / f"{name}.png")[:, :, :3]
        assert pixels.shape[1] >= 1900  # 170 mm at 300 dpi
        assert (pixels < 0.9).any(axis=2).mean() > 0.01
        assert pages(tmp_path / f"{name}.pdf") == 1
        assert (tmp_path / f"{name}.svg").read_text().rstrip().endswith("</svg>")


def test_same_bytes_beside_the_results_as_in_a_folder(copy: Path, tmp_path: Path) -> None:
    assert plot(copy, "-o", tmp_path / "a", "--formats", "svg").returncode == 0
    assert plot(copy, "--formats", "svg").returncode == 0
    names = sorted(p.name for p in (tmp_path / "a").iterdir())
    assert names == sorted([*(f"{name}.svg" for name in PICTURES), "manifest.json"])
    for name in set(names) - {"manifest.json"}:
        assert (tmp_path / "a" / name).read_bytes() == (copy / name).read_bytes()


def test_gaps_are_shaded_and_not_bridged(gap: Path, tmp_path: Path) -> None:
    assert plot(gap, "-o", tmp_path / "pics", "--formats", "png").returncode == 0
    result = read_result(gap)
    assert {"missing", "interpolated", "measured"} == set(result.flags)
    above = elevation(result).axes[0]
    labels = [text.get_text() for text in above.get_legend().get_texts()]
    assert "not seen" in labels
    assert "bridged" in labels
    assert len(above.patches) == result.flags.count("missing")
    assert np.isnan(result.at("z", np.array([115.0]))).all()
    assert np.isfinite(result.at("z", np.array([359.7, 0.2, 50.5]))).all()


def test_of_no_tank(run: Runner, tmp_path: Path) -> None:
    ground = np.random.default_rng(1).uniform((-5, -5, 0), (5, 5, 0.1), (5000, 3))
    scan = write_xyz(tmp_path / "ground.pcd", ground)
    assert run(scan, "-o", tmp_path / "out").returncode == 1
    result = plot(tmp_path / "out", "-o", tmp_path / "pics", "--formats", "png")
    assert result.returncode == 1
    assert result.stderr.startswith("plot.py: no_tank: ")
    assert result.stderr.count("\n") == 1
    assert sorted(p.name for p in (tmp_path / "pics").iterdir()) == [
        "cloud.png",
        "manifest.json",
    ]


def test_without_the_scan(copy: Path, tmp_path: Path) -> None:
    """The other pictures are written, and one line says what is not."""
    datum = json.loads((copy / "datum.json").read_text())
    datum["input"]["files"][0]["path"] = "/gone/scan.pcd"
    (copy / "datum.json").write_text(json.dumps(datum))
    result = plot(copy, "-o", tmp_path / "a", "--formats", "svg")
    assert result.returncode == 0
    assert "the cloud is left out" in result.stderr
    assert "scan.pcd" in result.stderr
    assert result.stderr.count("\n") == 1
    assert not (tmp_path / "a" / "cloud.svg").exists()
    assert len(read_cloud(read_result(copy), copy, [SAMPLE])) > 20_000
    shutil.copy(SAMPLE, copy.parent / "scan.pcd")  # beside the folder
    assert len(read_cloud(read_result(copy), copy, [])) > 20_000


@pytest.mark.parametrize("name", ["datum.json", "stations.csv", "datum_points.pcd"])
@pytest.mark.parametrize("text", [None, "", "a,b\n1,2\n", "{}", "\0\xff"])
def test_a_broken_result_is_one_line(copy: Path, name: str, text: str | None) -> None:
    (copy / name).unlink()
    if text is not None:
        (copy / name).write_bytes(text.encode("latin-1"))
    with pytest.raises(PlotError, match=re.escape(name)) as error:
        read_result(copy)
    assert "\n" not in str(error.value)


def test_refused(whole: Path, tmp_path: Path) -> None:
    formats = plot(whole, "--formats", "gif")
    assert formats.returncode == 2
    assert "gif" in formats.stderr
    for args, part in (
        ((tmp_path / "none",), "none/datum.json"),
        ((whole, "--scan", "/none.pcd"), "/none.pcd"),
        ((whole, "-o", "/dev/null/a"), "/dev/null/a"),
    ):
        result = plot(*args)
        assert result.returncode == 3
        assert part in result.stderr
        assert result.stderr.count("\n") == 1


def test_residuals_are_heights_above_the_papers_curve(whole: Path) -> None:
    result = read_result(whole)
    known = curve_residuals(result)
    assert np.isfinite(known).all()
    assert abs(known.mean()) < 0.005  # the curve goes through the points' middle
    i = 40
    x, y, z = (result.columns[n][i] for n in ("x", "y", "z_paper"))
    assert result.at("z_paper", result.azimuth(np.array([[x, y, z]])))[0] == pytest.approx(
        z, abs=1e-4
    )


@pytest.mark.parametrize("args", [(), ("--clockwise", "--zero-azimuth-deg", 90)])
def test_azimuths_are_those_of_the_stations(
    run: Runner, tmp_path: Path, args: tuple[object, ...]
) -> None:
    assert run(SAMPLE, "-o", tmp_path / "out", *args).returncode == 0
    result = read_result(tmp_path / "out")
    stations = np.column_stack([result.columns[name] for name in "xyz"])
    away = result.azimuth(stations) - result.columns["azimuth_deg"]
    assert np.abs(np.mod(away + 180, 360) - 180).max() < 0.1
    assert np.abs(result.radial(stations)).max() < 0.01


@pytest.mark.parametrize("kind", ["ascii", "binary"])
def test_scans_are_thinned(tmp_path: Path, kind: str) -> None:
    count = 1000
    columns = {"x": np.arange(count, dtype="<f4"), "i": np.zeros(count, "<u2")}
    columns |= {"y": np.ones(count, "<f8"), "z": np.full(count, 2, "<f4")}
    columns["z"][10] = np.nan
    path = write_pcd(tmp_path / "a.pcd", columns, data=kind)
    assert len(read_pcd(path, 10_000)) == count - 1
    thin = read_pcd(path, 100)
    assert 90 <= len(thin) <= 100
    assert np.diff(thin[5:, 0]).tolist() == [10.0] * (len(thin) - 6)
    assert (thin[:, 1:] == [1, 2]).all()


def test_compressed_scans_are_refused(tmp_path: Path) -> None:
    path = write_xyz(tmp_path / "a.pcd", np.zeros((3, 3)))
    path.write_bytes(path.read_bytes().replace(b"DATA binary\n", b"DATA binary_compressed\n"))
    with pytest.raises(PlotError, match="binary_compressed"):
        read_pcd(path, 10)


def test_the_scripts_know_the_units_that_the_programs_know() -> None:
    header = (ROOT / "src/core/length_units.h").read_text()
    listed = re.search(r"kUnits = \{(.*?)\};", header, re.DOTALL)
    assert listed is not None
    found = dict(re.findall(r'\{"([\w-]+)", ([^}]+)\}', listed[1]))
    written = {"kMetresPerFoot": 0.3048, "1200.0 / 3937.0": 1200 / 3937}
    assert METRES == {unit: written.get(size) or float(size) for unit, size in found.items()}
