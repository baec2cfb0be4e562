"""What moved between the epochs of a tank, kept until anything of it changes."""

from __future__ import annotations

import hashlib
import json
import math
import os
from dataclasses import asdict, replace
from typing import Any

import numpy as np

import tank_datum
from tank_datum.farm.alarms import alarms_of
from tank_datum.farm.campaign import FarmTank, Limits, Survey
from tank_datum.farm.heights import datum_of
from tank_datum.farm.history import History
from tank_datum.farm.hydrotest import hydrotests_of
from tank_datum.farm.models import Movement, Result
from tank_datum.farm.named_rows import upsert
from tank_datum.farm.over_time import EpochDatum, history_of
from tank_datum.farm.store import DATUM, Store

Plain = dict[str, Any]
Used = list[tuple[Survey, Result]]
SCHEMA = 3  # of what is below; another number makes it anew


def moved_over_time(tank: FarmTank, limits: Limits, store: Store, used: Used) -> Plain:
    """Changes, trends, hydrotests, alarms and notes. used: the tank's surveys by date.

    Kept in the store. An epoch whose result was taken from the store is left out, and noted.
    """
    name = _kept_as(tank, limits, used)
    if kept := store.note(name):
        return dict(json.loads(kept))
    there = [(s, r) for s, r in used if store.has(r.extraction_key, _file_of(r))]
    gone = [
        f"{s.epoch}: its result is no longer in the store"
        for s, r in used
        if (s, r) not in there
    ]
    made = _known(_moved(tank, limits, store, there))
    made |= {"asked": name, "notes": made["notes"] + gone}
    text = json.dumps(made, allow_nan=False)
    if not gone:
        store.keep_note(name, text.encode())
    return dict(json.loads(text))


def _moved(tank: FarmTank, limits: Limits, store: Store, used: Used) -> Plain:
    epochs = [
        EpochDatum(_plain(survey), _datum(store, result), result.id)
        for survey, result in used
    ]
    history = history_of(tank, epochs, limits)
    lines = {survey.epoch: survey.line for survey, _ in used}
    by_order = sorted(epochs, key=lambda e: lines[e.survey.epoch])
    return {
        "changes": [asdict(change) for change in history.changes],
        "trends": {k: _trend_view(t) for k, t in history.trends.items()},
        "hydrotests": [asdict(test) for test in hydrotests_of(tank, by_order)],
        "alarms": [asdict(alarm) for alarm in alarms_of(history, limits)],
        "notes": list(history.notes),
    }


def _plain(survey: Survey) -> Survey:
    """Without what does not change a movement."""
    return replace(survey, line=0, place=(), files=(), options={})


def _known(value: Any) -> Any:
    """The same with null for what is no number."""
    if isinstance(value, dict):
        return {name: _known(each) for name, each in value.items()}
    if isinstance(value, list | tuple):
        return [_known(each) for each in value]
    if isinstance(value, float | np.floating):
        return float(value) if math.isfinite(value) else None
    return value


def _kept_as(tank: FarmTank, limits: Limits, used: Used) -> str:
    """The name of what is made of them: another one when anything of it is another."""
    order = sorted(range(len(used)), key=lambda number: used[number][0].line)
    asked = [
        SCHEMA,
        tank_datum.__version__,
        asdict(tank),
        asdict(limits),
        [asdict(_plain(survey)) for survey, _ in used],
        [(r.extraction_key, r.folder, r.id) for _, r in used],
        order,
    ]
    text = json.dumps(asked, sort_keys=True)
    return f"over_time/{hashlib.sha256(text.encode()).hexdigest()[:40]}.json"


def _file_of(result: Result) -> str:
    return f"{result.folder}/{DATUM}"


def _datum(store: Store, result: Result) -> tank_datum.Datum:
    content = store.read(result.extraction_key, _file_of(result))
    return datum_of(content, result.epoch.label)


def _trend_view(trend: Any) -> Plain:
    words = trend.reaching.words if trend.reaching else None
    return {**asdict(trend), "moves": trend.moves, "reaching_words": words}


def record_movements(history: History, moved: Plain) -> None:
    """The changes as rows of the history's movements."""
    changes = moved["changes"]
    if len(changes) < 2:
        return
    with history.session() as session:
        for change in changes[1:]:
            upsert(
                session,
                Movement,
                ("baseline_id", "result_id", "asked"),
                baseline_id=changes[0]["result_id"],
                result_id=change["result_id"],
                asked=os.path.basename(moved["asked"])[:40],
                figures=change,
            )
