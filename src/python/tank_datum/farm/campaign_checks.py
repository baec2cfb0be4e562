"""What holds between the values of a campaign, and what the library says of its options."""

from __future__ import annotations

import functools
import json
from collections.abc import Iterator
from pathlib import PurePosixPath
from typing import Any

import numpy as np

import tank_datum
from tank_datum.farm.campaign import FIND, Campaign, FarmTank, Survey
from tank_datum.farm.fields import Reader
from tank_datum.farm.sources import is_url, resolved, unknown_system
from tank_datum.farm.task import FILES
from tank_datum.farm.toml_lines import Path

DATABASES = ("sqlite", "postgresql", "postgres", "postgresql+psycopg")

# Options that a tank or the engine sets, and those of a run's own results.
TAKEN = {
    "tank": "centre and radius of the tank",
    "pick": "tank of the scan",
    "baseline": "the epochs of the tank",
    "threads": "the engine",
    "checksum": "the engine",
    "no_checksum": "the engine",
    "height": "height of the tank",
    "yield_mpa": "yield_mpa of the tank",
    "modulus_mpa": "modulus_mpa of the tank",
    "roof": "roof of the tank",
    "foundation": "foundation of the tank",
    "service": "service of the tank",
    "zero_azimuth_deg": "drawing_north_deg of the tank",
    "registration_error": "registration_error of the scan",
    "registration_tilt_arcsec": "registration_tilt_arcsec of the scan",
    "remove": "height_reference of the tank",
}


def check_whole(reader: Reader, campaign: Campaign) -> None:
    """Notes in the reader what is wrong with names, options and places."""
    _names(reader, campaign)
    _places(reader, campaign)
    for path, options in _scopes(campaign):
        _options(reader, path, options, campaign)
    for number, tank in enumerate(campaign.tanks):
        _tank(reader, ("tank", number), tank)
    for survey in campaign.surveys:
        _survey(reader, campaign, survey)


def _scopes(campaign: Campaign) -> Iterator[tuple[Path, dict[str, Any]]]:
    yield ("options",), campaign.options
    for number, tank in enumerate(campaign.tanks):
        own = {k: v for k, v in tank.options.items() if campaign.options.get(k) != v}
        yield ("tank", number, "options"), own
    for survey in campaign.surveys:
        yield (*survey.place, "options"), survey.options


def _options(
    reader: Reader, path: Path, options: dict[str, Any], campaign: Campaign
) -> None:
    known = tank_datum.defaults()
    asked = {}
    for name, value in options.items():
        if name in TAKEN:
            reader.say((*path, name), f"option {name} is set by {TAKEN[name]}")
        elif name not in known:
            reader.refuse((*path, name), value, "an option of extract_datum")
        else:
            asked[name] = value
    for name, value in asked.items():
        if name in FILES and isinstance(value, str) and value:
            if not campaign.outside:
                _below(reader, (*path, name), value)
            value = resolved(value, campaign.folder)
        if reason := _refused({name: value}):
            reader.say((*path, name), reason)


def _refused(options: dict[str, Any]) -> str:
    """What the library has against options."""
    return _reason(json.dumps(options, sort_keys=True, default=str))


@functools.cache
def _reason(text: str) -> str:
    """Tanks of a site have much in common. An empty scan is measured in a few milliseconds."""
    options: dict[str, Any] = json.loads(text)
    try:
        tank_datum.extract_datum(np.empty((0, 3)), **options)
    except (tank_datum.OptionError, TypeError) as error:
        return str(error)
    except tank_datum.FileError:
        return ""  # a file that a worker may see
    return ""


