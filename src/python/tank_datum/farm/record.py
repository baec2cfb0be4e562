"""Rows of finished tasks put into the history: one transaction each, none twice."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable

from sqlalchemy import select
from sqlalchemy.exc import IntegrityError, SQLAlchemyError
from sqlalchemy.orm import Session

from tank_datum.farm.campaign import Campaign, Survey
from tank_datum.farm.history import History, cause
from tank_datum.farm.models import Epoch, Extraction, Failure, Result, Tank
from tank_datum.farm.named_rows import epoch_id, facts_of, tank_id, upsert
from tank_datum.farm.plan import store_url
from tank_datum.farm.result_rows import put_extraction, put_result
from tank_datum.farm.store import Store
from tank_datum.farm.task import FAILED, Row

AGAIN = 1.0  # seconds until a database that refused is asked again


class Recorder:
    """Writes rows as they come. While the database is locked or away they wait here, and every one
    of them is in the store already."""

    def __init__(
        self,
        history: History,
        campaign: Campaign,
        run_id: int,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._history, self._campaign, self._run = history, campaign, run_id
        self._store = Store(store_url(campaign))
        self._waiting: deque[tuple[Survey, Row, int]] = deque()
        self._next, self._clock = 0.0, clock
        self.recorded = 0
        self.trouble = ""

    @property
    def waiting(self) -> int:
        return len(self._waiting)

    def offer(self, survey: Survey, row: Row, attempts: int = 1) -> None:
        self._waiting.append((survey, row, attempts))
        self.flush()

    def flush(self) -> None:
        """Writes what waits; when the database refuses, not again for a second."""
        while self._waiting and self._clock() >= self._next:
            survey, row, attempts = self._waiting[0]
            try:
                self._write(survey, row, attempts)
            except (SQLAlchemyError, OSError) as error:
                if row.outcome != FAILED and self._is_gone(row):
                    reason = (
                        "its result was taken from the store before it was recorded"
                    )
                    row = Row(survey.job, FAILED, kind="store", reason=reason)
                    self._waiting[0] = (survey, row, attempts)
                    continue
                self.trouble = cause(error)
                self._next = self._clock() + AGAIN
                return
            self._waiting.popleft()
            self.recorded += 1
            self.trouble = ""

    def has(self, survey: Survey, row: Row) -> bool:
        """Whether all of a row is in the history; its epoch's facts are the campaign's then."""
        site = self._campaign.site
        recorded = (
            select(Tank.name, Epoch)
            .join(Epoch.tank)
            .join(Result, Result.epoch_id == Epoch.id)
            .where(
                Tank.site == site,
                Epoch.label == survey.epoch,
                Result.extraction_key == row.key,
            )
        )
        with self._history.session() as session:
            if session.get(Extraction, row.key) is None:
                return False
            if session.get(Failure, (site, survey.job)) is not None:
                return False
            epochs = {name: epoch for name, epoch in session.execute(recorded)}
            if not all(tank.name in epochs for tank in row.tanks):
                return False
            for epoch in epochs.values():
                for fact, value in facts_of(survey).items():
                    setattr(epoch, fact, value)  # what is the same is not written
            return True

    def finish(self, within: float) -> bool:
        """Waits for the database so many seconds; whether all is written."""
        end = self._clock() + within
        self.flush()
        while self._waiting and self._clock() < end:
            time.sleep(0.1)
            self.flush()
        return not self._waiting

    def _is_gone(self, row: Row) -> bool:
        """Whether the store is there and the result is not."""
        try:
            return self._store.row(row.key) is None
        except OSError:
            return False

    def _write(self, survey: Survey, row: Row, attempts: int) -> None:
        try:
            with self._history.session() as session:
                self._put(session, survey, row, attempts)
        except IntegrityError:  # another client was faster: its row is the same
            with self._history.session() as session:
                self._put(session, survey, row, attempts)

    def _put(self, session: Session, survey: Survey, row: Row, attempts: int) -> None:
        site = self._campaign.site
        if row.outcome == FAILED:
            upsert(
                session,
                Failure,
                ("site", "job"),
                site=site,
                job=survey.job,
                run_id=self._run,
                kind=row.kind,
                reason=row.reason,
                attempts=attempts,
            )
            return
        failure = session.get(Failure, (site, survey.job))
        if failure is not None:
            session.delete(failure)
        put_extraction(session, self._run, row)
        for tank in row.tanks:
            meant = self._campaign.tank(tank.name)
            epoch = epoch_id(session, tank_id(session, site, meant), survey)
            put_result(session, self._store, row, tank, epoch)
