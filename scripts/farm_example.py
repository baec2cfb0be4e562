"""A tank farm from simulated scans to its pages; ./scripts/farm_example says what of.

farm_example.py [DIR] [--pictures DIR]: with pictures of the pages, made by Chromium.
"""

from __future__ import annotations

import argparse
import shutil
import sys
from pathlib import Path
from random import Random
from typing import Any

import tank_datum
from tank_datum.farm._main import main as farm

CAMPAIGN = Path(__file__).with_name("farm_example.toml")
EPOCHS = (2018, 2020, 2022, 2024)
LEVELS = (0.0, 5.0, 10.0, 0.0)  # of the hydrotest [m]
REGISTRATION = 0.0003  # 1 sigma of every scan's height [m]


def tank(name: str, epoch: int) -> dict[str, Any]:
    """What a tank is at an epoch: T-1 does not move, T-2 settles and tilts, T-3 is filled."""
    waves = [{"n": 2, "amplitude": 0.003, "phase_deg": 40}]
    made = {"radius": 6.0, "height": 4.0, "tilt_slope": 0.001, "harmonics": waves}
    if name == "T-1":
        return made
    if name == "T-2":
        dip = {"azimuth_deg": 150, "width_deg": 40, "depth": 0.004 * epoch}
        sunk = {"x": 25.0, "base_elevation": -0.006 * epoch, "dips": [dip] if epoch else []}
        return made | sunk | {"tilt_slope": 0.001 + 0.0004 * epoch}
    lasting = 0.0015 if epoch == len(LEVELS) - 1 else 0.0
    settled = 0.0006 * LEVELS[epoch] + lasting
    return made | {"x": 12.0, "y": 22.0, "base_elevation": -settled}


def scene(name: str, epoch: int) -> dict[str, Any]:
    seed = 100 * int(name[-1]) + epoch
    shape = tank(name, epoch)
    height = shape.get("base_elevation", 0.0) + Random(seed).gauss(0.0, REGISTRATION)
    return {
        "seed": seed,
        "tanks": [shape | {"base_elevation": height}],
        "scanner": {"count": 5, "distance": 6, "step_deg": 0.25, "max_range": 18},
        "near_datum": 1.0,
        "measurement": {"range_sigma": 0.0015},
    }


def make_scans(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for name in ("T-1", "T-2", "T-3"):
        for number, year in enumerate(EPOCHS):
            label = f"step{number + 1}" if name == "T-3" else str(year)
            path = folder / f"{name}_{label}.pcd"
            if not path.exists():
                part = path.with_name(f".{path.name}")
                tank_datum.simulate(scene(name, number), part)
                part.rename(path)


def take_pictures(pages: Path, folder: Path) -> None:
    """farm.png, farm_settling.png and farm_hydrotest.png."""
    from playwright.sync_api import sync_playwright

    shots = (
        ("farm", "index.html", 1240, 760),
        ("farm_settling", "tanks/T-2.html#trends", 1000, 860),
        ("farm_hydrotest", "tanks/T-3.html#hydrotest-1", 1000, 640),
    )
    with sync_playwright() as tool:
        browser = tool.chromium.launch(
            executable_path=shutil.which("chromium"), args=["--no-sandbox"]
        )
        for name, page_name, width, height in shots:
            page = browser.new_page(viewport={"width": width, "height": height})
            page.goto(f"{pages.resolve().as_uri()}/{page_name}")
            page.screenshot(path=folder / f"{name}.png")
            few_colours(folder / f"{name}.png")
        browser.close()


def few_colours(path: Path) -> None:
    from PIL import Image

    Image.open(path).convert("RGB").quantize(32).save(path, optimize=True)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path, nargs="?", default=Path("farm_example.datum"))
    parser.add_argument("--pictures", type=Path, metavar="DIR")
    given = parser.parse_args()
    make_scans(given.folder / "scans")
    campaign = given.folder / "farm.toml"
    shutil.copyfile(CAMPAIGN, campaign)
    for words in (["check"], ["run"], ["report"], ["export", "-o", str(given.folder / "export")]):
        print(f"== tank_datum_farm {words[0]}", file=sys.stderr)
        status = farm([words[0], str(campaign), *words[1:]])
        if status:
            return status
    if given.pictures:
        take_pictures(given.folder / "pages", given.pictures)
    return 0


if __name__ == "__main__":
    sys.exit(main())
