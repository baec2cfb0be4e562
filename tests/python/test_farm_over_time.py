"""A tank's epochs in time: settlement, tilt, levels and alarms, of movements that are known."""

from __future__ import annotations

import json
import math
from random import Random
from typing import Any

import pytest

from farm_made import require_farm

require_farm()

from tank_datum.farm.alarms import ALARM, WATCH, alarms_of  # noqa: E402
from tank_datum.farm.campaign import FarmTank, Limits, Survey  # noqa: E402
from tank_datum.farm.heights import datum_of  # noqa: E402
from tank_datum.farm.hydrotest import hydrotests_of  # noqa: E402
from tank_datum.farm.over_time import EpochDatum, history_of  # noqa: E402

from farm_drawn import base  # noqa: E402

ERROR = 0.0001


def epoch(number: int, *, settled: float = 0.0, tilt: float = 0.0, **given: Any) -> EpochDatum:
    """The base, lowered by what has settled [m] and tilted [m/m]; 0.1 mm of error a station."""
    random, record = Random(number), json.loads(json.dumps(base()))
    dip = given.pop("dip", 0.0)
    for station in record["stations"]:
        if station["z"] is not None:
            azimuth = station["azimuth_deg"]
            station["z"] += 4.0 * tilt * math.cos(math.radians(azimuth)) - settled
            station["z"] += random.gauss(0.0, ERROR) - (dip if 170 <= azimuth <= 190 else 0.0)
    date = given.pop("date", f"{2015 + number}-01-01")
    survey = Survey(("s",), "T", date, str(number), **given)
    return EpochDatum(survey, datum_of(json.dumps(record), str(number)), number + 1)


def test_settlement_tilt_and_their_rates() -> None:
    epochs = [epoch(n, settled=0.003 * n, tilt=0.0005 * n) for n in range(5)]
    limits = Limits(settlement=0.030, tilt=0.005)
    history = history_of(FarmTank("T"), epochs, limits)
    last = history.changes[-1]
    assert last.settlement == pytest.approx(0.012, abs=1e-4)
    assert last.tilt == pytest.approx(0.002, abs=2e-5) and last.tilt_direction_deg is not None
    settling, tilting = history.trends["settlement"], history.trends["tilt"]
    assert settling.low < 0.003 < settling.high and settling.moves
    assert settling.high - settling.low < 0.0005
    assert tilting.low < 0.0005 < tilting.high
    reached = settling.reaching
    assert reached and reached.latest and reached.earliest < "2025-01-01" < reached.latest
    worst = history.trends["station"]
    assert worst.azimuth_deg is not None and abs(worst.azimuth_deg - 180.0) <= 40.0
    tilted = 0.002 * math.cos(math.radians(worst.azimuth_deg - 180.0))
    assert worst.rate == pytest.approx(-0.003 - tilted, abs=1e-4)


def test_a_station_that_sinks_is_the_worst_in_its_place() -> None:
    epochs = [epoch(n, dip=0.004 * n) for n in range(4)]
    history = history_of(FarmTank("T"), epochs, Limits())
    worst = history.trends["out_of_plane"]
    assert worst.moves and worst.azimuth_deg is not None and 165 <= worst.azimuth_deg <= 195
    assert worst.rate == pytest.approx(-0.004, abs=6e-4)


def test_an_unmoved_tank_raises_nothing_and_is_not_near_its_limit() -> None:
    limits = Limits(settlement=0.030)
    history = history_of(FarmTank("T"), [epoch(n) for n in range(5)], limits)
    assert alarms_of(history, limits) == []
    reaching = history.trends["settlement"].reaching
    assert reaching and (reaching.latest, reaching.words) == (None, "not in sight")


