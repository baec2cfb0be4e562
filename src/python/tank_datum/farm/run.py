"""A run of a campaign: what is missing is extracted, and every end is put into the history."""

from __future__ import annotations

import functools
import time
from dataclasses import dataclass
from typing import TYPE_CHECKING

from sqlalchemy.exc import SQLAlchemyError

from tank_datum.farm.campaign import Campaign, Survey
from tank_datum.farm.errors import FarmError
from tank_datum.farm.history import History, cause, open_history, patient
from tank_datum.farm.interrupts import stop_if_asked
from tank_datum.farm.plan import (
    STOPPED,
    Ending,
    Say,
    known_key,
    store_url,
    tasks_of,
    told,
)
from tank_datum.farm.record import Recorder
from tank_datum.farm.store import Store
from tank_datum.farm.task import OK, Row, Task
from tank_datum.farm.workers import Workers

if TYPE_CHECKING:
    from tank_datum.farm.engine import Engine

INTERRUPTED = 2.0  # seconds that the database has after Ctrl-C


@dataclass(frozen=True)
class Waits:
    """Seconds that a run waits for what is away."""

    database: float = 120.0
    scheduler: float = 60.0


def run_campaign(
    campaign: Campaign,
    workers: Workers,
    say: Say,
    waits: Waits | None = None,
    *,
    collect: bool = False,
) -> Ending:
    """Extracts what is missing or changed; with collect only records what is in the store.

    Ctrl-C ends it early, with what was done recorded. Raises FarmError.
    """
    waits = waits or Waits()
    store = Store(store_url(campaign))
    store.sweep()
    history = open_history(campaign, waits.database, say)
    try:
        run_id = patient(lambda: history.begin_run(campaign), waits.database)
        course = _Course(
            campaign, store, Recorder(history, campaign, run_id), Ending(), say
        )
        try:
            _run(course, None if collect else workers, waits)
        except KeyboardInterrupt:
            course.ending.trouble = STOPPED
            waits = Waits(database=INTERRUPTED)
        _finish(course, history, run_id, waits)
    except SQLAlchemyError as error:
        raise FarmError(f"database: {cause(error)}") from None
    finally:
        history.close()
        store.sweep()
    return course.ending


def _finish(course: _Course, history: History, run_id: int, waits: Waits) -> None:
    ending, recorder = course.ending, course.recorder
    ending.waiting = 0 if recorder.finish(waits.database) else recorder.waiting
    ending.trouble = ending.trouble or recorder.trouble
    if not ending.waiting:
        patient(lambda: history.end_run(run_id, ending.lines()[-1]), waits.database)


@dataclass
class _Course:
    campaign: Campaign
    store: Store
    recorder: Recorder
    ending: Ending
    say: Say

    def came(self, survey: Survey, row: Row, tries: int) -> None:
        self.ending.rows[survey.job] = row
        self.recorder.offer(survey, row, tries)
        self.say(told(survey, row))


def _run(course: _Course, workers: Workers | None, waits: Waits) -> None:
    tasks, missing = tasks_of(course.campaign)
    for survey, row in missing:
        course.came(survey, row, 1)
    wanted = _wanted(course, tasks, waits)
    if not wanted or workers is None:
        course.ending.left = len(wanted)
        return
    from tank_datum.farm.engine import Engine

    surveys = {task.job: survey for survey, task in wanted}
    engine = Engine(
        [task for _, task in wanted],
        lambda task, row, tries: course.came(surveys[task.job], row, tries),
        course.recorder.flush,
    )
    try:
        _work_through(engine, course, workers, waits)
    except FarmError as error:
        course.ending.trouble = str(error)
    finally:
        rows = course.ending.rows
        course.ending.left = sum(task.job not in rows for _, task in wanted)
        course.recorder.flush()


def _work_through(
    engine: Engine, course: _Course, workers: Workers, waits: Waits
) -> None:
    """With one client after the other, when the scheduler was lost and comes back in time."""
    from tank_datum.farm.cluster import client_of
    from tank_datum.farm.engine import SchedulerLost

    end = None
    while engine.left:
        stop_if_asked()
        try:
            with client_of(workers) as client:
                engine.run(client)
        except (SchedulerLost, FarmError) as error:
            if not workers.scheduler and isinstance(error, FarmError):
                raise
            end = None if engine.worked else end
            engine.worked = False
            end = end or time.monotonic() + waits.scheduler
            course.say(f"the scheduler is lost ({error}); waiting for it")
            if time.monotonic() >= end:
                raise FarmError(f"the scheduler is away: {error}") from None
            course.recorder.flush()
            time.sleep(0.5)


def _wanted(
    course: _Course, tasks: list[tuple[Survey, Task]], waits: Waits
) -> list[tuple[Survey, Task]]:
    """The tasks without a result; one that is in the store only is recorded."""
    wanted = []
    for survey, task in tasks:
        key = known_key(course.store, task)
        found = course.store.row(key) if key else None
        if found is None:
            wanted.append((survey, task))
            continue
        row = Row.of(found)
        if patient(functools.partial(course.recorder.has, survey, row), waits.database):
            course.ending.there += row.outcome == OK
            if row.outcome != OK:
                course.ending.rows[survey.job] = row
        else:
            course.came(survey, row, 1)
    return wanted
