"""A headless Chromium, driven by its DevTools protocol over a pipe, and a static server for what it is shown."""
import base64
import functools
import http.server
import json
import os
import select
import shutil
import subprocess
import tempfile
import threading
import time

from command import LIMIT_S, check

PROGRAM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
FLAGS = ("--headless=new", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking", "--disable-sync",
         "--disable-component-update", "--disable-dev-shm-usage", "--hide-scrollbars", "--remote-debugging-pipe")


# What an expression's evaluation fails with when its page is left.
LEFT = ("Inspected target navigated or closed", "Execution context was destroyed.", "Cannot find default execution context")


class Server:
    """Serves a folder, as python3 -m http.server does; `asked` are the paths that were asked for."""

    def __init__(self, folder):
        asked, self.paused = [], False
        self.asked = asked

        class Handler(http.server.SimpleHTTPRequestHandler):
            def handle_one_request(this):
                if self.paused:
                    this.close_connection = True
                    return
                super().handle_one_request()

            def log_message(self, *_):
                asked.append(self.path)

        self.http = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Handler, directory=folder))
        self.url = f"http://127.0.0.1:{self.http.server_port}/"
        threading.Thread(target=self.http.serve_forever, daemon=True).start()

    def pause(self):
        """From now on connections are closed without an answer."""
        self.paused = True

    def resume(self):
        self.paused = False

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.http.shutdown()
        self.http.server_close()


class Browser:
    """Messages are JSON with a zero byte at the end: to descriptor 3 of the browser, from its descriptor 4."""

    def __init__(self):
        self.folder = tempfile.mkdtemp()
        from_us, to_browser = os.pipe()
        from_browser, to_us = os.pipe()
        plug = "exec 3<&%d 4>&%d; exec \"$@\"" % (from_us, to_us)
        self.process = subprocess.Popen(["bash", "-c", plug, "bash", PROGRAM, *FLAGS, f"--user-data-dir={self.folder}"],
                                        pass_fds=(from_us, to_us), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                        stderr=subprocess.DEVNULL, start_new_session=True)
        os.close(from_us)
        os.close(to_us)
        self.to, self.source, self.rest = to_browser, from_browser, b""
        self.number, self.answers, self.events = 0, {}, []

    def __enter__(self):
        return self

    def __exit__(self, *_):
        os.killpg(self.process.pid, 9)
        self.process.wait()
        os.close(self.to)
        os.close(self.source)
        shutil.rmtree(self.folder, ignore_errors=True)

    def listen(self):
        """Takes what has come; waits for it."""
        check(select.select([self.source], [], [], LIMIT_S)[0], "the browser says nothing")
        got = os.read(self.source, 1 << 20)
        check(got, "the browser has ended")
        *messages, self.rest = (self.rest + got).split(b"\0")
        for message in map(json.loads, messages):
            if "id" in message:
                self.answers[message["id"]] = message
            else:
                self.events.append(message)

    def ask(self, method, session=None, **params):
        """The answer, with "result" or "error"."""
        self.number += 1
        number, message = self.number, {"id": self.number, "method": method, "params": params}
        if session:
            message["sessionId"] = session
        data = json.dumps(message).encode() + b"\0"
        while data:
            data = data[os.write(self.to, data):]
        while number not in self.answers:
            self.listen()
        return self.answers.pop(number)

    def call(self, method, session=None, **params):
        answer = self.ask(method, session, **params)
        check("error" not in answer, f"{method}: {answer.get('error')}")
        return answer["result"]

    def page(self, url, width, height, phone=False):
        return Page(self, url, width, height, phone)


class Page:
    def __init__(self, browser, url, width, height, phone):
        self.browser = browser
        self.target = browser.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = browser.call("Target.attachToTarget", targetId=self.target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(domain + ".enable")
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=2 if phone else 1,
                  mobile=phone)
        if phone:
            self.call("Emulation.setTouchEmulationEnabled", enabled=True)
        self.go(url)

    def go(self, url):
        self.call("Page.navigate", url=url)
        self.wait(f"location.href === {json.dumps(url)} && document.readyState === 'complete'", f"{url} is there")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.browser.call("Target.closeTarget", targetId=self.target)

    def call(self, method, **params):
        return self.browser.call(method, self.session, **params)

    def run(self, expression, leaves=False):
        """What the expression is, in the page; None if the page is left meanwhile and may be."""
        answer = self.browser.ask("Runtime.evaluate", self.session, expression=expression, returnByValue=True, awaitPromise=True)
        if leaves and answer.get("error", {}).get("message") in LEFT:
            return None
        check("error" not in answer, f"{expression}: {answer.get('error')}")
        check("exceptionDetails" not in answer["result"], f"{expression}: {answer['result'].get('exceptionDetails')}")
        return answer["result"]["result"].get("value")

    def wait(self, expression, what):
        """Waits until the expression is true, also in a page that replaces this one."""
        end = time.monotonic() + LIMIT_S
        while not self.run(expression, leaves=True):
            check(time.monotonic() < end, f"{what} did not happen: {self.complaints()}")
            time.sleep(0.02)

    def key(self, key, held=False, shift=False, control=False, commands=()):
        """Types a key, or presses it down; `commands`: what an editor does with it, as "undo"."""
        one = {"key": key, "modifiers": 8 * shift + 2 * control, "windowsVirtualKeyCode": KEYS.get(key, ord(key[0].upper())),
               "commands": list(commands)}
        if len(key) == 1 and not control:
            one["text"] = key
        self.call("Input.dispatchKeyEvent", type="keyDown", **one)
        if not held:
            self.release(key)

    def type(self, text):
        for letter in text:
            self.key("Enter" if letter == "\n" else letter)

    def reload(self):
        self.run("window.old = true")
        self.call("Page.reload")
        self.wait("!window.old && document.readyState === 'complete'", "the page again")

    def release(self, key):
        self.call("Input.dispatchKeyEvent", type="keyUp", key=key)

    def mouse(self, kind, x, y, down=True):
        self.call("Input.dispatchMouseEvent", type="mouse" + kind, x=x, y=y, button="left" if kind != "Moved" or down else "none",
                  buttons=int(down and kind != "Released"), clickCount=int(kind != "Moved"))

    def complaints(self):
        """What was written to the console, thrown, or refused."""
        said = []
        for event in self.browser.events:
            if event.get("sessionId") == self.session and event["method"] in (
                    "Runtime.consoleAPICalled", "Runtime.exceptionThrown", "Log.entryAdded", "Network.loadingFailed"):
                said.append(json.dumps(event["params"])[:600])
        return said

    def requests(self):
        return [event["params"]["request"]["url"] for event in self.browser.events
                if event.get("sessionId") == self.session and event["method"] == "Network.requestWillBeSent"]

    def screenshot(self, path, whole=False):
        data = self.call("Page.captureScreenshot", format="png", captureBeyondViewport=whole)["data"]
        with open(path, "wb") as file:
            file.write(base64.b64decode(data))


KEYS = {"Tab": 9, "Enter": 13, "ArrowLeft": 37, "ArrowUp": 38, "ArrowRight": 39, "ArrowDown": 40, "PageUp": 33, "PageDown": 34,
        "Home": 36, "Escape": 27}
