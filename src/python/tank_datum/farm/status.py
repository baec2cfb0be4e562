"""What is known of a campaign: each survey's last end, from history and store, nothing run."""

from __future__ import annotations

from dataclasses import dataclass

from sqlalchemy import select
from sqlalchemy.orm import Session, joinedload, selectinload

from tank_datum.farm.campaign import FIND, Campaign, Survey
from tank_datum.farm.history import History
from tank_datum.farm.models import Epoch, Extraction, Result, Run, Tank
from tank_datum.farm.plan import known_key, store_url, tasks_of
from tank_datum.farm.store import Store
from tank_datum.farm.task import OK

GONE = "its result is no longer in the store"
MOST = 500  # keys asked for at once; databases take some thousands


@dataclass(frozen=True)
class SurveyState:
    """state: "done", "no datum", "failed", "missing" or "to do"; key: of its present result."""

    job: str
    tank: str
    epoch: str
    date: str
    state: str
    reason: str = ""
    key: str = ""
    seconds: float | None = None
    version: str = ""


@dataclass(frozen=True)
class CampaignState:
    surveys: tuple[SurveyState, ...]
    last_run: str

    def count(self, state: str) -> int:
        return sum(survey.state == state for survey in self.surveys)

    def lines(self) -> list[str]:
        said = [
            f"{s.state:8}  {s.job}  {s.reason}".rstrip()
            for s in self.surveys
            if s.state != "done"
        ]
        states = ("done", "no datum", "failed", "missing", "to do")
        said.append(", ".join(f"{self.count(state)} {state}" for state in states))
        return [*said, f"last run: {self.last_run}"] if self.last_run else said


def state_of(campaign: Campaign, history: History) -> CampaignState:
    """The state of every survey. Raises SQLAlchemyError, OSError of the store."""
    tasks, missing = tasks_of(campaign)
    store = Store(store_url(campaign))
    keys = {survey.job: known_key(store, task) for survey, task in tasks}
    absent = {survey.job: row.reason for survey, row in missing}
    failed = {
        failure.job: failure.reason for failure in history.failures(campaign.site)
    }
    with history.session() as session:
        found = _extractions(session, [key for key in keys.values() if key])
        runs = select(Run).where(Run.site == campaign.site).order_by(Run.id.desc())
        last = session.scalars(runs).first()
    surveys = []
    for survey in campaign.surveys:
        extraction = found.get(keys.get(survey.job) or "")
        if survey.job in absent:
            how = ("missing", absent[survey.job])
        elif survey.job in failed:
            how = ("failed", failed[survey.job])
        elif extraction and store.row(extraction.key) is None:
            how = ("to do", GONE)
        else:
            how = _ended(extraction)
        surveys.append(_state(survey, how, extraction))
    ended = f"{last.begun} UTC, {last.ending or 'not ended'}" if last else ""
    return CampaignState(tuple(surveys), ended)


def _extractions(session: Session, keys: list[str]) -> dict[str, Extraction]:
    found: dict[str, Extraction] = {}
    for first in range(0, len(keys), MOST):
        some = Extraction.key.in_(keys[first : first + MOST])
        found |= {e.key: e for e in session.scalars(select(Extraction).where(some))}
    return found


def _ended(extraction: Extraction | None) -> tuple[str, str]:
    if extraction is None:
        return "to do", ""
    return "done" if extraction.outcome == OK else "no datum", extraction.reason


def _state(
    survey: Survey, how: tuple[str, str], extraction: Extraction | None
) -> SurveyState:
    given = (survey.job, survey.tank, survey.epoch, survey.date, *how)
    if extraction is None:
        return SurveyState(*given)
    seconds, version = extraction.seconds, extraction.version
    return SurveyState(*given, extraction.key, seconds, version)


def present_results(
    campaign: Campaign, history: History, state: CampaignState
) -> list[Result]:
    """The result of each tank and epoch that the campaign asks for now; where there is none yet,
    the last one of an earlier version or other options. A tank's own survey comes before "find"."""
    keys = {(survey.tank, survey.epoch): survey.key for survey in state.surveys}
    with history.session() as session:
        found = _results(session, campaign.site)
    chosen: dict[int, Result] = {}
    for result in found:
        epoch = result.epoch
        asked = {
            tank: keys[tank, epoch.label]
            for tank in (FIND, epoch.tank.name)
            if (tank, epoch.label) in keys
        }
        if not asked:
            continue
        before = chosen.get(result.epoch_id)
        if before is None or _rank(result, asked) >= _rank(before, asked):
            chosen[result.epoch_id] = result
    return sorted(
        chosen.values(), key=lambda r: (r.epoch.tank.name, r.epoch.date, r.epoch.id)
    )


def _rank(result: Result, asked: dict[str, str]) -> int:
    """Higher for what is asked for: keys by "find", then the tank's own."""
    order = list(asked.values())
    key = result.extraction_key
    return 1 + order.index(key) if key in order else 0


def _results(session: Session, site: str) -> list[Result]:
    asked = (
        select(Result)
        .join(Result.epoch)
        .join(Epoch.tank)
        .where(Tank.site == site)
        .options(
            joinedload(Result.epoch).joinedload(Epoch.tank),
            joinedload(Result.extraction),
            selectinload(Result.checks),
        )
        .order_by(Result.id)
    )
    return list(session.scalars(asked))
