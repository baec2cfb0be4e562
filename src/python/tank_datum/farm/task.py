"""What a worker is given and what travels back: about 1 KB each."""

from __future__ import annotations

import hashlib
import json
from dataclasses import asdict, dataclass
from typing import Any

import tank_datum
from tank_datum.farm.campaign import FIND, Campaign, FarmTank, Survey
from tank_datum.farm.sources import Source, content_hash, listed, resolved

FILES = ("limits", "setup_origins")  # options that name a file
OK, BAD, FAILED = "ok", "bad", "failed"


@dataclass(frozen=True)
class Meant:
    """A tank that a scan may show. place: x, y and radius [m], where they are known."""

    name: str
    place: tuple[float, float, float] | None
    options: dict[str, Any]


@dataclass(frozen=True)
class Task:
    """The extraction of one survey: of its one tank, or with `find` of those of the site that
    stand in it. diameter [m]: of a tank that was levelled; None: scanned. threads of the core's
    loops: no part of the key, nor of the result."""

    job: str
    sources: tuple[Source, ...]
    store: str
    meant: tuple[Meant, ...]
    find: bool = False
    threads: int = 1
    diameter: float | None = None

    def key(self, hashes: list[str]) -> str:
        """Names the result: content, options, version. hashes: of the sources, in order.

        Of options that name a file its content counts, not its place. Raises OSError for one that
        cannot be read.
        """
        asked = {
            "hashes": hashes,
            "meant": [
                asdict(tank) | {"options": _by_content(tank.options)}
                for tank in self.meant
            ],
            "files": {},
            "find": self.find,
            "version": tank_datum.__version__,
        }
        if self.diameter is not None:
            asked["diameter"] = self.diameter
        text = json.dumps(asked, sort_keys=True, allow_nan=False)
        return hashlib.sha256(text.encode()).hexdigest()[:40]


def _by_content(options: dict[str, Any]) -> dict[str, Any]:
    """Options with the hash of each file in place of its path."""
    files = {name: options[name] for name in FILES if options.get(name)}
    return options | {name: content_hash(str(path)) for name, path in files.items()}


@dataclass(frozen=True)
class TankRow:
    """A tank of a result: its name, its folder below the key's, and where it stands [m]."""

    name: str
    folder: str
    status: str
    message: str
    centre: tuple[float, float] | None
    radius: float | None


@dataclass(frozen=True)
class Row:
    """The end of a task. outcome: "ok"; "bad", the scan gives no datum and reason says why; or
    "failed", it could not be tried to the end: kind "io" may be tried again, others not now."""

    job: str
    outcome: str
    key: str = ""
    kind: str = ""
    reason: str = ""
    version: str = tank_datum.__version__
    inputs: tuple[dict[str, Any], ...] = ()
    tanks: tuple[TankRow, ...] = ()
    seconds: float = 0.0
    points: int = 0
    worker: str = ""

    def to_dict(self) -> dict[str, Any]:
        return asdict(self)

    @classmethod
    def of(cls, given: dict[str, Any]) -> Row:
        tanks = tuple(TankRow(**tank) for tank in given["tanks"])
        return cls(**{**given, "tanks": tanks, "inputs": tuple(given["inputs"])})


def options_of(campaign: Campaign, survey: Survey, tank: FarmTank) -> dict[str, Any]:
    """Those of the campaign, then of the tank, then of the scan; steel and drawing north too."""
    options = campaign.options | tank.options | tank.steel
    options |= (
        {"zero_azimuth_deg": tank.drawing_north_deg} if tank.drawing_north_deg else {}
    )
    options |= survey.options
    for name in FILES:
        if isinstance(options.get(name), str):
            options[name] = resolved(options[name], campaign.folder)
    return options


def task_of(campaign: Campaign, survey: Survey) -> Task:
    """The task of a survey. Raises OSError for a scan that is missing."""
    find = survey.tank == FIND
    tanks = (
        [t for t in campaign.tanks if t.place] if find else [campaign.tank(survey.tank)]
    )
    return Task(
        job=survey.job,
        sources=tuple(listed(survey.files, campaign.folder)),
        store=resolved(campaign.results, campaign.folder),
        meant=tuple(
            Meant(t.name, t.place, options_of(campaign, survey, t)) for t in tanks
        ),
        find=find,
        diameter=2.0 * (tanks[0].radius or 0.0) if survey.levelled else None,
    )
