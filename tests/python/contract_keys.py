"""The keys of datum.json and their types, as the contract has them."""

from __future__ import annotations

from typing import Any

AGREEMENT_OF_SEVERAL = {
    "groups_apart": 0.0,
    "told_apart_by": "",
    **dict.fromkeys(["sigma_height", "sigma_tilt_arcsec", "sigma_plan"], 0.0),
    **dict.fromkeys(["height_from", "tilt_from", "plan_from"], ""),
}
"""Keys of `agreement` that one setup does not have."""


NUMBER, TEXT, LIST = (int, float), str, list
OPTIONAL = (int, float, type(None))
# Every key there is, with its type; a method that has no such figure gives null.
KEYS: dict[str, Any] = {
    "schema": int,
    "version": TEXT,
    "input": {
        "files": LIST,
        "kind": TEXT,
        "units": TEXT,
        "origin": LIST,
        "invalid_points": int,
        "left_out_points": int,
        "far_points": int,
    },
    "options": dict,
    "status": TEXT,
    "message": TEXT,
    "service": TEXT,
    "tank": {
        "center": LIST,
        "radius": NUMBER,
        "sigma_radius": NUMBER,
        "rms": NUMBER,
        "coverage_deg": NUMBER,
        "foot_points_per_degree": OPTIONAL,
        "side": TEXT,
    },
    "tests": LIST,
    "lean": {"slope_x": NUMBER, "slope_y": NUMBER, "sigma": NUMBER, "sentence": TEXT},
    "datum": {
        "surface": TEXT,
        "other_surface_deg": LIST,
        "shell_below_deg": LIST,
        "in_doubt_deg": LIST,
        "measured": int,
        "interpolated": int,
        "missing": int,
        "mean": NUMBER,
        "min": NUMBER,
        "max": NUMBER,
        "range": NUMBER,
        "min_azimuth_deg": NUMBER,
        "max_azimuth_deg": NUMBER,
        "curve": {
            "degree": int,
            "closed": bool,
            "control_points": int,
            "rms": NUMBER,
            "max_residual": NUMBER,
            "check_points": int,
        },
    },
    "tilt": dict.fromkeys(
        ["slope", "angle_arcsec", "direction_deg", "sigma_slope"]
        + ["standard_error", "r2", "p_value"],
        NUMBER,
    ),
    "antipodal": dict.fromkeys(
        ["max_h", "diameter", "angle_deg", "angle_arcsec", "azimuth_deg"], NUMBER
    )
    | {"h": LIST},
    "harmonics": LIST,
    "out_of_plane": dict,
    "local_settlements": list,
    "foundation": dict.fromkeys(["level_9m", "level_3m", "level_total"], dict),
    "checks": LIST,
    "verdict": {
        "word": TEXT,
        "governing": TEXT,
        "utilisation": OPTIONAL,
        "utilisation_95": LIST,
        "sentence": TEXT,
    },
    "notes": LIST,
    "setups": LIST,
    "agreement": {
        **dict.fromkeys(
            ["rms_before", "rms_after", "repeated_points", "unlabelled_discrepancy"], OPTIONAL
        ),
        **{name: type(value) for name, value in AGREEMENT_OF_SEVERAL.items()},
    },
    "covariance": {"independent": LIST, "factors": LIST},
    "stations": LIST,
    "shell": dict,
}


def check_keys(value: dict[str, Any], keys: dict[str, Any], place: str = "") -> None:
    assert list(value) == list(keys), place
    for name, kind in keys.items():
        if isinstance(kind, dict):
            check_keys(value[name], kind, f"{place}/{name}")
        else:
            assert isinstance(value[name], kind), f"{place}/{name}: {value[name]!r}"
            assert not isinstance(value[name], bool) or kind is bool
