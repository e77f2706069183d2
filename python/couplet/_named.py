"""Keywords that several functions have, each list written once, and what gives a function those of a list."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from ._types import Any, Callable, Circle, Exact, Landmark, LandmarkName, Lengths, Range, Sequence, Stones, TypedDict, TypeVar

    F = TypeVar("F", bound=Callable[..., Any])
else:

    class TypedDict:
        """That of ``typing``, which takes longer to import than all else."""

        def __init_subclass__(cls, total=True):
            pass


class Common(TypedDict, total=False):
    """What is no half opening, no friction and no length of an arch."""

    joints: str | Sequence[Exact] | None
    measured_at: Circle
    density: str | None
    depth: str | None
    weight: str


class Sizes(Common, total=False):
    """One arch, perhaps in metres."""

    span: str | None
    rise: str | None
    radius: str | None
    digits: int


class OfThickness(Sizes, total=False):
    """The same, perhaps of a thickness."""

    thickness: Exact | None


class OfStones(Sizes, total=False):
    """One arch, perhaps of stones."""

    stones: Stones


class Arch(OfStones, total=False):
    """The same, perhaps tilted."""

    tilt: Exact | None


class Ends(Common, total=False):
    """All arches between the ends of ranges."""

    span: Lengths
    rise: Lengths
    radius: Lengths
    stones: Stones
    tilt: Exact | None


class Arches(Ends, total=False):
    """The same, to so many digits."""

    digits: int


class Certifiable(Arches, total=False):
    """What a certificate is made of."""

    thickness: Range | None
    asymmetric: bool | str
    threads: int


class Beside(TypedDict, total=False):
    """What else an arch may be given by."""

    friction_angle: Range | None
    thickness: Range | None


class Paper(TypedDict, total=False):
    """How a picture is printed."""

    width: str | None
    font_size: str | None
    font: str | None
    full_caption: bool
    no_caption: bool
    no_title: bool
    threads: int


class Values(TypedDict, total=False):
    """What an equation or a state may have."""

    rotation_joint: Exact | None
    thickness: Exact | None
    thrust: Exact | None
    opening_variable: Exact | None
    weight: str
    digits: int


class Batch(TypedDict, total=False):
    """How many arches are asked about."""

    weight: str
    quantities: str | Sequence[str] | None
    threads: int
    progress: bool | Callable[[int, int], object]


class Drawn(Ends, Beside, Paper, total=False):
    """An arch that is drawn, or all of them, and what is drawn of it."""

    at: Landmark | LandmarkName | None
    mode: str | None
    dilatant: bool
    half: bool
    arrows: bool
    animate: bool
    amplitude: float | str | None


#: What is meant where nothing is given; of what is true or false that it is false, of all else None.
_USUAL = {"weight": "milankovitch", "digits": 30, "threads": 0, "progress": False, "asymmetric": False}


def named(*lists: type) -> Callable[[F], F]:
    """Gives a function that takes ``**given`` the keywords of lists instead: help, completion and the error of a wrong name know
    them, and whoever writes the function has those that are not given too."""
    bases = [base for of in lists for base in reversed(of.__mro__)]
    kinds = {name: kind for base in bases for name, kind in getattr(base, "__annotations__", {}).items()}

    def of(function: Any) -> Any:
        code = function.__code__
        first = code.co_varnames[: code.co_argcount]
        own = code.co_varnames[code.co_argcount : code.co_argcount + code.co_kwonlyargcount]
        usual = dict(zip(first[::-1], (function.__defaults__ or ())[::-1])) | (function.__kwdefaults__ or {})
        more = [name for name in kinds if name not in first + own]
        usual |= {name: _USUAL.get(name, False if kinds[name] == "bool" else None) for name in more}
        shown = [f"{name}={usual[name]!r}" if name in usual else name for name in (*first, *more, *own)]
        shown.insert(len(first), "*")
        handed = [*first, *(f"{name}={name}" for name in (*more, *own))]
        name = function.__name__
        made: dict[str, Any] = {}
        text = f"def make(inner):\n def {name}({', '.join(shown)}): return inner({', '.join(handed)})\n return {name}"
        exec(text, function.__globals__, made)
        whole = made["make"](function)
        whole.__doc__, whole.__qualname__ = function.__doc__, function.__qualname__
        own_kinds = {name: kind for name, kind in function.__annotations__.items() if name in (*first, *own, "return")}
        whole.__annotations__ = {**kinds, **own_kinds}
        return whole

    return of
