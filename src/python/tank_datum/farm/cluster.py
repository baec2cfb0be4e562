"""The workers: a cluster of this machine, one that exists, or none for a shard."""

from __future__ import annotations

import contextlib
import logging
import os
import signal
import threading
from collections.abc import Iterator
from pathlib import Path

import dask.config
import psutil
from distributed import Client, LocalCluster

from tank_datum.farm.engine import connected
from tank_datum.farm.errors import FarmError
from tank_datum.farm.work import reason_of
from tank_datum.farm.workers import Workers

SETTINGS = {
    "distributed.scheduler.worker-saturation": 1.0,  # a dying worker takes one task along
    "distributed.scheduler.allowed-failures": 3,
    "distributed.comm.timeouts.connect": "10s",
    "distributed.worker.memory.spill": False,
    "distributed.worker.memory.target": False,
    "distributed.admin.log-format": "%(message)s",
}


@contextlib.contextmanager
def _undisturbed() -> Iterator[None]:
    """Signals wait until the cluster stands. Its threads, and the workers that they start, keep
    SIGINT blocked: Ctrl-C at the terminal is for the client, which then ends its workers."""
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    main = threading.current_thread() is threading.main_thread()
    came: list[int] = []
    handler = (
        signal.signal(signal.SIGTERM, lambda n, _: came.append(n)) if main else None
    )
    try:
        yield
    finally:
        if main:
            signal.signal(signal.SIGTERM, handler)
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
    if came:
        os.kill(os.getpid(), signal.SIGTERM)


def _silence() -> None:
    """Dask tells of connections that close, with their calls; what matters here is said by us."""
    names = [
        name
        for name in logging.root.manager.loggerDict
        if name.startswith("distributed")
    ]
    for name in ("distributed", *names):
        logging.getLogger(name).setLevel(logging.CRITICAL)


@contextlib.contextmanager
def client_of(workers: Workers) -> Iterator[Client]:
    """A client of these workers. Raises FarmError where the scheduler is not reached."""
    _silence()
    with dask.config.set(SETTINGS):
        if workers.scheduler:
            with connected(lambda: _joined(workers.scheduler)) as client:
                yield client
            return
        with _local(workers) as cluster, connected(lambda: Client(cluster)) as client:
            yield client


def _joined(scheduler: str) -> Client:
    if Path(scheduler).is_file():
        return Client(scheduler_file=scheduler, timeout=10, set_as_default=False)
    return Client(scheduler, timeout=10, set_as_default=False)


@contextlib.contextmanager
def _local(workers: Workers) -> Iterator[LocalCluster]:
    count = workers.count or os.cpu_count() or 1
    memory = workers.memory or int(0.9 * psutil.virtual_memory().available)
    with contextlib.ExitStack() as stack:
        with _undisturbed():
            cluster = _started(count, memory // count)
            stack.callback(_end, cluster)
        yield cluster


def _started(count: int, memory: int) -> LocalCluster:
    try:
        return LocalCluster(
            n_workers=count,
            threads_per_worker=1,
            processes=True,
            memory_limit=memory,
            dashboard_address="127.0.0.1:0",
            silence_logs=50,
        )
    except (OSError, RuntimeError) as error:
        raise FarmError(f"workers: {reason_of(error)}") from None


def _end(cluster: LocalCluster) -> None:
    """At once: nothing is lost, since a result is whole or not there."""
    with _undisturbed():
        processes = [nanny.process for nanny in cluster.workers.values()]
        for held in processes:
            with contextlib.suppress(Exception):
                os.kill(held.process.pid, signal.SIGKILL)
        with contextlib.suppress(Exception):
            cluster.close(timeout=2)