@pytest.mark.parametrize(
    ("limits", "level", "words"),
    [
        (Limits(), WATCH, "moves: settlement of the mean +3.0"),
        (Limits(settlement=0.010), ALARM, "settlement of the mean 12.0 mm, limit 10.0"),
        (Limits(settlement=0.0119), WATCH, "settlement of the mean 12.0 mm, limit 11.9"),
        (Limits(settlement=0.030), "", ""),
        (Limits(settlement_rate=0.002), ALARM, "settlement of the mean +3.0"),
        (Limits(settlement_rate=0.004), "", ""),
    ],
    ids=["none", "passed", "near", "far", "rate passed", "rate far"],
)
def test_alarms_of_limits_and_rates(limits: Limits, level: str, words: str) -> None:
    """A limit that lies within the error of the figure is watched."""
    epochs = [epoch(n, settled=0.003 * n, registration_error=0.0003) for n in range(5)]
    history = history_of(FarmTank("T"), epochs, limits)
    found = [a for a in alarms_of(history, limits) if a.quantity == "settlement"]
    found = (
        found
        if not level
        else [
            a
            for a in found
            if not a.words.startswith("moves") or not (limits.settlement or limits.settlement_rate)
        ]
    )
    if level:
        assert (found[0].level, found[0].words[: len(words)]) == (level, words)
    else:
        assert all(a.level == WATCH for a in found)


def test_a_sudden_movement_at_the_end_is_told() -> None:
    epochs = [epoch(n, settled=0.0 if n < 4 else 0.005) for n in range(5)]
    limits = Limits()
    found = alarms_of(history_of(FarmTank("T"), epochs, limits), limits)
    assert any(a.words.startswith("has moved: settlement of the mean +5.0") for a in found)


@pytest.mark.parametrize("reference", ["marks", "stable", "mean"])
def test_heights_hang_on_what_the_user_says(reference: str) -> None:
    """Every epoch is scanned 50 mm higher than the one before; a sector sinks 4 mm."""
    tank = FarmTank(
        "T",
        height_reference=reference,
        marks={"A": 10.0, "B": 11.0},
        stable_deg=((200.0, 520.0),) if reference == "stable" else (),
    )
    epochs = [
        epoch(
            n,
            settled=-0.050 * n,
            dip=0.002 * n,
            marks={"A": 10.0 + 0.050 * n, "B": 11.0 + 0.050 * n},
            registration_error=0.0002,
        )
        for n in range(3)
    ]
    history = history_of(tank, epochs, Limits())
    last = history.changes[-1]
    if reference == "mean":
        assert last.settlement is None and "settlement" not in history.trends
    else:
        assert last.settlement == pytest.approx(0.004 * 20 / 360, abs=3e-4)
    assert last.station == pytest.approx(-0.004, abs=6e-4)
    assert history.notes == ()


def test_a_hydrotest_has_a_slope_and_what_is_left() -> None:
    """0.4 mm a metre while it fills; 1 mm stays when it is empty again."""
    levels = [0.0, 5.0, 10.0, 5.0, 0.0]
    settled = [0.0, 0.002, 0.004, 0.003, 0.001]
    epochs = [
        epoch(n, settled=s, fill_level=h, hydrotest="h", date="2024-05-01")
        for n, (h, s) in enumerate(zip(levels, settled, strict=True))
    ]
    (test,) = hydrotests_of(FarmTank("T"), epochs)
    assert test.per_metre and test.lasting and test.hysteresis
    assert test.per_metre.value == pytest.approx(0.0004, abs=2e-5)
    assert test.lasting.value == pytest.approx(0.001, abs=1e-4)
    assert test.hysteresis.value == pytest.approx(0.001, abs=2e-4)
    assert 0.0 < test.lasting.sigma < 2e-4 and test.highest == 10.0
    later = epoch(9, settled=0.002, fill_level=0.0, date="2025-05-01")
    history = history_of(FarmTank("T"), [*epochs, later], Limits())
    assert [change.epoch for change in history.changes] == ["0", "9"]


def test_epochs_that_cannot_be_compared_are_named() -> None:
    other = epoch(1)
    record = other.datum.to_dict()
    record["tank"]["radius"] += 1.0
    strange = EpochDatum(other.survey, datum_of(json.dumps(record), "1"), 2)
    history = history_of(FarmTank("T"), [epoch(0), strange, epoch(2)], Limits())
    assert [change.epoch for change in history.changes] == ["0", "2"]
    assert history.notes[0].startswith("1: movement: ")
