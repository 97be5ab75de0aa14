#!/usr/bin/env python3
"""Measures how much work --gaze saves: the share of the pixels that is drawn, by eccentricity, and the CPU time.

    bench/gaze.py scenes/castle.tia             # tables in Markdown, for 1920x1080 and 3840x2160

The shares follow from the acuity model, which draws one pixel of each block; they are computed for every eighth pixel of
every eighth row. The share "all" is the one that build/tia reports. Times are sums over all threads, and include reading the
scene.
"""
import json
import math
import os
import resource
import subprocess
import sys
import tempfile

SIZES = ((1920, 1080), (3840, 2160))
ANGLES = (30, 50, 90)
RINGS = (0, 2.5, 5, 10, 20, 30, 90)
W0, M, FOVEA = 1 / 48, 0.0275, 2.5


def block(e, pixel):
    size = 1
    while size < 16 and e >= FOVEA and 2 * size * pixel <= W0 + M * e:
        size *= 2
    return size


def shares(width, height, angle):
    """Returns for each ring around the middle the share of its pixels that is drawn; None for a ring without pixels."""
    z = width / 2 / math.tan(math.radians(angle / 2))
    pixel = math.degrees(1 / z)
    drawn, pixels = [0] * len(RINGS), [0] * len(RINGS)
    for y in range(4, height, 8):
        for x in range(4, width, 8):
            e = math.degrees(math.atan(math.hypot(x - width / 2, y - height / 2) / z))
            ring = max(i for i, from_ in enumerate(RINGS) if e >= from_)
            pixels[ring] += 1
            drawn[ring] += 1 / block(e, pixel) ** 2
    return [d / p if p else None for d, p in zip(drawn, pixels)][:-1]


def run(*args):
    """Returns the seconds of CPU time, and the share of the pixels that was drawn."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([os.path.join(os.environ.get("BUILD", "build"), "tia"), *args, "--stats"], check=True,
                          stderr=subprocess.PIPE)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime, json.loads(done.stderr.splitlines()[-1]).get("drawn", 1)


def percent(share):
    return "" if share is None else f"{100 * share:.1f} %" if share < 0.9995 else "100 %"


def main(scene):
    names = [f"{a:g}-{b:g}" for a, b in zip(RINGS, RINGS[1:])]
    print("| picture | width seen | " + " | ".join(f"{n}°" for n in names) + " | all | time | smooth |")
    print("|---|---|" + "---|" * (len(names) + 3))
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "a.ppm")
        for width, height in SIZES:
            common = (scene, "-o", out, "-s", f"{width}x{height}")
            full = run(*common)[0]
            print(f"| {width}x{height} | without |" + " |" * len(names) + f" 100 % | {full:.1f} s | |", flush=True)
            for angle in ANGLES:
                gaze = ("--gaze", f"{width // 2},{height // 2}", "--view-angle", str(angle))
                seconds, drawn = run(*common, *gaze)
                smooth = run(*common, *gaze, "--smooth")[0]
                print(f"| {width}x{height} | {angle}° | " + " | ".join(map(percent, shares(width, height, angle))) +
                      f" | {percent(drawn)} | {seconds:.1f} s | {smooth:.1f} s |", flush=True)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: bench/gaze.py SCENE")
    main(sys.argv[1])
