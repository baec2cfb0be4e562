"""The bad files of the shared data: refused, or read as scans without a tank."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from results import Run
from test_errors import FILE_FAILED, no_datum, refused

Runner = Callable[..., Run]

# whose points can be read: their faults are in records that no point needs, or there are too few
READABLE = """
pdal_missingheader.pcd xyz_one_point.xyz xyz_all_identical_points.xyz xyz_utf8_bom_header.txt
pdal_duplicates-unsorted.txt pdal_missingheader.txt pdal_spec_3.las pdal_lots_of_vlr.las
pdal_bad_vlr_count.las laspy_unregistered_extra_bytes.las pdal_bad-geotiff-keys.las pdal_prec3.las
pdal_1.2-empty-geotiff-vlrs.las pdal_gps-time-nan.las pdal_wontcompress3.las pdal_no-points.las
pdal_spurious.las
""".split()


def test_bad_collection(run: Runner, data: Path, tmp_path: Path) -> None:
    """Every bad file, whatever its kind, ends with one line and the status of the contract."""
    files = sorted(p for p in (data / "bad").rglob("*") if p.is_file() and p.suffix != ".txt")
    files += sorted((data / "bad").glob("*/*.txt"))
    assert len(files) > 60
    assert set(READABLE) < {file.name for file in files}
    for i, file in enumerate(files):
        out = tmp_path / str(i)
        result = run(file, "-o", out, timeout=20)
        if file.name in READABLE:
            no_datum(result, out, "no_tank", "too_few_points")
        else:
            refused(result, FILE_FAILED, out, file.name, "expected")
