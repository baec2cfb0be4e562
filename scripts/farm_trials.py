"""Trials of a campaign with a real scheduler and two workers; scripts/farm_faults.py uses them."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path

from sqlalchemy import create_engine, text

from farm_postgres import Server, free_port

TASKS = 12
LONGEST = 240  # seconds of a run
QUIET = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
SCENE = {
    "seed": 5,
    "tanks": [{"radius": 4, "height": 2, "tilt_slope": 0.002}],
    "scanner": {"count": 4, "distance": 5, "step_deg": 0.4, "max_range": 15},
    "near_datum": 0.6,
    "measurement": {"range_sigma": 0.001},
}


class Stuck(Exception):
    """A trial that did not come to the end that it must have."""


@dataclass
class Cluster:
    """A scheduler and two workers, whose results go to `results` in the folder."""

    folder: Path
    port: int
    disk: bool = False
    processes: dict[str, subprocess.Popen[bytes]] = field(default_factory=dict)

    @property
    def parts(self) -> Path:
        """Where results are made before they are put in place."""
        return self.folder / "results/.parts"

    def start(self, name: str) -> None:
        address = f"tcp://127.0.0.1:{self.port}"
        host = ["--host", "127.0.0.1"]
        plain = ["--no-dashboard"]
        if name == "scheduler":
            words = ["scheduler", "--port", str(self.port), *host, *plain]
        else:
            more = ["--nthreads", "1", "--no-nanny", "--death-timeout", "60"]
            folder = ["--local-directory", str(self.folder / "workers")]
            words = ["worker", address, *host, *plain, *more, *folder]
        command = [sys.executable, "-m", "distributed.cli.dask_" + words[0], *words[1:]]
        if self.disk and name == "worker 2":
            command = ["unshare", "-m", *command]
        self.processes[name] = subprocess.Popen(
            command, env=os.environ | {"OMP_NUM_THREADS": "1"}, **QUIET
        )

    def kill(self, name: str) -> None:
        self.processes[name].kill()
        self.processes[name].wait()

    def end(self) -> None:
        for process in self.processes.values():
            with suppress(OSError):
                process.kill()
            process.wait()


@dataclass
class Trial:
    """A campaign of its own; number: tells its tasks from those of other trials."""

    folder: Path
    cluster: Cluster
    number: int = 0
    postgres: Server | None = None

    @property
    def campaign(self) -> Path:
        return self.folder / "farm.toml"

    @property
    def database(self) -> Path:
        return self.folder / "history.sqlite"

    def client(self) -> subprocess.Popen[str]:
        words = ["run", self.campaign, "--scheduler", f"tcp://127.0.0.1:{self.cluster.port}"]
        waits = ["--database-wait", "120", "--scheduler-wait", "60"]
        return subprocess.Popen(
            [sys.executable, "-m", "tank_datum.farm", *map(str, words), *waits],
            text=True,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
        )


def write_campaign(made: Trial, scan: Path) -> None:
    database = "history.sqlite"
    if made.postgres:
        database = made.postgres.url
    text = f'allow_outside = true\nresults = "{made.cluster.folder}/results"\n'
    text += f'site = "{made.folder.name}"\ndatabase = "{database}"\n[[tank]]\nname = "T"\n'
    (made.folder / "scans").mkdir()
    for number in range(TASKS):
        os.link(scan, made.folder / f"scans/{number}.pcd")
        text += (
            f'[[scan]]\nfiles = "scans/{number}.pcd"\ntank = "T"\ndate = {2000 + number}-01-01\n'
            f"options.stations = {72 + number + TASKS * made.number}\n"
        )
    made.campaign.write_text(text)


@contextmanager
def cluster(scan: Path, *, disk: bool = False) -> Iterator[Cluster]:
    """On the file system of the scan. disk: worker 2 has a name space of its own, for mounts."""
    folder = Path(tempfile.mkdtemp(prefix="tank_datum_faults_", dir=scan.parent))
    made = Cluster(folder, free_port(), disk)
    try:
        for name in ("scheduler", "worker 1", "worker 2"):
            made.start(name)
        yield made
    finally:
        made.end()
        shutil.rmtree(folder, ignore_errors=True)


def trial(cluster: Cluster, number: int, scan: Path, postgres: Server | None = None) -> Trial:
    folder = cluster.folder / f"trial_{number}"
    folder.mkdir()
    made = Trial(folder, cluster, number, postgres)
    write_campaign(made, scan)
    return made


def finished(client: subprocess.Popen[str]) -> tuple[int, str]:
    """Exit status and last line. Raises Stuck."""
    try:
        out, _ = client.communicate(timeout=LONGEST)
    except subprocess.TimeoutExpired:
        client.kill()
        client.communicate()
        raise Stuck("the run did not end") from None
    return client.returncode, (out.strip().splitlines() or [""])[-1]


def require_once(made: Trial) -> None:
    """Everything is in the history, and once. Raises Stuck."""
    url = f"sqlite:///{made.database}"
    if made.postgres:
        url = made.postgres.url.replace("postgresql:", "postgresql+psycopg:")
    site = {"site": made.folder.name}
    joined = (
        "from extraction join result on extraction_key = key join epoch on epoch.id = epoch_id "
        "join tank on tank.id = tank_id where site = :site"
    )
    asked = (
        f"select count(*) {joined}",
        f"select count(distinct key) {joined}",
        f"select count(distinct job) {joined}",
        "select count(*) from failure where site = :site",
    )
    engine = create_engine(url)
    with engine.connect() as database:
        counts = [database.execute(text(each), site).scalar_one() for each in asked]
    engine.dispose()
    if counts != [TASKS, TASKS, TASKS, 0]:
        raise Stuck(f"results, extractions, jobs, failures {counts}")
