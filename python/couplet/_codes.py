"""The codes in arrays, which are numbers and words."""

from __future__ import annotations

from enum import IntEnum

from ._arrays import VERDICTS
from ._core import modes


class _Code(IntEnum):
    """A number whose text is a word."""

    @property
    def word(self) -> str:
        """The word: of a verdict as in ``couplet.VERDICTS``, of a mode the joints from the shoulder inward, ``'[r,r,s]'``, or ``'none'``."""
        words = VERDICTS if isinstance(self, Verdict) else modes()
        return words[self] if self < len(words) else "none"

    def __str__(self) -> str:
        return self.word

    def __format__(self, spec: str) -> str:
        return format(self.word, spec)


class Verdict(_Code):
    """The verdict of a row of ``states``: a number that is equal to its code, and whose text is its word."""

    STANDS = 0
    FALLS = 1
    UNDECIDED = 2
    REFUSED = 3


class Mode(_Code):
    """The mode of a row of ``states``: a number that is equal to its code, and whose text is as in ``couplet.MODES``."""

    RRR = 0
    SRR = 1
    RRS = 2
    RSR = 3
    RS = 4
    R = 5
    SS = 6
    NONE = 255
