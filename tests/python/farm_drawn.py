"""A farm whose results are put into store and history without scans: many tanks in seconds.

Each is the datum of one simulated scan, lowered and tilted by known amounts an epoch.
"""

from __future__ import annotations

import functools
import json
import math
from pathlib import Path
from random import Random
from typing import Any

from farm_made import Farm, scene

SETTLING = 0.002  # of tank n: n / 10 of it an epoch [m]
ERROR = 0.0001  # of a station, drawn anew each epoch [m]
TILTING = 0.0002  # likewise [m/m]


@functools.cache
def base() -> dict[str, Any]:
    import tank_datum

    points = tank_datum.simulate(scene(seed=1)).points
    found = tank_datum.extract_datum(
        points, stations=36, height=2, yield_mpa=235, modulus_mpa=206000, roof="open"
    )
    return found.to_dict()


def drawn_farm(
    folder: Path,
    tanks: int,
    epochs: int,
    names: dict[int, str] | None = None,
    database: str = "history.sqlite",
) -> Farm:
    """Tank number n settles by n / 10 of SETTLING an epoch; rows go through the recorder.

    database: a path or URL; the site's name is the folder's.
    """
    from tank_datum.farm import read_campaign
    from tank_datum.farm.history import open_history
    from tank_datum.farm.plan import store_url
    from tank_datum.farm.record import Recorder
    from tank_datum.farm.store import Store

    head = f'site = "{folder.name}"\ndatabase = "{database}"\n'
    farm = Farm(folder, head=f"{head}limits.settlement = 0.002\n")
    listed = [(names or {}).get(n, f"Tank-{n:03d}") for n in range(tanks)]
    for number, name in enumerate(listed):
        place = f"centre = [{20 * (number % 20)}, {20 * (number // 20)}]\nradius = 4"
        farm.tanks.append(f"[[tank]]\nname = {json.dumps(name)}\n{place}\n")
        for epoch in range(epochs):
            head = f'[[scan]]\nfiles = "scan.pcd"\ntank = {json.dumps(name)}\n'
            farm.scans.append(f'{head}date = {2015 + 2 * epoch}-06-01\nepoch = "{epoch}"\n')
    farm.write()
    (folder / "scan.pcd").write_text("no scan")
    campaign = read_campaign(farm.file)
    history = open_history(campaign)
    recorder = Recorder(history, campaign, history.begin_run(campaign))
    store = Store(store_url(campaign))
    for number, survey in enumerate(campaign.surveys):
        recorder.offer(survey, _stored(store, survey, *divmod(number, epochs)))
    assert recorder.waiting == 0, recorder.trouble
    history.close()
    return farm


def _stored(store: Any, survey: Any, tank: int, epoch: int) -> Any:
    from tank_datum.farm.task import OK, Row, TankRow

    record = json.loads(json.dumps(base()))
    random = Random(f"{tank} {epoch}")
    lowered, tilt = epoch * tank / 10 * SETTLING, epoch * tank / 10 * TILTING
    for station in record["stations"]:
        if station["z"] is not None:
            along = 4.0 * math.cos(math.radians(station["azimuth_deg"]))
            station["z"] += tilt * along - lowered + random.gauss(0.0, ERROR)
    record["tilt"]["slope"] += tilt
    record["verdict"] |= {
        "word": "FAIL" if tank % 5 == 0 else "PASS",
        "utilisation": 0.01 * (tank + 10 * epoch + 1),
    }
    record["datum"]["measured"] -= tank % 7
    record["datum"]["missing"] += tank % 7
    key = f"{tank:03x}{epoch:037x}"
    centre = tuple(record["tank"]["center"])
    row = TankRow(survey.tank, "tank_1", "ok", "", centre, record["tank"]["radius"])
    made = Row(survey.job, OK, key, tanks=(row,), seconds=1.0, points=12000)
    with store.making(key) as folder:
        (folder / "tank_1").mkdir()
        (folder / "tank_1/datum.json").write_text(json.dumps(record))
        (folder / "tank_1/report.html").write_text("<!DOCTYPE html><title>report</title>")
        (folder / "row.json").write_text(json.dumps(made.to_dict()))
    return made
