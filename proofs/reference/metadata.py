#!/usr/bin/env python3
"""Writes codemeta.json and .zenodo.json from CITATION.cff.

    proofs/reference/metadata.py CFFCONVERT

cffconvert 2.0 writes two licences as the text of a list and calls the authors a person: both are put right here."""

import json
import pathlib
import subprocess
import sys

HOUSE = pathlib.Path(__file__).resolve().parent.parent.parent


def converted(cffconvert, form):
    asked = [cffconvert, "--infile", "CITATION.cff", "--format", form]
    return json.loads(subprocess.run(asked, cwd=HOUSE, check=True, capture_output=True, text=True).stdout)


def write(name, record):
    (HOUSE / name).write_text(json.dumps(record, indent=2, ensure_ascii=False) + "\n", encoding="utf-8")


def main(cffconvert):
    zenodo = converted(cffconvert, "zenodo")
    licences = zenodo["license"]["id"]
    # Zenodo takes one licence.
    zenodo |= {"upload_type": "software", "license": {"id": licences[0]}, "notes": f"Licence: {' OR '.join(licences)}"}
    write(".zenodo.json", zenodo)
    codemeta = converted(cffconvert, "codemeta")
    codemeta["license"] = [f"https://spdx.org/licenses/{licence}" for licence in licences]
    for author in codemeta["author"]:
        author["@type"] = "Organization" if "name" in author else author["@type"]
    write("codemeta.json", codemeta)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("metadata.py: usage: metadata.py CFFCONVERT")
    main(sys.argv[1])
