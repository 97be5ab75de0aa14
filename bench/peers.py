#!/usr/bin/env python3
"""Measures the scenes of the Standard Procedural Databases with tia's SIMD kernels, Embree and POV-Ray, on one thread each:
milliseconds of CPU time per picture of 640x480.

    taskset -c 1 bench/peers.py [BUILD [NAME ...]]      scenes whose name contains NAME

Needs `make BUILD/bench BUILD/tia-pov`, with libembree-dev installed for Embree, and povray. A renderer that is missing is
reported, and has no column. `bench simd-rays` measures Embree and the SIMD kernels in turns. Between two runs of it, POV-Ray
draws the scenes as written by tia-pov; its time is the CPU time that it reports for tracing. The least time of all runs
counts. Embree traces rays singly, and in packets and streams; "best" is the fastest of these ways. The last lines give the
speeds relative to tia's plain C, to Embree's single rays and to its best, as geometric means.
"""
import glob
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile

ROUNDS = 2
SIZE = ("640", "480")
BUILD = sys.argv[1] if len(sys.argv) > 1 else "build"


def output(*command, **options):
    done = subprocess.run(command, check=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **options)
    return done.stdout.decode(errors="replace")


def by_bench(name):
    """Returns {renderer: ms} for a scene."""
    rows = re.findall(rf"^\| {name}\.nff \S+ \| ([^|]+) \| ([0-9.]+) \|", output(f"{BUILD}/bench", "simd-rays", name),
                      re.MULTILINE)
    return {who: float(ms) for who, ms in rows if "threads" not in who}


def by_povray(folder, name):
    said = output("povray", f"+I{name}.pov", f"+O{name}.png", f"+W{SIZE[0]}", f"+H{SIZE[1]}", "+FN", "-A", "-D", "-P",
                  "+WT1", "File_Gamma=1.0", cwd=folder)
    return 1e3 * float(re.findall(r"Trace Time:.*\n.*with ([0-9.]+) CPU-seconds", said)[0])


def measure(folder, scene):
    name = os.path.splitext(os.path.basename(scene))[0]
    least = {}
    if shutil.which("povray"):
        output(f"{BUILD}/tia-pov", scene, "-o", os.path.join(folder, name + ".pov"))
    for _ in range(ROUNDS):
        found = by_bench(name)
        if shutil.which("povray"):
            found["POV-Ray"] = by_povray(folder, name)
        for who, ms in found.items():
            least[who] = min(ms, least.get(who, ms))
    ways = [ms for who, ms in least.items() if who.startswith("Embree")]
    if ways:
        least["best"] = min(ways)
    return name, {who: ms for who, ms in least.items() if not who.startswith("Embree,")}


def mean(rows, who, over):
    return math.exp(sum(math.log(row[over] / row[who]) for row in rows) / len(rows))


def main():
    names = sys.argv[2:] or [""]
    rows = []
    if not shutil.which("povray"):
        print("peers: no povray: measured without it (apt-get install povray)", file=sys.stderr)
    with tempfile.TemporaryDirectory(prefix="peers.") as folder:
        for scene in sorted(glob.glob("scenes/nff/*.nff")):
            if not any(name in scene for name in names):
                continue
            name, row = measure(folder, scene)
            if not rows:
                print("| 640x480, ms | " + " | ".join(row) + " |\n|---|" + "--:|" * len(row))
            rows.append(row)
            print(f"| {name} | " + " | ".join(f"{ms:.0f}" for ms in row.values()) + " |", flush=True)
    for over in ("plain", "Embree", "best"):
        if rows and over in rows[0]:
            print(f"| {over} over it | " + " | ".join(f"{mean(rows, who, over):.2f}" for who in rows[0]) + " |")
    return 0


if __name__ == "__main__":
    sys.exit(main())
