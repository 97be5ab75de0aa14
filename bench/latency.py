#!/usr/bin/env python3
"""latency.py [--host] [--keys N] [--pause SECONDS] [--enough SECONDS] [--limit SECONDS] [NAME]...: how long after a key its picture is seen, first coarse, then
complete, for the scenes of the gallery or those named, at 1280x800: a table in Markdown.

    make bench-latency                      # all of them, in a guest
    make bench-latency SCENES='chess glass'
    bench/latency.py --host                 # without a guest

In the guest QEMU's PS/2 keyboard types h and l in turn, which turn the scene by 5 degrees and back, so that all of the
picture is new; in the built-in scene, which has no such keys, the arrows that move its light. The time is what --stats tells:
from the kernel's time stamp of the key to the end of the call that shows the picture. A guest on emulated processors is far
slower than this machine (--kvm takes this machine's, where its KVM can boot a guest). With --host a pseudo-terminal types,
a key's time is when it was read, which is up to 20 ms late, and a display that shows nothing takes the pictures.

N keys (default 10) come a second or so apart, or as many as --pause says. Then as many come each after the complete
picture of the one before, which tia tells; after --enough SECONDS (default 30) for a scene there are no more, but the first
picture is waited for until --limit (default 3600), after which a dash is in its place.
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
    """How many complete pictures keys were followed by."""
    for i in range(options.keys):
        where.tap(keys[i % 2])
        time.sleep(options.pause + random.random() / 5)  # in step with nothing that ticks
    begin, complete = time.monotonic(), 0
    enough, end = begin + options.enough, begin + options.limit
    while complete < options.keys and time.monotonic() < (enough if complete else end):
        want = where.drawn() + 1 + plays        # what plays first shows the picture that was begun before the key
        where.tap(keys[complete % 2])
        while where.drawn() < want and time.monotonic() < end:
            time.sleep(0.02)
        complete += where.drawn() >= want
    return complete


def said(ms):
    return "-" if ms is None else "%.0f ms" % ms if ms < 9999.5 else "%.0f s" % (ms / 1000)


def measure(where, name, options):
    """A row of the table."""
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
