"""A proved value, and a property of one line for each part that is told of it or of an answer."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Generic

    from ._types import Any, Callable, Decimal, Fraction, Optional, TypeVar

    Parts = tuple[str, str, str, float, float, float, Optional[str], Optional[str]]
    T = TypeVar("T", covariant=True)

    class Told(Generic[T]):
        """A property, to those who read types."""

        at: Any

        def __init__(self, words: str, of: Callable[[Any], T] = ..., at: str | int = ...) -> None: ...
        def __get__(self, answer: Any, kind: type | None = None) -> T: ...

else:

    class Told(property):
        """What ``_told`` has under the name of the property, or at another place, as a function makes something of it."""

        def __init__(self, words, of=lambda told: told, at=None):
            super().__init__(self._of, doc=words)
            self.of, self.at = of, at

        def __class_getitem__(cls, kind):
            return cls

        def __set_name__(self, owner, name):
            self.at = name if self.at is None else self.at

        def _of(self, answer):
            return self.of(answer._told[self.at])


# The types of a number in a format: of a Decimal they round half to even, and no digit is made up.
_NUMBERS = tuple("eEfFgG%")

_UNITS = {
    "rad": "friction_angle half_opening rotation_joint sliding_joint crown_hinge least_thrust_joint largest_thrust_joint".split(),
    "r": "thickness least_thickness asymmetric_thickness continuous_thickness thickness_ratio".split(),
    "w r": "thrust least_thrust largest_thrust vertical_force".split(),
    "gamma d r^2": ["intrinsic_thrust"],
}


class Certified:
    """A value that is proved: text with all its digits, and the nearest double, both between bounds.

    ``quantity`` is its name (``'thickness'``); docs/columns.md has all, angles are in radians unless the name says degrees. ``str()``
    is the text and ``float()`` the double; ``f"{value:.5f}"`` is the true value rounded. ``==`` says whether two are one record: of
    the same quantity with the same digits and bounds. Of the true values it says nothing: compare their bounds.
    """

    __slots__ = ("_quantity", "_told")

    # Told are the text, its bounds, the nearest double, its bounds, the exact value, what limits a thrust.
    def __init__(self, quantity: str, told: tuple[Any, ...]) -> None:
        self._quantity = quantity
        self._told: Parts = told

    @property
    def quantity(self) -> str:
        """Its name."""
        return self._quantity

    text = Told[str]("The true value correctly rounded to the digits asked for; ``'inf'`` if it is infinite.", at=0)
    text_lower = Told[str]("A decimal not above the true value.", at=1)
    text_upper = Told[str]("A decimal not below the true value.", at=2)
    double = Told[float]("The double nearest to the true value, whatever the digits.", at=3)
    lower = Told[float]("A double not above the true value: its lower neighbour, or the same where it is a double.", at=4)
    upper = Told[float]("A double not below the true value: its upper neighbour, or the same where it is a double.", at=5)
    exact = Told["str | None"]("The exact value, where there is one and it says more (``'2(2√3−3)'``); else None.", at=6)
    limited_by = Told["str | None"]("What limits a thrust; else None.", at=7)

    @property
    def unit(self) -> str:
        """``'m'``, ``'kN'``, ``'rad'``, ``'deg'``; the radius ``'r'``, the force ``'w r'``, ``'gamma d r^2'``; ``'1'`` of a bare number."""
        for end, unit in (("_m", "m"), ("_kn", "kN"), ("_degrees", "deg")):
            if self.quantity.endswith(end):
                return unit
        return next((unit for unit, names in _UNITS.items() if self.quantity in names), "1")

    def to_dict(self) -> dict[str, Any]:
        """All of the value, for ``json.dumps``: digits and doubles; what is infinite is the text ``'inf'``."""
        names = ("text", "text_lower", "text_upper", "double", "lower", "upper", "unit", "exact", "limited_by")
        told = zip(names, (*self._told[:6], self.unit, *self._told[6:]))
        return {name: "inf" if value == float("inf") else value for name, value in told if value is not None}

    def decimal(self) -> Decimal:
        """The text as a decimal.Decimal, which is exactly that."""
        from decimal import Decimal

        return Decimal(self._told[0])

    def decimals(self) -> tuple[Decimal, Decimal]:
        """The bounds of the text, lower and upper."""
        from decimal import Decimal

        return Decimal(self._told[1]), Decimal(self._told[2])

    def fractions(self) -> tuple[Fraction, Fraction]:
        """The same bounds as fractions.Fraction; an OverflowError if the value is infinite."""
        from fractions import Fraction

        if self._told[0] == "inf":
            raise OverflowError("the value is infinite")
        return Fraction(self._told[1]), Fraction(self._told[2])

    def mpf(self) -> Any:
        """An mpmath.mpf, rounded to mpmath's precision (needs mpmath)."""
        import mpmath  # type: ignore[import-not-found, import-untyped, unused-ignore]

        return mpmath.mpf(self._told[0])

    def mpi(self) -> Any:
        """The interval of the bounds in mpmath.iv, outward at its precision (needs mpmath)."""
        import mpmath  # type: ignore[import-not-found, import-untyped, unused-ignore]

        return mpmath.iv.mpf([self._told[1], self._told[2]])

    def arb(self) -> Any:
        """A ball flint.arb around the bounds, at flint's precision (needs python-flint)."""
        import flint  # type: ignore[import-not-found, import-untyped, unused-ignore]

        return flint.arb(self._told[1]).union(flint.arb(self._told[2]))

    def __str__(self) -> str:
        return self._told[0]

    def __format__(self, spec: str) -> str:
        """With a place for the text (``'>40'``), or with the type of a number (``'.5f'``): then the true value rounded so, proved
        by both its bounds; a ValueError where they do not tell."""
        if spec[-1:] not in _NUMBERS:
            if "." in spec:
                raise ValueError(f"the format {spec!r} would cut a number off; with the type of one it is rounded: {spec + 'f'!r}")
            return format(self._told[0], spec)
        if self._told[0] == "inf":
            return format(self._told[3], spec)
        lower, upper = (format(bound, spec) for bound in self.decimals())
        if lower != upper:
            raise ValueError(f"the digits of {self!r} do not tell how {spec!r} rounds it: it is between {lower} and {upper}")
        return lower

    def __float__(self) -> float:
        return self._told[3]

    def __repr__(self) -> str:
        return f"Certified({self.quantity!r}, {self._told[0]!r})"

    def __eq__(self, other: object) -> bool:
        if type(other) is not Certified:
            return NotImplemented
        return (self.quantity, self._told) == (other.quantity, other._told)

    def __hash__(self) -> int:
        return hash((self.quantity, self._told))

    def __reduce__(self) -> tuple[type, tuple[str, tuple[Any, ...]]]:
        return Certified, (self.quantity, self._told)
