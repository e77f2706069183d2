"""What is told, as a property of one line."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any, Generic, TypeVar

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
