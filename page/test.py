#!/usr/bin/env python3
"""The page in a real browser: what it shows and says is what the command prints. Without Chromium nothing is tested.

    page/test.py INDEX.html COUPLET
"""

import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

REPOSITORY = pathlib.Path(__file__).resolve().parent.parent

# Every mode that has a thickness, arches that fall for want of friction or as they are too wide, and unlimited friction.
ARCHES = [
    ("heyman", "80deg", "0.6"), ("heyman", "80deg", "0.35"), ("heyman", "90deg", "0.38"), ("heyman", "1.4", "inf"),
    ("heyman", "2.5", "1.5"), ("heyman", "2.65", "inf"), ("heyman", "20deg", "0.1"),
    ("heyman", "pi/2", "0.5"), ("heyman", "1", "0.12"), ("heyman", "3", "5"), ("heyman", "2.6", "2"),
    ("milankovitch", "80deg", "0.6"), ("milankovitch", "2.45", "1.45"), ("milankovitch", "2.45", "1.6"),
    ("milankovitch", "2.57", "2.2"), ("milankovitch", "100deg", "31deg"), ("milankovitch", "pi/3", "0.25"),
    ("milankovitch", "2.7", "0.5"), ("milankovitch", "2.9", "inf"), ("milankovitch", "2.62", "5"),
    ("milankovitch", "2.3", "1.1"), ("heyman", "2.602", "60.8deg"),
]

# Shows the arches, drops the files, makes the certificates, moves a slider; what came of it stands in one element.
HARNESS = """<script>
(async () => {
  while (!engine) await new Promise((resolve) => setTimeout(resolve, 50));
  const noted = [];
  const texts = () => ["proof", "verdict", "mode", "thickness", "thrust", "rotation_joint", "sliding_joint"].map((id) => at(id).textContent);
  const note = (given) => { show(given); noted.push(texts()); };
  const WORK = %s;
  for (const [weight, half_opening, friction, thickness] of WORK.arches) {
    const isAngle = friction.endsWith("deg");
    note({ weight, half_opening, ...(isAngle ? { friction_angle: friction } : { friction }), ...(thickness && { thickness }) });
  }
  note({ weight: "heyman", thickness: "0.3", friction: "0.6" });
  const fields = ["ask-half-opening", "ask-thickness", "slide-thickness"].map((id) => at(id).value);
  const transfer = new DataTransfer();
  for (const [name, text] of WORK.files) transfer.items.add(new File([text], name));
  dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, cancelable: true }));
  while (at("checked").children.length < WORK.files.length || /being checked/.test(at("checked").textContent)) {
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
  const sentences = [...at("checked").children].map((line) => line.textContent).reverse();
  const made = WORK.arches.map(([weight, half_opening, friction]) => {
    const isAngle = friction.endsWith("deg");
    const given = { weight, half_opening, ...(isAngle ? { friction_angle: friction } : { friction }) };
    return prove(given, solve(given), true).certificate ?? null;
  });
  at("slide-friction").value = "0.2";
  at("slide-friction").dispatchEvent(new Event("change"));
  const pre = document.createElement("pre");
  pre.id = "noted";
  pre.textContent = JSON.stringify({ noted, sentences, made, fields, hash: location.hash });
  document.body.append(pre);
})();
</script>"""


# Milliseconds on the browser's clock, which runs ahead to the next timer while nothing else is due: enough for the
# harness, which waits by timers.
BUDGET = 10_000_000


