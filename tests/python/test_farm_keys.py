"""What src/doc/farm.md says of a campaign's file is what is read."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from conftest import ROOT
from farm_made import require_farm

require_farm()

from tank_datum.farm import read_campaign  # noqa: E402

from test_farm_campaign import GOOD, refusals  # noqa: E402


def page() -> str:
    return (ROOT / "src/doc/farm.md").read_text()


def test_the_campaign_of_the_page_is_good(tmp_path: Path) -> None:
    path = tmp_path / "farm.toml"
    path.write_text(re.findall(r"^```toml\n(.*?)^```", page(), re.M | re.S)[0])
    read = read_campaign(path)
    assert [survey.levelled for survey in read.surveys] == [False, True]


@pytest.mark.parametrize("table", ["tank", "scan", "levelling"])
def test_every_key_is_on_the_page(tmp_path: Path, table: str) -> None:
    """Those that a wrong key is told of, and no others."""
    found = refusals(tmp_path / "farm.toml", GOOD + f"[[{table}]]\nwrong = 1\n")
    told = next(line for line in found if f"{table}.wrong" in line)
    known = set(told.partition("expected one of: ")[2].split(", "))
    rows = page().partition(f"| key of `[[{table}]]` |")[2].partition("\n\n")[0]
    said = {
        key for row in rows.split("\n")[2:] for key in re.findall(r"`(\w+)`", row.split("|")[1])
    }
    if table == "levelling":
        said |= known - {"file", "above_datum", "elevation_error"}
    assert said == known
