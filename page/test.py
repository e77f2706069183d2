#!/usr/bin/env python3
"""The page in a real browser: what it shows and says is what the command prints. Without Chromium nothing is tested.

    page/test.py INDEX.html COUPLET            tests
    page/test.py --measure INDEX.html          how long the first picture and a step of a slider take
    page/test.py --pictures INDEX.html FOLDER  the page in both themes and on a phone, to look at
"""

import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

from browser import Browser

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
# With a thickness: thicker and thinner than the least one, in several modes.
THICK = [
    ("heyman", "80deg", "0.6", "0.2"), ("heyman", "80deg", "0.6", "0.05"), ("heyman", "80deg", "0.35", "3/20"),
    ("milankovitch", "2.45", "1.45", "0.9"), ("milankovitch", "2.45", "1.45", "0.5"), ("milankovitch", "2.57", "2.2", "1.4"),
    ("heyman", "2.65", "inf", "1.3"), ("milankovitch", "20deg", "0.6", "0.001"), ("milankovitch", "20deg", "0.6", "0.0001"),
]
# Measured: span, rise, friction, thickness.
MEASURED = [("10m", "3m", "0.6", "60cm"), ("33ft", "7ft", "0.5", "5in"), ("8m", "400cm", "0.38", "0.3m"), ("8m", "5m", "1.1", "")]


def given(weight, alpha, mu, *eta):
    friction = {"friction_angle": mu} if mu.endswith("deg") else {"friction": mu}
    return {"weight": weight, "half_opening": alpha, **friction, **({"thickness": eta[0]} if eta and eta[0] else {})}


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


class Page(Browser):
    """The page, opened and ready to prove."""

    def __init__(self, index, fragment="", **options):
        super().__init__(**options)
        self.address = f"file://{pathlib.Path(index).resolve()}"
        self.fragment = fragment

    def __enter__(self):
        super().__enter__()
        self.open(f"{self.address}#{self.fragment}" if self.fragment else self.address)
        # A test asserts no time.
        self.run("patience = 1000; prover.ready()")
        self.settled()
        return self

    def settled(self):
        """Waits for the last proof."""
        self.run("(async () => { while (isBusy || !canProve) await new Promise((resolve) => setTimeout(resolve, 5)); })()")

    def show(self, arch):
        self.run(f"show({json.dumps(arch)})")
        self.settled()
        return self.texts()

    def texts(self):
        return self.run("""Object.fromEntries([...ROWS, ...MORE, "proof", "verdict", "summary", "certify-command", "saved"].map((id) => [id, at(id).textContent]))""")


class Couplet:
    """The command, and what it says as JSON."""

    def __init__(self, path):
        self.path = path

    def said(self, *words):
        return subprocess.run([self.path, *words], capture_output=True, text=True)

    def json(self, *words):
        return json.loads(self.said(*words, "--format", "json").stdout)

    @staticmethod
    def options(arch):
        return [word for key, value in arch.items() for word in (f"--{key.replace('_', '-')}", value)]

    def state(self, arch, digits=10):
        arch = {key: value for key, value in arch.items() if key != "thickness"}
        return self.json("state", *self.options(arch), "--digits", str(digits))

    def accepts(self, text):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "arch.json"
            file.write_text(text, encoding="utf-8")
            checked = self.said("check", str(file))
        return checked.returncode == 0, checked.stdout.strip().removeprefix(str(file))


