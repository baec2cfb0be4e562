"""Runs tasks on workers of Dask: at most two a worker in flight, tried again only for I/O."""

from __future__ import annotations

import contextlib
import heapq
import time
from asyncio import CancelledError
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from typing import Any

from distributed import Client, Future, KilledWorker, as_completed

from tank_datum.farm.errors import FarmError
from tank_datum.farm.interrupts import whole
from tank_datum.farm.task import FAILED, Row, Task
from tank_datum.farm.work import DELAY, TRIES, reason_of, work

A_WORKER = 2  # tasks in flight
PAUSE = 0.02  # seconds between looks at what came back
ALONE = 15.0  # seconds without any worker after which the scheduler counts as lost
LONGEST_WAY = 30.0  # seconds of a row from worker to client
LOOK = 1.0  # seconds between questions which workers there are

Came = Callable[[Task, Row, int], None]


class SchedulerLost(Exception):
    """The scheduler does not answer; what was in flight may have been done or not."""


@dataclass(order=True)
class _Queued:
    not_before: float
    number: int
    task: Task = field(compare=False)
    tries: int = field(default=0, compare=False)
    shun: str = field(default="", compare=False)
    """the worker where it failed"""


class Engine:
    """The tasks that are left, and those in flight. came() gets each row once; idle() is called
    some ten times a second."""

    def __init__(self, tasks: list[Task], came: Came, idle: Callable[[], None]) -> None:
        self._queue = [_Queued(0.0, number, task) for number, task in enumerate(tasks)]
        self._flying: dict[Future, _Queued] = {}
        self._came, self._idle = came, idle
        self._workers: list[str] = []
        self._looked = self._seen = -LOOK
        self.worked = False  # whether the last run() had workers

    @property
    def left(self) -> int:
        return len(self._queue) + len(self._flying)

    def run(self, client: Client) -> None:
        """Until nothing is left. Raises SchedulerLost, after which another client may go on."""
        returned = as_completed([], raise_errors=False, loop=client.loop)
        looked, self.worked, self._seen = 0.0, False, time.monotonic()
        try:
            while self.left:
                _require_running(client)
                self._submit(client, returned)
                while returned.has_ready():
                    for future in returned.next_batch(block=False):
                        with whole():
                            self._take(future)
                        self._submit(client, returned)
                if time.monotonic() - looked > 0.1:
                    looked = time.monotonic()
                    self._idle()
                time.sleep(PAUSE)
        except Exception as error:
            self._land()
            if isinstance(error, SchedulerLost | OSError) or client.status != "running":
                raise SchedulerLost(str(error)) from None
            raise
        except BaseException:
            with contextlib.suppress(Exception):
                client.cancel(list(self._flying))
            raise

    def _submit(self, client: Client, returned: as_completed) -> None:
        if time.monotonic() - self._looked > LOOK:
            self._workers, self._looked = list(client.nthreads()), time.monotonic()
            self._seen = self._looked if self._workers else self._seen
        if time.monotonic() - self._seen > ALONE:
            raise SchedulerLost("it has no workers")
        while self._queue and len(self._flying) < A_WORKER * len(self._workers):
            if self._queue[0].not_before > time.monotonic():
                return
            queued = self._queue[0]
            threads = threads_for(len(self._workers), self.left + 1)
            others = [address for address in self._workers if address != queued.shun]
            only: dict[str, Any] = {}
            if queued.shun and others:
                only = {"workers": others, "allow_other_workers": True}
            task = replace(queued.task, threads=threads)
            future = client.submit(work, task, pure=False, retries=0, **only)
            self._flying[future] = heapq.heappop(self._queue)
            returned.add(future)
            self.worked = True

    def _take(self, future: Future) -> None:
        """A row that cannot be had leaves its task among those in flight."""
        if future.status in ("cancelled", "lost"):
            raise SchedulerLost("tasks were cancelled")
        if future.status == "finished":
            row = Row.of(_result_of(future))
        else:
            row = _killed(self._flying[future].task, future)
        self._judge(self._flying.pop(future), row)

    def _judge(self, queued: _Queued, row: Row) -> None:
        tries = queued.tries + 1
        again = row.outcome == FAILED and (
            (row.kind == "io" and tries < TRIES) or (row.kind == "killed" and tries < 2)
        )
        if not again:
            self._came(queued.task, row, tries)
            return
        later = time.monotonic() + DELAY * 2 ** (tries - 1)
        shun = row.worker
        heapq.heappush(
            self._queue, _Queued(later, queued.number, queued.task, tries, shun)
        )

    def _land(self) -> None:
        """What was in flight is asked for again; work() returns what it finds in the store."""
        self._workers, self._looked = [], -LOOK
        for queued in self._flying.values():
            heapq.heappush(self._queue, queued)
        self._flying.clear()


def threads_for(workers: int, left: int) -> int:
    """Of the core's loops in one task: one while each worker is busy, else what the idle ones
    leave. A worker has one core."""
    return max(1, workers // max(1, min(workers, left)))


def _result_of(future: Future) -> Any:
    """What work() gave, which raises nothing: an error is one of bringing it here."""
    try:
        return future.result(timeout=LONGEST_WAY)
    except (Exception, CancelledError) as error:  # noqa: BLE001 (whatever broke on the way)
        raise SchedulerLost(f"a row was lost: {reason_of(error)}") from None


def _require_running(client: Client) -> None:
    if client.status != "running":
        raise SchedulerLost(f"the client is {client.status}")


def _killed(task: Task, future: Future) -> Row:
    """A task whose worker died more often than the scheduler allows, or that could not be sent."""
    error: Any = future.exception()
    killed = isinstance(error, KilledWorker)
    said = "its worker died each time that it was tried" if killed else reason_of(error)
    return Row(task.job, FAILED, kind="killed" if killed else "error", reason=said)


@contextlib.contextmanager
def connected(make: Callable[[], Client]) -> Iterator[Client]:
    """A client that is closed quickly, whatever happens. Raises FarmError without a scheduler."""
    try:
        client = make()
    except (OSError, ValueError) as error:
        raise FarmError(f"scheduler: {reason_of(error)}") from None
    try:
        yield client
    finally:
        with contextlib.suppress(Exception):
            client.close(timeout=2)
