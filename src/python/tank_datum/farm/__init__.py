"""A tank farm, survey after survey: campaigns of scans, their history, and pages to look at.

The command is tank_datum_farm; from Python::

    from tank_datum.farm import read_campaign
    campaign = read_campaign("farm.toml")

Needs the extra `farm`: pip install './scripts[farm]'.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from tank_datum.farm.campaign import Campaign, FarmTank, Limits, Survey
    from tank_datum.farm.campaign_file import read_campaign
    from tank_datum.farm.errors import CampaignError, FarmError, Problem

_PLACES = {  # the command says by itself which package is missing, so nothing is needed here yet
    "Campaign": "campaign",
    "CampaignError": "errors",
    "FarmError": "errors",
    "FarmTank": "campaign",
    "Limits": "campaign",
    "Problem": "errors",
    "Survey": "campaign",
    "read_campaign": "campaign_file",
}

__all__ = [
    "Campaign",
    "CampaignError",
    "FarmError",
    "FarmTank",
    "Limits",
    "Problem",
    "Survey",
    "read_campaign",
]


def __getattr__(name: str) -> Any:
    if name not in _PLACES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(f"{__name__}.{_PLACES[name]}"), name)