def _tank(reader: Reader, path: Path, tank: FarmTank) -> None:
    unknown = tank.radius is None and (*path, "radius") not in reader.refused
    if tank.centre is not None and unknown:
        reader.say(path, f"tank {tank.name!r}: a centre without a radius")
    if tank.height_reference == "stable" and not tank.stable_deg:
        reader.say(path, f"tank {tank.name!r}: height_reference stable, no stable_deg")
    if tank.height_reference == "marks" and not tank.marks:
        reader.say(path, f"tank {tank.name!r}: height_reference marks, no marks")
    for first, last in tank.stable_deg:
        if not 0.0 < last - first < 360.0:
            reader.refuse(
                (*path, "stable_deg"), [first, last], "from < to, less than a turn"
            )
    if tank.steel and (reason := _refused(tank.steel)):
        reader.say(path, f"tank {tank.name!r}: {reason}")


def _survey(reader: Reader, campaign: Campaign, survey: Survey) -> None:
    path, job = survey.place, f"{survey.place[0]} {survey.job!r}"
    tanks = {tank.name: tank for tank in campaign.tanks}
    tank = tanks.get(survey.tank)
    if survey.tank == FIND and not survey.levelled:
        if not any(tank.centre for tank in campaign.tanks):
            reader.say(path, "tank find, but no tank has centre and radius")
    elif survey.tank and tank is None:
        word = "a tank's name" if survey.levelled else f"a tank's name or {FIND!r}"
        reader.refuse((*path, "tank"), survey.tank, word)
    elif tank:
        _of_tank(reader, survey, job, tank)
    if survey.hydrotest and survey.fill_level is None:
        reader.say(path, f"{job}: of a hydrotest without fill_level")
    if not campaign.outside:
        for file in survey.files:
            _below(reader, (*path, "file" if survey.levelled else "files"), file)


def _of_tank(reader: Reader, survey: Survey, job: str, tank: FarmTank) -> None:
    """What a survey says beside what its tank is."""
    marks = tank.marks.keys() & survey.marks.keys()
    if tank.height_reference == "marks" and not marks:
        reader.say(survey.place, f"{job}: none of the marks of its tank")
    if survey.levelled and not tank.radius:
        reader.say(survey.place, f"{job}: its tank {tank.name!r} has no radius")
    height = tank.steel.get("height", float("inf"))
    if survey.fill_level is not None and survey.fill_level > height:
        reader.refuse(
            (*survey.place, "fill_level"),
            survey.fill_level,
            f"at most the height of {tank.name!r}, {height:g} m",
        )


def _names(reader: Reader, campaign: Campaign) -> None:
    seen: set[str] = set()
    for number, tank in enumerate(campaign.tanks):
        if tank.name.casefold() in seen or tank.name == FIND:
            reader.refuse(("tank", number, "name"), tank.name, "a name of its own")
        seen.add(tank.name.casefold())  # a file each, on any system
    jobs: set[str] = set()
    for survey in campaign.surveys:
        if survey.job in jobs:
            reader.refuse(
                (*survey.place, "epoch"),
                survey.epoch,
                f"one survey of {survey.tank!r} an epoch",
            )
        jobs.add(survey.job)


def _places(reader: Reader, campaign: Campaign) -> None:
    scheme, _, database = campaign.database.rpartition("://")
    if scheme and scheme not in DATABASES:
        reader.refuse(("database",), campaign.database, " or ".join(DATABASES))
    elif scheme == "sqlite" and not database.removeprefix("/"):
        reader.refuse(("database",), campaign.database, "a file")
    for name in ("results", "pages"):
        if reason := unknown_system(getattr(campaign, name)):
            reader.refuse((name,), getattr(campaign, name), f"a file system: {reason}")
    if campaign.outside:
        return
    for name in ("results", "pages"):
        _below(reader, (name,), getattr(campaign, name))
    if scheme in ("", "sqlite"):
        _below(
            reader, ("database",), database.removeprefix("/") if scheme else database
        )


def _below(reader: Reader, path: Path, place: str) -> None:
    """A URL says by itself that it is elsewhere; a path must stay below the campaign's folder."""
    if is_url(place):
        return
    parts = PurePosixPath(place)
    if parts.is_absolute() or ".." in parts.parts:
        reader.refuse(
            path, place, "a path below the campaign's folder, or allow_outside = true"
        )
