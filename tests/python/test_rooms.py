"""The rooms of src/: who may include whom, and that src/README.md names what is there."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
INCLUDE = re.compile(r'^\s*#\s*include\s+["<]([^">]+)[">]')
PARALLEL = Path("src/core/thread_pool.cpp")
RAW_OPENMP = re.compile(r'#\s*pragma\s+omp\b|#\s*include\s+[<"]omp\.h[>"]')
MOST_LINES = 250
SOURCES = {".h", ".hpp", ".cpp", ".c", ".py", ".js", ".css", ".cmake", ".txt", ".sh", ""}
PROGRAMS = {"bench", "rates", "synth", "view"}
# a text, or a comment, which may hold quotes too
TEXT = re.compile(r""""(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)*'|`[^`]*`|//.*""")
FLAG = re.compile(r"(?<![\w-])--[a-z]")


def rooms_in_order() -> list[str]:
    """The rooms from src/CMakeLists.txt, bottom first; "." is src itself."""
    text = (ROOT / "src/CMakeLists.txt").read_text()
    return re.search(r"foreach\(room ([^)]*)\)", text)[1].split()


ORDER = rooms_in_order()


def sources(*folders: str) -> list[Path]:
    return [
        path.relative_to(ROOT)
        for folder in folders
        for path in sorted((ROOT / folder).rglob("*"))
        if path.suffix in {".h", ".hpp", ".cpp"}
    ]


def room_of(path: Path) -> str:
    """Where a file of src/ or include/tank_datum/ lives."""
    parts = path.parts[2:] if path.parts[0] == "include" else path.parts[1:]
    return parts[0] if len(parts) > 1 else "."


def target_of(include: str) -> str | None:
    """The room of an included header of the project, "apps" of a program's; None of any other."""
    for base in ("src", "include"):
        if (ROOT / base / include).is_file():
            return room_of(Path(base) / include)
    return "apps" if (ROOT / "apps" / include).is_file() else None


def broken_rule(path: Path, include: str) -> str | None:
    """What an include line of a file breaks, if anything."""
    target = target_of(include)
    if path.parts[0] == "apps":
        inside = [part for part in (path.parts[1], Path(include).parts[0]) if part in PROGRAMS]
        if target == "apps" and len(inside) == 2 and inside[0] != inside[1]:
            return f"the program {inside[0]} includes a header of its sibling {inside[1]}"
        return None
    if target is None:
        return None
    room = room_of(path)
    if target == "apps":
        return "the library includes a program's header"
    if room != "python" and ORDER.index(target) > ORDER.index(room):
        return f"{room} includes {target}, which stands above it"
    if path.parts[0] == "include" and not include.startswith("tank_datum/"):
        return "a public header includes a private one"
    return None


def violations(text: str, path: Path) -> list[str]:
    found = []
    for number, line in enumerate(text.splitlines(), start=1):
        match = INCLUDE.match(line)
        rule = broken_rule(path, match[1]) if match else None
        if rule:
            found.append(f"{path}:{number}: {rule}")
    return found


def test_every_room_has_its_folder_and_every_folder_its_room() -> None:
    folders = {path.name for path in (ROOT / "src").iterdir() if path.is_dir()}
    assert folders - {"cmake", "python", "doc"} == set(ORDER) - {"."}


def test_includes_go_down_only() -> None:
    found = []
    for path in sources("src", "include", "apps"):
        found += violations((ROOT / path).read_text(), path)
    assert not found, "\n".join(found)


@pytest.mark.parametrize(
    ("path", "include", "rule"),
    [
        (
            "src/locate/crop.cpp",
            "shell/shell_bands.h",
            "locate includes shell, which stands above it",
        ),
        ("src/movement/epoch.cpp", "tank_datum/report/report.h", "movement includes report"),
        ("src/shape/analysis.cpp", "tank_datum/datum.h", "shape includes ., which stands above it"),
        (
            "include/tank_datum/foot/refined.h",
            "foot/shell_line.h",
            "a public header includes a private",
        ),
        ("src/python/options.cpp", "exit_status.h", "the library includes a program's header"),
        (
            "apps/view/scene.cpp",
            "synth/scene.h",
            "the program view includes a header of its sibling",
        ),
    ],
    ids=["upward", "report", "chain", "private", "program", "sibling"],
)
def test_a_forbidden_include_is_named(path: str, include: str, rule: str) -> None:
    (found,) = violations(f'#pragma once\n#include "{include}"\n', Path(path))
    assert found.startswith(f"{path}:2: ")
    assert rule in found


def test_allowed_includes_are_not_named() -> None:
    text = '#include "core/units.h"\n#include "tank_datum/datum.h"\n#include <vector>\n'
    assert violations(text, Path("src/report/summary.cpp")) == []


def test_public_headers_are_few() -> None:
    """Only what a user of the library needs is public; the rest stands in src/."""
    assert len(sources("include")) <= 25