def numbers_of_states(page, couplet):
    """The mode and the numbers of the table are those of the command, digit by digit."""
    state = couplet.state(given("heyman", "80deg", "0.35"), 8)
    across = []
    for name in ["sliding_friction", "rotational_friction"]:
        limit = float(state[name]["value"])
        across += [("heyman", "80deg", f"{limit + step:.7f}") for step in (-1e-5, 1e-5)]
    modes = []
    for arch in ARCHES + across:
        arch = given(*arch)
        found, truth = page.show(arch), couplet.state(arch)
        assert found["proof"].startswith("Proved here"), (arch, found["proof"])
        made = page.run(f"prove({json.dumps(arch)}, solve({json.dumps(arch)}), {{ file: true }})")
        assert couplet.accepts(made["certificate"])[0], arch
        if truth.get("mode") is None:
            # Beyond a limit that is that of the certificate, and not what is given.
            assert "stands at no thickness" in found["proof"], (arch, found)
            limits = {of["quantity"]: of["value"] for of in json.loads(made["certificate"])["values"]}
            limit = limits["friction" if "slides with less friction" in found["proof"] else "half_opening"]
            assert float(limit) == float(re.search(r"(?:less friction than|beyond) ([\d.e-]*\d)", found["proof"])[1]), (found, limits)
        else:
            shown = [found[name] for name in ("mode", "thickness", "thrust")]
            assert shown == [truth["mode"], truth["thickness"]["value"], truth["thrust"]["value"]], (arch, shown, truth)
            if truth.get("rotation_joint"):
                assert found["rotation_joint"].split(" ")[0] in (truth["rotation_joint"]["value"], "none"), (arch, found)
        modes.append(truth.get("mode"))
    assert len(set(modes[: len(ARCHES)])) == 7, modes
    assert modes[len(ARCHES) :] == [None, "[s,r,r]", "[s,r,r]", "[r,r,r]"], modes
    return len(modes)


def more_friction(page):
    """Short of B friction is what an arch that slides lacks, between B and L it lacks more, beyond L it is too wide."""
    for alpha, said, other in [("149deg", "slides with less friction than", ", and"), ("151deg", "thicker than twice its radius", "nothing stands"), ("155.2deg", "nothing stands at any friction", "needs")]:
        proof = page.show(given("milankovitch", alpha, "0.9"))["proof"]
        assert said in proof and other not in proof, (alpha, proof)


def verdicts_on_thicknesses(page, couplet):
    """Stands or falls, the safety, and a certificate of it that the command accepts; the command shown makes it too."""
    for arch in THICK:
        arch = given(*arch)
        found, truth = page.show(arch), couplet.json("assess", *couplet.options(arch), "--digits", "4")
        stands = truth["stands"]
        assert found["verdict"].startswith("It stands, proved" if stands else "It falls, proved"), (arch, found["verdict"])
        said, known = found["geometric_safety"], truth["geometric_safety"]["value"]
        assert float(said) == float(known), (arch, said, known)
        made = page.run(f"prove({json.dumps(arch)}, solve({json.dumps(arch)}), {{ file: true }})")
        accepted, sentence = couplet.accepts(made["certificate"])
        assert accepted and ("does not stand" in sentence) != stands, (arch, sentence)
        words = subprocess.run(["bash", "-c", found["certify-command"].replace("couplet", couplet.path, 1).replace("-o arch.json", "")], capture_output=True, text=True)
        assert words.returncode == 0 and couplet.accepts(words.stdout)[0], (found["certify-command"], words.stderr)
        drawn = page.run("at('arch').innerHTML")
        assert ("arch-thrust" in drawn) == stands, arch
    # A thickness that is the least one to twenty digits is neither.
    least = couplet.state(given("heyman", "80deg", "0.6"), 40)["thickness"]["value"]
    found = page.show(given("heyman", "80deg", "0.6", least))
    assert found["verdict"].startswith("Undecided"), found["verdict"]


