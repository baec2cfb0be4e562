"""The words of the report: one file a language, none missing or left over, none in scripts."""

from __future__ import annotations

import csv
import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from programs import ROOT, run_program
from report_pages import SAMPLE, opened, with_data
from results import Run

Runner = Callable[..., Run]

PAGE = ROOT / "src/report/page"
LANGUAGES = sorted(path.stem for path in (PAGE / "words").glob("*.json"))
SCRIPTS = sorted((PAGE / "js").glob("*.js"))
SOURCES = sorted((ROOT / "src/report").glob("*.cpp"))
PLACE = re.compile(r"\{\w+\}")
KEY = re.compile(r'"((?:[a-z_]+\.)+\w+)"')
# keys that are put together while the page runs: say(`word.${name}`)
BUILT = (
    *("word.", "movement.removed.", "movement.mean.", "movement.tilt.", "movement.rest."),
    *("check_name.", "limit_rate.", "verdict.", "said.", "source."),
)
# a text of two plain words or a word with a capital, which a reader would see
TEXT = re.compile(r'"(?:[A-Z][a-z]+[a-z ,.]*|[a-z]+ [a-z]+ [a-z ,.]+)"')


def words(language: str) -> dict[str, str]:
    text = (PAGE / f"words/{language}.json").read_text()
    found: dict[str, str] = json.loads(text)
    return found


def without_comments(path: Path) -> str:
    text = re.sub(r"/\*.*?\*/", "", path.read_text(), flags=re.S)
    return re.sub(r"(?<!:)//.*", "", text)


def asked() -> set[str]:
    """Every key that script or library asks for."""
    text = "".join(without_comments(path) for path in [*SCRIPTS, *SOURCES])
    literal = {key for key in KEY.findall(text) if key in words("en") or "say(" in text}
    said = set(re.findall(r'say\("([\w.]+)"', text))
    assert said <= words("en").keys(), f"en.json lacks {sorted(said - words('en').keys())}"
    return literal | said


def test_english_has_every_key_and_no_other() -> None:
    found = asked()
    left = {
        key
        for key in words("en")
        if key.removesuffix(".many") not in found and not key.startswith(BUILT)
    }
    assert left == set()


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_language_has_what_english_has(language: str) -> None:
    english, own = words("en"), words(language)
    assert sorted(own) == sorted(english)
    for key, text in english.items():
        assert own[key].strip(), key
        assert set(PLACE.findall(own[key])) == set(PLACE.findall(text)), key
        assert "<" not in own[key], key


@pytest.mark.parametrize("language", LANGUAGES)
def test_keys_stand_once_and_in_order(language: str) -> None:
    pairs = json.loads(
        (PAGE / f"words/{language}.json").read_text(), object_pairs_hook=lambda found: found
    )
    keys = [key for key, _ in pairs]
    assert keys == sorted(set(keys))


@pytest.mark.parametrize("script", SCRIPTS, ids=lambda path: path.stem)
def test_no_script_holds_words(script: Path) -> None:
    kept = {"ArrowRight", "ArrowUp", "ArrowLeft", "ArrowDown", "Home"}
    found = [text for text in TEXT.findall(without_comments(script)) if text[1:-1] not in kept]
    assert found == []


def test_what_is_said_in_other_languages_is_what_the_library_says() -> None:
    """Each template's fixed words stand in a source; some are put together of pieces."""
    pieced = {f"said.{key}" for key in ("found_doubtful", "found_rejected", "setups_disagree")}
    pieced |= {"said.points_apart", "said.points_apart_once", "said.which_units"}
    sources = [p for end in ("*.cpp", "*.h") for p in sorted((ROOT / "src").rglob(end))]
    text = "".join(p.read_text() for p in sources)
    text += (ROOT / "src/limits/limits.csv").read_text()
    text = re.sub(r'"\s*"', "", text).replace("%%", "%").replace("\\n", " ")
    for key, template in words("en").items():
        if not key.startswith("said.") or key in pieced:
            continue
        pieces = [p.strip(" ,.:") for p in PLACE.split(template)]
        assert [p for p in pieces if len(p) > 3 and p not in text] == [], key


def test_every_standard_check_has_a_name_in_each_language() -> None:
    lines = (ROOT / "src/limits/limits.csv").read_text().splitlines()
    for row in csv.DictReader(line for line in lines if not line.startswith("#")):
        key = "check_name." + re.sub(r"[^a-z0-9]+", "_", row["name"].lower()).strip("_")
        assert words("en")[key] == row["name"]


@pytest.mark.parametrize("language", [name for name in LANGUAGES if name != "en"])
def test_a_page_holds_no_english_sentence(
    run: Runner, browser: Any, tmp_path: Path, language: str
) -> None:
    """A tank seen in part, and a refusal: verdict, notes, reasons and what to try."""
    english = [t for k, t in words("en").items() if k.startswith(("said.", "verdict.", "missing."))]
    for name, options in (("part", ("--tank", "0,0,5")), ("none", ("--min-radius", 20))):
        out = tmp_path / name
        run(SAMPLE, "-o", out, "--language", language, *options)
        with opened(browser, out / "report.html") as page:
            assert page.slips() == []
            said = page.text("#summary li, #summary .verdict, #summary .quality")
            assert len(said) > 60
            for template in english:
                pieces = [p.strip(" ,.:") for p in PLACE.split(template)]
                assert [p for p in pieces if len(p) > 12 and p in said] == []


