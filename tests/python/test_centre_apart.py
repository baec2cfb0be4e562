"""How far a tank is from where it was: in movement.json, on the terminal and on the page."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from report_pages import opened
from test_compare import compare, epoch


def test_a_tank_that_slid_is_said_to(browser: Any, tmp_path: Path) -> None:
    before = epoch(tmp_path / "0.json", 0.0)
    for slid, said in ((0.018, False), (0.022, True)):
        survey = json.loads(before.read_text())
        survey["tank"]["center"][0] += slid
        after = tmp_path / "1.json"
        after.write_text(json.dumps(survey))
        done = compare(before, after, "-o", tmp_path / "m")
        movement = json.loads((tmp_path / "m" / "movement.json").read_text())["movements"][0]
        assert movement["centre_apart"] == pytest.approx(slid, abs=1e-6)
        assert ("the tank slid" in done.stdout) == said
        with opened(browser, tmp_path / "m" / "report.html") as page:
            assert ("the tank slid" in page.text("#trend .verdict")) == said