def measures(page, couplet):
    """Span and rise give the arch of the command, in radians, degrees and metres."""
    for span, rise, mu, thickness in MEASURED:
        page.run("at('by-span').click()")
        for id, text in [("ask-span", span), ("ask-rise", rise), ("ask-friction", mu), ("ask-thickness", thickness)]:
            page.run(f"at('{id}').value = {json.dumps(text)}")
        page.click("show-arch")
        page.settled()
        found = page.texts()
        arch = ["--weight", page.run("map().id"), "--span", span, "--rise", rise, "--friction", mu, "--digits", "10"]
        truth = couplet.json("state", *arch)
        same = lambda shown, name: float(shown) == float(truth[name]["value"])
        assert same(found["thickness"], "thickness") and same(found["thrust"], "thrust"), (span, rise, found, truth)
        assert same(found["least_thickness_m"], "least_thickness_m"), (found, truth)
        # The radius of the centreline is that at the thickness which the arch has.
        sized = couplet.json("assess", *arch, "--thickness", thickness) if thickness else truth
        assert float(found["radius_m"]) == float(sized["radius_m"]["value"]), (found, sized)
        degrees = found["half_opening"].split(", ")[1].removesuffix("°")
        if truth.get("half_opening_degrees"):
            assert same(degrees, "half_opening_degrees"), (degrees, truth)
        if thickness:
            truth = couplet.json("assess", "--weight", page.run("map().id"), "--span", span, "--rise", rise, "--friction", mu, "--thickness", thickness, "--digits", "4")
            assert float(found["geometric_safety"]) == float(truth["geometric_safety"]["value"]), (found, truth)
    # At another circle; a slider's thickness says that it is a ratio; an angle is a friction.
    for id, text in [("ask-span", "10m"), ("ask-rise", "3m"), ("ask-friction", "31deg"), ("ask-thickness", "60cm")]:
        page.run(f"at('{id}').value = {json.dumps(text)}")
    page.run("at('ask-circle').value = 'extrados'; at('ask-circle').dispatchEvent(new Event('change'))")
    page.settled()
    found = page.texts()
    arch = ["--weight", page.run("map().id"), "--span", "10m", "--rise", "3m", "--friction", "31deg", "--measured-at", "extrados", "--thickness", "60cm"]
    truth = couplet.json("assess", *arch, "--digits", "10")
    assert float(found["radius_m"]) == float(truth["radius_m"]["value"]), (found, truth)
    assert "measured_at=extrados" in page.run("location.hash") and "friction=31deg" in page.run("location.hash")
    page.run("at('slide-thickness').value = '0.1'; at('slide-thickness').dispatchEvent(new Event('change'))")
    assert page.run("at('ask-thickness').value") == "0.1r"
    page.run("at('ask-circle').value = 'intrados'; at('ask-thickness').value = ''")
    # A length without its unit is in metres; what is no length is said so.
    page.run("at('ask-span').value = '12'")
    page.click("show-arch")
    page.settled()
    assert "span=12m" in page.run("location.hash"), page.run("location.hash")
    page.run("at('ask-rise').value = 'x'")
    page.click("show-arch")
    assert "lengths" in page.texts()["summary"]
    page.run("at('by-half-opening').click()")


def drags(page, couplet):
    """A slider that is dragged across a dividing line changes the mode where the command has it."""
    page.show(given("heyman", "80deg", "0.35"))
    limit = float(couplet.state(given("heyman", "80deg", "0.35"), 8)["rotational_friction"]["value"])
    x, y, width, height = page.place("slide-friction")
    y += height / 2
    page.pointer("mouseMoved", x + 0.3 * width, y)
    page.pointer("mousePressed", x + 0.3 * width, y, down=True)
    seen = []
    for k in range(60, 0, -1):
        page.pointer("mouseMoved", x + 0.3 * width * k / 60, y, down=True)
        page.settled()
        seen.append((float(page.run("at('slide-friction').value")), page.texts()["mode"], page.run("at('found').hidden")))
    page.pointer("mouseReleased", x, y)
    page.settled()
    sliding = float(couplet.state(given("heyman", "80deg", "0.35"), 8)["sliding_friction"]["value"])
    for friction, mode, is_hidden in seen:
        should = None if friction < sliding else "[s,r,r]" if friction < limit else "[r,r,r]"
        assert (None if is_hidden else mode) == should, (friction, mode, should)
    assert {None if is_hidden else mode for _, mode, is_hidden in seen} == {None, "[s,r,r]", "[r,r,r]"}, seen
    assert f"friction={page.run('at(`slide-friction`).value')}" in page.run("location.hash")
    return len(seen)


