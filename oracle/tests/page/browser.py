"""A headless Chromium, driven by chromedriver over WebDriver: plain HTTP and JSON, so nothing is needed but Python."""
import base64
import json
import re
import shutil
import struct
import subprocess
import urllib.request
import zlib

ELEMENT = "element-6066-11e4-a52e-4f735466cecf"
KEYS = {"Left": "\ue012", "Right": "\ue014", "Home": "\ue011", "End": "\ue010", "Tab": "\ue004", "Space": " "}


def missing():
    """What is not installed of what a browser takes; empty if all is here."""
    browser = shutil.which("chromium") or shutil.which("google-chrome")
    return ([] if browser else ["chromium"]) + ([] if shutil.which("chromedriver") else ["chromium-driver"])


class Browser:
    def __init__(self):
        self.driver = subprocess.Popen(["chromedriver", "--port=0"], stdout=subprocess.PIPE, text=True)
        started = (re.search(r"started successfully on port (\d+)", line) for line in self.driver.stdout)
        self.base = f"http://127.0.0.1:{next(port[1] for port in started if port)}/session"
        options = {"args": ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                            "--force-device-scale-factor=1", "--hide-scrollbars"]}
        capabilities = {"browserName": "chrome", "goog:chromeOptions": options, "goog:loggingPrefs": {"browser": "ALL"}}
        self.base += "/" + self.call("", {"capabilities": {"alwaysMatch": capabilities}})["sessionId"]

    def close(self):
        try:
            self.call("", method="DELETE")
        finally:
            self.driver.terminate()
            self.driver.wait()
            self.driver.stdout.close()

    def call(self, path, body=None, method="POST"):
        data = json.dumps(body or {}).encode() if method == "POST" else None
        request = urllib.request.Request(self.base + path, data, {"Content-Type": "application/json"}, method=method)
        try:
            with urllib.request.urlopen(request, timeout=60) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise RuntimeError(json.load(error)["value"]["message"]) from None

    def cdp(self, command, **parameters):
        """What WebDriver has no words for: dark colours, the size of a phone."""
        return self.call("/goog/cdp/execute", {"cmd": command, "params": parameters})

    def window(self, width, height, **features):
        """The size of the page in pixels; features: color_scheme="dark", reduced_motion="reduce"."""
        self.cdp("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
        media = [{"name": "prefers-" + name.replace("_", "-"), "value": value} for name, value in features.items()]
        self.cdp("Emulation.setEmulatedMedia", features=media)

    def open(self, path):
        self.call("/url", {"url": path.as_uri()})

    def run(self, script, *arguments):
        """The result of a JavaScript function's body; elements are given by find()."""
        return self.call("/execute/sync", {"script": script, "args": list(arguments)})

    def find(self, selector):
        return self.call("/element", {"using": "css selector", "value": selector})

    def click(self, selector):
        self.call(f"/element/{self.find(selector)[ELEMENT]}/click")

    def press(self, *keys):
        actions = [{"type": kind, "value": KEYS.get(key, key)} for key in keys for kind in ("keyDown", "keyUp")]
        self.call("/actions", {"actions": [{"type": "key", "id": "keyboard", "actions": actions}]})

    def pointer(self, *actions):
        """Each action: ("move", x, y), ("down",) or ("up",), in pixels of the window."""
        steps = []
        for kind, *where in actions:
            place = {"x": round(where[0]), "y": round(where[1]), "duration": 20} if where else {"button": 0}
            steps.append({"type": "pointer" + kind.capitalize(), **place})
        self.call("/actions", {"actions": [{"type": "pointer", "id": "mouse", "actions": steps}]})

    def complaints(self):
        """What the browser has logged: errors of scripts, what the page's policy forbids."""
        return [entry["message"] for entry in self.call("/se/log", {"type": "browser"})]

    def screenshot(self, x, y, width, height):
        """A part of the page as a PNG."""
        clip = {"x": x, "y": y, "width": width, "height": height, "scale": 1}
        return base64.b64decode(self.cdp("Page.captureScreenshot", clip=clip)["data"])


def colours_of(png):
    """The colours in a PNG, as a set of (red, green, blue). Eight bits a channel, not interlaced, as browsers write."""
    chunks, at = {}, 8
    while at < len(png):
        length, kind = struct.unpack(">I4s", png[at:at + 8])
        chunks[kind] = chunks.get(kind, b"") + png[at + 8:at + 8 + length]
        at += length + 12
    width, height, _, colour = struct.unpack(">IIBB", chunks[b"IHDR"][:10])
    size = {2: 3, 6: 4}[colour]
    raw, stride = zlib.decompress(chunks[b"IDAT"]), width * size
    colours, above = set(), bytearray(stride)
    for y in range(height):
        filtered = raw[y * (stride + 1)]
        row = bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for x in range(stride):
            left, corner = (row[x - size], above[x - size]) if x >= size else (0, 0)
            row[x] = (row[x] + predicted(filtered, left, above[x], corner)) & 255
        colours.update(tuple(row[x:x + 3]) for x in range(0, stride, size))
        above = row
    return colours


def predicted(kind, left, above, corner):
    if kind == 4:  # Paeth
        guess = left + above - corner
        return min((left, above, corner), key=lambda value: abs(guess - value))
    return (0, left, above, (left + above) // 2)[kind]
