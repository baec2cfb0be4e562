"""How far two values of a fixture are apart: what is no number is beyond every tolerance."""

from __future__ import annotations

import math
from typing import Any

import pytest
from tank_datum_qa import _compare

NAN, INF = math.nan, math.inf


@pytest.mark.parametrize(
    ("old", "new", "apart"),
    [
        pytest.param(1.0, 1.5, 0.5, id="numbers"),
        pytest.param(NAN, 1.0, None, id="NaN in the fixture"),
        pytest.param(1.0, NAN, None, id="NaN in the result"),
        pytest.param(NAN, NAN, 0.0, id="NaN in both"),
        pytest.param(INF, INF, 0.0, id="infinite in both"),
        pytest.param(INF, 1.0, None, id="infinite in one"),
        pytest.param("a", 1.0, None, id="text and number"),
    ],
)
def test_difference(old: Any, new: Any, apart: float | None) -> None:
    assert _compare._difference(old, new) == apart
