#!/usr/bin/env python3
"""Puts the page together: the map that `couplet map` writes, the checker in WebAssembly, and what joins them.

    page/assemble.py MAP.html CHECKER.wasm INDEX.html
"""

import base64
import gzip
import hashlib
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).parent


def part(name):
    return (HERE / name).read_text(encoding="utf-8")


def replaced(text, old, new):
    """The text with the one place of `old` replaced; the map has changed if there is not exactly one."""
    if text.count(old) != 1:
        sys.exit(f"page/assemble.py: the map has {text.count(old)} places '{old[:60]}', not one")
    return text.replace(old, new)


def inside(text, tag):
    found = re.findall(f"<{tag}>(.*?)</{tag}>", text, re.DOTALL)
    if len(found) != 1:
        sys.exit(f"page/assemble.py: the map has {len(found)} elements '{tag}', not one")
    return found[0]


def digest(text):
    return base64.b64encode(hashlib.sha256(text.encode("utf-8")).digest()).decode("ascii")


# In the order in which they are read.
SCRIPTS = ["engine.js", "numbers.js", "motion.js", "controls.js", "files.js", "proof.js"]


def page(text, wasm):
    style, script = inside(text, "style"), inside(text, "script")
    new_style, new_script = style + part("extra.css"), script + "".join(map(part, SCRIPTS))
    policy = re.search(r'<meta http-equiv="Content-Security-Policy" content="([^"]*)">', text)[1]
    new_policy = (
        f"default-src 'none'; style-src 'sha256-{digest(new_style)}'; "
        f"script-src 'sha256-{digest(new_script)}' 'wasm-unsafe-eval'; worker-src blob:; base-uri 'none'; form-action 'none'"
    )
    text = replaced(text, policy, new_policy)
    text = replaced(text, f"<style>{style}</style>", f"<style>{new_style}</style>")
    # The same bytes whenever the checker is the same.
    packed = gzip.compress(wasm, 9, mtime=0)
    data = f'<script type="text/plain" id="wasm">{base64.b64encode(packed).decode("ascii")}</script>\n'
    worker = f'<script type="text/plain" id="worker">{part("worker.js")}</script>\n'
    text = replaced(text, f"<script>{script}</script>", f"{data}{worker}<script>{new_script}</script>")
    # What is proved here is said in one place, before the numbers.
    warning = re.search(r'<p class="note warning" id="with-command">.*?</p>', text, re.DOTALL)[0]
    command = re.search(r'<code id="command"></code>', warning)[0]
    text = replaced(text, warning, f'<p class="note" id="with-command">More digits, from a shell:<br>{command}</p>\n' + part("certify.html"))
    # What is asked stands before what is found.
    form = re.search(r'<form id="ask">.*?</form>\n', text, re.DOTALL)[0]
    text = replaced(text, form, "")
    text = replaced(text, '<p id="summary" role="status"></p>', form + '<p id="summary" role="status"></p>')
    text = replaced(text, '<p id="summary" role="status"></p>', '<p id="summary" role="status"></p>\n' + part("extra.html"))
    text = replaced(text, "<h2>The least thickness of an arch</h2>", "<h2>An arch to play with</h2>\n" + part("controls.html"))
    numbers = re.search(r"<dl>.*?</dl>", text, re.DOTALL)[0]
    text = replaced(text, numbers, part("motion.html") + part("numbers.html"))
    legend = re.search(r'<p class="note">Dots: hinges.*?</p>', text)[0]
    text = replaced(text, legend, part("legend.html"))
    field = '<label>half opening <input type="text" id="ask-half-opening" value="80deg"></label>\n'
    text = replaced(text, field, part("fields.html"))
    field = '<label>thickness <input type="text" id="ask-thickness" placeholder="none"></label>'
    text = replaced(text, "<button>show</button>", f"{field} <button id=\"show-arch\">show</button>")
    text = replaced(text, "or an angle (31deg).</p>", "or an angle (31deg); lengths as 10m, 60cm or 33ft, at the circle that is named; a thickness beside them as 60cm or 0.1r.</p>")
    made = re.search(r"made this page: <code>.*?</code>", text)[0]
    text = replaced(text, made, "made this page: <code>make page</code>")
    # The check comes after the map, as a part of its own.
    title = re.search(r'<section class="wide"[^>]*>\n<h2>Landmarks', text)[0]
    return replaced(text, title, part("check.html") + title)


def main():
    source, wasm, out = map(pathlib.Path, sys.argv[1:])
    out.write_text(page(source.read_text(encoding="utf-8"), wasm.read_bytes()), encoding="utf-8")


if __name__ == "__main__":
    main()