@pytest.mark.parametrize("language", [name for name in LANGUAGES if name != "en"])
def test_citations_are_in_the_pages_language(
    browser: Any, sample_report: Path, tmp_path: Path, language: str
) -> None:
    """Codes, formulas and figures stay; of the words round them none is English."""
    lines = (ROOT / "src/limits/limits.csv").read_text().splitlines()
    rows = csv.DictReader(line for line in lines if not line.startswith("#"))
    citations = sorted({row["citation"] for row in rows})
    english = set("at most of the any with without roof also it to".split())
    told = {"language": language}
    page_file = with_data(sample_report / "report.html", tmp_path / "page.html", told)
    with opened(browser, page_file) as page:
        said = page.page.evaluate("citations => citations.map(translated)", citations)
        shown = page.page.locator(".checks tbody td:nth-child(5)").all_text_contents()
    for before, after in zip(citations, said, strict=True):
        assert set(re.findall(r"[a-z]+", after)) & english == set(), (before, after)
        assert re.findall(r"\d+", after) == re.findall(r"\d+", before) or language in ("zh", "ru")
    assert len(shown) > 5
    assert not any(re.search("verified|secondary", text) for text in shown), shown


FOUND = "circle found, R 16.71 m at 0, -0.001, seen over 328 deg"
SENTENCES = [
    f"{FOUND}, doubtful (option accept takes it): its foot is measured over 28 deg only; "
    "315 of 360 stations are missing: the datum is not measured there",
    f"{FOUND}: the foundation is first seen 225 mm from the shell: a lip or a gutter may be hidden",
    "the survey does not hold it; shown beside the limits that are judged by",
    "no survey points 15 to 32 ft apart: the tank is too small for 8 points 4.6 m (15 ft) apart",
    "the type of roof is not given (option roof: open or fixed); 0.30 m above the datum",
]


@pytest.mark.parametrize("language", [name for name in LANGUAGES if name != "en"])
def test_sentences_of_several_clauses_are_translated_clause_by_clause(
    browser: Any, sample_report: Path, tmp_path: Path, language: str
) -> None:
    told = {"language": language}
    page_file = with_data(sample_report / "report.html", tmp_path / "page.html", told)
    with opened(browser, page_file) as page:
        said = page.page.evaluate("texts => texts.map(translated)", SENTENCES)
    for before, after in zip(SENTENCES, said, strict=True):
        numbers = re.findall(r"\d+(?:\.\d+)?", before)
        assert sorted(re.findall(r"\d+(?:\.\d+)?", after)) == sorted(numbers), (before, after)
        english = set("the its seen is are of with over only by".split())
        assert set(re.findall(r"[a-z]+", after)) & english == set(), after


def test_the_option_knows_every_language() -> None:
    listed = json.loads(run_program("tank_datum", ["--print-options"]).stdout)
    (option,) = [o for o in listed if o["name"] == "language"]
    assert sorted(option["words"]) == LANGUAGES


def test_a_german_page_and_summary(
    run: Runner, browser: Any, sample_report: Path, tmp_path: Path
) -> None:
    """Headings, charts and movement in German; files, names of checks and their notes as ever."""
    options = ("--language", "de", "--baseline", sample_report)
    done = run(SAMPLE, "-o", tmp_path / "out", *options)
    assert done.returncode == 0
    told = next(line for line in done.stdout.splitlines() if line.startswith("movement "))
    assert "KEINE BEWEGUNG NACHGEWIESEN: Änderung des Mittels" in told
    with opened(browser, tmp_path / "out" / "report.html") as page:
        assert page.slips() == []
        assert page.page.evaluate("document.documentElement.lang") == "de"
        headings = page.texts("main h2")
        assert headings[:4] == ["Urteil", "Höhe", "Aus der Ebene", "Grundriss"]
        assert "360 Stationen gemessen" in page.text(".quality")
        assert "Azimut [°]" in page.page.locator("#elevation-chart").text_content()
        assert told.split(":", 1)[1].split(";")[0].split()[0] in page.text("#summary .quality")
        english = set(words("en").values()) - set(words("de").values())
        said = {t for t in page.texts("h2, h3, dt, th, caption, .legend label, button") if t}
        assert said & english == set()


def test_what_a_language_lacks_is_said_in_english(
    browser: Any, sample_report: Path, tmp_path: Path
) -> None:
    """A page of a language that has one word: that word, and English for the rest."""
    html = (sample_report / "report.html").read_text()
    html = html.replace('id="data-words">{', 'id="data-words">{"xx":{"plan.plan":"Aufsicht"},', 1)
    html = html.replace('"schema": 1,', '"schema": 1, "language": "xx",', 1)
    (tmp_path / "xx.html").write_text(html)
    with opened(browser, tmp_path / "xx.html") as page:
        assert page.slips() == []
        assert page.text("#plan h2") == "Aufsicht" and page.text("#elevation h2") == "Elevation"
        assert page.page.evaluate("document.documentElement.lang") == "xx"
