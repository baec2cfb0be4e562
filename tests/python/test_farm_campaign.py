"""Campaign files of tank_datum_farm: what is read, and what is refused with its line."""

from __future__ import annotations

from pathlib import Path

import pytest

from farm_made import Farm, farm_command, require_farm

require_farm()

from tank_datum.farm import CampaignError, read_campaign  # noqa: E402
from tank_datum.farm.toml_lines import line_numbers  # noqa: E402

GOOD = """site = "North"
[limits]
settlement = 0.05
tilt = 0.004
[options]
stations = 180
[[tank]]
name = "T1"
height = 12
roof = "fixed"
centre = [
  10.0,
  20,
]
radius = 5
drawing_north_deg = 90
limits.settlement = 0.02
[[tank]]
name = "T2"
height_reference = "stable"
stable_deg = [[10, 80]]
[[scan]]
files = ["a.pcd", "b.pcd"]
tank = "T1"
date = 2021-05-31
fill_level = 2
setup_error = 0.001
registration_error = 0.0005
[[scan]]
files = "*.pcd"
tank = "find"
date = "2022-05-31"
epoch = "second"
"""


@pytest.fixture
def campaign(tmp_path: Path) -> Path:
    path = tmp_path / "farm.toml"
    path.write_text(GOOD)
    return path


def refusals(path: Path, text: str) -> list[str]:
    path.write_text(text)
    with pytest.raises(CampaignError) as refused:
        read_campaign(path)
    return [str(problem).removeprefix(f"{path}:") for problem in refused.value.problems]


def test_everything_of_a_campaign_is_read(campaign: Path) -> None:
    read = read_campaign(campaign)
    first, second = read.tanks
    assert (read.site, first.steel) == ("North", {"height": 12.0, "roof": "fixed"})
    assert first.place == (10.0, 20.0, 5.0) and second.place is None
    assert read.limits_of(first).settlement == 0.02 and read.limits_of(first).tilt == 0.004
    assert read.limits_of(second).settlement == 0.05
    scan, find = read.surveys
    assert scan.files == ("a.pcd", "b.pcd") and scan.options == {"setup_error": 0.001}
    assert (scan.epoch, scan.fill_level, scan.registration_error) == ("2021-05-31", 2.0, 0.0005)
    assert (find.job, find.date, scan.line) == ("find/second", "2022-05-31", 22)


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ('site = "North"', 'site = "N\\u001b[2J"', "1: site, 'N\\x1b[2J', expected a text without"),
        ('"North"', '"N"\ndatabase = "mysql://x"', "2: database, 'mysql://x', expected sqlite or"),
        ("settlement = 0.05", "settlement = -1", "3: limits.settlement, -1, expected a number > 0"),
        ("stations = 180", "stations = 3", "6: options: stations, 3, expected 8 to 36000"),
        ("stations = 180", "statoins = 180", "6: options.statoins, 180, expected an option"),
        ("stations = 180", "tank = 'a'", "6: option tank is set by centre and radius"),
        ("height = 12", "hieght = 12", "9: tank.hieght, 12, expected one of: centre"),
        ("height = 12", "height = nan", "9: tank.height, nan, expected a number > 0"),
        ("radius = 5", "", "7: tank 'T1': a centre without a radius"),
        ("  20,", "", "11: tank.centre, [10.0], expected 2 numbers"),
        ('"T2"', '"T1"', "19: tank.name, 'T1', expected a name of its own"),
        ('"T2"', '"t1"', "19: tank.name, 't1', expected a name of its own"),
        ('"T2"', '"T\\u202e2"', "19: tank.name, 'T\\u202e2', expected a text without control"),
        ("[[10, 80]]", "[[80, 10]]", "21: tank.stable_deg, [80.0, 10.0], expected from < to"),
        ("stable_deg = [[10, 80]]", "", "18: tank 'T2': height_reference stable, no stable_deg"),
        ('tank = "T1"', 'tank = "T9"', "24: scan.tank, 'T9', expected a tank's name or 'find'"),
        ("date = 2021-05-31", "date = 3", "25: scan.date, 3, expected a date as 2024-05-31"),
        ("2021-05-31", "2021-02-30", "25: "),
        ("2021-05-31", "0201-05-31", "25: scan.date, '0201-05-31', expected a date from 1900"),
        ("fill_level = 2", "fill_level = 12.5", "26: scan.fill_level, 12.5, expected at most the"),
        ("stations = 180", "limits = '../l'", "6: options.limits, '../l', expected a path below"),
        ("fill_level = 2", "b = 1\na = 1", "26: scan.b, 1, expected one of: date"),
        ('"a.pcd"', '"../a.pcd"', "23: scan.files, '../a.pcd', expected a path below"),
        ('"*.pcd"', '"/a.pcd"', "30: scan.files, '/a.pcd', expected a path below"),
        ("fill_level = 2", "hydrotest = 'h'", "22: scan 'T1/2021-05-31': of a hydrotest without"),
    ],
)
def test_refused_with_its_line(campaign: Path, old: str, new: str, expected: str) -> None:
    found = refusals(campaign, GOOD.replace(old, new, 1))
    assert any(refusal.startswith(expected) for refusal in found), found


LEVELLED = """[[levelling]]
file = "old.csv"
tank = "T1"
date = 1998-05-31
elevation_error = 0.0005
above_datum = 0.25
options.units = "mm"
"""


