"""Surveys that share a part of the ring."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from test_compare import compare, epoch


@pytest.mark.parametrize(("seen", "said"), [(170, True), (190, False)], ids=["less", "more"])
def test_less_than_half_of_the_ring_is_said_to_be_extrapolated(
    tmp_path: Path, seen: int, said: bool
) -> None:
    surveys = [epoch(tmp_path / f"{i}.json", 0.002 * i) for i in range(2)]
    survey = json.loads(surveys[1].read_text())
    for station in survey["stations"]:
        if station["azimuth_deg"] > seen:
            station |= {"z": None, "sigma_z": None, "flag": "missing"}
    surveys[1].write_text(json.dumps(survey))
    done = compare(*surveys, "-o", tmp_path / "m")
    assert done.returncode == 0
    assert ("less than half of the ring" in done.stdout) is said
    whole = compare(surveys[0], epoch(tmp_path / "2.json", 0.002), "-o", tmp_path / "w")
    assert "half of the ring" not in whole.stdout
