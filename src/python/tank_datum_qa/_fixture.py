"""A fixture's folder, which is rewritten with what a run gave."""

from __future__ import annotations

import shutil
from pathlib import Path

from tank_datum_qa._cases import Case
from tank_datum_qa._result_folder import ResultFolder
from tank_datum_qa._values import csv_table, read_json

HEAD = 64  # bytes by which files are told that are neither JSON nor CSV


def rewrite(case: Case, results: Path) -> list[str]:
    """Puts the results in the fixture's place, all or none; others' files keep another name."""
    ours = is_result(case.fixture)

    def is_own(place: Path) -> bool:
        return ours or is_alike(place, results / place.name)

    with ResultFolder(case.fixture, "qa", own=is_own) as new:
        for file in case.files:
            shutil.copyfile(results / file, new / file)
    return list(case.files)


def is_result(folder: Path) -> bool:
    """Whether a folder's datum.json or movement.json is one of tank_datum."""
    for name, keys in (
        ("datum.json", {"schema", "version", "input", "status"}),
        ("movement.json", {"schema", "version", "surveys", "movements"}),
    ):
        try:
            table = read_json(folder / name)
        except (OSError, ValueError):
            continue
        if isinstance(table, dict) and keys <= table.keys():
            return True
    return False


def is_alike(place: Path, result: Path) -> bool:
    """Whether a file stands for an earlier version of a result, by its content's form.

    A table of CSV with the first columns, or one of JSON with half of the keys, may have been
    written by an earlier version; others must begin alike.
    """
    try:
        if place.suffix == ".csv":
            old, new = csv_table(place)[0], csv_table(result)[0]
            return old[:2] == new[:2]
        if place.suffix == ".json":
            both = read_json(place), read_json(result)
            keys, wanted = (
                set(table) if isinstance(table, dict) else set() for table in both
            )
            return 2 * len(keys & wanted) > len(wanted)
        with place.open("rb") as one, result.open("rb") as other:
            return one.read(HEAD) == other.read(HEAD)
    except (OSError, ValueError):
        return False
