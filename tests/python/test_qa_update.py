"""What --update leaves behind: the same in every order, and only what is of others under a name."""

from __future__ import annotations

from pathlib import Path

import pytest

from qa_command import fake, one_case, qa

CASES = {
    "movement": 'command = "compare"\ninputs = ["spring", "autumn/datum.json"]',
    "again": 'inputs = ["x"]\noptions = ["--baseline=spring/datum.json"]\nfiles = ["datum.json"]',
    "spring": 'inputs = ["x"]\nfiles = ["datum.json"]',
    "autumn": 'inputs = ["x"]\nfiles = ["datum.json"]',
}
EXTRACT = """
sleep 0.2
case "$*" in *--baseline*) from=spring/datum.json ;; *) from=x ;; esac
cp "$from" "$out/datum.json"
"""


def cases_file(folder: Path, names: list[str]) -> Path:
    text = [f'[[case]]\nname = "{name}"\n{CASES[name]}\n' for name in names]
    (folder / "cases.toml").write_text("".join(text))
    return folder / "cases.toml"


@pytest.mark.parametrize("jobs", [1, 3])
@pytest.mark.parametrize("names", [list(CASES), list(reversed(CASES))], ids=["last", "first"])
def test_fixtures_come_before_what_reads_them(tmp_path: Path, names: list[str], jobs: int) -> None:
    command = fake(tmp_path, EXTRACT)
    (tmp_path / "other").mkdir()
    body = 'cp "$1/datum.json" "$out/movement.json"; cp "$2" "$out/movement.csv"'
    fake(tmp_path / "other", body).rename(tmp_path / "tank_datum_compare")
    cases = cases_file(tmp_path, names)
    for number in (1, 2):
        (tmp_path / "x").write_text(f'{{"a": {number}}}')
        updated = qa(cases, "--command", command, "--update", "--jobs", jobs)
        assert updated.returncode == 0, updated.stdout + updated.stderr
        result = qa(cases, "--command", command)
        assert result.stdout == "".join(f"PASS  {name}\n" for name in names)
        assert (tmp_path / "movement/movement.json").read_text() == f'{{"a": {number}}}'


def test_circle_is_refused(tmp_path: Path) -> None:
    cases = one_case(tmp_path, more='options = ["--baseline", "b"]')
    cases.write_text(cases.read_text() + '[[case]]\nname = "b"\ninputs = ["a"]\n')
    result = qa(cases, "--update")
    assert result.returncode == 2 and result.stderr.count("\n") == 1, result.stderr
    assert "--update, 'a' reads 'b' reads 'a', expected" in result.stderr


@pytest.mark.parametrize(
    ("name", "before", "after", "kept"),
    [
        ("stations.csv", "station,azimuth,z\n1,2,3\n", "station,azimuth,z,u\n1,2,3,4\n", False),
        ("stations.csv", "petrol stations\n", "station,azimuth,z\n1,2,3\n", True),
        ("stations.csv", '"not closed', "station,azimuth,z\n1,2,3\n", True),
        ("curves.json", '{"a": 1, "b": 1}', '{"a": 2, "b": 1, "c": 1}', False),
        ("curves.json", '{"name": "mine"}', '{"a": 2, "b": 1, "c": 1}', True),
        (
            "shell.txt",
            "# shell, of tank_datum, in the frame of the scan, in metres\t1 2\n1",
            "",
            True,
        ),
    ],
)
def test_what_is_kept(tmp_path: Path, name: str, before: str, after: str, kept: bool) -> None:
    """Where the fixture's folder has no datum.json that says whose its files are."""
    (tmp_path / "a").mkdir()
    (tmp_path / "a" / name).write_text(before)
    command = fake(tmp_path, f'cp new "$out/{name}"')
    (tmp_path / "new").write_text(after)
    result = qa(one_case(tmp_path, more=f'files = ["{name}"]'), "--command", command, "--update")
    assert result.returncode == 0, result.stdout + result.stderr
    assert (tmp_path / "a" / name).read_text() == after
    names = [path.read_text() for path in (tmp_path / "a").iterdir() if ".kept" in path.name]
    assert names == ([before] if kept else [])


def test_a_file_that_is_not_among_the_results_is_an_error(tmp_path: Path) -> None:
    """All of a fixture is rewritten or nothing, and a run that did not says so by its status."""
    cases = one_case(tmp_path, more='files = ["datum.json", "shel.csv"]')
    command = fake(tmp_path, 'echo "{}" > "$out/datum.json"')
    result = qa(cases, "--command", command, "--update")
    assert result.returncode == 1, result.stdout
    assert "files 'shel.csv', expected what is among the results" in result.stdout
    assert not (tmp_path / "a").exists()
