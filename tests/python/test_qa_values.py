"""Odd fixtures: what only one side has is a difference, and what cannot be read is said."""

from __future__ import annotations

from pathlib import Path

import pytest

from qa_command import fake, one_case, qa


def compared(folder: Path, name: str, fixture: str, result: str) -> tuple[int, str]:
    """Exit status and what is printed, of a run whose fixture and results are these texts."""
    (folder / "a").mkdir()
    (folder / "a" / name).write_text(fixture)
    (folder / "new").write_text(result)
    command = fake(folder, f'cp "{folder}/new" "$out/{name}"')
    done = qa(one_case(folder, more=f'files = ["{name}"]'), "--command", command)
    assert done.stderr == ""
    return done.returncode, " ".join(done.stdout.split())


LONG, DEEP = "1" + "0" * 400, "[" * 100_000


@pytest.mark.parametrize(
    ("name", "fixture", "result", "said"),
    [
        pytest.param("d.json", '{"a": []}', "{}", "d.json a is missing FAIL", id="list gone"),
        pytest.param("d.json", "{}", '{"a": []}', "d.json a is new FAIL", id="new list"),
        pytest.param("d.json", "{}", '{"a": {}}', "d.json a is new FAIL", id="new table"),
        pytest.param("d.json", '{"a": []}', '{"a": {}}', "a [] became {}", id="list and table"),
        pytest.param("d.json", '{"a": 1}', '{"a": true}', "a 1 became true", id="1 and true"),
        pytest.param("d.json", f'{{"a": {LONG}}}', '{"a": 1}', "a 10000", id="400 digits"),
        pytest.param("d.json", DEEP, '{"a": 1}', "cannot be read: values too deep", id="deep"),
        pytest.param("s.csv", "a,b\n1,2,3\n", "a,b\n1,2\n", "beyond the columns", id="cell gone"),
        pytest.param("s.csv", "a,b\n1,2\n", "a,b\n1,2,3\n", "beyond the columns", id="new cell"),
        pytest.param("s.csv", "a,b\n1,2,4\n", "a,b\n1,2,3\n", "beyond the columns", id="cell"),
        pytest.param("s.csv", "a,b\n1\n", "a,b\n1,2\n", "s.csv b null became 2.0", id="short row"),
        pytest.param("s.csv", "a\n10\n", "a\n1_0\n", 'a 10.0 became "1_0"', id="underscore"),
        pytest.param("s.csv", "a,a\n1,2\n", "a,a\n1,3\n", "s.csv a (2) moved 1 1", id="one name"),
        pytest.param("s.csv", 'a\n"' + "x" * 140_000, "a\n1\n", "field larger than", id="quote"),
    ],
)
def test_difference(tmp_path: Path, name: str, fixture: str, result: str, said: str) -> None:
    status, printed = compared(tmp_path, name, fixture, result)
    assert status == 1 and said in printed, printed


@pytest.mark.parametrize(
    ("name", "text"),
    [
        pytest.param("d.json", f'{{"a": [], "b": {{}}, "c": {LONG}}}', id="JSON"),
        pytest.param("s.csv", "a,a\n1\n1,2,3\n", id="CSV"),
    ],
)
def test_same_passes(tmp_path: Path, name: str, text: str) -> None:
    assert compared(tmp_path, name, text, text) == (0, "PASS a")
