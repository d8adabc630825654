# SPDX-License-Identifier: Apache-2.0
"""Parameters of scenes."""
from __future__ import annotations

from typing import NamedTuple, Optional, Tuple, Union

Value = Union[float, bool, str, Tuple[float, float, float], None]


class Param(NamedTuple):
    """A parameter of a scene. Lengths are in metres, angles in radians, ratios relative to 1."""

    name: str
    value: Value
    default: Value
    low: Optional[float]  # None without a range
    high: Optional[float]
    doc: str
    type: str  # "number", "vector", "true or false", "text", "name"
    dimension: str  # "length", "angle", "ratio", "number per metre", "time"; empty for plain numbers
