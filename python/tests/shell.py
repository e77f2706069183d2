"""What a shell has, and no sentence of Python."""

import re

_COMMANDS = (
    "state assess find equation voussoirs complementarity states sweep sample judge run map draw figure certify check constants "
    "audit prove"
)
_WORDS = re.compile(
    rf"--\w|\B-[a-z]\b|\bcouplet (?:{_COMMANDS.replace(' ', '|')})\b|\bcargo\b|\busage:|for example:|<[A-Z]+|\btip:|\bhelp lists|\bflag\b"
)


def words_of_a_shell(sentence):
    """Those that a sentence has."""
    return _WORDS.findall(str(sentence))
