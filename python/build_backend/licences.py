"""Collects the licences of everything that is compiled into a package, a program or a library into a folder.

The texts of MIT and Apache-2.0 for couplet itself, of the LGPL and the GPL for GMP, MPFR and the crates that bind them,
and the notices of every other crate.
"""

import json
import subprocess
from pathlib import Path

# Under the LGPL; docs/licences.md of the source says what follows from that.
LIBRARIES = ("gmp-mpfr-sys", "rug")

OURS = """\
couplet is under the MIT licence or the Apache licence 2.0, as you prefer (LICENSE-MIT, LICENSE-APACHE).
"""

LESSER = """
Compiled and linked statically, GMP {gmp} and MPFR {mpfr} are in it with the crates gmp-mpfr-sys {sys} and rug {rug},
all under the GNU Lesser General Public License, version 3 or later (LGPL-3.0.md, with GPL-3.0.md). You may replace
them: the complete source is {source}.
It takes the crates from the Rust registry, or your own by a [patch.crates-io] entry in its Cargo.toml.
"""

OTHERS = """
The other crates are under permissive licences; NOTICES.txt has their texts.
"""


def collect(package):
    """Writes the folder `licences` of the Python package in this folder; from a source distribution nothing is left out.

    Where the crates of couplet are, and the versions of GMP and MPFR.
    """
    # A source distribution has the files of Python at its top, and the crate where it is in the repository.
    manifests = (package / "python" / "Cargo.toml", package / "Cargo.toml")
    crates = linked(next(manifest for manifest in manifests if manifest.exists()))
    source = "its source distribution, beside every wheel, which builds with `pip install`"
    return write(crates, package / "licences", source)


def write(crates, folder, source):
    """Writes the texts for these crates; `source` says where the complete source is.

    Where the crates of couplet are, and the versions of GMP and MPFR, which are empty where these are not.
    """
    folder.mkdir(exist_ok=True)
    by_name = {crate["name"]: crate for crate in crates}
    home = {name: Path(crate["manifest_path"]).parent for name, crate in by_name.items()}
    couplet = home["couplet" if "couplet" in home else "couplet-check"]
    for name in ("LICENSE-MIT", "LICENSE-APACHE"):
        copy(couplet / name, folder / name)
    together, bundled = OURS, {}
    if "rug" in home:
        for name, ours in (("LICENSE-LGPL.md", "LGPL-3.0.md"), ("LICENSE-GPL.md", "GPL-3.0.md")):
            copy(home["rug"] / name, folder / ours)
        bundled = {
            name: next(path.name.split("-")[1] for path in home["gmp-mpfr-sys"].glob(f"{name}-*-c"))
            for name in ("gmp", "mpfr")
        }
        versions = {"sys": by_name["gmp-mpfr-sys"]["version"], "rug": by_name["rug"]["version"]}
        together += LESSER.format(source=source, **versions, **bundled)
    # The font is compiled in with what draws its letters.
    if "resvg" in home:
        copy(home["couplet-draw"] / "assets" / "DejaVuSans.LICENSE", folder / "DejaVuSans.LICENSE")
        together += "\nThe font DejaVu Sans is in it (DejaVuSans.LICENSE).\n"
    (folder / "LICENCES.txt").write_text(together + OTHERS, encoding="utf-8")
    (folder / "NOTICES.txt").write_text(notices(crates), encoding="utf-8")
    return couplet, bundled


def copy(source, target):
    target.write_text(source.read_text(encoding="utf-8"), encoding="utf-8")


def linked(manifest):
    """The crates that are compiled into a package, for this platform, as `cargo metadata` describes them."""
    tree = cargo("tree", manifest, "--edges=normal,no-proc-macro", "--prefix=none", "--format={p}")
    inside = {tuple(line.split()[:2]) for line in tree.splitlines()}
    known = json.loads(cargo("metadata", manifest, "--format-version=1"))["packages"]
    found = [crate for crate in known if (crate["name"], "v" + crate["version"]) in inside]
    return sorted(found, key=lambda crate: crate["name"])


def cargo(command, manifest, *options):
    done = subprocess.run(
        ["cargo", command, "--manifest-path", manifest, *options], check=True, stdout=subprocess.PIPE, text=True
    )
    return done.stdout


def notices(crates):
    """The texts of the licences of the crates from elsewhere, each text once."""
    texts = {}
    for crate in crates:
        home = Path(crate["manifest_path"]).parent
        if crate["source"] is None or crate["name"] in LIBRARIES:
            continue
        names = ("LICEN[CS]E*", "COPYING*", "NOTICE*", "UNLICENSE*")
        files = sorted(path for name in names for path in home.glob(name) if path.is_file())
        who = f"{crate['name']} {crate['version']}: {crate['license']}"
        for path in files:
            text = path.read_text(encoding="utf-8", errors="replace").strip()
            texts.setdefault(text, []).append(who)
        if not files:
            texts.setdefault("(its package has no text of its own)", []).append(who)
    parts = ("\n".join(dict.fromkeys(who)) + "\n\n" + text for text, who in texts.items())
    return f"\n\n{'=' * 80}\n".join(parts) + "\n"
