"""What a campaign costs, measured here, and from that what a large one would take.

  --farm          200 tanks x 5 epochs of small simulated scans: run, run again, report; the tanks
                  show the same points, but each has a number of stations of its own
  --overhead      milliseconds of engine and database for a task that does nothing but its row
  --scheduler     memory of the scheduler with 10 000 tasks that wait
  --pages         seconds until 200 tanks are drawn in Chromium
  --points        seconds and bytes for a scan of so many points, and the arithmetic to 1000 tanks

Without any of them the last one. Figures are printed, none is judged.
"""

from __future__ import annotations

import argparse
import os
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import psutil
import tank_datum

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests/python"))

GOAL_TANKS, GOAL_POINTS = 1000, 10**9
NIC = 1.25e9  # bytes a second of a 10 Gbit network


def timed(words: list[str]) -> tuple[float, str]:
    began = time.monotonic()
    done = subprocess.run(
        [sys.executable, "-m", "tank_datum.farm", *words], capture_output=True, text=True
    )
    return time.monotonic() - began, (done.stdout.strip().splitlines() or [done.stderr])[-1]


def farm(tanks: int, epochs: int, counts: list[int]) -> None:
    """Seconds of a run with 1 and 2 workers, of a second run, and of the pages."""
    from farm_made import Farm, scan

    for workers in counts:
        with tempfile.TemporaryDirectory() as folder:
            made = Farm(Path(folder))
            scans = [scan(Path(folder) / f"scans/{n}.pcd", seed=n + 1) for n in range(epochs)]
            for number in range(tanks):
                made.tank(f"T{number:03d}", f"options.stations = {72 + number}")
                for epoch, path in enumerate(scans):
                    made.scan(f"scans/{path.name}", f"T{number:03d}", f"{2015 + epoch}-01-01")
            file = str(made.write())
            seconds, said = timed(["run", file, "--workers", str(workers), "--quiet"])
            count = tanks * epochs
            print(
                f"{count} scans of 12 000 points, {workers} workers: {seconds:.1f} s, "
                f"{count / seconds:.2f} a second; {said}",
                flush=True,
            )
            seconds, said = timed(["run", file, "--quiet"])
            print(
                f"again: {seconds:.1f} s, {1e3 * seconds / count:.2f} ms a scan; {said}", flush=True
            )
            if workers == counts[-1]:
                seconds, said = timed(["report", file])
                print(f"report: {seconds:.1f} s, {seconds / tanks:.2f} s a tank", flush=True)
                seconds, said = timed(["report", file])
                print(f"report again: {seconds:.1f} s", flush=True)
                size = (Path(folder) / "history.sqlite").stat().st_size
                print(f"database: {size / count / 1e3:.1f} kB a result", flush=True)


def idle(number: int) -> dict[str, object]:
    """A task's row without its work."""
    from tank_datum.farm.task import OK, Row

    return Row(str(number), OK, f"{number:040x}").to_dict()


def overhead(count: int = 2000) -> None:
    """Submitted and taken as the engine does; recorded as the recorder does."""
    import tank_datum.farm.engine as engine
    from farm_drawn import drawn_farm
    from tank_datum.farm.cluster import client_of
    from tank_datum.farm.task import Task
    from tank_datum.farm.workers import Workers

    tasks = [Task(str(n), (), "", ()) for n in range(count)]
    engine.work = work_of_nothing
    with client_of(Workers(count=2)) as client:
        came: list[object] = []
        made = engine.Engine(tasks, lambda *row: came.append(row), lambda: None)
        began = time.monotonic()
        made.run(client)
        seconds = time.monotonic() - began
        print(f"engine, 2 workers: {1e3 * seconds / count:.2f} ms a task, {len(came)} tasks")
    with tempfile.TemporaryDirectory() as folder:
        began = time.monotonic()
        drawn_farm(Path(folder), tanks=50, epochs=4)
        print(
            f"store and database: {1e3 * (time.monotonic() - began) / 200:.2f} ms a result of 36 "
            "stations, its making included"
        )


def work_of_nothing(task: object) -> dict[str, object]:
    return idle(0)


def scheduler(count: int = 10_000) -> None:
    """All at once, as it is not done by the engine, and as it is."""
    from distributed import Client, LocalCluster

    for waiting in (4, count):
        with (
            LocalCluster(
                n_workers=1,
                threads_per_worker=1,
                processes=True,
                dashboard_address="127.0.0.1:0",
                silence_logs=50,
            ) as cluster,
            Client(cluster) as client,
        ):
            before = psutil.Process().memory_info().rss
            futures = [client.submit(time.sleep, 60, pure=False) for _ in range(waiting)]
            time.sleep(5)
            grown = psutil.Process().memory_info().rss - before
            print(f"{waiting} tasks that wait: {grown / 1e6:.1f} MB more in scheduler and client")
            client.cancel(futures)