def test_levellings_stand_beside_scans_in_the_order_of_the_file(campaign: Path) -> None:
    text = GOOD.replace("[[scan]]", LEVELLED + "[[scan]]", 1)
    campaign.write_text(text.replace("radius = 5", "radius = 5 # m"))
    first, *scans = read_campaign(campaign).surveys
    assert (first.levelled, first.files, first.job) == (True, ("old.csv",), "T1/1998-05-31")
    assert (first.elevation_error, first.above_datum, first.line) == (0.0005, 0.25, 22)
    assert first.options == {"units": "mm"} and not any(scan.levelled for scan in scans)
    campaign.write_text(text[: text.index("[[scan]]")])
    assert len(read_campaign(campaign).surveys) == 1


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ('"old.csv"', '["old.csv"]', "23: levelling.file, ['old.csv'], expected a text"),
        ('"old.csv"', '"../old.csv"', "23: levelling.file, '../old.csv', expected a path below"),
        ('"T1"', '"find"', "24: levelling.tank, 'find', expected a tank's name"),
        ('"T1"', '"T2"', "22: levelling 'T2/1998-05-31': its tank 'T2' has no radius"),
        ("0.0005", "0", "26: levelling.elevation_error, 0, expected a number > 0"),
        ('"mm"', '"ell"', "28: options: units, ell, expected"),
        ("above_datum", "setup_error", "27: levelling.setup_error, 0.25, expected one of: above"),
    ],
)
def test_levellings_are_refused_with_their_line(
    campaign: Path, old: str, new: str, expected: str
) -> None:
    text = GOOD.replace("[[scan]]", LEVELLED.replace(old, new) + "[[scan]]", 1)
    found = refusals(campaign, text)
    assert any(refusal.startswith(expected) for refusal in found), found


def test_names_are_the_same_however_they_are_written(campaign: Path) -> None:
    """A letter of its own or with an accent after it; blanks around; a mark of the editor's."""
    text = GOOD.replace('"T1"', '" K\\u00f6ln"', 1).replace('"T1"', '"Ko\\u0308ln "')
    campaign.write_bytes(b"\xef\xbb\xbf" + text.encode().replace(b"\n", b"\r\n"))
    read = read_campaign(campaign)
    assert read.tanks[0].name == read.surveys[0].tank == "K\u00f6ln"


def test_an_epoch_has_one_scan_of_a_tank(campaign: Path) -> None:
    text = GOOD.replace('"find"', '"T1"').replace('"second"', '"2021-05-31"')
    expected = "33: scan.epoch, '2021-05-31', expected one survey of 'T1' an epoch"
    assert refusals(campaign, text) == [expected]


def test_a_campaign_without_its_tables_is_refused(campaign: Path) -> None:
    found = refusals(campaign, "# nothing\n")
    assert [line.strip().split(",")[0] for line in found] == [
        "site",
        "tank",
        "scan",
    ]


def test_all_refusals_are_told_at_once(campaign: Path) -> None:
    text = GOOD.replace("radius = 5", "radius = 0").replace("fill_level = 2", "fill_level = -1")
    found = refusals(campaign, text)
    assert [line.split(":")[0] for line in found] == ["15", "26"]


def test_paths_elsewhere_are_allowed_when_it_is_said(campaign: Path) -> None:
    campaign.write_text("allow_outside = true\n" + GOOD.replace('"*.pcd"', '"/a/*.pcd"'))
    assert read_campaign(campaign).surveys[1].files == ("/a/*.pcd",)
    campaign.write_text(GOOD.replace('"*.pcd"', '"s3://bucket/*.pcd"'))
    assert read_campaign(campaign).surveys[1].files == ("s3://bucket/*.pcd",)


def test_lines_of_every_form_of_toml() -> None:
    text = 'a.b = 1\n# c = 2\n[t]\nx = """\n[no]\ny = 1\n"""\n'
    text += "[[l]]\nk = {m = 1}\n[l.n]\np = 1\n[[l]]\n"
    lines = line_numbers(text)
    assert lines == {
        ("a",): 1,
        ("a", "b"): 1,
        ("t",): 3,
        ("t", "x"): 4,
        ("l", 0): 8,
        ("l", 0, "k"): 9,
        ("l", 0, "k", "m"): 9,
        ("l", 0, "n"): 10,
        ("l", 0, "n", "p"): 11,
        ("l", 1): 12,
    }


def test_the_command_says_file_line_and_reason(campaign: Path) -> None:
    for text, said in [
        (GOOD.replace("radius = 5", "radius = [5"), f"{campaign}:16: "),
        (GOOD.replace("radius = 5", "radius = 'x'"), f"{campaign}:15: tank.radius, 'x', expected"),
    ]:
        campaign.write_text(text)
        result = Farm(campaign.parent).command("check")
        assert result.returncode == 2 and said in result.stderr
    result = farm_command("check", campaign.parent / "none.toml")
    assert result.returncode == 2 and "No such file" in result.stderr


def test_check_tells_missing_scans(campaign: Path) -> None:
    (campaign.parent / "a.pcd").write_text("1 2 3\n")
    result = Farm(campaign.parent).command("check")
    assert result.returncode == 1
    assert f"{campaign}:22: No such file or directory: " in result.stdout
    assert result.stdout.endswith("North: 2 tanks, 2 surveys, 1 missing, 0.0 MB\n")
