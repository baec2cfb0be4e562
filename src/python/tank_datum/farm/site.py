"""The pages of a farm: static files that need no server and no network."""

from __future__ import annotations

import os
from importlib import resources
from pathlib import Path
from urllib.parse import quote

from tank_datum.farm.campaign import Campaign
from tank_datum.farm.index_page import index_page
from tank_datum.farm.markup import page
from tank_datum.farm.plan import store_url
from tank_datum.farm.sources import resolved
from tank_datum.farm.store import Store
from tank_datum.farm.tank_page import tank_page
from tank_datum.farm.view import Plain, farm_view


def write_site(campaign: Campaign) -> str:
    """Writes index.html and a page a tank; the path of the first. Raises FarmError, OSError."""
    views, state = farm_view(campaign)
    place = Store(resolved(campaign.pages, campaign.folder))
    results = Store(store_url(campaign))
    styles = _file("report.css") + _file("farm.css")
    for view in views:
        _link_reports(view, place, results)
        text = page(
            f"{view['name']}, {campaign.site}",
            styles,
            tank_page(campaign.site, view),
            "",
        )
        place.keep_note(f"tanks/{view['slug']}.html", text.encode())
    body = index_page(campaign.site, views, state)
    text = page(campaign.site, styles, body, _file("farm.js"))
    place.keep_note("index.html", text.encode())
    return f"{place.root}/index.html"


def _file(name: str) -> str:
    return (resources.files("tank_datum.farm") / "page" / name).read_text(
        encoding="utf-8"
    )


def _link_reports(view: Plain, place: Store, results: Store) -> None:
    """Each epoch's `report`: a link from the tank's page to its report.html. Of results or pages
    in an object store the report is copied beside the pages."""
    for epoch in view["epochs"]:
        path = f"{epoch['folder']}/report.html"
        epoch["report"] = None
        if place.is_local and results.is_local:
            epoch["report"] = quote(os.path.relpath(path, f"{place.root}/tanks"))
            continue
        name = f"reports/{epoch['key']}_{Path(epoch['folder']).name}.html"
        there = f"{Path(epoch['folder']).name}/report.html"
        if results.has(epoch["key"], there):
            place.keep_note(name, results.read(epoch["key"], there))
            epoch["report"] = f"../{name}"
