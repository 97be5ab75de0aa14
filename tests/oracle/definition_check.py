#!/usr/bin/python3
"""Compares tia's pictures with definition.py's: of the built-in scene, of random scenes, also of balls that are very
small for their distance, or of given files.

    definition_check.py built-in
    definition_check.py random|small FIRST LAST DIRECTORY
    definition_check.py files NAME.WIDTHxHEIGHT.tia ...
"""
import os
import random
import subprocess
import sys
import tempfile
import time

import numpy as np

import definition
import definition_scene

TIA = os.path.join(os.path.dirname(definition_scene.COMPILE), "tia")


def pixels_of_tia(path, width, height, dither, keys):
    with tempfile.NamedTemporaryFile(suffix=".565") as file:
        command = [TIA, path, "-s", f"{width}x{height}", "-o", file.name, "-j", "1", *["--dither"] * dither]
        subprocess.run(command + (["-k", keys] if keys else []), check=True, stderr=subprocess.DEVNULL)
        return np.fromfile(file.name, "<u2")


def channels(pixel):
    return int(pixel) >> 11, int(pixel) >> 5 & 63, int(pixel) & 31


def compare(path, width, height, dither, keys="", shown=4):
    """Prints a line for a picture, and one for each of the first pixels that differ; returns the number of all that differ."""
    scene, counts, begin = definition_scene.read(path, keys), [], time.time()
    name = f"{os.path.basename(path)} {keys or '-'} {width}x{height}{' dithered' if dither else ''}"
    theirs = pixels_of_tia(path, width, height, dither, keys)
    try:
        ours = definition.draw(scene, width, height, dither, counts=counts)
    except ValueError as error:
        print(f"{name}: {error}, open {counts}")
        return 1
    differing = np.flatnonzero(ours != theirs)
    print(f"{name}: {len(differing)} differ, open {counts}, {time.time() - begin:.1f} s", flush=True)
    for i in differing[:shown]:
        x, y = int(i % width), int(i // width)
        print(f"  ({x}, {y}) definition {channels(ours[i])} tia {channels(theirs[i])}")
        print("".join(f"    {q:.40f}\n" for q in definition.digits_of(scene, width, height, dither, x, y)), end="")
    return len(differing)


def number(integer, bits):
    """The exact decimal digits of integer/2^bits."""
    sign, integer = "-" * (integer < 0), abs(integer)
    return f"{sign}{integer >> bits}.{(integer % 2**bits) * 5**bits:0{bits}d}"


def text_of(scene):
    """The scene as a file."""
    def row(values, bits=16):
        return " ".join(number(i, bits) for i in values)

    camera = scene["camera"]
    lines = [f"camera eye {row(camera['eye'])} fov {number(camera['fov'], 16)}",
             f"background {row(scene['background'], 30)}"]
    for i, m in enumerate(scene["materials"]):
        lines.append(f"material m{i} colour {row(m['colour'], 30)} transmission {row(m['transmission'], 30)} "
                     f"emission {row(m['emission'], 30)}")
    for s in scene["spheres"]:
        lines.append(f"sphere centre {row(s['centre'])} radius {number(s['radius'], 16)} material m{s['material']}")
    for s in scene["lights"]:
        lines.append(f"light at {row(s['centre'])} radius {number(s['radius'], 16)} emission {row(s['emission'], 30)}")
    return "\n".join(lines) + "\n"


def random_scene(seed):
    """A scene with 1 to 8 balls, the eye outside of them, and 1 to 3 lights."""
    r = random.Random(seed)

    def length(low, high):
        return int(r.uniform(low, high) * 65536)

    def colour(top=2**30):
        return [r.choice([r.randrange(top), r.randrange(top), 0, 2**30]) for _ in range(3)]

    def outside(thing, eye):
        return sum((i - j)**2 for i, j in zip(thing["centre"], eye)) >= thing["radius"]**2

    eye = [length(-2, 2) for _ in range(3)] if r.random() < 0.5 else [0, 0, 0]
    materials = [{"colour": colour(), "transmission": colour() if r.random() < 0.5 else [0] * 3,
                  "emission": [r.randrange(2**28) for _ in range(3)] if r.random() < 0.5 else [0] * 3}
                 for _ in range(r.randint(1, 4))]
    spheres, lights = [], []
    if r.random() < 0.5:
        spheres.append({"centre": [0, length(-1010, -1002), length(-20, 0)], "radius": 1000 * 65536, "material": 0})
    for _ in range(r.randint(1, 8 - len(spheres))):
        spheres.append({"centre": [length(-5, 5), length(-4, 4), length(-20, -5)],
                        "radius": length(0.05, r.choice([1, 3])), "material": r.randrange(len(materials))})
    for _ in range(r.randint(1, 3)):
        place = [length(-8, 8), length(-3, 15), length(-25, 5)]
        if r.random() < 0.2:
            place = list(r.choice(spheres)["centre"])
        lights.append({"centre": place, "radius": length(0.1, 2) if r.random() < 0.6 else 0,
                       "emission": [min(i, 2**31 - 1) for i in colour(2**31)]})
    return {"camera": {"eye": eye, "fov": r.choice([90 * 65536, 25 * 65536, length(1, 120), length(20, 70)])},
            "background": [r.randrange(2**30) for _ in range(3)], "materials": materials,
            "spheres": [s for s in spheres if outside(s, eye)] or [{"centre": [eye[0], eye[1], eye[2] - 10 * 65536],
                                                                    "radius": 65536, "material": 0}],
            "lights": [s for s in lights if outside(s, eye)] or [{**lights[0], "radius": 0}]}


def small_scene(seed):
    """A scene of balls that are 2^-8 to 2^-21 of their distance, in a narrow field of view."""
    r, scene = random.Random(seed), random_scene(seed)
    away = r.choice([20, 200, 2000]) * 65536
    scene["camera"] = {"eye": [0, 0, 0], "fov": r.choice([1, 2]) * 65536}
    scene["spheres"] = [{"centre": [int(r.uniform(-0.012, 0.012) * away), int(r.uniform(-0.01, 0.01) * away),
                                    int(-r.uniform(0.6, 1.2) * away)],
                         "radius": max(64, int(r.choice([0.001, 0.003, 0.01, 0.05]) * 65536)),
                         "material": r.randrange(len(scene["materials"]))} for _ in range(12)]
    for light in scene["lights"]:
        light["radius"] = 0
    return scene


def write(scene, path):
    """Writes the scene, and checks that the stored integers are the same."""
    with open(path, "w", encoding="utf-8") as file:
        file.write(text_of(scene))
    stored = definition_scene.read(path)
    if stored != scene:
        print(f"{path}: stored otherwise")


def main(kind, *arguments):
    if kind == "built-in":
        path = os.path.join(os.path.dirname(TIA), "..", "scenes", "thesis.tia")
        cases = [(path, *size, dither, key) for size in ((320, 240), (640, 480), (333, 777))
                 for key in ("", "a", "d", "s", "w") for dither in (False, True)]
    elif kind in ("random", "small"):
        cases = []
        for seed in range(int(arguments[0]), int(arguments[1])):
            path = os.path.join(arguments[2], f"{kind}-{seed}.tia")
            write(random_scene(seed) if kind == "random" else small_scene(seed), path)
            size = (160, 120) if kind == "random" else (320, 240)
            cases.append((path, *size, seed % 2 == 1))
    else:
        cases = [(path, *map(int, path.split(".")[-2].split("x")), dither) for path in arguments
                 for dither in (False, True)]
    differing = [compare(*case) for case in cases]
    print(f"{len(cases)} pictures, {sum(i > 0 for i in differing)} differ, in {sum(differing)} pixels")
    return any(differing)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
