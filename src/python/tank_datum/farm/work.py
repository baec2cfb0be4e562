"""What a worker does with a task: hash, extract, write, and tell in a row."""

from __future__ import annotations

import contextlib
import json
import math
import time
from dataclasses import replace
from pathlib import Path
from typing import Any

import tank_datum
from tank_datum import _core
from tank_datum.farm.sources import local_copies
from tank_datum.farm.store import ROW, Store
from tank_datum.farm.task import BAD, FAILED, OK, Meant, Row, TankRow, Task

USABLE = ("ok", "partial")
APART = 0.25  # of the radius: a tank found further than this from its place is another
TRIES = 4  # of a task whose storage fails
DELAY = 0.5  # seconds before a second try; each next waits twice as long


class ChangedError(OSError):
    """A scan that changed between hash and extraction."""


def work(task: Task) -> dict[str, Any]:
    """The row of a task, as a dict. Raises nothing but what ends the process.

    A result that is in the store is not made again. What the scan lacks is a row "bad", kept in
    the store too; a row "failed" is not.
    """
    began = time.monotonic()
    try:
        row = _worked(task, Store(task.store), began)
    except OSError as error:
        row = Row(task.job, FAILED, kind="io", reason=reason_of(error))
    except MemoryError as error:
        row = Row(task.job, FAILED, kind="memory", reason=reason_of(error))
    except Exception as error:  # noqa: BLE001 (a defect: the others go on)
        row = Row(task.job, FAILED, kind="error", reason=reason_of(error))
    return row.to_dict() | {"worker": _address()}


def reason_of(error: BaseException) -> str:
    """One line, the type's name where the text alone would say little."""
    text = " ".join(str(error).split())
    plain = isinstance(error, tank_datum.FileError | tank_datum.OptionError)
    if not plain and isinstance(error, OSError) and error.strerror and error.filename:
        return f"{error.strerror}: {error.filename}"[:500]
    return (text if plain else f"{type(error).__name__}: {text}")[:500]


def _worked(task: Task, store: Store, began: float) -> Row:
    hashes = [store.hash_of(source) for source in task.sources]
    key = task.key(hashes)
    if found := store.row(key):
        return Row.of(found | {"job": task.job})
    inputs = tuple(
        {"url": s.url, "size": s.size, "stamp": s.stamp, "hash": h}
        for s, h in zip(task.sources, hashes, strict=True)
    )
    about = Row(task.job, BAD, key=key, inputs=inputs)
    with store.making(key) as folder:
        try:
            row = _written(about, task, folder)
        except (tank_datum.OptionError, TypeError) as error:
            row = replace(about, reason=reason_of(error))
        except tank_datum.FileError as error:
            if error.errno is not None:
                raise
            row = replace(about, reason=reason_of(error))
        row = replace(row, seconds=round(time.monotonic() - began, 3))
        text = json.dumps(row.to_dict(), allow_nan=False)
        (folder / ROW).write_text(text, encoding="utf-8")
    return row


def _written(about: Row, task: Task, folder: Path) -> Row:
    """Extracts and writes each tank, a folder each."""
    made: list[tuple[Meant, tank_datum.Datum]] = []
    with local_copies(list(task.sources)) as paths:
        if task.find:
            made = _stand_there(paths, task)
            if not made:
                return replace(
                    about, reason="none of the site's tanks stands in the scan"
                )
        elif task.diameter is not None:
            made = [(task.meant[0], _levelled(paths[0], task.meant[0], task.diameter))]
        else:
            made = [(task.meant[0], _meant(paths, task.meant[0], task.threads))]
    _require_unchanged(about, made[0][1])
    tanks = []
    for number, (meant, datum) in enumerate(made, start=1):
        name = f"tank_{number}"
        datum.save(folder / name)
        tanks.append(_tank_row(datum, name, meant))
    good = [tank for tank in tanks if tank.status in USABLE]
    return replace(
        about,
        outcome=OK if good else BAD,
        reason="" if good else tanks[0].message,
        tanks=tuple(tanks),
        points=sum(file["points"] for file in made[0][1].to_dict()["input"]["files"]),
    )


def _require_unchanged(about: Row, datum: tank_datum.Datum) -> None:
    """Raises ChangedError when what was read is not what was hashed."""
    hashed = {given["hash"] for given in about.inputs}
    for file in datum.to_dict()["input"]["files"]:
        found = file.get("hash")
        if found and found["algorithm"] == "xxh3_128" and found["value"] not in hashed:
            raise ChangedError(5, "changed while it was read", file["path"])


def _stand_there(paths: list[str], task: Task) -> list[tuple[Meant, tank_datum.Datum]]:
    """The tanks of the site that the scan shows, each with its own options."""
    found = tank_datum.find_tanks(paths, **_search(task.meant[0]), threads=task.threads)
    made = []
    for meant in task.meant:
        for tank in found:
            if _is_there(tank, meant):
                options: dict[str, Any] = meant.options | {
                    "threads": task.threads,
                    "tank": tank.circle,
                }
                made.append((meant, tank_datum.extract_datum(paths, **options)))
                break
    return made


def _search(meant: Meant) -> dict[str, Any]:
    """The options that are not one tank's own."""
    own = (
        "height",
        "yield_mpa",
        "modulus_mpa",
        "roof",
        "foundation",
        "zero_azimuth_deg",
    )
    return {name: value for name, value in meant.options.items() if name not in own}


def _meant(paths: list[str], meant: Meant, threads: int) -> tank_datum.Datum:
    """The best seen tank when it is the one meant; else the one found in its place, if any is."""
    options: dict[str, Any] = meant.options | {"threads": threads}
    datum = tank_datum.extract_datum(paths, **options)
    if meant.place is None or _is_there(datum.to_dict().get("tank"), meant):
        return datum
    found = [t for t in tank_datum.find_tanks(paths, **options) if _is_there(t, meant)]
    return (
        tank_datum.extract_datum(paths, **options, tank=found[0].circle)
        if found
        else datum
    )


def _levelled(path: str, meant: Meant, diameter: float) -> tank_datum.Datum:
    of_scans = _core.keywords_of_scans()
    options = {k: v for k, v in meant.options.items() if k not in of_scans}
    return tank_datum.read_levelling(path, diameter, **options)


def _is_there(tank: Any, meant: Meant) -> bool:
    """Whether a tank stands in the place of the one meant and has about its radius."""
    if meant.place is None or not tank or not tank.get("center"):
        return False
    reach = APART * meant.place[2]
    apart = math.dist(tank["center"], meant.place[:2])
    return apart < reach and abs(tank["radius"] - meant.place[2]) < reach


def _tank_row(datum: tank_datum.Datum, folder: str, meant: Meant) -> TankRow:
    record = datum.to_dict()
    tank = record.get("tank") or {}
    status, message = record["status"], record["message"]
    is_scan = record["input"].get("kind") != "levelling"
    centre = tank.get("center") if is_scan else meant.place and meant.place[:2]
    if is_scan and meant.place and centre and not _is_there(tank, meant):
        place = ", ".join(f"{v:.2f}" for v in (*centre, tank["radius"]))
        wanted = ", ".join(f"{v:.2f}" for v in meant.place)
        status = "other_tank"
        message = f"the tank found has x, y, radius {place} m, expected {wanted} m"
    at = (float(centre[0]), float(centre[1])) if centre else None
    return TankRow(meant.name, folder, status, message, at, tank.get("radius"))


def _address() -> str:
    """Of the Dask worker that this runs in, if any."""
    with contextlib.suppress(ImportError, ValueError):
        from distributed import get_worker

        return str(get_worker().address)
    return ""
