"""Results that were damaged on their way are refused as files, whatever is wrong with them."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import clouds

tank_datum = pytest.importorskip("tank_datum", reason="the module is not installed")
Damage = Callable[[Path], object]


def changed(change: Callable[[Any], object]) -> Damage:
    """datum.json with one thing changed."""

    def damage(folder: Path) -> None:
        record = json.loads((folder / "datum.json").read_text())
        change(record)
        (folder / "datum.json").write_text(json.dumps(record))

    return damage


def cut(name: str, kept: Callable[[bytes], float]) -> Damage:
    def damage(folder: Path) -> None:
        content = (folder / name).read_bytes()
        (folder / name).write_bytes(content[: int(kept(content))])

    return damage


def rows(name: str, count: int) -> Damage:
    def damage(folder: Path) -> None:
        lines = (folder / name).read_text().splitlines()
        (folder / name).write_text("\n".join(lines[: count + 1]) + "\n")

    return damage


def written(name: str, content: bytes) -> Damage:
    return lambda folder: (folder / name).write_bytes(content)


DAMAGES: dict[str, Damage] = {
    "json cut": cut("datum.json", lambda content: 0.7 * len(content)),
    "json not utf-8": written("datum.json", b'{"schema": 1, "status": "\xff"}'),
    "json deep": written("datum.json", b"[" * 100_000),
    "schema true": changed(lambda r: r.update(schema=True)),
    "schema text": changed(lambda r: r.update(schema="1")),
    "tank a number": changed(lambda r: r.update(tank=5)),
    "center a text": changed(lambda r: r["tank"].update(center="x")),
    "checks a dict": changed(lambda r: r.update(checks={})),
    "word missing": changed(lambda r: r["verdict"].pop("word")),
    "stations a text": changed(lambda r: r.update(stations="none")),
    "no files": changed(lambda r: r["input"].pop("files")),
    "beyond numbers": changed(lambda r: r["tilt"].update(slope=float("inf"))),
    "covariance": changed(lambda r: r["covariance"].update(factors=[[1.0, 2.0]])),
    "covariance without factors": changed(lambda r: r["covariance"].pop("factors")),
    "covariance of fewer": changed(
        lambda r: r["covariance"].update(independent=[0.001] * 9, factors=[])
    ),
    "fewer rows": rows("stations.csv", 99),
    "csv cut": cut("stations.csv", lambda content: content.rindex(b"\n")),
    "csv not utf-8": written("stations.csv", b"\xff\xfe"),
    "csv a quote": written("stations.csv", b'"'),
    "csv a column twice": written("stations.csv", b"station,station\n"),
    "shell cut in its last column": cut("shell.csv", lambda content: content.rindex(b",") + 2),
    "shell of fewer rows": rows("shell.csv", 99),
    "points without an axis": written(
        "datum_points.pcd",
        b"FIELDS full_x full_y x y z\nSIZE 8 8 4 4 4\nPOINTS 1\nDATA binary\n" + bytes(28),
    ),
    "points cut": cut("datum_points.pcd", lambda content: 0.9 * len(content)),
}


@pytest.mark.parametrize("damage", DAMAGES)
def test_damaged_results_are_refused(damage: str, command: Path, tmp_path: Path) -> None:
    folder = tmp_path / "out"
    shutil.copytree(command, folder)
    DAMAGES[damage](folder)
    with pytest.raises(tank_datum.FileError) as caught:
        tank_datum.load(folder)
    assert caught.value.stage == "load"
    assert str(folder) in caught.value.filename
    assert "\n" not in str(caught.value)


def test_schema_of_another_type_is_shown_as_it_is(command: Path, tmp_path: Path) -> None:
    folder = tmp_path / "out"
    shutil.copytree(command, folder)
    DAMAGES["schema text"](folder)
    with pytest.raises(tank_datum.FileError, match='schema "1", expected schema 1'):
        tank_datum.load(folder)


def test_an_older_result_lacks_what_came_later(command: Path, tmp_path: Path) -> None:
    folder = tmp_path / "out"
    shutil.copytree(command, folder)
    changed(lambda r: (r["input"].pop("far_points"), r["verdict"].pop("utilisation_95")))(folder)
    loaded = tank_datum.load(folder)
    assert loaded.input.far_points is None
    assert loaded.verdict.utilisation_95 is None
    with pytest.raises(AttributeError, match="Verdict has no 'word_'"):
        _ = loaded.verdict.word_


def test_every_part_is_an_attribute(datum: Any) -> None:
    record = datum.to_dict()
    for key in set(record) - {"stations", "covariance"}:
        assert getattr(datum, key) == (record[key] or getattr(datum, key)), key
    assert datum.datum.curve.degree == 3
    assert datum.input.files[0].points == record["input"]["files"][0]["points"]
    assert type(datum.tilt.copy()) is type(datum.tilt)


def test_a_file_of_another_name_draws_what_it_has(command: Path, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib").use("Agg")
    shutil.copy(command / "datum.json", tmp_path / "other.json")
    loaded = tank_datum.load(tmp_path / "other.json")
    loaded.plot("elevation")
    with pytest.raises(tank_datum.OptionError, match="u is not known"):
        loaded.plot("out_of_plane")


def test_a_rejected_circle_is_loaded_as_it_was(tmp_path: Path) -> None:
    """Without stations there is no file of edge points."""
    datum = tank_datum.extract_datum(clouds.tank(spacing=0.03) * 30)
    assert datum.status == "no_crease"
    datum.save(tmp_path)
    assert tank_datum.load(tmp_path) == datum