def map_and_pointer(page):
    """A place of the map under the pointer is a candidate, marked as one, and can be taken."""
    x, y, width, height = page.run("(() => { scrollTo(0, 0); const b = drawing().getBoundingClientRect(); return [b.x, b.y, b.width, b.height]; })()")
    page.pointer("mouseMoved", x + 0.6 * width, y + 0.75 * height)
    page.settled()
    assert page.texts()["proof"].startswith("Candidates"), page.texts()
    assert page.run("[...ROWS].every((id) => at(id).classList.contains('candidate'))")
    assert page.run("getComputedStyle(at('thickness'), '::before').content").startswith('"≈'), "a mark that is seen"
    page.click("take")
    page.settled()
    assert page.texts()["proof"].startswith("Proved here")
    assert page.run("ROWS.every((id) => at(id).classList.contains('proved'))")


def keyboard(page):
    """Everything can be reached by Tab, has a name, and the arrows move sliders and the cross."""
    page.show(given("heyman", "80deg", "0.6"))
    page.run("document.body.tabIndex = -1; document.body.focus()")
    reached = []
    for _ in range(40):
        page.key("Tab")
        reached.append(page.run("document.activeElement.id || document.activeElement.textContent.trim()"))
    wanted = {"heyman", "closer", "by-half-opening", "slide-half-opening", "slide-friction", "slide-thickness", "ask-half-opening", "ask-friction", "ask-thickness", "save", "play", "motion", "copy", "files"}
    assert wanted <= set(reached), wanted - set(reached)
    page.run("at('slide-friction').focus()")
    before = page.run("at('slide-friction').value")
    page.key("ArrowRight")
    page.settled()
    after = page.run("at('slide-friction').value")
    assert abs(float(after) - float(before) - 0.01) < 1e-9 and page.texts()["friction"] == after, (before, after)
    page.run("map().focus()")
    page.key("ArrowUp")
    page.settled()
    assert page.texts()["proof"].startswith("Candidates"), "the cross has moved"
    names = page.call("Accessibility.getFullAXTree")["nodes"]
    nameless = [node for node in names if node.get("role", {}).get("value") in ("slider", "button", "textbox", "radio", "radiogroup", "application", "img", "table") and not node.get("ignored") and not node.get("name", {}).get("value")]
    assert not nameless, nameless
    return len(set(reached))


def motion(page):
    """The blocks move, stop, and go where the slider says; who asked for less motion sees them still."""
    page.show(given("milankovitch", "2.45", "1.35"))
    place = "picture().querySelector('[id=arch-mechanism] g').getCTM().e"
    drawn = page.run("at('arch').innerHTML")
    assert drawn.count("<animateTransform") == 12, "two for each of six blocks"
    assert not page.run("picture().animationsPaused()")
    page.click("play")
    assert page.run("picture().animationsPaused()") and page.run("at('play').textContent") == "Play"
    page.run("at('motion').value = 0; at('motion').dispatchEvent(new Event('input'))")
    rest = page.run(place)
    page.run("at('motion').value = 100; at('motion').dispatchEvent(new Event('input'))")
    assert abs(page.run(place) - rest) > 1, "the blocks have moved"
    page.show(given("milankovitch", "2.45", "1.36"))
    assert page.run("picture().animationsPaused()"), "another arch stays still too"
    page.click("play")


def less_motion(index):
    with Browser() as page:
        page.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-reduced-motion", "value": "reduce"}])
        page.open(f"file://{pathlib.Path(index).resolve()}")
        page.run("prover.ready()")
        page.run("(async () => { while (isBusy || !canProve) await new Promise((resolve) => setTimeout(resolve, 5)); })()")
        assert page.run("picture().animationsPaused()") and page.run("at('play').textContent") == "Play"


