"""A page in Chromium, without a display: what a user can do to it, what it looks like, what it asks the network for.

The browser is spoken to over a pipe in its own debugging protocol, so that Debian's chromium is all that is needed:
https://chromedevtools.github.io/devtools-protocol/."""

import base64
import contextlib
import fcntl
import json
import os
import select
import shutil
import subprocess
import tempfile
import time

# WebGL is computed by the processor; nothing is asked of the network but what the page asks.
FLAGS = ["--headless", "--no-sandbox", "--enable-unsafe-swiftshader", "--disable-quic", "--no-first-run",
         "--disable-background-networking", "--disable-component-update", "--disable-sync", "--hide-scrollbars",
         "--force-device-scale-factor=1", "--remote-debugging-pipe"]

# Of the protocol's answers; a page that takes longer has failed.
TIMEOUT_S = 60

# Name, and the number that old browsers gave it.
KEYS = {"ArrowLeft": 37, "ArrowRight": 39, " ": 32}


def installed():
    """The program, or None."""
    return shutil.which("chromium") or shutil.which("chromium-browser")


class Failure(Exception):
    """The page, or the browser, has done something wrong."""


class Pipe:
    """Messages of the protocol: JSON that ends with a zero byte, to the browser's file 3 and from its file 4."""

    def __init__(self, command, log):
        # Above the two numbers that the child's ends get, so that neither is overwritten.
        from_us, self._write = (fcntl.fcntl(end, fcntl.F_DUPFD_CLOEXEC, 10) for end in os.pipe())
        self._read, to_us = (fcntl.fcntl(end, fcntl.F_DUPFD_CLOEXEC, 10) for end in os.pipe())

        def connect():
            os.dup2(from_us, 3)
            os.dup2(to_us, 4)

        self.process = subprocess.Popen(command, preexec_fn=connect, close_fds=False, stdin=subprocess.DEVNULL,
                                        stdout=log, stderr=log)
        os.close(from_us)
        os.close(to_us)
        self._unread = b""

    def send(self, message):
        data = json.dumps(message).encode() + b"\0"
        while data:
            data = data[os.write(self._write, data):]

    def receive(self, until):
        """The next message; None after the time `until`."""
        while b"\0" not in self._unread:
            ready, _, _ = select.select([self._read], [], [], max(0, until - time.monotonic()))
            if not ready:
                return None
            data = os.read(self._read, 1 << 20)
            if not data:
                raise Failure("the browser has ended")
            self._unread += data
        message, self._unread = self._unread.split(b"\0", 1)
        return json.loads(message)

    def end(self):
        """Of the browser, at the latest now."""
        try:
            self.process.wait(5)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        os.close(self._write)
        os.close(self._read)


class Page:
    """The one page of a browser of its own."""

    def __init__(self, pipe):
        self._pipe = pipe
        self._calls = 0
        self._session = None
        self._events = []
        target = self._call("Target.createTarget", url="about:blank")["targetId"]
        self._session = self._call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self._call(domain + ".enable")

    def _call(self, method, **arguments):
        self._calls += 1
        message = {"id": self._calls, "method": method, "params": arguments}
        if self._session:
            message["sessionId"] = self._session
        self._pipe.send(message)
        until = time.monotonic() + TIMEOUT_S
        while True:
            answer = self._pipe.receive(until)
            if answer is None:
                raise Failure(f"no answer to {method} in {TIMEOUT_S} s")
            if answer.get("id") == self._calls:
                break
            self._events.append(answer)
        if "error" in answer:
            raise Failure(f"{method}: {answer['error']['message']}")
        return answer["result"]

    def close(self):
        """End the browser."""
        self._session = None
        self._call("Browser.close")

    def _events_of(self, method):
        return [event["params"] for event in self._events if event.get("method") == method]

    def size(self, width, height):
        """Of the window, in CSS pixels."""
        self._call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)

    def open(self, path, fragment=""):
        """Load a file, and wait until it is there."""
        self._events.clear()
        answer = self._call("Page.navigate", url=path.resolve().as_uri() + fragment)
        if "errorText" in answer:
            raise Failure(f"{path}: {answer['errorText']}")
        self.wait_for("document.readyState === 'complete' && location.href !== 'about:blank'")

    def value(self, expression):
        """Of a JavaScript expression, once it is no promise any more."""
        answer = self._call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            details = answer["exceptionDetails"]
            raise Failure(f"{expression[:100]}: {details.get('exception', {}).get('description', details['text'])}")
        return answer["result"].get("value")

    def wait_for(self, expression, seconds=20):
        until = time.monotonic() + seconds
        while not self.value(expression):
            if time.monotonic() > until:
                raise Failure(f"not after {seconds} s: {expression}")
            time.sleep(0.02)

    def press(self, key):
        code = "Space" if key == " " else key
        for kind in ("keyDown", "keyUp"):
            self._call("Input.dispatchKeyEvent", type=kind, key=key, code=code, windowsVirtualKeyCode=KEYS[key])

    def click(self, x, y):
        for kind in ("mousePressed", "mouseReleased"):
            self._call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)

    def drag(self, start, end):
        self._call("Input.dispatchMouseEvent", type="mousePressed", x=start[0], y=start[1], button="left", clickCount=1)
        for tenth in range(1, 11):
            x, y = (a + (b - a) * tenth / 10 for a, b in zip(start, end))
            self._call("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y, button="left", buttons=1)
        self._call("Input.dispatchMouseEvent", type="mouseReleased", x=end[0], y=end[1], button="left", clickCount=1)

    def turn_wheel(self, x, y, pixels):
        self._call("Input.dispatchMouseEvent", type="mouseWheel", x=x, y=y, deltaX=0, deltaY=pixels)

    def picture(self, box=None, **kind):
        """A PNG of the window, or of its box (x, y, width, height); or format="webp", quality=0..100."""
        # Two frames, so that what was asked for last has been drawn.
        self.value("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
        clip = {}
        if box:
            clip = {"clip": dict(zip(("x", "y", "width", "height"), box), scale=1)}
        return base64.b64decode(self._call("Page.captureScreenshot", **{"format": "png", **kind, **clip})["data"])

    def complaints(self):
        """Errors and warnings of the console, and exceptions that nobody caught, since the page was opened."""
        said = [details["exceptionDetails"]["text"] for details in self._events_of("Runtime.exceptionThrown")]
        said += [str([part.get("value") for part in call["args"]]) for call in
                 self._events_of("Runtime.consoleAPICalled") if call["type"] in ("error", "warning", "assert")]
        said += [event["entry"]["text"] for event in self._events_of("Log.entryAdded")
                 if event["entry"]["level"] == "error"]
        return said

    def requests(self):
        """What was asked for since the page was opened, pages themselves and what stands within them aside."""
        return [event["request"]["url"] for event in self._events_of("Network.requestWillBeSent")
                if event.get("type") != "Document" and not event["request"]["url"].startswith("data:")]


@contextlib.contextmanager
def page(width=800, height=600, flags=()):
    """A fresh browser, started with some more `flags`, with one empty page."""
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        with open(os.path.join(profile, "log"), "w+", encoding="utf-8", errors="replace") as log:
            pipe = Pipe([installed(), *FLAGS, *flags, f"--user-data-dir={profile}/data"], log)
            try:
                shown = Page(pipe)
                shown.size(width, height)
                yield shown
                shown.close()
            finally:
                pipe.end()
