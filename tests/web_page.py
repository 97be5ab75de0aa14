"""The page of `make web` in headless Chromium, for tests/slow/web*. Screenshots lie in build/web-shots."""
import base64
import json
import os
import shutil
import subprocess
import time

from browser import PROGRAM, Browser, Server
from command import LIMIT_S, Skip, check, fine, run_cases, same

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), ".."))
BUILD = os.path.join(ROOT, os.environ.get("BUILD", "build"))
GOLDEN = os.path.join(ROOT, "tests/golden/web.crc")
SCENES = os.path.join(ROOT, "scenes")
SMALL = "160x120"
SHORT = "camera eye 0 0 4\nmaterial red colour 0.8 0.1 0.1\nsphere centre 0 0 0 radius 1 material red\nlight at 4 6 4\n"

# Pixels of the canvas as RGB565 again, little-endian, in base64.
PIXELS = """(() => { const c = document.getElementById('canvas'), d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;
let s = ''; for (let i = 0; i < d.length; i += 4) { const p = d[i] >> 3 << 11 | d[i + 1] >> 2 << 5 | d[i + 2] >> 3;
s += String.fromCharCode(p & 255, p >> 8); } return btoa(s); })()"""


def pins():
    with open(GOLDEN, encoding="utf-8") as file:
        lines = [line.split() for line in file if not line.startswith("#")]
    return {(name, key, size): crc for name, key, size, crc in lines}


def native(name, size, *options):
    return fine(os.path.join(ROOT, "scenes", name + ".tia"), "-n", "1", "--checksum", "-d", "none", "-s", size, *options).split()[1]


def text_of(name):
    with open(os.path.join(SCENES, name), encoding="utf-8") as file:
        return file.read()


def editor(page):
    return page.run("document.getElementById('text').value")


def missing_packages():
    """The Debian packages that are missing for tests of the page."""
    return [name for name, there in (("chromium", PROGRAM), ("clang", shutil.which("clang")), ("lld", shutil.which("wasm-ld")),
            ("nodejs", shutil.which("node")), ("wasi-libc", os.path.exists("/usr/lib/wasm32-wasi/libc.a"))) if not there]


def run_page_cases(cases, anyway=()):
    """Builds the page and runs the cases; without the packages for that, only those that run anyway."""
    missing = missing_packages()
    if missing:
        def page():
            raise Skip(f"no {', no '.join(missing)} (apt-get install {' '.join(missing)})")
        return run_cases([*anyway, page])
    subprocess.run(["make", "-s", "web"], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    return run_cases([*anyway, *cases])


class Shown:
    """The page, in a browser of its own; what it complains of is an error."""

    def __init__(self, width=1280, height=900, phone=False, query="scene=thesis", folder=os.path.join(BUILD, "web")):
        self.browser, self.server = Browser(), Server(folder)
        self.page = self.browser.page(self.server.url + "?" + query, width, height, phone)
        self.run, self.wait, self.key = self.page.run, self.page.wait, self.page.key

    def __enter__(self):
        return self

    def __exit__(self, kind, *_):
        complaints, asked = self.page.complaints(), self.page.requests()
        self.browser.__exit__()
        self.server.__exit__()
        if kind is None:
            same(complaints, [], "what the page complains of")
            check(len(asked) > 5 and all(url.startswith((self.server.url, "data:")) for url in asked), f"it asked for {asked}")

    def wait_for(self, condition, what):
        end = time.monotonic() + LIMIT_S
        while not condition():
            check(time.monotonic() < end, f"{what} did not happen")
            time.sleep(0.02)

    def text(self, name):
        return self.run(f"document.getElementById('{name}').textContent")

    def complete(self, crc=None):
        """Waits for a complete picture, or that one; says its checksum."""
        want = f"=== '{crc}'" if crc else "!== '\u2026'"
        self.wait(f"document.getElementById('crc').textContent {want} && document.getElementById('crc').textContent[0] !== '-'",
                  f"the picture {crc}, but {self.text('crc')} {self.text('error-text')} {self.text('verdict')}")
        return self.text("crc")

    def changed(self, crc):
        self.wait(f"!['{crc}', '\u2026'].includes(document.getElementById('crc').textContent)", f"another picture than {crc}")
        return self.text("crc")

    def pixels(self):
        return base64.b64decode(self.run(PIXELS))

    def choose(self, name, value):
        self.run(f"(() => {{ const e = document.getElementById('{name}'); e.value = '{value}';"
                 " e.dispatchEvent(new Event('change')); })()")
        if name == "scene":
            self.wait(f"document.getElementById('name').textContent === '{value}'", f"the text of {value}")
        same(self.run(f"document.getElementById('{name}').value"), value, f"the choice of {name}")

    def write(self, text):
        self.run(f"(() => {{ const e = document.getElementById('text'); e.value = {json.dumps(text)};"
                 " e.dispatchEvent(new Event('input')); })()")

    def box(self, name):
        return self.run(f"(({{x, y, width, height}}) => [x, y, width, height])(document.getElementById('{name}').getBoundingClientRect())")

    def shot(self, name, whole=False):
        folder = os.path.join(BUILD, "web-shots")
        os.makedirs(folder, exist_ok=True)
        self.page.screenshot(os.path.join(folder, name + ".png"), whole)
