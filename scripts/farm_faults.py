"""Faults of a campaign, made at random moments with a real scheduler and workers on loopback.

Each fault is made --times times while campaigns run, several times in each. A run that ends for it
is started again; in the end of every campaign each result must be in the history exactly once.
Faults:

  worker     a worker process is killed, and another one started
  scheduler  the scheduler is killed, and started again on its port after a second
  client     the client is killed, and started again
  scan       a scan is taken away, and put back before the next run
  disk       the disk of one of two workers is full for a while (needs root)
  locked     another process locks the database (SQLite) for a while
  away       the database server (PostgreSQL) is away for a while

A while is half a second to three, and with --outage S so many seconds.
"""

from __future__ import annotations

import argparse
import os
import random
import shutil
import sqlite3
import subprocess
import tempfile
import time
from collections.abc import Callable
from contextlib import nullcontext
from dataclasses import dataclass
from pathlib import Path

import tank_datum

from farm_postgres import programs, server
from farm_trials import SCENE, TASKS, Stuck, Trial, cluster, finished, require_once, trial

LONGEST_GAP = 3.0  # seconds between faults
OUTAGE: list[float] = []  # seconds that the database is locked or away, where it was asked for
MOST_RUNS = 40  # of one campaign


def a_while() -> float:
    return OUTAGE[0] if OUTAGE else random.uniform(0.5, LONGEST_GAP)


def kill_worker(made: Trial, client: subprocess.Popen[str]) -> None:
    name = random.choice(["worker 1", "worker 2"])
    made.cluster.kill(name)
    made.cluster.start(name)


def kill_scheduler(made: Trial, client: subprocess.Popen[str]) -> None:
    made.cluster.kill("scheduler")
    time.sleep(1.0)
    made.cluster.start("scheduler")
    for name in ("worker 1", "worker 2"):
        made.cluster.kill(name)
        made.cluster.start(name)


def kill_client(made: Trial, client: subprocess.Popen[str]) -> None:
    client.kill()


def take_scan(made: Trial, client: subprocess.Popen[str]) -> None:
    """One that is there; put_scans_back() does so."""
    there = sorted((made.folder / "scans").glob("*.pcd"))
    if there:
        scan = random.choice(there)
        scan.rename(made.folder / scan.name)


def put_scans_back(made: Trial) -> None:
    for scan in made.folder.glob("*.pcd"):
        scan.rename(made.folder / "scans" / scan.name)


def lock_database(made: Trial, client: subprocess.Popen[str]) -> None:
    if not made.database.exists():
        return
    database = sqlite3.connect(made.database, timeout=30)
    database.execute("begin exclusive")
    time.sleep(a_while())
    database.rollback()
    database.close()


def stop_server(made: Trial, client: subprocess.Popen[str]) -> None:
    assert made.postgres is not None
    made.postgres.stop()
    time.sleep(a_while())
    made.postgres.start()


def fill_disk(made: Trial, client: subprocess.Popen[str]) -> None:
    """Where worker 2 makes its results, a disk smaller than any is mounted in its name space."""
    process = made.cluster.processes["worker 2"].pid
    parts = made.cluster.parts
    parts.mkdir(parents=True, exist_ok=True)
    inside = ["nsenter", "-m", "-t", str(process)]
    mount = ["mount", "-t", "tmpfs", "-o", "size=100k", "tmpfs", str(parts)]
    subprocess.run([*inside, *mount], check=True)
    time.sleep(random.uniform(0.5, LONGEST_GAP))
    subprocess.run([*inside, "umount", "-l", str(parts)], check=True)


@dataclass(frozen=True)
class Fault:
    """make: what happens; ends: exit statuses that a run may have then; mend: before the campaign
    is run again."""

    make: Callable[[Trial, subprocess.Popen[str]], None]
    ends: tuple[int, ...] = (0,)
    mend: Callable[[Trial], None] | None = None


FAULTS = {
    "worker": Fault(kill_worker, (0, 1)),
    "scheduler": Fault(kill_scheduler, (0, 1)),
    "client": Fault(kill_client, (-9, 0)),
    "scan": Fault(take_scan, (0, 1), put_scans_back),
    "disk": Fault(fill_disk, (0, 1)),
    "locked": Fault(lock_database),
    "away": Fault(stop_server),
}


def faulty(name: str, made: Trial, most: int) -> int:
    """A campaign run until it ends well, with at most so many faults; how many came during a run.

    Raises Stuck.
    """
    fault, landed = FAULTS[name], 0
    for _ in range(MOST_RUNS):
        client = made.client()
        while client.poll() is None and landed < most:
            time.sleep(random.uniform(0.2, LONGEST_GAP))
            if client.poll() is None:
                fault.make(made, client)
                landed += 1
        status, said = finished(client)
        if status not in fault.ends:
            raise Stuck(f"exit status {status}: {said}")
        if fault.mend:
            fault.mend(made)
        if status == 0:
            require_once(made)
            return landed
    raise Stuck(f"{MOST_RUNS} runs, the last with exit status {status}: {said}")


def campaigns(name: str, scan: Path, times: int) -> tuple[int, int, list[str]]:
    """Until a fault was made so many times: faults, campaigns, and what went wrong."""
    made_faults, number, wrong = 0, 0, []
    with (
        server() if name == "away" else nullcontext() as postgres,
        cluster(scan, disk=name == "disk") as workers,
    ):
        while made_faults < times and number < 2 * times:
            made = trial(workers, number, scan, postgres)
            number += 1
            try:
                made_faults += faulty(name, made, times - made_faults)
            except Stuck as error:
                wrong.append(str(error))
            shutil.rmtree(made.folder)
    return made_faults, number, wrong


def parsed() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--times", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--outage", type=float, metavar="S")
    parser.add_argument("--only", choices=list(FAULTS), action="append")
    return parser.parse_args()


def skipped(name: str) -> str:
    """Why a fault cannot be made here."""
    if name == "disk" and (os.geteuid() != 0 or not shutil.which("nsenter")):
        return "needs root and nsenter for a full disk of one worker"
    if name == "away" and programs() is None:
        return "no PostgreSQL server is installed"
    return ""


def main() -> int:
    given = parsed()
    random.seed(given.seed)
    OUTAGE[:] = [] if given.outage is None else [given.outage]
    bad = 0
    with tempfile.TemporaryDirectory(prefix="tank_datum_faults_") as folder:
        scan = Path(folder) / "scan.pcd"
        tank_datum.simulate(SCENE, scan)
        for name in given.only or FAULTS:
            if why := skipped(name):
                print(f"{name:10} skipped: {why}", flush=True)
                continue
            faults, number, wrong = campaigns(name, scan, given.times)
            bad += len(wrong) + (faults < given.times)
            print(
                f"{name:10} {faults} faults in {number} campaigns of {TASKS} tasks; in "
                f"{number - len(wrong)} each result is there, once",
                flush=True,
            )
            for line in wrong:
                print(f"    {line}", flush=True)
    return 1 if bad else 0


if __name__ == "__main__":
    raise SystemExit(main())