def test_the_datum_is_known_without_the_functions_that_make_it() -> None:
    """datum.h takes in the results of the stages, none of the headers of their functions."""
    met, waiting = set(), {"tank_datum/datum.h"}
    while waiting:
        header = waiting.pop()
        met.add(header)
        lines = (ROOT / "include" / header).read_text().splitlines()
        found = {match[1] for match in map(INCLUDE.match, lines) if match}
        waiting |= {name for name in found if name.startswith("tank_datum/")} - met
    functions = {"edge/find_edge_points.h", "search/estimate_normals.h", "pcl/pcl_stages.h"}
    assert not met & {f"tank_datum/{name}" for name in functions}
    assert len(met) <= 17


def test_one_way_to_be_parallel() -> None:
    raw = [
        f"{path}:{number}: a raw OpenMP region; use forEachIndex of core/parallel.h"
        for path in sources("src", "include", "apps")
        if path != PARALLEL
        for number, line in enumerate((ROOT / path).read_text().splitlines(), start=1)
        if RAW_OPENMP.search(line)
    ]
    assert not raw, "\n".join(raw)


def test_no_two_cpp_tests_write_the_same_file() -> None:
    """Cases run side by side, each a process; a file of a fixed name is written by several."""
    shared = [
        f"{path}:{number}: a temporary name of its own; use TestFolder"
        for path in sources("tests")
        if path != Path("tests/support/test_folder.h")
        for number, line in enumerate((ROOT / path).read_text().splitlines(), start=1)
        if re.search(r"temp_directory_path|TempDir\(|tmpnam|getpid\(", line)
    ]
    assert not shared, "\n".join(shared)


def flags_in(text: str, path: Path) -> list[str]:
    """The lines whose text for people names a flag; comments may."""
    found = []
    for number, line in enumerate(text.splitlines(), start=1):
        texts = [text for text in TEXT.findall(line) if not text.startswith("//")]
        if any(FLAG.search(text) for text in texts):
            found.append(
                f"{path}:{number}: a flag in a text of the library; write 'option some_name'"
            )
    return found


def test_texts_of_the_library_name_no_flags() -> None:
    """They are read by Python's users too. A program writes --some-name for "option some_name"."""
    found = []
    for path in [*sources("src", "include"), *scripts_of_the_page()]:
        if path.parts[1] not in {"python", "doc"}:
            found += flags_in((ROOT / path).read_text(), path)
    assert not found, "\n".join(found)


def scripts_of_the_page() -> list[Path]:
    return [path.relative_to(ROOT) for path in sorted((ROOT / "src/report/page").rglob("*.js"))]


@pytest.mark.parametrize(
    ("line", "named"),
    [
        ('lacks(facts.height, "shell height (--height)");', True),
        ("say('needs --yield-mpa');", True),
        ('lacks(facts.height, "shell height (option height)");  // --height', False),
        ('"a-->b", "--", "x --y"[0]', True),
        ('"ends --" + name', False),
    ],
)
def test_a_flag_in_a_text_is_named_with_its_line(line: str, named: bool) -> None:
    assert bool(flags_in(line, Path("src/limits/checks.cpp"))) == named


def test_files_are_short() -> None:
    """Every source, script and build file; data aside."""
    files = [
        path
        for folder in ("src", "include", "apps", "tests", "scripts")
        for path in sorted((ROOT / folder).rglob("*"))
        if path.is_file() and path.suffix in SOURCES and "__pycache__" not in path.parts
    ]
    files = [path for path in files if not path.is_relative_to(ROOT / "tests/data")]
    assert len(files) > 400
    lines = {str(path.relative_to(ROOT)): path.read_bytes().count(b"\n") for path in files}
    long = [f"{name}: {count} lines" for name, count in lines.items() if count > MOST_LINES]
    assert not long, "\n".join(long)


def test_the_maintainers_page_is_short_and_names_what_is_there() -> None:
    page = (ROOT / "src/README.md").read_text()
    assert len(page.splitlines()) <= 60
    for name in re.findall(r"`([\w./]+\.(?:h|hpp|cpp|py|csv|txt)|[\w./]+/)`", page):
        assert any((ROOT / base / name).exists() for base in (".", "src", "include/tank_datum")), (
            f"src/README.md names {name}, which is not there"
        )
    code = "\n".join((ROOT / path).read_text() for path in sources("src", "include"))
    for name in re.findall(r"`([A-Z][A-Za-z]+|[a-z]+[A-Z][A-Za-z]*)(?:\(\))?`", page):
        assert re.search(rf"\b{name}\b", code), f"src/README.md names {name}, which is not there"
    table = re.findall(r"^\| `([a-z]+)/` \|", page, re.MULTILINE)
    assert table == [room for room in ORDER if room != "."] + ["python"], "rooms in order"
