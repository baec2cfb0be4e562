"""What a campaign comes to: its tasks, which of them are done, and how a run of them ended."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from tank_datum.farm.campaign import Campaign, Survey
from tank_datum.farm.sources import resolved
from tank_datum.farm.store import Store
from tank_datum.farm.task import BAD, FAILED, OK, Row, Task, task_of
from tank_datum.farm.work import reason_of

Say = Callable[[str], None]
STOPPED = "interrupted"


@dataclass
class Ending:
    """What a run came to. rows: of this run, by job; there: jobs that were recorded before."""

    rows: dict[str, Row] = field(default_factory=dict)
    there: int = 0
    left: int = 0
    waiting: int = 0
    trouble: str = ""

    def count(self, outcome: str) -> int:
        return sum(row.outcome == outcome for row in self.rows.values())

    @property
    def status(self) -> int:
        """The exit status: 0 all gave a datum, 1 not every scan did, 3 something is undone."""
        if self.left or self.waiting or self.trouble:
            return 3
        return 1 if self.count(BAD) + self.count(FAILED) else 0

    def lines(self) -> list[str]:
        """The last lines of a run: what failed, and what it came to."""
        said = [
            f"{'failed' if row.outcome == FAILED else 'no datum'}  {job}: {row.reason}"
            for job, row in sorted(self.rows.items())
            if row.outcome != OK
        ]
        if self.trouble:
            said.append(f"stopped: {self.trouble}")
        if self.waiting:
            said.append(
                f"{self.waiting} results are stored but not in the database; run again"
            )
        said.append(
            f"{self.count(OK)} done, {self.there} were there, {self.count(BAD)} without a datum, "
            f"{self.count(FAILED)} failed, {self.left} left"
        )
        return said


def store_url(campaign: Campaign) -> str:
    return resolved(campaign.results, campaign.folder)


def tasks_of(
    campaign: Campaign,
) -> tuple[list[tuple[Survey, Task]], list[tuple[Survey, Row]]]:
    """The tasks of a campaign, and a failed row for each scan that is missing."""
    tasks, missing = [], []
    for survey in campaign.surveys:
        try:
            tasks.append((survey, task_of(campaign, survey)))
        except (OSError, ValueError, ImportError) as error:
            reason = reason_of(error)
            missing.append(
                (survey, Row(survey.job, FAILED, kind="missing", reason=reason))
            )
    return tasks, missing


def known_key(store: Store, task: Task) -> str | None:
    """The key of a task where its scans were hashed before and are unchanged."""
    hashes = [store.known_hash(source) for source in task.sources]
    return task.key([h for h in hashes if h]) if all(hashes) else None


def told(survey: Survey, row: Row) -> str:
    """The line of a task that came to its end."""
    return f"{row.outcome:6}  {survey.job}  {row.seconds:.1f} s  {row.reason}".rstrip()
