"""Outcomes as JUnit XML."""

from __future__ import annotations

import re
from pathlib import Path
from xml.etree import ElementTree

from tank_datum_qa._output_file import write_output
from tank_datum_qa._run import Outcome

NO_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def write_junit(path: Path, outcomes: list[Outcome]) -> None:
    """A testcase per case with its seconds; the table of what moved too far as its failure."""
    suite = ElementTree.Element(
        "testsuite", name="tank_datum qa", tests=str(len(outcomes))
    )
    suite.set("failures", str(sum(not outcome.passed for outcome in outcomes)))
    suite.set("time", f"{sum(outcome.seconds for outcome in outcomes):.3f}")
    for outcome in outcomes:
        case = ElementTree.SubElement(
            suite,
            "testcase",
            classname=f"qa.{outcome.case.command}",
            name=_xml_text(outcome.case.name),
            time=f"{outcome.seconds:.3f}",
        )
        if not outcome.passed:
            failure = ElementTree.SubElement(
                case, "failure", message=_xml_text(_headline(outcome))
            )
            failure.text = _xml_text("\n".join(outcome.lines(failed_only=True)))
    text = ElementTree.tostring(suite, encoding="utf-8", xml_declaration=True)
    write_output(path, text, "qa", is_junit)


def _xml_text(text: str) -> str:
    """A text without the characters that XML has no place for, which are escaped."""
    return NO_XML.sub(lambda found: ascii(found[0])[1:-1], text)


def _headline(outcome: Outcome) -> str:
    """The failure in a line."""
    if outcome.error:
        return outcome.error
    bad = [change for change in outcome.changes if change.failed]
    first = bad[0]
    text = f"{first.file}: {first.key} {first.what}".replace("  ", " ")
    if first.what == "moved":
        text += f" by {first.largest:.3g}, {first.tolerance:.3g} allowed"
    return text + (f", and {len(bad) - 1} more" if len(bad) > 1 else "")


def is_junit(path: Path) -> bool:
    return b'<testsuite name="tank_datum qa"' in path.read_bytes()[:200]
