"""Files that Open3D writes: the same stations as of a PCD of the same numbers."""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from programs import TIMEOUT
from results import Array, Run, read_pcd, write_pcd

Runner = Callable[..., Run]
Synth = Callable[..., Path]
PYTHON = "/usr/bin/python3"  # Debian's, which has python3-open3d

WRITE = """
import sys
import numpy, open3d
given, *outs = sys.argv[1:]
points = numpy.load(given)
cloud = open3d.geometry.PointCloud()
cloud.points = open3d.utility.Vector3dVector(points)
cloud.colors = open3d.utility.Vector3dVector(numpy.full(points.shape, 0.5))
cloud.normals = open3d.utility.Vector3dVector(numpy.tile([0.0, 0.6, 0.8], (len(points), 1)))
for out in outs:
    how = {"write_ascii": "ascii" in out, "compressed": "compressed" in out}
    assert open3d.io.write_point_cloud(out, cloud, **how), out
"""

# The numbers that each kind of file holds.
KINDS: dict[str, Callable[[Array], Array]] = {
    "binary.pcd": lambda p: p.astype(np.float32),
    "compressed.pcd": lambda p: p.astype(np.float32),
    "ascii.pcd": lambda p: np.vectorize(lambda v: float(f"{v:.10g}"))(p),
    "binary.ply": lambda p: p,
    "ascii.ply": lambda p: np.vectorize(lambda v: float(f"{v:g}"))(p),
    "scan.pts": lambda p: np.round(p, 10),
    "scan.xyz": lambda p: np.round(p, 10),
    "scan.xyzn": lambda p: np.round(p, 10),
    "scan.xyzrgb": lambda p: np.round(p, 10),
}


@pytest.fixture(scope="module")
def written(synth: Synth, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Array]:
    """The folder of Open3D's files, and the points that it was given."""
    there = subprocess.run([PYTHON, "-c", "import open3d"], capture_output=True, timeout=TIMEOUT)
    if there.returncode != 0:
        pytest.skip(f"{PYTHON} has no open3d")
    folder = tmp_path_factory.mktemp("open3d")
    columns = read_pcd(synth("--double"))
    points = np.stack([columns[n] for n in "xyz"], axis=1)
    np.save(folder / "points.npy", points)
    words = [PYTHON, "-c", WRITE, folder / "points.npy", *(folder / kind for kind in KINDS)]
    subprocess.run(words, check=True, timeout=TIMEOUT)
    return folder, points


@pytest.mark.parametrize("kind", KINDS)
def test_the_same_stations(
    kind: str, written: tuple[Path, Array], run: Runner, tmp_path: Path
) -> None:
    folder, points = written
    columns = dict(zip("xyz", KINDS[kind](points).T, strict=True))
    tables = []
    for path in (write_pcd(tmp_path / "scan.pcd", columns), folder / kind):
        out = tmp_path / f"of_{path.name}"
        made = run(path, "-o", out, "--quiet", "--no-report")
        assert made.returncode == 0, made.stderr
        tables.append((out / "stations.csv").read_bytes())
    assert tables[0] == tables[1]
