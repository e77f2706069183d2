"""Names of types, for those who read types: no module imports this one when it runs."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from typing import Any, Literal, NoReturn, Optional, ParamSpec, TypeVar, Union

import numpy as np
from typing_extensions import TypedDict, Unpack

__all__ = [
    "Any", "Callable", "Circle", "Decimal", "Exact", "Fraction", "Given", "Iterable", "Iterator", "Landmark", "LandmarkName",
    "Lengths", "Literal", "Mapping", "NoReturn", "Optional", "ParamSpec", "Range", "Sequence", "Stones", "TypedDict", "TypeVar", "Union",
    "Unpack", "np",
]  # fmt: skip

#: What is given, by its names.
Given = tuple[tuple[str, Any], ...]
Exact = Union[str, int, float, Fraction, Decimal]
#: A value, or the least and the largest.
Range = Union[Exact, tuple[Exact, Exact]]
#: The same of a length, with its unit.
Lengths = Optional[Union[str, tuple[str, str]]]
Stones = Union[int, str, None]
Circle = Optional[Literal["intrados", "centreline", "extrados"]]
Landmark = Literal["T", "S", "J", "B", "l", "L", "sb"]
LandmarkName = Literal["triple", "shift", "junction", "border", "rotation-end", "overturning-end", "widest-joint"]
