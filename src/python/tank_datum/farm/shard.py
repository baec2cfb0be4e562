"""A part of a campaign in this process alone: for arrays of SLURM or a batch service."""

from __future__ import annotations

import time
from dataclasses import replace

from tank_datum.farm.campaign import Campaign
from tank_datum.farm.plan import STOPPED, Ending, Say, tasks_of, told
from tank_datum.farm.task import FAILED, Row, Task
from tank_datum.farm.work import DELAY, TRIES, work


def run_shard(campaign: Campaign, number: int, of: int, say: Say) -> Ending:
    """One of n parts, in this process: results go to the store, the history is left alone.

    number: from 1. What it leaves in the store a run with collect records.
    """
    ending = Ending()
    tasks, missing = tasks_of(campaign)
    if number == 1:
        ending.rows |= {survey.job: row for survey, row in missing}
    mine = tasks[number - 1 :: of]
    try:
        for done, (survey, task) in enumerate(mine):
            ending.left = len(mine) - done
            row = _worked(task)
            ending.rows[survey.job] = row
            say(told(survey, row))
        ending.left = 0
    except KeyboardInterrupt:
        ending.trouble = STOPPED
    return ending


def _worked(task: Task) -> Row:
    """Tried again while storage fails."""
    tries = 1
    while True:
        row = Row.of(work(replace(task, threads=0)))
        if row.outcome != FAILED or row.kind != "io" or tries == TRIES:
            return row
        time.sleep(DELAY * 2 ** (tries - 1))
        tries += 1
