"""What can reach a result is computed alike on every processor: by core/portable_math.h, not by
those functions that the C library chooses by the processor."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
# of glibc 2.36 on x86-64 those with forms of their own for FMA and AVX2, those that call them, and
# those that later versions have such forms of; square roots, roundings, remainders and hypot have
# one result
CHOSEN = (
    *("sin", "cos", "tan", "sincos", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh"),
    *("asinh", "acosh", "atanh", "exp", "exp2", "exp10", "expm1", "log", "log2", "log10", "log1p"),
    *("pow", "cbrt", "erf", "erfc", "lgamma", "tgamma"),
)
NAMES = "|".join(CHOSEN)
CALL = re.compile(rf"(?<![\w:.>])(?:{NAMES})[fl]?\(|\bstd::(?:{NAMES}|polar|arg)[fl]?\b")
# these take logarithms or sines themselves
HIDDEN = re.compile(
    r"std::(?!uniform_)\w+_distribution|\bAngleAxis|\bRotation2D|\bslerp\b|"
    r"\.(?:array\(\)\.)?(?:sin|cos|tan|asin|acos|atan|exp|log|log10|pow|tanh|erf)\(\)"
)
HERE = Path("src/core/portable_math.h"), Path("src/core/portable_math.cpp")
NO_RESULTS = {"bench", "rates", "view"}  # what they say is no file of a tank


def sources() -> list[Path]:
    files = [p for folder in ("src", "include", "apps") for p in (ROOT / folder).rglob("*.[ch]pp")]
    files += [p for folder in ("src", "include", "apps") for p in (ROOT / folder).rglob("*.h")]
    paths = sorted(path.relative_to(ROOT) for path in files)
    return [
        p
        for p in paths
        if p not in HERE and not (p.parts[0] == "apps" and p.parts[1] in NO_RESULTS)
    ]


def calls_in(text: str) -> list[str]:
    """The lines that call such a function, without comments and texts."""
    found = []
    for number, line in enumerate(text.splitlines(), start=1):
        code = re.sub(r'"(?:[^"\\]|\\.)*"|//.*', "", line)
        if CALL.search(code) or HIDDEN.search(code):
            found.append(f"{number}: {line.strip()}")
    return found


def test_results_do_not_call_what_the_c_library_chooses_by_the_processor() -> None:
    found = [f"{path}:{call}" for path in sources() for call in calls_in((ROOT / path).read_text())]
    assert not found, "call those of core/portable_math.h:\n" + "\n".join(found)


@pytest.mark.parametrize(
    ("line", "named"),
    [
        ("z = std::sin(a);", True),
        ("z = sinf(a) + 1;", True),
        ("std::transform(a, b, c, std::exp);", True),
        ("std::normal_distribution<double> normal;", True),
        ("p = Eigen::AngleAxisd(a, axis) * p;", True),
        ("z = angles.array().sin();", True),
        ("z = portable::sin(a);", False),
        ("z = std::sqrt(a) + std::hypot(a, b);  // std::sin(a)", False),
        ('lacks("log(x)");', False),
        ("std::uniform_real_distribution<double> drawn;", False),
        ("viewer.log(a), fit.exp(b), polar(visits)", False),
    ],
)
def test_a_call_is_told(line: str, named: bool) -> None:
    assert bool(calls_in(line)) == named


def test_sleef_is_named_in_one_source() -> None:
    """So that nobody who includes the library's headers needs its headers."""
    named = [p for p in sorted((ROOT / "src").rglob("*.[ch]pp")) if "<sleef.h>" in p.read_text()]
    assert named == [ROOT / "src/core/portable_math.cpp"]
