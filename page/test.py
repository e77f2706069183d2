#!/usr/bin/env python3
"""The page in a real browser: what it shows and says is what the command prints. Without Chromium nothing is tested.

    page/test.py INDEX.html COUPLET            tests
    page/test.py --measure INDEX.html          how long the first picture and a step of a slider take
    page/test.py --pictures INDEX.html FOLDER  the page in both themes and on a phone, to look at
"""

import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree

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
PLANES = ["thickness-friction", "opening-friction", "opening-thickness"]
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

    def go(self, fragment):
        """What the page says to another address."""
        went = "addEventListener('hashchange', () => setTimeout(done), { once: true })"
        self.run(f"new Promise((done) => {{ {went}; history.replaceState(null, '', '#'); location.hash = {json.dumps(fragment)}; }})")
        self.settled()
        return self.texts()

    def at_place(self, plane, across, up):
        """A point of the window over a plane, at these parts of its frame from the left and from above."""
        return self.run(f"""(() => {{
          const plane = shownPlanes().find((one) => one.plane === "{plane}"), {{ left, top, width, height }} = plane.frames.at(-1);
          plane.svg.scrollIntoView({{ block: "center" }});
          const box = plane.svg.getBoundingClientRect();
          return [box.x + left + {across} * width, box.y + top + {up} * height];
        }})()""")

    def texts(self):
        return self.run("""Object.fromEntries([...ROWS, ...MORE, "proof", "verdict", "summary", "command", "certify-command", "map-command", "saved"].map((id) => [id, at(id).textContent]))""")


class Couplet:
    """The command, and what it says as JSON."""

    def __init__(self, path):
        self.path = str(pathlib.Path(path).resolve())

    def said(self, *words):
        return subprocess.run([self.path, *words], capture_output=True, text=True)

    def runs(self, line):
        """A line of the page, run by a shell as it stands; what it would write goes nowhere."""
        words = line.replace("couplet", self.path, 1)
        with tempfile.TemporaryDirectory() as folder:
            return subprocess.run(["bash", "-c", words], capture_output=True, text=True, cwd=folder)

    def refusal(self, fields):
        """The sentence in which the command refuses a question, in the words of keys."""
        *_, question, options = fields
        said = self.said(question, *options).stderr.strip().removeprefix("couplet: ").split("; for example")[0]
        return re.sub(r"--([a-z-]+)", lambda option: option[1].replace("-", "_"), said)

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


def more_friction(page, couplet):
    """Short of B friction is what an arch that slides lacks, between B and L it lacks more, beyond L it is too wide."""
    for alpha, mu, said, other in [
        ("149deg", "0.9", "slides with less friction than", ", and"), ("151deg", "0.9", "thicker than twice its radius", "nothing stands"),
        ("155.2deg", "0.9", "nothing stands at any friction", "enough"), ("151deg", "2.5", "a thickness of 2 is just enough, and with", "nothing stands"),
        ("155.2deg", "inf", "a thickness of 2 is just enough, and beyond", "with a friction"),
    ]:
        proof = page.show(given("milankovitch", alpha, mu))["proof"]
        assert said in proof and other not in proof, (alpha, proof)
        # What is named is a little more than what is not enough; the command has both so.
        named = re.search(r"with a friction of (\S+) it .*; (\S+) is enough", proof)
        assert (named is None) == (alpha != "151deg"), proof
        for friction, stands in zip(named.groups() if named else (), (False, True)):
            assert bool(couplet.state(given("milankovitch", alpha, friction)).get("mode")) == stands, (friction, stands)


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
        arch = ["--weight", page.run("weight"), "--span", span, "--rise", rise, "--friction", mu, "--digits", "10"]
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
            truth = couplet.json("assess", "--weight", page.run("weight"), "--span", span, "--rise", rise, "--friction", mu, "--thickness", thickness, "--digits", "4")
            assert float(found["geometric_safety"]) == float(truth["geometric_safety"]["value"]), (found, truth)
    # At another circle; a slider's thickness says that it is a ratio; an angle is a friction.
    for id, text in [("ask-span", "10m"), ("ask-rise", "3m"), ("ask-friction", "31deg"), ("ask-thickness", "60cm")]:
        page.run(f"at('{id}').value = {json.dumps(text)}")
    page.run("at('ask-circle').value = 'extrados'; at('ask-circle').dispatchEvent(new Event('change'))")
    page.settled()
    found = page.texts()
    arch = ["--weight", page.run("weight"), "--span", "10m", "--rise", "3m", "--friction", "31deg", "--measured-at", "extrados", "--thickness", "60cm"]
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
    page.settled()
    friction = page.run("at('ask-friction').value")
    assert page.texts()["summary"] == couplet.refusal(["state", ["--span", "12m", "--rise", "x", "--friction", friction]]), page.texts()
    page.run("at('by-half-opening').click()")


