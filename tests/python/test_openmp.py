"""Of OpenMP the programs use the runtime's settings alone: threads share the work out by themselves."""

from __future__ import annotations

import re
import subprocess

import pytest

from programs import executable

REGIONS = re.compile(r"\b(?:GOMP|__kmpc)_\w+")  # of gcc's and of clang's runtime


@pytest.mark.parametrize("name", ["tank_datum", "tank_datum_compare", "tank_datum_report"])
def test_no_program_opens_regions(name: str) -> None:
    """Neither for a query of FLANN nor for a product of Eigen, whose blocks follow the threads."""
    listed = subprocess.run(
        ["nm", "-D", "--undefined-only", executable(name)], capture_output=True, text=True, check=True
    )
    assert "malloc" in listed.stdout
    assert not REGIONS.findall(listed.stdout)
