"""Builds the package with maturin, after it has looked for what a build needs.

GMP and MPFR are compiled from source. Where a program for that is missing, their configure scripts end in a long log;
here it is one line.
"""

import gzip
import io
import os
import re
import sys
import tarfile
from pathlib import Path

import maturin
from licences import collect
from needs import missing
from sbom import complete


def ready():
    """Ends with one line where something is missing; else the licences are where the wheel takes them from.

    Where the crates are, and the versions of GMP and MPFR.
    """
    line = missing()
    if line:
        sys.exit(line)
    return collect(Path("."))


get_requires_for_build_wheel = maturin.get_requires_for_build_wheel
get_requires_for_build_sdist = maturin.get_requires_for_build_sdist
get_requires_for_build_editable = maturin.get_requires_for_build_editable


def build_wheel(directory, *arguments, **options):
    crates, bundled = ready()
    name = maturin.build_wheel(directory, *arguments, **options)
    complete(Path(directory) / name, crates, bundled)
    return name


def build_sdist(directory, *arguments, **options):
    ready()
    name = maturin.build_sdist(directory, *arguments, **options)
    leave_out_benches(Path(directory) / name)
    return name


def leave_out_benches(archive):
    """Benchmarks and tests are not in a package, and so must not be in its manifest, as cargo has it in its own packages."""
    whole = archive.with_suffix(".whole")
    archive.replace(whole)
    time = int(os.environ.get("SOURCE_DATE_EPOCH", "0"))
    packed = gzip.GzipFile(archive, "wb", mtime=time)
    with tarfile.open(whole) as old, packed, tarfile.open(fileobj=packed, mode="w") as new:
        top = Path(old.getnames()[0]).parts[0]
        for member in old:
            data = old.extractfile(member).read() if member.isfile() else b""
            if member.name == f"{top}/Cargo.toml":
                data = re.sub(rb"\[\[(?:bench|test)\]\]\n(?:[^\[\n].*\n|\n)*", b"", data)
                member.size = len(data)
            new.addfile(member, io.BytesIO(data) if member.isfile() else None)
    whole.unlink()


def build_editable(*arguments, **options):
    ready()
    return maturin.build_editable(*arguments, **options)


def prepare_metadata_for_build_wheel(*arguments, **options):
    ready()
    return maturin.prepare_metadata_for_build_wheel(*arguments, **options)


prepare_metadata_for_build_editable = prepare_metadata_for_build_wheel