def drags(page, couplet):
    """A slider that is dragged across a dividing line changes the mode where the command has it."""
    page.show(given("heyman", "80deg", "0.35"))
    limit = float(couplet.state(given("heyman", "80deg", "0.35"), 8)["rotational_friction"]["value"])
    x, y, width, height = page.place("slide-friction")
    y += height / 2
    page.pointer("mouseMoved", x + 0.45 * width, y)
    page.pointer("mousePressed", x + 0.45 * width, y, down=True)
    seen = []
    for k in range(60, 0, -1):
        page.pointer("mouseMoved", x + 0.45 * width * k / 60, y, down=True)
        page.settled()
        seen.append((float(page.run("at('ask-friction').value")), page.texts()["mode"], page.run("at('found').hidden")))
    page.pointer("mouseReleased", x, y)
    page.settled()
    sliding = float(couplet.state(given("heyman", "80deg", "0.35"), 8)["sliding_friction"]["value"])
    for friction, mode, is_hidden in seen:
        should = None if friction < sliding else "[s,r,r]" if friction < limit else "[r,r,r]"
        assert (None if is_hidden else mode) == should, (friction, mode, should)
    assert {None if is_hidden else mode for _, mode, is_hidden in seen} == {None, "[s,r,r]", "[r,r,r]"}, seen
    assert f"friction={page.run('at(`ask-friction`).value')}" in page.run("location.hash")
    # At its end friction is unlimited, which is where half arches overturn.
    page.show(given("heyman", "2.65", "1.9"))
    page.run("at('slide-friction').focus()")
    page.key("End")
    page.settled()
    assert (page.texts()["mode"], page.texts()["friction"], page.run("at('slide-friction').ariaValueText ?? at('slide-friction').getAttribute('aria-valuetext')")) == ("[r]", "∞", "inf"), page.texts()
    return len(seen)


def map_and_pointer(page):
    """A place of the map under the pointer is a candidate, marked as one, and can be taken."""
    page.pointer("mouseMoved", *page.at_place("thickness-friction", 0.6, 0.8))
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
    for _ in range(60):
        page.key("Tab")
        reached.append(page.run("document.activeElement.id || document.activeElement.textContent.trim()"))
    wanted = {*(f"heyman-{plane}" for plane in PLANES), "closer", "levels", "save-map", "by-half-opening", "slide-half-opening", "slide-friction", "slide-thickness", "ask-half-opening", "ask-friction", "ask-thickness", "save", "play", "motion", "copy", "files"}
    assert wanted <= set(reached), wanted - set(reached)
    page.run("at('slide-friction').focus()")
    before = page.run("at('slide-friction').value")
    page.key("ArrowRight")
    page.settled()
    after = page.run("at('slide-friction').value")
    said = page.run("at('slide-friction').getAttribute('aria-valuetext')")
    assert abs(float(after) - float(before) - 0.1) < 1e-9 and page.texts()["friction"] == said, (before, after, said)
    page.run("largePlane().svg.focus()")
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


def refused(page, fragment):
    """What an address is refused with; nothing is shown then, nor a command."""
    found = page.go(fragment)
    assert page.run("at('found').hidden && at('with-command').hidden && at('certify').hidden && at('verdict').hidden"), fragment
    assert not found["proof"], (fragment, found["proof"])
    return found["summary"]


