"""Reads a campaign from its TOML file, and checks it whole."""

from __future__ import annotations

import os
import tomllib
from dataclasses import replace
from pathlib import Path
from typing import Any

from tank_datum_qa._regular_file import read_regular, text_of

from tank_datum.farm.campaign import HEIGHTS, Campaign, FarmTank, Limits, Survey
from tank_datum.farm.campaign_checks import check_whole
from tank_datum.farm.errors import CampaignError, Problem
from tank_datum.farm.fields import Reader, Table
from tank_datum.farm.toml_lines import line_numbers

# Beyond these a figure is in another unit.
LARGEST = 500.0  # radius of a tank [m]
WORST, STEEPEST = 0.1, 3600.0  # 1 sigma of heights [m], and of tilts [arcsec]


def read_campaign(path: str | os.PathLike[str]) -> Campaign:
    """Reads and checks a campaign. Raises CampaignError with every reason."""
    try:
        return _checked(Path(path))
    except RecursionError:
        reason = "values too deep in each other, expected a campaign (TOML)"
        raise CampaignError([Problem(str(path), 0, reason)]) from None


def _checked(file: Path) -> Campaign:
    path, content, text = str(file), b"", ""
    try:
        content = read_regular(file)
        text = text_of(content, encoding="utf-8-sig")
        given = tomllib.loads(text)
    except OSError as error:
        reason = f"{error.strerror}, expected a campaign (TOML)"
        raise CampaignError([Problem(path, 0, reason)]) from None
    except UnicodeDecodeError as error:
        line = content[: error.start].count(b"\n") + 1
        reason = f"{error.reason}, expected UTF-8"
        raise CampaignError([Problem(path, line, reason)]) from None
    except ValueError as error:  # of TOML; of Python, for thousands of digits
        raise CampaignError([_syntax(path, text, error)]) from None
    reader = Reader(path, line_numbers(text))
    campaign = _inherited(_campaign(reader, file.resolve(), given))
    check_whole(reader, campaign)
    if reader.problems:
        raise CampaignError(sorted(reader.problems, key=lambda p: p.line))
    return campaign


def _syntax(path: str, text: str, error: ValueError) -> Problem:
    """tomllib says "... (at line 3, column 7)" or "... (at end of document)"."""
    said, _, place = str(error).rpartition(" (at ")
    number = place.removeprefix("line ").partition(",")[0]
    line = int(number) if number.isdigit() else text.count("\n") + 1
    return Problem(path, line, f"{said or error}, expected TOML")


def _campaign(reader: Reader, path: Path, given: dict[str, Any]) -> Campaign:
    top = reader.table(given, ())
    site = top.name("site", needed=True)
    made = Campaign(
        path=path,
        site=site,
        results=top.text("results", "results"),
        database=top.text("database", "history.sqlite"),
        pages=top.text("pages", "pages"),
        outside=top.flag("allow_outside"),
        limits=_limits(top),
        options=top.options("options"),
        tanks=tuple(_tank(t) for t in top.tables("tank", needed=True)),
        surveys=_surveys(top),
    )
    top.refuse_unknown()
    return made


def _surveys(top: Table) -> tuple[Survey, ...]:
    """Scans and levellings in the order of the file."""
    levellings = top.tables("levelling")
    scans = top.tables("scan", needed=not levellings)
    made = [_scan(t) for t in scans] + [_levelling(t) for t in levellings]
    return tuple(sorted(made, key=lambda survey: survey.line))


def _inherited(campaign: Campaign) -> Campaign:
    """Options of the campaign are those of each tank, where it has none of its own."""
    tanks = [
        replace(tank, options=campaign.options | tank.options)
        for tank in campaign.tanks
    ]
    return replace(campaign, tanks=tuple(tanks))


def _limits(table: Table) -> Limits:
    inner = table.inner("limits")
    names = Limits.__dataclass_fields__
    made = Limits(**{name: inner.number(name, above=0.0) for name in names})
    inner.refuse_unknown()
    return made


def _tank(table: Table) -> FarmTank:
    steel = {
        "height": table.number("height", above=0.0),
        "yield_mpa": table.number("yield_mpa", above=0.0),
        "modulus_mpa": table.number("modulus_mpa", above=0.0),
        "roof": table.choice("roof", ("open", "fixed")),
        "foundation": table.choice("foundation", ("ringwall", "earth")),
        "service": table.choice("service", ("new", "rebuilt", "in-service")),
    }
    made = FarmTank(
        name=table.name("name", needed=True),
        steel={name: value for name, value in steel.items() if value is not None},
        centre=table.numbers("centre", 2),
        radius=table.number("radius", above=0.0, most=LARGEST),
        drawing_north_deg=table.number("drawing_north_deg") or 0.0,
        height_reference=table.choice("height_reference", HEIGHTS) or "common",
        stable_deg=table.sectors("stable_deg"),
        marks=table.marks("marks"),
        limits=_limits(table),
        options=table.options("options"),
    )
    table.refuse_unknown()
    return made


def _scan(table: Table) -> Survey:
    options = table.options("options")
    for name, most in (("setup_error", WORST), ("setup_tilt_arcsec", STEEPEST)):
        value = table.number(name, least=0.0, most=most)
        options |= {} if value is None else {name: value}
    made = _survey(table, table.texts("files"), options)
    table.refuse_unknown()
    return made


def _levelling(table: Table) -> Survey:
    """A table of elevations, of one tank."""
    file = table.text("file", needed=True)
    made = replace(
        _survey(table, (file,), table.options("options")),
        levelled=True,
        above_datum=table.number("above_datum"),
        elevation_error=table.number("elevation_error", above=0.0, most=WORST) or 0.0,
    )
    table.refuse_unknown()
    return made


def _survey(table: Table, files: tuple[str, ...], options: dict[str, Any]) -> Survey:
    date = table.date("date")
    day = date.isoformat() if date else ""
    tilt = table.number("registration_tilt_arcsec", least=0.0, most=STEEPEST)
    return Survey(
        files=files,
        tank=table.name("tank", needed=True),
        date=day,
        epoch=table.name("epoch", day),
        fill_level=table.number("fill_level", least=0.0),
        hydrotest=table.name("hydrotest", ""),
        registration_error=table.number("registration_error", least=0.0, most=WORST)
        or 0.0,
        registration_tilt_arcsec=tilt or 0.0,
        marks=table.marks("marks"),
        options=options,
        place=table.path,
        line=table.line(),
    )