def files(page, couplet):
    """Good and spoiled certificates get the sentence of the command; a long one can be given up while the page goes on."""
    good = (REPOSITORY / "proofs/constants/triple-point-heyman.json").read_text(encoding="utf-8")
    others = sorted((REPOSITORY / "proofs/states").glob("*.json"))
    dropped = [["good.json", good], *[[path.name, path.read_text(encoding="utf-8")] for path in others]]
    dropped += [[f"spoiled-{k}.json", text] for k, text in enumerate(spoiled(json.loads(good)))]
    dropped.append(["blank.json", ""])
    drop = """(async (files) => {
      const transfer = new DataTransfer();
      for (const [name, text] of files) transfer.items.add(new File([text], name));
      dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, cancelable: true }));
      %s
    })"""
    wait = "while (isChecking) await new Promise((resolve) => setTimeout(resolve, 20)); return [...at('checked').children].map((line) => line.textContent.trim()).reverse();"
    sentences = page.run(f"{drop % wait}({json.dumps(dropped)})")
    for (name, text), sentence in zip(dropped, sentences, strict=True):
        truth = couplet.accepts(text)[1]
        # The command adds the option that this page has not.
        assert truth.split(";")[0] == sentence.removeprefix(name).split(";")[0], (truth, sentence)
    assert sum("accepted" in text for text in sentences) == len(others) + 1
    long = couplet.said("certify", "T", "--weight", "heyman", "--digits", "20000").stdout
    page.run(f"{drop % ''}({json.dumps([['long.json', long], ['after.json', good]])})")
    page.run("new Promise((done) => { const look = () => /long.json: checking/.test(at('checked').textContent) ? done() : setTimeout(look, 5); look(); })")
    # In the meantime an arch is proved.
    assert page.show(given("heyman", "80deg", "0.61"))["proof"].startswith("Proved here")
    page.run("[...at('checked').querySelectorAll('button')].find((button) => /long/.test(button.ariaLabel)).click()")
    lines = page.run("(async () => { while (isChecking) await new Promise((resolve) => setTimeout(resolve, 20)); return [...at('checked').children].slice(0, 2).map((line) => line.textContent.trim()); })()")
    assert "accepted" in lines[0] and "given up while it was checked" in lines[1], lines
    return len(dropped)


def nonsense(page):
    """What is no arch is said to be none, in words, and nothing is shown as proved; the address runs nothing."""
    for fragment, said in [
        ("half_opening=<img src=x onerror=alert(1)>&friction=0.6", "a half opening is between"),
        ("half_opening=200deg&friction=1", "a half opening is between"),
        ("half_opening=1&friction=", "a friction is positive"),
        ("half_opening=1", "a friction is positive"),
        ("span=10m&friction=0.6", "are lengths"),
        ("span=10&rise=3&friction=0.6", "are lengths"),
        ("half_opening=1&friction=1&thickness=3", "not proved: the thickness 3 is not between 0 and 2"),
        ("half_opening=1&friction=1&thickness=60cm", "not proved: the thickness 60cm is a length"),
        ("span=10m&rise=3m&friction=1&thickness=0.6", "not proved: the thickness 0.6 has no unit"),
        ("span=10m&rise=3m&friction=1&thickness=60cm&measured_at=middle", "not proved: an arch is measured at one of"),
        ("half_opening=1e-9&friction=0.6", "not proved"),
    ]:
        page.run(f"new Promise((done) => {{ addEventListener('hashchange', () => setTimeout(done), {{ once: true }}); location.hash = {json.dumps(fragment)}; }})")
        page.settled()
        found = page.texts()
        assert said in found["summary"] + found["proof"], (fragment, found)
        assert page.run("at('found').hidden || ROWS.every((id) => !at(id).classList.contains('proved'))"), fragment
        assert not found["thickness"].startswith("-"), found


def saves(page):
    """The file that the button hands out is checked once more on the page."""
    page.show(given("heyman", "80deg", "0.6", "0.2"))
    page.click("save")
    page.run("new Promise((done) => { const look = () => /accepted|refused|not/.test(at('saved').textContent) ? done() : setTimeout(look, 10); look(); })")
    assert page.texts()["saved"].startswith("arch.json: accepted  stands (an admissible symmetric state exists) half_opening 4/9 pi"), page.texts()["saved"]