def nonsense(page):
    """What is no arch is said to be none, in words, and nothing is shown as proved; the address runs nothing."""
    for fragment, said in [
        ("half_opening=<img src=x onerror=alert(1)>&friction=0.6", "'<img src=x onerror=alert(1)>' is not a number"),
        ("half_opening=200deg&friction=1", "half opening"),
        ("half_opening=1&friction=", "friction"),
        ("half_opening=1&friction=1&thickness=60cm", "the thickness 60cm is a length"),
        ("half_opening=1&friction=1&friction_angle=1", "one of them is enough"),
        ("thickness=3&friction=1", "a thickness is positive, and 2 at most"),
        ("thickness=1&friction=x", "a friction is positive"),
        ("thickness=1&half_opening=4", "a half opening is between"),
        ("span=10m&rise=3m&friction=1&thickness=60cm&measured_at=middle", "an arch is measured at one of"),
        ("weight=__proto__", "the weight '__proto__' is none of this page, which has heyman, milankovitch"),
        ("half_opening=1&friction=1&weight=", "the weight '' is none of this page"),
        ("__proto__=1&half_opening=1&friction=1", "an address has no key '__proto__'; its keys are weight, half_opening"),
        ("half_opening=1&friction=1&colour=red", "an address has no key 'colour'"),
        ("half_opening=1&friction=1&alpha=2", "half_opening is given twice"),
        ("plane=constructor", "the plane 'constructor' is none of this page"),
        ("friction_range=50..40", "the smaller first, within 0..90, and not '50..40'"),
        ("thickness_range=0..2.5", "within 0..2, and not '0..2.5'"),
        ("half_opening_range=0..90", "the plane thickness-friction has no axis of half opening"),
    ]:
        summary = refused(page, fragment)
        assert said in summary, (fragment, summary)
    # Beyond what doubles hold it says so, and the command has the digits.
    found = page.go("half_opening=1e-9&friction=0.6")
    assert found["proof"].startswith("Candidates (≈), not proved here") and "The command below" in found["proof"], found["proof"]


def questions(page, couplet):
    """The list that every door is asked, by addresses: what the command answers, and its sentence where it refuses."""
    lines = (REPOSITORY / "tests/questions.txt").read_text(encoding="utf-8").splitlines()
    asked = [line for line in lines if not line.startswith("#")]
    for line in asked:
        question, *fields = line.removeprefix("! ").split(" ")
        fragment = "&".join(["weight=heyman", *fields])
        options = ["--weight", "heyman", *(part for field in fields for part in ("--" + field.split("=")[0].replace("_", "-"), field.split("=")[1]))]
        if line.startswith("!"):
            summary, sentence = refused(page, fragment), couplet.refusal([question, options])
            assert summary == sentence, (line, summary, sentence)
            continue
        found, truth = page.go(fragment), couplet.json(question, *options, "--digits", "10")
        if truth.get("mode") is None and "least_thickness" not in truth:
            assert "stands at no thickness" in found["proof"], (line, found)
            continue
        assert found["proof"].startswith("Proved here"), (line, found["proof"])
        least = (truth.get("least_thickness") or truth["thickness"])["value"] if question == "state" else truth["least_thickness"]["value"]
        assert found["thickness"] == least, (line, found["thickness"], truth)
        if question == "assess":
            assert found["verdict"].startswith("It stands" if truth["stands"] else "It falls"), (line, found["verdict"])
        for name in ("radius_m", "least_thickness_m"):
            if truth.get(name):
                assert float(found[name]) == float(truth[name]["value"]), (line, name, found, truth)
    return len(asked)


