#!/usr/bin/env python3
"""latency.py [--host] [--keys N] [--pause SECONDS] [--enough SECONDS] [--limit SECONDS] [NAME]...

Measures the time from a key to its picture, first coarse and then complete, at 1280x800, for all scenes of the gallery or
for those named. Prints a table in Markdown.

    make bench-latency                      # all of them, in a guest
    make bench-latency SCENES='chess glass'
    bench/latency.py --host                 # without a guest

In the guest, QEMU's PS/2 keyboard types h and l in turn, which turn the scene by 5 degrees and back, so that the whole
picture changes. In the built-in scene, which has no such keys, it types the arrows that move the light. The time is the one
that --stats reports: from the kernel's time stamp of the key to the end of the call that shows the picture. A guest on
emulated processors is far slower than this machine; --kvm uses this machine's processors, if its KVM can boot a guest. With
--host, a pseudo-terminal types, and the pictures go to a display that shows nothing. A key's time is then the time at which
it was read, up to 20 ms late.

First, N keys (default 10) are typed about --pause SECONDS (default 1) apart. Then N more are typed, each after the complete
picture of the one before. After --enough SECONDS (default 30) for a scene no more are typed, except that the first complete
picture may take up to --limit SECONDS (default 3600). A dash stands for a picture that did not come.
"""
import argparse
import json
import os
import pty
import random
import subprocess
import sys
import tempfile
import time

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), ".."))
sys.path.insert(0, os.path.join(ROOT, "tests/vm"))
import image
from guest import Guest
from session import Session
from setups import drm

SIZE = 1280, 800
BUILT_IN = "built in"
NAMES = (BUILT_IN, "porch", "shadow-volume", "shadow-mapping", "marbles", "orrery", "castle", "castle-openness", "vase", "chess",
         "flake", "glass", "caustic", "window", "cornell")
OPTIONS = {"castle-openness": ["--integrator", "ao=6", "--spp", "64"]}
PLAY = ("orrery", "marbles", "shadow-mapping", "shadow-volume")
ARGUMENTS = ["--stats", "--checksum"]   # a line for each complete picture
BYTES = {"left": b"\x1b[D", "right": b"\x1b[C", "esc": b"\x1b"}


class InGuest:
    def __init__(self, guest, setup):
        self.session = Session(guest, setup, True)
        self.tap, self.drawn = guest.tap, self.session.frames_drawn

    def start(self, scene):
        self.session.run(*self.session.display, *ARGUMENTS, *scene, wrap="env -u TIA_SIMD ")
        self.session.wait_grabbed(1)

    def end(self):
        self.tap("esc")
        self.session.ends(0)
        return self.session.file("err")


class OnHost:
    def start(self, scene):
        self.keyboard, terminal = pty.openpty()
        self.out, self.err = tempfile.TemporaryFile(), tempfile.TemporaryFile()
        scene = [os.path.join(ROOT, argument.lstrip("/")) if argument.startswith("/") else argument for argument in scene]
        self.process = subprocess.Popen([os.path.join(os.environ.get("BUILD", "build"), "tia"), "-d", "none", "-i", "tty",
                                         "-s", "%dx%d" % SIZE, *ARGUMENTS, *scene], stdin=terminal, stdout=self.out,
                                        stderr=self.err, start_new_session=True)
        os.close(terminal)

    def tap(self, key):
        os.write(self.keyboard, BYTES.get(key) or key.encode())

    def drawn(self):
        return os.pread(self.out.fileno(), 1 << 24, 0).count(b"\n")

    def end(self):
        self.tap("esc")
        self.process.wait()
        os.close(self.keyboard)
        return os.pread(self.err.fileno(), 1 << 16, 0).decode()


def type_keys(where, keys, plays, options):
    """Types all keys. Returns the number of complete pictures in the second part."""
    for i in range(options.keys):
        where.tap(keys[i % 2])
        time.sleep(options.pause + random.random() / 5)  # random, so as not to be in phase with any timer
    begin, complete = time.monotonic(), 0
    enough, end = begin + options.enough, begin + options.limit
    while complete < options.keys and time.monotonic() < (enough if complete else end):
        want = where.drawn() + 1 + plays        # a scene that plays first shows the picture that was begun before the key
        where.tap(keys[complete % 2])
        while where.drawn() < want and time.monotonic() < end:
            time.sleep(0.02)
        complete += where.drawn() >= want
    return complete


def said(ms):
    return "-" if ms is None else "%.0f ms" % ms if ms < 9999.5 else "%.0f s" % (ms / 1000)


def measure(where, name, options):
    """Returns a row of the table."""
    scene = [*OPTIONS.get(name, []), "/scenes/%s.tia" % name.partition("-openness")[0]]
    where.start(["-k", "a"] if name == BUILT_IN else scene)
    time.sleep(2)
    complete = type_keys(where, ("left", "right") if name == BUILT_IN else "hl", name in PLAY, options)
    stats = json.loads(where.end().splitlines()[-1])
    figures = [said(stats[which][p]) for which in ("input_to_coarse_ms", "input_to_flip_ms") for p in ("p50", "p95")]
    return "| %s | %s | %d | %s |" % (name, " | ".join(figures), complete, stats["simd"])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--host", action="store_true")
    parser.add_argument("--kvm", action="store_true")
    parser.add_argument("--keys", type=int, default=10)
    parser.add_argument("--pause", type=float, default=1)
    parser.add_argument("--enough", type=float, default=30)
    parser.add_argument("--limit", type=float, default=3600)
    parser.add_argument("names", nargs="*", metavar="NAME", default=NAMES)
    options = parser.parse_args()
    if not set(options.names) <= set(NAMES):
        sys.exit("latency: no such scene of the gallery (%s)" % ", ".join(NAMES))

    def table(where):
        print("| scene | first p50 | p95 | complete p50 | p95 | of | level |\n" + "|---" * 7 + "|", flush=True)
        for name in options.names:
            print(measure(where, name, options), flush=True)
    if options.host:
        table(OnHost())
        return
    try:
        image.prepare()
    except image.Missing as missing:
        sys.exit("latency: %s" % missing)
    setup = drm("latency", ["-device", "VGA,xres=%d,yres=%d" % SIZE, "-smp", str(min(os.cpu_count() or 1, 8))], ["bochs"], SIZE)
    with Guest(setup.qemu, modules=setup.modules, memory="1G", accel="kvm" if options.kvm else "tcg") as guest:
        table(InGuest(guest, setup))


if __name__ == "__main__":
    main()