def narrow(index):
    with Page(index, size=(360, 740), touch=True) as page:
        assert page.run("document.documentElement.scrollWidth") <= 360
        assert not page.console, page.console


def test(index, couplet):
    text = pathlib.Path(index).read_text(encoding="utf-8")
    assert len(text) < 2_000_000, len(text)
    bare = re.sub(r'<script type="text/plain".*?</script>', "", text, flags=re.DOTALL)
    for loaded in ["src=", "href=", "@import", "fetch(", "unsafe-inline", "unsafe-eval' "]:
        assert loaded not in bare.replace("link.href =", "").replace("'wasm-unsafe-eval'", ""), loaded
    couplet = Couplet(couplet)
    with Page(index, "half_opening=80deg&friction=0.35&weight=heyman") as page:
        assert page.texts()["thickness"] == "0.06863521258", page.texts()
        states = numbers_of_states(page, couplet)
        more_friction(page)
        verdicts_on_thicknesses(page, couplet)
        measures(page, couplet)
        steps = drags(page, couplet)
        map_and_pointer(page)
        reached = keyboard(page)
        motion(page)
        checked = files(page, couplet)
        saves(page)
        nonsense(page)
        assert not page.console, page.console
    less_motion(index)
    narrow(index)
    print(f"page: {states} states, {len(THICK)} thicknesses, {len(MEASURED)} spans and {checked} files as the command has them; {steps} steps of a slider; {reached} places by Tab; {len(text)} bytes")


def measure(index):
    """What nobody asserts: milliseconds of the first picture, and of the steps of a slider."""
    with Browser() as page:
        page.open("about:blank")
        first = []
        for _ in range(5):
            page.open(f"file://{pathlib.Path(index).resolve()}")
            page.run("prover.ready()")
            page.run("(async () => { while (isBusy || !canProve) await new Promise((resolve) => setTimeout(resolve, 1)); })()")
            first.append(page.run("[performance.getEntriesByName('first-contentful-paint')[0].startTime, performance.now()]"))
        paint, proof = (sorted(of)[2] for of in zip(*first))
        print(f"first picture after {paint:.0f} ms, its proof and drawing after {proof:.0f} ms (median of 5)")
        for what, arch in [("least thickness", ""), ("thickness 0.2", "&thickness=0.2")]:
            page.open(f"file://{pathlib.Path(index).resolve()}#half_opening=80deg&friction=0.6&weight=heyman{arch}")
            page.run("prover.ready()")
            times = page.run("""(async () => {
              const frames = [], told = [];
              addEventListener("told", () => told.push(performance.now()));
              for (let k = 0; k < 120; k++) {
                frames.push(await new Promise(requestAnimationFrame));
                at("slide-half-opening").value = 60 + k / 4;
                at("slide-half-opening").dispatchEvent(new Event("input"));
              }
              frames.push(await new Promise(requestAnimationFrame));
              await new Promise((resolve) => setTimeout(resolve, 200));
              return { frames, told };
            })()""")
            gaps = sorted(b - a for a, b in zip(times["frames"], times["frames"][1:]))
            print(f"slider, {what}: 120 steps, a frame every {gaps[60]:.1f} ms, the slowest but six {gaps[-7]:.1f} ms; {len(times['told'])} proved and drawn")


def pictures(index, folder):
    wanted = [("light", {}), ("dark", {"dark": True}), ("phone", {"size": (360, 740), "touch": True}), ("phone-dark", {"size": (360, 740), "touch": True, "dark": True})]
    for name, options in wanted:
        with Page(index, "half_opening=140deg&friction=1.45&weight=milankovitch", **options) as page:
            time.sleep(0.5)
            page.picture(pathlib.Path(folder) / f"{name}.png", whole=True)


def main():
    if not shutil.which("chromium"):
        print("skipped: the page in a browser; install chromium", file=sys.stderr)
    elif sys.argv[1] == "--measure":
        measure(sys.argv[2])
    elif sys.argv[1] == "--pictures":
        pictures(*sys.argv[2:])
    else:
        test(*sys.argv[1:])


if __name__ == "__main__":
    main()