def commands(page, couplet):
    """Each command that the page names is run as it stands, and answers what the page shows."""
    digits = lambda text: len(re.sub(r"^[0.]*|[^0-9]", "", text))
    for fragment, quantity, shown in [
        ("half_opening=80deg&friction=0.35", "thickness", "thickness"),
        ("half_opening=2atan(3/5)&friction=tan(31deg)", "thickness", "thickness"),
        ("span=10m&rise=3m&friction=0.6&thickness=60cm&measured_at=extrados", "geometric_safety", "geometric_safety"),
        ("radius=5m&half_opening=pi/2&friction=31deg", "thickness", "thickness"),
        ("half_opening=2.65&friction=inf", "thickness", "thickness"),
        ("half_opening=1e-9&friction=0.6", "thickness", None),
        ("half_opening=155.2deg&friction=0.9&weight=milankovitch", "stands", None),
        ("thickness=0.1&friction_angle=31deg", "half_opening", "half_opening"),
        ("thickness=0.1&half_opening=80deg", "friction", "friction"),
        ("thickness=1.5&half_opening=146deg", "friction", "friction"),
    ]:
        found = page.go(fragment)
        number = found[shown].split(" ")[0] if shown else ""
        ran = couplet.runs(found["command"] + " --format json" + (f" --digits {digits(number)}" if number else ""))
        assert ran.returncode == 0, (found["command"], ran.stderr)
        if shown:
            value = json.loads(ran.stdout)[quantity]["value"]
            assert float(value) == float(number), (found["command"], value, number)
        if found["certify-command"]:
            made = couplet.runs(found["certify-command"].replace("-o arch.json", ""))
            assert made.returncode == 0 and couplet.accepts(made.stdout)[0], (found["certify-command"], made.stderr)
    for fragment in ["weight=milankovitch", "plane=opening-friction&half_opening_range=120..150&friction_range=40..70&weight=heyman", "plane=opening-thickness", "friction_range=50..60&thickness_range=0.5..1"]:
        line = page.go(fragment)["map-command"]
        ran = couplet.runs(line)
        assert ran.returncode == 0, (line, ran.stderr)
        for part in fragment.split("&"):
            key, _, text = part.partition("=")
            assert not key or f"--{key.replace('_', '-')} {text}" in line, (line, part)


def overlapping(page):
    """Pairs of texts of the planes that lie over each other, and texts that leave their plane."""
    return page.run("""shownPlanes().flatMap(({ svg }) => {
      const whole = svg.getBoundingClientRect(), all = [...svg.querySelectorAll("text")].filter((one) => one.getClientRects().length);
      const boxes = all.map((one) => [one.textContent, one.getBoundingClientRect()]);
      const apart = ([, a], [, b]) => a.right <= b.left + 1 || b.right <= a.left + 1 || a.bottom <= b.top + 4 || b.bottom <= a.top + 4;
      const beyond = boxes.filter(([, a]) => a.left < whole.left - 1 || a.right > whole.right + 1 || a.top < whole.top - 1 || a.bottom > whole.bottom + 1);
      return [...beyond.map(([text]) => text), ...boxes.flatMap((a, k) => boxes.slice(k + 1).filter((b) => !apart(a, b)).map((b) => `${a[0]} ${b[0]}`))];
    })""")


