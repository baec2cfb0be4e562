"""scripts/mutants finds the named numbers, writes a copy that asks for them, and tests it."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))

import mutant_sources  # noqa: E402
import mutant_tests  # noqa: E402
import mutants  # noqa: E402

SOURCE = """#include <cstdio>
struct Pair { double a, b; };
constexpr double kOne = 0.25, kTwo = 4.0;  // [m]
constexpr double kFollows = kOne;
constexpr Pair kPair{1.5, 2.5};
int size() {
  constexpr int kThree = 7;
  constexpr int kLength = 3;
  int all[kLength] = {kThree, 0, 0};
  return all[0];
}
int main() { std::printf("%g %g %g %g %d", kOne, kTwo, kFollows, kPair.b, size()); }
"""


@pytest.mark.parametrize(
    ("value", "factors"),
    [
        ("8", [0.5, 2.0]),
        ("1", [2.0]),
        ("0", []),
        ("30'000", [0.5, 2.0]),
        ("0.3", [0.5, 2.0]),
        ("0.0", []),
    ],
)
def test_factors_leave_out_what_is_the_same_or_nothing(value: str, factors: list[float]) -> None:
    assert mutant_sources.Constant("src/a.cpp", 1, "kA", value).factors() == factors


def rewritten(compile_time: frozenset[str] = frozenset()) -> mutant_sources.Rewriter:
    return mutant_sources.Rewriter("src/fit/a.cpp", SOURCE, compile_time)


def test_every_number_is_found_and_what_follows_from_others_is_not() -> None:
    found = [(c.name, c.line, c.value) for c in rewritten().constants]
    assert found == [
        ("kOne", 3, "0.25"), ("kTwo", 3, "4.0"), ("kPair.1", 5, "1.5"), ("kPair.2", 5, "2.5"),
        ("kThree", 7, "7"), ("kLength", 8, "3"),
    ]  # fmt: skip


def test_a_second_constant_of_a_name_has_a_key_of_its_own() -> None:
    text = "void f() {\n  constexpr int kA = 2;\n}\nvoid g() {\n  constexpr int kA = 3;\n}\n"
    keys = [c.key for c in mutant_sources.Rewriter("a.cpp", text).constants]
    assert keys == ["a.cpp:kA", "a.cpp:kA#2"]


def test_a_file_without_a_number_to_change_stays_as_it_is() -> None:
    text = "constexpr double kA = 1.0;\n"
    assert mutant_sources.Rewriter("a.cpp", text, frozenset({"a.cpp:kA"})).rewritten == text


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The source, rewritten and built."""
    folder = tmp_path_factory.mktemp("mutants")
    (folder / "mutated.h").write_text(mutant_sources.HEADER)
    (folder / "a.cpp").write_text(rewritten(frozenset({"src/fit/a.cpp:kLength"})).rewritten)
    subprocess.run(["c++", "-std=c++17", "-o", folder / "a", folder / "a.cpp"], check=True)
    return folder / "a"


@pytest.mark.parametrize(
    ("mutant", "printed"),
    [
        ("", "0.25 4 0.25 2.5 7"),
        ("src/fit/a.cpp:kOne 2", "0.5 4 0.5 2.5 7"),
        ("src/fit/a.cpp:kTwo 0.5", "0.25 2 0.25 2.5 7"),
        ("src/fit/a.cpp:kPair.2 2", "0.25 4 0.25 5 7"),
        ("src/fit/a.cpp:kThree 0.5", "0.25 4 0.25 2.5 3"),
    ],
)
def test_one_program_serves_all_mutants(program: Path, mutant: str, printed: str) -> None:
    environment = {"TANK_DATUM_MUTANT": mutant} if mutant else {}
    done = subprocess.run([program], capture_output=True, text=True, check=True, env=environment)
    assert done.stdout == printed


def test_a_program_says_what_it_asked_for(program: Path, tmp_path: Path) -> None:
    subprocess.run(
        [program],
        check=True,
        capture_output=True,
        env={"TANK_DATUM_TOUCHED": str(tmp_path / "keys")},
    )
    keys = (tmp_path / "keys").read_text().split()
    assert keys == [
        f"src/fit/a.cpp:{name}" for name in ("kOne", "kPair.1", "kPair.2", "kThree", "kTwo")
    ]


def test_own_room_and_closest_tests_come_first() -> None:
    key = "src/fit/circle.cpp:kA"

    def case(program: str, source: str, seconds: float, asked: int) -> mutant_tests.Case:
        others = {f"b{i}" for i in range(asked)}
        return mutant_tests.Case(program, ".", "T.t", source, seconds, frozenset({key, *others}))

    far = case("datum_test", "tests/datum_test.cpp", 0.1, 300)
    slow = case("spline_test", "tests/fit/spline_test.cpp", 2.0, 3)
    near = case("spline_test", "tests/fit/spline_test.cpp", 0.1, 3)
    own = case("circle_test", "tests/fit/circle_test.cpp", 0.2, 20)
    other = mutant_tests.Case("x_test", ".", "T.t", "tests/fit/x_test.cpp", 0.1, frozenset())
    runs = mutant_tests.in_order([far, slow, near, own, other], key, 30.0)
    assert runs == [[own], [near], [slow], [far]]
    assert mutant_tests.in_order([far, slow, near, own, other], key, 0.35) == [[own], [near]]


def test_what_is_left_alone_is_in_the_sources() -> None:
    assert mutants.stale(mutants.left_alone(ROOT), mutant_sources.all_constants(ROOT)) == []
