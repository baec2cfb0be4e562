"""A file of cases that is wrong is refused in one line that says where and why."""

from __future__ import annotations

from pathlib import Path

import pytest

from qa_command import qa


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "at least one [[case]]"),
        ("[[case]]\n", "case 1.name, None, expected a text"),
        ('[[case]]\nname = "a"\n', "a.inputs, None, expected a list of texts"),
        ('[[case]]\nname = "a"\ninputs = ["\\u0000"]\n', "a.inputs, '\\x00', expected texts"),
        ('[[case]]\nname = "a"\ninputs = []\n', "a.inputs, [], expected at least 1"),
        ('[[case]]\nname = "a"\ninputs = ["b"]\nopts = 1\n', "case 1, 'opts', expected one of"),
        ('[[case]]\nname = "a"\ninputs = ["b"]\nstatus = 3\n', "a.status, 3, expected 0 or 1"),
        ('[[case]]\nname = "a"\ninputs = ["b"]\ntolerance = {z = -1}\n', "a.tolerance.z, -1,"),
        ('[tolerance]\nz = "much"\n[[case]]\n', "tolerance.z, 'much', expected a number >= 0"),
        ('[[case]]\nname = "a"\ninputs = ["b"]\n' * 2, "a name of its own"),
        ("[[case", "expected TOML"),
        (
            '[[case]]\nname = "a"\ninputs = ["x"]\n'
            '[[case]]\nname = "b"\ninputs = ["x"]\nfixture = "a"\n',
            "b.fixture, 'a', expected another than that of 'a'",
        ),
        *(
            (f'[[case]]\nname = "a"\ninputs = ["b"]\n{line}\n', said)
            for line, said in (
                ('fixture = "../a"', "a.fixture, '../a', expected the name of a folder below"),
                ('fixture = "."', "a.fixture, '.', expected the name of a folder below"),
                ('fixture = "/tmp/a"', "a.fixture, '/tmp/a', expected the name of a folder below"),
                ('command = "view"', "a.command, 'view', expected extract, compare or levelling"),
                ('command = "compare"', "a.inputs, ['b'], expected at least 2"),
                ('files = ["../datum.json"]', "a.files, '../datum.json', expected names"),
                ('files = [".."]', "a.files, '..', expected names of files in the fixture"),
                ('files = [""]', "a.files, '', expected names of files in the fixture"),
                ('files = ["a\\u0000"]', "a.files, 'a\\x00', expected texts without"),
                ('options = ["a\\u0000"]', "a.options, 'a\\x00', expected texts without"),
                ('fixture = "a\\u0000"', "a.fixture, 'a\\x00', expected the name of a folder"),
                ('command = ["extract"]', "a.command, ['extract'], expected extract, compare"),
                ("status = true", "a.status, True, expected 0 or 1"),
                ("status = [0]", "a.status, [0], expected 0 or 1"),
                ("status = 1.0", "a.status, 1.0, expected 0 or 1"),
                (f"tolerance = {{z = 1{'0' * 400}}}", "a.tolerance.z, 1000"),
                ('options = ["-o", "x"]', "a.options, '-o', expected no option that names"),
                ('options = ["-ox"]', "a.options, '-ox', expected no option that names"),
                ('options = ["--output=x"]', "a.options, '--output=x', expected no option"),
                ('options = ["--timings", "x"]', "a.options, '--timings', expected no option"),
                ('options = ["--json", "x"]', "a.options, '--json', expected no option"),
                ('options = ["--json=x"]', "a.options, '--json=x', expected no option"),
            )
        ),
        *(
            (
                f'[[case]]\nname = "a"\ninputs = ["b", "{word}"]\n',
                f"a.inputs, '{word}', expected paths",
            )
            for word in ("-o", "--help", "")
        ),
    ],
)
def test_wrong_cases_are_refused(tmp_path: Path, text: str, said: str) -> None:
    cases = tmp_path / "cases.toml"
    cases.write_text(text)
    result = qa(cases)
    assert result.returncode == 2
    assert said in result.stderr
    assert result.stderr.count("\n") == 1


def test_no_cases_file(tmp_path: Path) -> None:
    result = qa(tmp_path / "none.toml")
    assert result.returncode == 2
    assert "No such file" in result.stderr


def test_a_byte_order_mark_is_passed_over(tmp_path: Path) -> None:
    cases = tmp_path / "cases.toml"
    cases.write_text('\ufeff[[case]]\nname = "a"\ninputs = ["b"]\n', encoding="utf-8")
    result = qa(cases, "--list")
    assert (result.returncode, result.stdout) == (0, "a: extract b\n")
