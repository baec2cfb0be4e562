"""Of OpenMP the programs use the runtime's settings alone: own threads share the work out."""

from __future__ import annotations

import re
import subprocess

import pytest

from programs import executable

REGIONS = re.compile(r"\b(?:GOMP|__kmpc)_\w+")  # of gcc's and of clang's runtime


@pytest.mark.parametrize("name", ["tank_datum", "tank_datum_compare", "tank_datum_report"])
def test_no_program_opens_regions(name: str) -> None:
    """Neither for a query of FLANN nor for a product of Eigen, whose blocks follow the threads."""
    words = ["nm", "-D", "--undefined-only", executable(name)]
    listed = subprocess.run(words, capture_output=True, text=True, check=True)
    assert "malloc" in listed.stdout
    assert not REGIONS.findall(listed.stdout)