def zooms(page, couplet):
    """Another part is drawn anew: types and strokes keep their sizes, lines are where they are proved to be."""
    looks = """(() => {
      const sizes = (name) => [...new Set([...largePlane().svg.querySelectorAll(`[${name}]`)].map((one) => one.getAttribute(name)))].sort().join();
      return [sizes("font-size"), sizes("stroke-width"), largePlane().svg.getAttribute("viewBox")];
    })()"""
    page.go("weight=milankovitch&half_opening=80deg&friction=0.6")
    triple = {one["quantity"]: float(one["value"]) for one in couplet.json("constants", "T", "--weight", "milankovitch", "--digits", "8")["constants"]}
    point = [math.degrees(triple["friction_angle"]), triple["thickness"]]
    for plane in PLANES:
        page.run(f"enlarge('{plane}')")
        before, seen = page.run(looks), set()
        for turn in range(9):
            assert not overlapping(page), (plane, turn, overlapping(page))
            assert page.run(looks)[2] == before[2] and set(page.run(looks)[0].split(",")) <= set(before[0].split(",")), (plane, page.run(looks))
            seen.add(page.run("largePlane().svg.querySelectorAll('g')[1] && JSON.stringify(largePlane().view)"))
            if plane == PLANES[0]:
                off = page.run(f"""(() => {{
                  const {{ main, frames }} = largePlane(), line = main.paths.find(({{ of }}) => of === "line-rrr-rrs");
                  const [x, y] = line.element.getAttribute("d").match(/-?[\d.]+/g), at = frames.at(-1).at({point});
                  return Math.hypot(x - at[0], y - at[1]);
                }})()""")
                assert off < 2.5, (turn, off)
            page.run("(() => { const plane = largePlane(), at = plane.landmarks.find(([name]) => name === 'T')[1]; plane.look(0.6, plane.frames.at(-1).at(at)); moved(); })()")
        assert len(seen) > 5, seen
        # It ends where the bound of a line is as wide as the line.
        page.run("for (let k = 0; k < 30; k++) largePlane().look(0.5, largePlane().middle())")
        wide = page.run("Math.max(...largePlane().off.map((off, k) => { const [low, high] = largePlane().view[k], { width, height } = largePlane().frames.at(-1); return off / (high - low) * [width, height][k]; }))")
        assert 1 < wide <= 2, (plane, wide)
        page.run("largePlane().look(Infinity, largePlane().middle())")
        assert page.run("largePlane().isWhole()")
    # The wheel keeps the place under the pointer, and so does a drag.
    under = lambda x, y: page.run(f"(() => {{ const plane = shownPlanes().find((one) => one.plane === '{PLANES[0]}'); return plane.frames.at(-1).of(plane.on({{ clientX: {x}, clientY: {y} }})); }})()")
    page.go("weight=milankovitch")
    # A wheel's place is that of a whole pixel.
    x, y = map(round, page.at_place(PLANES[0], 0.5, 0.6))
    place = under(x, y)
    page.call("Input.dispatchMouseEvent", type="mouseWheel", x=x, y=y, deltaX=0, deltaY=-300)
    page.run("new Promise((done) => { const look = () => largePlane().isWhole() ? setTimeout(look, 5) : done(); look(); })")
    near = lambda a, b: all(abs(p - q) < 1e-6 for p, q in zip(a, b, strict=True))
    assert near(under(x, y), place) and page.run("largePlane().view[0][1] - largePlane().view[0][0]") < 50, page.run("largePlane().view")
    page.pointer("mousePressed", x, y, down=True)
    page.pointer("mouseMoved", x + 40, y - 30, down=True)
    page.pointer("mouseReleased", x + 40, y - 30)
    assert near(under(x + 40, y - 30), place), (under(x + 40, y - 30), place)
    page.go("plane=opening-friction&half_opening_range=120..150&friction_range=40..70&half_opening=130deg&friction=inf")
    assert page.run("JSON.stringify(largePlane().view)") == "[[120,150],[40,70]]"
    # The address keeps what is shown.
    page.run("largePlane().look(0.5, largePlane().middle()); keep()")
    address = page.run("location.hash")
    assert "half_opening_range=127.5..142.5" in address and "plane=opening-friction" in address, address
    page.run("at('levels').click()")
    assert page.run("[...largePlane().svg.querySelectorAll('[data-of^=level-]')].every((one) => one.getAttribute('display') === 'none')")
    assert "--bare" in page.texts()["map-command"]
    page.run("at('levels').click()")
    page.go("weight=heyman")


def linked(page):
    """The pointer in one plane shows one arch in all of them, each at its coordinates."""
    page.go("weight=heyman")
    for plane, across, up, place in [(PLANES[0], 0.7, 0.9, "isPlace(shown.given)"), (PLANES[1], 0.5, 0.3, "!isPlace(shown.given)"), (PLANES[2], 0.6, 0.4, "isPlace(shown.given)")]:
        page.pointer("mouseMoved", *page.at_place(plane, across, up))
        page.settled()
        assert page.run(place), plane
        crosses = page.run("""shownPlanes().map((plane) => {
          const { halfOpening, phi, eta } = shown.found, degrees = 180 / Math.PI, frame = plane.frames.at(-1), [x, y] = plane.plane.split("-");
          const at = { "thickness-friction": [phi * degrees, eta], "opening-friction": [halfOpening * degrees, phi * degrees], "opening-thickness": [halfOpening * degrees, eta] }[plane.plane];
          const [, left, top] = /M(\S+) (\S+)H/.exec([...plane.crosses.children].at(-1)?.getAttribute("d") ?? "") ?? [];
          const [px, py] = frame.at(at);
          return Math.hypot(Number(left) + 9 - px, top - py);
        })""")
        assert all(off < 0.01 for off in crosses), (plane, crosses)
    assert "friction of this place was found in doubles" in page.texts()["proof"], page.texts()["proof"]
    page.click("take")
    page.settled()
    assert page.texts()["proof"].startswith("Proved here"), page.texts()