def browser(page, fragment=""):
    """What becomes of a page, and what its console says."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "index.html"
        file.write_text(page, encoding="utf-8")
        quiet = ["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--enable-logging=stderr", f"--virtual-time-budget={BUDGET}"]
        line = ["chromium", *quiet, f"--user-data-dir={folder}/profile", "--dump-dom", f"file://{file}#{fragment}"]
        run = subprocess.run(line, capture_output=True, text=True, timeout=300)
        return run.stdout, [said for said in run.stderr.splitlines() if "CONSOLE" in said]


def element(dom, name):
    return re.search(rf'id="{name}"[^>]*>(.*?)</', dom, re.DOTALL)[1]


def spoiled(good):
    """Copies of a certificate with one thing wrong each."""
    def change(path, value):
        copy = json.loads(json.dumps(good))
        *inner, key = path
        place = copy
        for step in inner:
            place = place[step]
        place[key] = value(place[key]) if callable(value) else value
        return json.dumps(copy)

    digit = lambda text: text[:-1] + ("1" if text[-1] != "1" else "2")
    return [
        change(["schema"], "couplet.certificate/2"),
        change(["claim", "weight"], "milankovitch"),
        change(["claim", "landmark"], "S"),
        change(["digits"], 0),
        change(["digits"], 60000),
        change(["unique", "radius", 0], "0x0p0"),
        change(["unique", "radius", 0], "0x1p4"),
        change(["root", "centre", 0], "0x1p0"),
        change(["values", 0, "value"], digit),
        change(["inverse"], []),
        json.dumps(good)[:-1],
        "<script>document.title = 'run'</script>",
    ]


def said(couplet, *words):
    return subprocess.run([couplet, *words], capture_output=True, text=True)


def main():
    index, couplet = sys.argv[1:]
    if not shutil.which("chromium"):
        print("skipped: the page in a browser; install chromium", file=sys.stderr)
        return
    page = pathlib.Path(index).read_text(encoding="utf-8")
    assert len(page) < 2_000_000, len(page)
    for loaded in ["src=", "href=", "@import", "fetch("]:
        assert loaded not in re.sub(r'<script type="text/plain".*?</script>', "", page, flags=re.DOTALL).replace("link.href =", ""), loaded

    # As it is, under its policy.
    for _ in range(5):
        # Without a timer that waits, the clock may run out before WebAssembly is compiled.
        dom, console = browser(page, "half_opening=80deg&friction=0.35&weight=heyman")
        if "loaded" not in element(dom, "proof"):
            break
    assert not console, console
    assert element(dom, "proof").startswith("Proved here"), element(dom, "proof")
    assert element(dom, "thickness") == "0.06863521258", element(dom, "thickness")

    good = (REPOSITORY / "proofs/constants/triple-point-heyman.json").read_text(encoding="utf-8")
    other = (REPOSITORY / "proofs/states").glob("*.json")
    files = [["good.json", good], *[[path.name, path.read_text(encoding="utf-8")] for path in sorted(other)]]
    files += [[f"spoiled-{k}.json", text] for k, text in enumerate(spoiled(json.loads(good)))]
    files.append(["blank.json", ""])

    # Across the dividing lines: where the friction is that of the purely sliding state, or lets the shoulder slide.
    state = json.loads(said(couplet, "state", "--weight", "heyman", "--half-opening", "80deg", "--friction", "0.35", "--digits", "8", "--format", "json").stdout)
    across = []
    for name in ["sliding_friction", "rotational_friction"]:
        limit = float(state[name]["value"])
        across += [("heyman", "80deg", f"{limit + step:.7f}") for step in (-1e-5, 1e-5)]
    thick = [("heyman", "80deg", "0.6", "0.2"), ("heyman", "80deg", "0.6", "0.05")]
    arches = ARCHES + across + thick
    work = json.dumps({"arches": arches, "files": files}).replace("</", "<\\/")
    bare = re.sub(r"<meta http-equiv=\"Content-Security-Policy\".*?>", "", page, count=1)
    dom, console = browser(bare + HARNESS % work)
    assert not console, console
    found = json.loads(re.search(r'<pre id="noted">(.*?)</pre>', dom, re.DOTALL)[1].replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&"))

    modes = []
    with tempfile.TemporaryDirectory() as folder:
        for (weight, alpha, mu, *eta), (proof, verdict, mode, thickness, thrust, rotation, _), made in zip(arches, found["noted"], found["made"]):
            arch = ["--weight", weight, "--half-opening", alpha, "--friction-angle" if mu.endswith("deg") else "--friction", mu]
            truth = json.loads(said(couplet, "state", *arch, "--digits", "10", "--format", "json").stdout)
            assert proof.startswith("Proved here"), (arch, proof)
            if truth.get("mode") is None:
                assert "stands at no thickness" in proof, (arch, proof, truth)
                modes.append(None)
            else:
                shown = [mode, thickness, thrust]
                assert shown == [truth["mode"], truth["thickness"]["value"], truth["thrust"]["value"]], (arch, shown, truth)
                if truth.get("rotation_joint"):
                    assert rotation.split(" ")[0] in (truth["rotation_joint"]["value"], "none"), (arch, rotation, truth)
                modes.append(mode)
            if eta:
                stands = float(eta[0]) > float(truth["thickness"]["value"])
                assert verdict.startswith("It stands" if stands else "It does not stand"), verdict
            assert made, (arch, "no certificate")
            file = pathlib.Path(folder) / "arch.json"
            file.write_text(made, encoding="utf-8")
            checked = said(couplet, "check", str(file))
            assert checked.returncode == 0, checked.stdout
        for (name, text), sentence in zip(files, found["sentences"]):
            file = pathlib.Path(folder) / name
            file.write_text(text, encoding="utf-8")
            truth = said(couplet, "check", str(file)).stdout.strip().removeprefix(str(file))
            # The command adds the option that this page has not.
            assert truth.split(";")[0] == sentence.removeprefix(name).split(";")[0], (truth, sentence)
        assert sum("accepted" in text for text in found["sentences"]) == len(list((REPOSITORY / "proofs/states").glob("*.json"))) + 1
    assert len(set(modes[: len(ARCHES)])) == 7 and modes[len(ARCHES) : len(ARCHES) + 4] == [None, "[s,r,r]", "[s,r,r]", "[r,r,r]"], modes
    assert found["fields"][1] == "" and abs(float(found["fields"][0]) - 1.918) < 1e-3, found["fields"]
    # A place of the map is a candidate, and says so.
    assert found["noted"][-1][0].startswith("Candidate, not proved"), found["noted"][-1]
    assert "friction=0.2" in found["hash"], found["hash"]
    print(f"page: {len(arches)} arches and {len(files)} files as the command has them; {len(page)} bytes")


if __name__ == "__main__":
    main()
