"""Metres in each unit of option units, as src/core/length_units.h has them."""

METRES = {"m": 1.0, "mm": 0.001, "ft": 0.3048, "in": 0.0254, "us-ft": 1200 / 3937}