def pictures_saved(page):
    """The pictures are handed out as files of their own."""
    for id in ["save-map", "save-arch"]:
        text = page.run(f"""(async () => {{
          const kept = URL.createObjectURL, blobs = [];
          URL.createObjectURL = (blob) => {{ blobs.push(blob); return kept.call(URL, blob); }};
          at("{id}").click();
          URL.createObjectURL = kept;
          return blobs[0].text();
        }})()""")
        root = xml.etree.ElementTree.fromstring(text)
        assert root.tag == "{http://www.w3.org/2000/svg}svg" and float(root.get("width")) > 300, text[:300]


def axe(index):
    """What axe-core finds, on wide and narrow screens, light and dark; without axe-core this is skipped."""
    places = [os.environ.get("COUPLET_AXE", ""), "/usr/lib/node_modules/axe-core/axe.min.js", "/usr/local/lib/node_modules/axe-core/axe.min.js"]
    script = next((pathlib.Path(place) for place in places if place and pathlib.Path(place).is_file()), None)
    if script is None:
        print("skipped: the page before axe-core; npm install --global axe-core, or COUPLET_AXE=axe.min.js", file=sys.stderr)
        return
    for dark in (False, True):
        for options in ({}, {"size": (360, 740), "touch": True}):
            with Page(index, "half_opening=80deg&friction=0.35&weight=heyman&thickness=0.2", dark=dark, **options) as page:
                page.run(script.read_text(encoding="utf-8") + "; 0")
                found = page.run("axe.run().then(({ violations }) => violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html.slice(0, 120))}`))")
                assert not found, (dark, options, found)


def saves(page):
    """The file that the button hands out is checked once more on the page."""
    page.show(given("heyman", "80deg", "0.6", "0.2"))
    page.click("save")
    page.run("new Promise((done) => { const look = () => /accepted|refused|not/.test(at('saved').textContent) ? done() : setTimeout(look, 10); look(); })")
    assert page.texts()["saved"].startswith("arch.json: accepted  stands (an admissible symmetric state exists) half_opening 4/9 pi"), page.texts()["saved"]


def narrow(index):
    with Page(index, size=(360, 740), touch=True) as page:
        assert page.run("document.documentElement.scrollWidth") <= 360
        assert not overlapping(page), overlapping(page)
        assert not page.console, page.console


def test(index, couplet):
    text = pathlib.Path(index).read_text(encoding="utf-8")
    assert len(text) < 900_000, len(text)
    bare = re.sub(r'<script type="text/plain".*?</script>', "", text, flags=re.DOTALL)
    for loaded in ["src=", "href=", "@import", "fetch(", "unsafe-inline", "unsafe-eval' "]:
        assert loaded not in bare.replace("link.href =", "").replace("'wasm-unsafe-eval'", ""), loaded
    couplet = Couplet(couplet)
    with Page(index, "half_opening=80deg&friction=0.35&weight=heyman") as page:
        assert page.texts()["thickness"] == "0.06863521258", page.texts()
        states = numbers_of_states(page, couplet)
        more_friction(page, couplet)
        verdicts_on_thicknesses(page, couplet)
        measures(page, couplet)
        steps = drags(page, couplet)
        map_and_pointer(page)
        linked(page)
        zooms(page, couplet)
        asked = questions(page, couplet)
        commands(page, couplet)
        pictures_saved(page)
        reached = keyboard(page)
        motion(page)
        checked = files(page, couplet)
        saves(page)
        nonsense(page)
        assert not page.console, page.console
    less_motion(index)
    narrow(index)
    axe(index)
    print(f"page: {states} states, {asked} questions of the list, {len(THICK)} thicknesses, {len(MEASURED)} spans and {checked} files as the command has them; {steps} steps of a slider; {reached} places by Tab; {len(text)} bytes")


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
