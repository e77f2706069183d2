"""Chromium without a window, driven through a pipe by its own protocol: real pointers and keys, and what the console says."""

import base64
import fcntl
import json
import os
import subprocess
import tempfile


class Browser:
    """One page in one browser; a context manager."""

    def __init__(self, size=(1280, 900), dark=False, touch=False):
        self.size, self.dark, self.touch = size, dark, touch

    def __enter__(self):
        self.folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        here, to_browser = os.pipe()
        from_browser, there = os.pipe()
        quiet = ["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--hide-scrollbars"]
        line = ["chromium", *quiet, "--remote-debugging-pipe", f"--user-data-dir={self.folder.name}", "about:blank"]

        # The browser reads from its file 3 and writes to its file 4; above 4 neither is written over.
        here, there = [self.above(file) for file in (here, there)]

        def files():
            os.dup2(here, 3)
            os.dup2(there, 4)

        self.process = subprocess.Popen(line, preexec_fn=files, pass_fds=(3, 4, here, there), stderr=subprocess.DEVNULL)
        os.close(here)
        os.close(there)
        self.to, self.of = to_browser, from_browser
        self.count, self.rest, self.console, self.session = 0, b"", [], None
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log"):
            self.call(f"{domain}.enable")
        self.call("Page.setDownloadBehavior", behavior="deny")
        self.view(*self.size)
        scheme = [{"name": "prefers-color-scheme", "value": "dark" if self.dark else "light"}]
        self.call("Emulation.setEmulatedMedia", features=scheme)
        return self

    @staticmethod
    def above(file):
        moved = fcntl.fcntl(file, fcntl.F_DUPFD, 10)
        os.close(file)
        return moved

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait()
        os.close(self.to)
        os.close(self.of)
        self.folder.cleanup()

    def message(self):
        while b"\0" not in self.rest:
            more = os.read(self.of, 1 << 20)
            if not more:
                raise EOFError("the browser has ended")
            self.rest += more
        text, self.rest = self.rest.split(b"\0", 1)
        return json.loads(text)

    def call(self, method, **parameters):
        """The result of a method of the protocol; what the page says in the meantime is kept."""
        self.count += 1
        sent = {"id": self.count, "method": method, "params": parameters}
        if self.session:
            sent["sessionId"] = self.session
        # A pipe may take a long message in pieces.
        data = json.dumps(sent).encode() + b"\0"
        while data:
            data = data[os.write(self.to, data) :]
        while True:
            got = self.message()
            if got.get("id") == self.count:
                if "error" in got:
                    raise RuntimeError(f"{method}: {got['error']}")
                return got["result"]
            self.keep(got)

    def keep(self, event):
        said = event.get("params", {})
        match event.get("method"):
            case "Runtime.exceptionThrown":
                self.console.append(str(said["exceptionDetails"]))
            case "Runtime.consoleAPICalled" if said["type"] in ("error", "warning", "assert"):
                self.console.append(str(said["args"]))
            case "Log.entryAdded" if said["entry"]["level"] in ("error", "warning"):
                self.console.append(str(said["entry"]))

    def open(self, address):
        self.call("Page.navigate", url="about:blank")
        self.call("Page.navigate", url=address)
        self.run("new Promise((done) => document.readyState === 'complete' ? done() : addEventListener('load', done))")

    def run(self, code):
        """What a script of the page comes to, at the latest after a while."""
        got = self.call("Runtime.evaluate", expression=code, awaitPromise=True, returnByValue=True, userGesture=True)
        if "exceptionDetails" in got:
            raise RuntimeError(str(got["exceptionDetails"]))
        return got["result"].get("value")

    def view(self, width, height):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=2 if self.touch else 1, mobile=self.touch)

    def pointer(self, kind, x, y, down=False):
        button = {"button": "left", "buttons": 1 if down else 0, "clickCount": 1} if down or kind == "mouseReleased" else {}
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **button)

    def place(self, id):
        """Left, top, width and height of an element, once it is in sight."""
        return self.run(f"(() => {{ const e = document.getElementById('{id}'); e.scrollIntoView({{block: 'center'}}); const b = e.getBoundingClientRect(); return [b.x, b.y, b.width, b.height]; }})()")

    def click(self, id):
        x, y, width, height = self.place(id)
        middle = (x + width / 2, y + height / 2)
        self.pointer("mousePressed", *middle, down=True)
        self.pointer("mouseReleased", *middle)

    def key(self, key, code=None, shift=False):
        numbers = {"Tab": 9, "Enter": 13, " ": 32, "ArrowLeft": 37, "ArrowUp": 38, "ArrowRight": 39, "ArrowDown": 40, "Home": 36, "End": 35}
        text = {"text": "\r"} if key == "Enter" else {"text": key} if len(key) == 1 else {}
        which = {"key": key, "code": code or key, "windowsVirtualKeyCode": numbers.get(key, ord(key[0])), "modifiers": 8 if shift else 0}
        self.call("Input.dispatchKeyEvent", type="keyDown", **which, **text)
        self.call("Input.dispatchKeyEvent", type="keyUp", **which)

    def picture(self, path, whole=False):
        data = self.call("Page.captureScreenshot", captureBeyondViewport=whole)["data"]
        with open(path, "wb") as file:
            file.write(base64.b64decode(data))
