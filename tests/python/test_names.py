"""Names of tests can be read: short, and parameters have names and not numbers or bytes."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest

from programs import executable
from readable_ids import MOST, readable_id

LONGEST = 100  # characters


def fault_of(name: str) -> str | None:
    """What keeps a person from reading the name of a test, if anything."""
    if len(name) > LONGEST:
        return f"{len(name)} characters, expected at most {LONGEST}"
    if re.search(r"-byte object|<[0-9A-F]{2}[- ]| at 0x", name):
        return "it shows the bytes of an object"
    if re.search(r"/\d+\b", name.partition("[")[0]):
        return "it numbers its parameter, expected its name"
    return None


def faults(names: list[str]) -> list[str]:
    return [f"{name}: {fault}" for name in names if (fault := fault_of(name))]


def numbered(test: pytest.Function) -> bool:
    """Whether pytest found no name for a parameter but the argument's and a number."""
    if not hasattr(test, "callspec"):
        return False
    parts = test.callspec.id.split("-")
    return any(re.fullmatch(rf"{name}\d+", part) for name in test.callspec.params for part in parts)


def test_names_of_python_tests(request: pytest.FixtureRequest) -> None:
    tests = request.session.items
    wrong = faults([test.name for test in tests])
    wrong += [f"{test.name}: a parameter without a name" for test in tests if numbered(test)]
    assert not wrong, "\n".join(wrong)


def test_names_of_ctest() -> None:
    """Those of the build that TANK_DATUM_BIN, or build/bin, belongs to."""
    build = executable("tank_datum").parent.parent
    if not (build / "CTestTestfile.cmake").exists():
        pytest.skip(f"{build} was built without tests")
    listed = subprocess.run(
        ["ctest", "--test-dir", build, "-N"], capture_output=True, text=True, check=True
    )
    names = re.findall(r"^ *Test +#\d+: (.*)$", listed.stdout, re.MULTILINE)
    assert "qa" in names
    assert not faults(names), "\n".join(faults(names))


def test_parameters_of_the_unit_tests() -> None:
    """What a failing test prints of its parameter, which ctest's names leave out."""
    programs = sorted(executable("tank_datum").parent.glob("*_tests"))
    assert programs
    for program in programs:
        listed = subprocess.run(
            [program, "--gtest_list_tests"], capture_output=True, text=True, check=True
        )
        names = [line.strip() for line in listed.stdout.splitlines() if "# TypeParam" not in line]
        assert not faults(names), "\n".join([program.name, *faults(names)])


@pytest.mark.parametrize(
    ("name", "fault"),
    [
        ("Suite.Test", None),
        ("Suite.Test/ascii", None),
        ("Suite.Test<pcl::PointXYZ>", None),
        ("test_scale[1/2]", None),
        ("a" * 101, "101 characters"),
        ("Suite.Test/0", "numbers its parameter"),
        ("Test/a  # GetParam() = 72-byte object <E0-61>", "bytes of an object"),
        ("test_of[<function f at 0x7f00>]", "bytes of an object"),
    ],
    ids=["plain", "named", "typed", "python", "long", "numbered", "bytes", "address"],
)
def test_a_name_that_cannot_be_read_is_told(name: str, fault: str | None) -> None:
    told = fault_of(name)
    assert (told is None) if fault is None else (told is not None and fault in told)


def test_readable_ids() -> None:
    assert readable_id({"k": 12, "angle_deg": 30.0}) == "k=12 angle_deg=30.0"
    assert readable_id(["--k", "12"]) == "--k 12"
    assert readable_id("two\nlines") == "two lines"
    assert readable_id(Path(__file__).parents[2] / "README.md") == "README.md"
    assert readable_id("") == "blank"
    assert readable_id([]) == readable_id({}) == "none"
    assert readable_id(1.5) is None
    long = readable_id("a" * 200)
    assert long is not None and len(long) == MOST and long.endswith("...")
