"""Everything that is known of a farm, as plain values for export and pages."""

from __future__ import annotations

import hashlib
import re
from dataclasses import asdict
from typing import Any

from tank_datum.farm.campaign import FIND, Campaign, FarmTank, Survey
from tank_datum.farm.history import History, open_history
from tank_datum.farm.models import Result
from tank_datum.farm.movements import Used, moved_over_time, record_movements
from tank_datum.farm.plan import store_url
from tank_datum.farm.status import CampaignState, present_results, state_of
from tank_datum.farm.store import Store

Plain = dict[str, Any]

FIGURES = (  # of a result
    "status",
    "message",
    "verdict",
    "governing",
    "utilisation",
    "mean_z",
    "sigma_z",
    "measured",
    "interpolated",
    "missing",
    "tilt_slope",
    "tilt_direction_deg",
    "sigma_tilt",
    "out_of_plane",
)


def slug(name: str) -> str:
    """A name for files and links: of two names never the same one."""
    plain = re.sub(r"[^A-Za-z0-9_-]+", "-", name)[:60]
    if plain == name:
        return plain
    return f"{plain}-{hashlib.sha256(name.encode()).hexdigest()[:8]}"


def farm_view(campaign: Campaign) -> tuple[list[Plain], CampaignState]:
    """Every tank with its epochs, trends, hydrotests and alarms, and the campaign's state.

    Movements that are new are put into the history. Raises FarmError, OSError of the store.
    """
    history = open_history(campaign)
    try:
        state = state_of(campaign, history)
        store = Store(store_url(campaign))
        surveys = _surveys_of(campaign)
        used: dict[str, Used] = {name: [] for name in surveys}
        for result in present_results(campaign, history, state):
            name = result.epoch.tank.name
            if name in surveys:
                used[name].append((surveys[name][result.epoch.label], result))
        views = [
            _tank_view(campaign, history, store, tank, used[tank.name])
            for tank in campaign.tanks
        ]
        undone: dict[str, list[Plain]] = {}
        for survey in state.surveys:
            if survey.state != "done":
                undone.setdefault(survey.tank, []).append(asdict(survey))
        for view in views:
            view["undone"] = undone.get(view["name"], [])
        return views, state
    finally:
        history.close()


def _tank_view(
    campaign: Campaign, history: History, store: Store, tank: FarmTank, used: Used
) -> Plain:
    used = sorted(used, key=lambda each: (each[0].date, each[0].line))
    results = [result for _, result in used]
    epochs = [_epoch_view(store, survey, result) for survey, result in used]
    moved = moved_over_time(tank, campaign.limits_of(tank), store, used)
    record_movements(history, moved)
    return {
        "name": tank.name,
        "slug": slug(tank.name),
        "facts": tank.steel
        | {
            "centre": tank.centre or _centre(results),
            "radius": tank.radius or _radius(results),
            "drawing_north_deg": tank.drawing_north_deg,
            "height_reference": tank.height_reference,
        },
        "limits": asdict(campaign.limits_of(tank)),
        "epochs": epochs,
        **{
            name: moved[name]
            for name in ("changes", "trends", "hydrotests", "alarms", "notes")
        },
    }


def _surveys_of(campaign: Campaign) -> dict[str, dict[str, Survey]]:
    """Of every tank, by epoch; a tank's own before those of "find"."""
    found = {s.epoch: s for s in campaign.surveys if s.tank == FIND}
    surveys = {tank.name: dict(found) for tank in campaign.tanks}
    for survey in campaign.surveys:
        if survey.tank != FIND:
            surveys[survey.tank][survey.epoch] = survey
    return surveys


def _centre(results: list[Result]) -> tuple[float, float] | None:
    """Of the last survey that shows it; a levelling does not."""
    for result in reversed(results):
        if result.centre_x is not None and result.centre_y is not None:
            return result.centre_x, result.centre_y
    return None


def _radius(results: list[Result]) -> float | None:
    known = (r.radius for r in reversed(results) if r.radius is not None)
    return next(known, None)


def _epoch_view(store: Store, survey: Survey, result: Result) -> Plain:
    return {
        "epoch": survey.epoch,
        "date": survey.date,
        "kind": "levelling" if survey.levelled else "scan",
        "fill_level": survey.fill_level,
        "hydrotest": survey.hydrotest,
        **{name: getattr(result, name) for name in FIGURES},
        "key": result.extraction_key,
        "folder": f"{store.folder(result.extraction_key)}/{result.folder}",
        "version": result.extraction.version,
        "result_id": result.id,
        "checks": [
            {
                n: getattr(c, n)
                for n in (
                    "code",
                    "clause",
                    "name",
                    "value",
                    "limit_value",
                    "unit",
                    "verdict",
                    "role",
                )
            }
            for c in result.checks
        ],
    }
