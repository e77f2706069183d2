"""The SBOM of a wheel (CycloneDX, in `.dist-info/sboms`) or a program: with GMP and MPFR, and without the folders of the
machine that built it."""

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
    for part in (sbom["metadata"]["component"], *sbom["components"]):
        leave_out_empty(part)
    for name, version in bundled.items():
        purl = f"pkg:generic/{name}@{version}"
        component = {"type": "library", "bom-ref": purl, "name": name, "version": version, "scope": "required"}
        sbom["components"].append({**component, "licenses": [{"expression": LICENCES[name]}], "purl": purl})
        for crate in sbom["dependencies"]:
            if "#gmp-mpfr-sys@" in crate["ref"]:
                crate.setdefault("dependsOn", []).append(purl)
    return json.dumps(sbom, indent=2).encode()


def leave_out_empty(component):
    """Takes the address of the repository out of a component, where there is none."""
    found = [reference for reference in component.pop("externalReferences", []) if reference["url"]]
    if found:
        component["externalReferences"] = found


def only(data, crates):
    """The bytes of an SBOM of a workspace with these crates alone, by name and version."""
    sbom = json.loads(data)
    inside = {(crate["name"], crate["version"]) for crate in crates}
    sbom["components"] = [part for part in sbom["components"] if (part["name"], part["version"]) in inside]
    known = {part["bom-ref"] for part in [sbom["metadata"]["component"], *sbom["components"]]}
    sbom["dependencies"] = [crate for crate in sbom["dependencies"] if crate["ref"] in known]
    for crate in sbom["dependencies"]:
        if "dependsOn" in crate:
            crate["dependsOn"] = [name for name in crate["dependsOn"] if name in known]
    return json.dumps(sbom).encode()


def line(name, data):
    """What RECORD has of a file."""
    digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(data)}\n"