def pages(tanks: int = 200) -> None:
    from farm_drawn import drawn_farm
    from playwright.sync_api import sync_playwright

    with tempfile.TemporaryDirectory() as folder:
        made = drawn_farm(Path(folder), tanks=tanks, epochs=2)
        assert made.command("report").returncode == 0
        index = Path(folder) / "pages/index.html"
        with sync_playwright() as tool:
            browser = tool.chromium.launch(
                executable_path=shutil.which("chromium"), args=["--no-sandbox"]
            )
            for _ in range(5):
                page = browser.new_page(viewport={"width": 1200, "height": 900})
                began = time.monotonic()
                page.goto(index.as_uri())
                page.wait_for_function("document.getElementById('shown').textContent !== ''")
                page.evaluate("new Promise((done) => requestAnimationFrame(() => done(1)))")
                opened = time.monotonic() - began
                began = time.monotonic()
                page.locator("#tanks th[data-key=tilt] button").click()
                print(
                    f"{tanks} tanks, {index.stat().st_size / 1e3:.0f} kB: "
                    f"drawn after {opened:.2f} s, "
                    f"sorted after {time.monotonic() - began:.2f} s"
                )
                page.close()
            browser.close()


def points(step: float) -> None:
    """A tank of 30 m radius scanned by twelve setups with so fine a step [deg]."""
    scene = {
        "tanks": [{"radius": 30, "height": 15}],
        "scanner": {"count": 12, "distance": 20, "step_deg": step, "max_range": 60},
    }
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "scan.pcd"
        tank_datum.simulate(scene, path)
        used = resource.getrusage(resource.RUSAGE_SELF)
        began = time.monotonic()
        datum = tank_datum.extract_datum(path, threads=1)
        seconds = time.monotonic() - began
        after = resource.getrusage(resource.RUSAGE_SELF)
        count = datum.to_dict()["input"]["files"][0]["points"]
        size = path.stat().st_size
    cpu = after.ru_utime + after.ru_stime - used.ru_utime - used.ru_stime
    print(
        f"{count / 1e6:.2f} million points, {size / count:.1f} bytes each: {seconds:.1f} s, "
        f"{cpu:.1f} s of processor, {after.ru_maxrss / 1e6:.2f} GB at most, one thread of "
        f"{os.cpu_count()}; {datum.status}"
    )
    arithmetic(cpu / count, size / count)


def arithmetic(second_a_point: float, bytes_a_point: float) -> None:
    """Both grow with the points: the scan is read in blocks; only the search does not."""
    print(f"10^8 points: {1e8 * second_a_point:.0f} s of processor, {bytes_a_point / 10:.2f} GB")
    core_hours = GOAL_TANKS * GOAL_POINTS * second_a_point / 3600
    data = GOAL_TANKS * GOAL_POINTS * bytes_a_point
    print(
        f"{GOAL_TANKS} tanks x 10^9 points: {core_hours:.0f} core hours, {data / 1e12:.1f} TB, "
        f"read twice: for the hash and for the datum"
    )
    for cores in (16, 64, 256):
        computing = core_hours / cores
        moving = 2 * data / NIC / 3600
        most = "processors" if computing > moving else "storage"
        print(
            f"{cores:4d} cores: {computing:.1f} h of computing, {moving:.1f} h of reading at "
            f"10 Gbit/s in all; the bottleneck is: {most}"
        )


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--farm", action="store_true")
    parser.add_argument("--tanks", type=int, default=200)
    parser.add_argument("--epochs", type=int, default=5)
    parser.add_argument("--workers", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--overhead", action="store_true")
    parser.add_argument("--scheduler", action="store_true")
    parser.add_argument("--pages", action="store_true")
    parser.add_argument("--points", action="store_true")
    parser.add_argument("--step-deg", type=float, default=0.05)
    given = parser.parse_args()
    load = os.getloadavg()[0]
    print(f"{os.cpu_count()} processors, load {load:.1f} before", flush=True)
    if given.farm:
        farm(given.tanks, given.epochs, given.workers)
    if given.overhead:
        overhead()
    if given.scheduler:
        scheduler()
    if given.pages:
        pages()
    if given.points or not (given.farm or given.overhead or given.scheduler or given.pages):
        points(given.step_deg)


if __name__ == "__main__":
    main()
