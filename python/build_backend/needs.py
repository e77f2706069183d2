"""What a build needs of the machine."""

import shutil

# Programs, any of each row, and how to get them.
NEEDED = [
    (("cargo",), "cargo (https://rustup.rs)"),
    (("cc", "gcc", "clang"), "a C compiler (Debian: apt-get install gcc)"),
    (("make",), "make (Debian: apt-get install make)"),
    (("m4",), "m4 (Debian: apt-get install m4)"),
]


def missing(found=shutil.which):
    """What a build needs and this machine has not, in one line; None if nothing is missing."""
    texts = [text for names, text in NEEDED if not any(found(name) for name in names)]
    if not texts:
        return None
    return (
        "couplet: there is no wheel for this platform, and to build one GMP and MPFR have to be compiled; "
        "please install " + ", ".join(texts)
    )
