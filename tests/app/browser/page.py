"""Opens a page in headless Chromium and drives it, by the browser's own protocol over two pipes.

Needs Python's standard library and chromium only. Used by the scripts beside it.
"""
import base64
import json
import os
import select
import subprocess
import tempfile
import time

FLAGS = ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--use-gl=angle", "--use-angle=swiftshader",
         "--enable-unsafe-swiftshader", "--hide-scrollbars", "--remote-debugging-pipe", "--no-first-run",
         "--disable-background-networking", "--disable-component-update", "--disable-sync"]


# What Chromium says of tests that read the picture.
PIXELS_READ = "GPU stall due to ReadPixels"


class Page:
    """A page and all that it has said: `console` (errors), `requests` (addresses asked for)."""

    def __init__(self, chromium, width=1280, height=900, flags=()):
        self.console, self.requests, self.number = [], [], 0
        self.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        to_browser, self.to = os.pipe()
        self.come, from_browser = os.pipe()

        def at_three_and_four():
            os.dup2(to_browser, 60), os.dup2(from_browser, 61)
            os.dup2(60, 3), os.dup2(61, 4)
            os.closerange(5, 62)

        self.browser = subprocess.Popen(
            [chromium, *FLAGS, *flags, "--user-data-dir=" + self.profile.name, "about:blank"],
            preexec_fn=at_three_and_four, close_fds=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_browser), os.close(from_browser)
        self.rest, self.session = b"", None
        target = next(t for t in self.call("Target.getTargets")["targetInfos"] if t["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=target["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(domain + ".enable")
        self.size(width, height)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.browser.terminate()
        try:
            self.browser.wait(10)
        except subprocess.TimeoutExpired:
            self.browser.kill()
            self.browser.wait()
        for end in (self.to, self.come):
            os.close(end)
        self.profile.cleanup()

    def size(self, width, height, touch=False):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=touch)
        self.call("Emulation.setTouchEmulationEnabled", enabled=touch)

    def call(self, method, patience=120, **parameters):
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.to, json.dumps(message).encode() + b"\0")
        end = time.monotonic() + patience
        while True:
            answer = self.next_message(end)
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise RuntimeError(method + ": " + str(answer["error"]))
                return answer["result"]
            self.note(answer)

    def next_message(self, end):
        while b"\0" not in self.rest:
            if not select.select([self.come], [], [], max(0, end - time.monotonic()))[0]:
                raise TimeoutError("the browser does not answer")
            more = os.read(self.come, 1 << 20)
            if not more:
                raise RuntimeError("the browser has ended")
            self.rest += more
        message, self.rest = self.rest.split(b"\0", 1)
        return json.loads(message)

    def note(self, event):
        said = event.get("params", {})
        if event.get("method") == "Runtime.exceptionThrown":
            self.console.append(str(said["exceptionDetails"].get("exception", said["exceptionDetails"]).get("description")))
        elif event.get("method") == "Log.entryAdded" and said["entry"]["level"] in ("error", "warning"):
            if PIXELS_READ not in said["entry"]["text"]:
                self.console.append(said["entry"]["text"])
        elif event.get("method") == "Runtime.consoleAPICalled" and said["type"] in ("error", "warning"):
            self.console.append(" ".join(str(part.get("value")) for part in said["args"]))
        elif event.get("method") == "Network.requestWillBeSent":
            self.requests.append(said["request"]["url"])

    def open(self, file):
        self.call("Page.navigate", url="file://" + os.path.abspath(file))

    def run(self, script):
        """Value of a JavaScript expression; a promise is waited for."""
        answer = self.call("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(script + ": " + str(answer["exceptionDetails"]["exception"].get("description")))
        return answer["result"].get("value")

    def wait(self, condition, patience=60):
        end = time.monotonic() + patience
        while not self.run(condition):
            if time.monotonic() > end:
                raise TimeoutError("never true: " + condition)
            time.sleep(0.05)

    def picture(self, file=None):
        """Bytes of a PNG of what the window shows."""
        png = base64.b64decode(self.call("Page.captureScreenshot", format="png")["data"])
        if file:
            with open(file, "wb") as stream:
                stream.write(png)
        return png

    def mouse(self, kind, x, y, button="none", buttons=0, **more):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button=button, buttons=buttons, clickCount=1, **more)

    def drag(self, x, y, by_x, by_y, button="left", bit=1):
        self.mouse("mousePressed", x, y, button, bit)
        for share in (0.5, 1.0):
            self.mouse("mouseMoved", x + share * by_x, y + share * by_y, button, bit)
        self.mouse("mouseReleased", x + by_x, y + by_y, button)

    def key(self, key):
        for kind in ("keyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key=key)

    def touch(self, kind, *points):
        self.call("Input.dispatchTouchEvent", type=kind, touchPoints=[{"x": x, "y": y} for x, y in points])
