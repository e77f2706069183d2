"""The SBOM of a wheel (CycloneDX, in `.dist-info/sboms`): with GMP and MPFR, and without the folders of the machine that
built it."""

import base64
import hashlib
import json
import os
import zipfile

# Those of the libraries of C, which stand in their crate as source.
LICENCES = {"gmp": "LGPL-3.0-or-later OR GPL-2.0-or-later", "mpfr": "LGPL-3.0-or-later"}


def complete(wheel, folder, bundled):
    """Completes the SBOMs of a wheel: the crates of a folder stand in /couplet; `bundled` has versions of libraries of C.

    A wheel is replaced whole or not at all. What else is in it stays as it is.
    """
    made = f"{wheel}.made"
    try:
        with zipfile.ZipFile(wheel) as old, zipfile.ZipFile(made, "w") as new:
            record = next(name for name in old.namelist() if name.endswith(".dist-info/RECORD"))
            recorded = old.read(record).decode()
            for member in sorted(old.infolist(), key=lambda member: member.filename == record):
                data = old.read(member)
                if ".dist-info/sboms/" in member.filename:
                    found, data = data, completed(data, folder, bundled)
                    before, after = line(member.filename, found), line(member.filename, data)
                    if before not in recorded:
                        raise ValueError(f"RECORD has another {member.filename}")
                    recorded = recorded.replace(before, after)
                elif member.filename == record:
                    data = recorded.encode()
                new.writestr(member, data, compresslevel=9)
        os.replace(made, wheel)
    finally:
        if os.path.exists(made):
            os.remove(made)


def completed(data, folder, bundled):
    """The bytes of one SBOM."""
    sbom = json.loads(data.decode().replace(folder.as_uri(), "file:///couplet"))
    for name, version in bundled.items():
        purl = f"pkg:generic/{name}@{version}"
        component = {"type": "library", "bom-ref": purl, "name": name, "version": version, "scope": "required"}
        sbom["components"].append({**component, "licenses": [{"expression": LICENCES[name]}], "purl": purl})
        for crate in sbom["dependencies"]:
            if "#gmp-mpfr-sys@" in crate["ref"]:
                crate.setdefault("dependsOn", []).append(purl)
    return json.dumps(sbom, indent=2).encode()


def line(name, data):
    """What RECORD has of a file."""
    digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(data)}\n"
