"""The engine with a client that breaks where it is told to: no task is lost, none comes twice."""

from __future__ import annotations

import asyncio
from dataclasses import dataclass, field
from typing import Any

import pytest

from farm_made import require_farm

require_farm()

import tank_datum.farm.engine as engine  # noqa: E402
from tank_datum.farm.task import OK, Row, Task  # noqa: E402

JOBS = [f"T/{number}" for number in range(7)]


@dataclass(eq=False)
class Future:
    """Of one task. broken: what asking for its row raises."""

    job: str
    broken: BaseException | None = None
    status: str = "finished"

    def result(self, timeout: float) -> dict[str, Any]:
        if self.broken:
            raise self.broken
        return Row(self.job, OK, key=self.job).to_dict()


class Returned:
    """as_completed of futures that are there at once."""

    def __init__(self, futures: list[Future], **options: Any) -> None:
        self.there: list[Future] = []

    def add(self, future: Future) -> None:
        self.there.append(future)

    def has_ready(self) -> bool:
        return bool(self.there)

    def next_batch(self, block: bool = True) -> list[Future]:
        batch, self.there = self.there, []
        return batch


@dataclass
class Client:
    """Of one worker. harm: by the number of the submission, what breaks."""

    harm: dict[int, Any] = field(default_factory=dict)
    status: str = "running"
    loop: Any = None
    submitted: int = 0

    def nthreads(self) -> dict[str, int]:
        return {"tcp://worker": 1}

    def submit(self, function: Any, task: Task, **options: Any) -> Future:
        self.submitted += 1
        harm = self.harm.get(self.submitted)
        if harm == "submit":
            raise OSError("connection closed")
        if harm == "closed":
            self.status = "closed"
            raise RuntimeError("the client is closed")
        if harm == "cancelled":
            return Future(task.job, status="cancelled")
        return Future(task.job, harm)

    def cancel(self, futures: list[Future]) -> None:
        pass


@pytest.fixture
def made(monkeypatch: pytest.MonkeyPatch) -> tuple[engine.Engine, list[str]]:
    monkeypatch.setattr(engine, "as_completed", Returned)
    came: list[str] = []
    tasks = [Task(job, (), "", ()) for job in JOBS]
    return engine.Engine(tasks, lambda task, row, tries: came.append(row.job), lambda: None), came


@pytest.mark.parametrize("number", [1, 2, 4, 7])
@pytest.mark.parametrize(
    "harm",
    [
        OSError("connection closed"),
        TimeoutError(),
        asyncio.CancelledError(),
        ValueError("cut off"),
        "submit",
        "closed",
        "cancelled",
    ],
    ids=["closed way", "late", "cancelled way", "cut off", "submit", "closed", "cancelled"],
)
def test_what_breaks_on_the_way_is_asked_for_again(
    made: tuple[engine.Engine, list[str]], harm: Any, number: int
) -> None:
    run, came = made
    with pytest.raises(engine.SchedulerLost):
        run.run(Client({number: harm}))  # type: ignore[arg-type]
    assert run.left + len(came) == len(JOBS)
    run.run(Client())  # type: ignore[arg-type]
    assert sorted(came) == JOBS and run.left == 0


def test_a_defect_of_the_clients_is_no_lost_scheduler(
    made: tuple[engine.Engine, list[str]],
) -> None:
    run, _ = made
    run._idle = lambda: [][1]  # type: ignore[assignment]
    with pytest.raises(IndexError):
        run.run(Client())  # type: ignore[arg-type]
