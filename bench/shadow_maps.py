#!/usr/bin/env python3
"""Prints the tables of shadow maps in docs/shadows.md: their errors relative to shadow volumes, in a scene with one light.

    shadow_maps.py TIA LIGHT [FILTER] [SIZE...]  each bias; LIGHT: spot, point or sun; FILTER: none; SIZE: all
    shadow_maps.py TIA filters [BIAS]            each filter, beside 64 volumes of an area light; BIAS: plane=1

A pixel's error is the fraction of its unshadowed light that is missing (wrongly dark) or too much (wrongly lit). The tables
give the sums of the errors in per cent of the pixels that see a face. Without a filter a fraction is 0 or 1, so that the
sums are numbers of pixels."""
import math
import os
import subprocess
import sys
import tempfile

TIA = (sys.argv + [""])[1]
WIDTH, HEIGHT = 640, 480
LIGHTS = {
    "spot": "light spot at 3 7 4 direction -3 -6.5 -4 inner 60 outer 60 emission 1",
    "point": "light at 3 7 4 emission 1",
    "sun": "light directional direction -3 -6.5 -4 emission 1",
}
BIASES = ["none", "constant=0.002", "constant=0.01", "constant=0.05", "constant=0.2", "slope=0.5", "slope=1", "slope=2", "slope=3",
          "normal=1", "normal=2", "plane=0", "plane=0.25", "plane=1"]
SIZES = (64, 128, 256, 512, 1024, 2048, 4096)
FILTERS = ["none", "bilinear", "3x3", "5x5", "7x7", "poisson", "pcss"]


def mesh(name, rows, columns, point):
    """Returns a closed mesh; `point` maps two angles to a point of the surface."""
    lines = [f"mesh {name}"]
    for i in range(rows):
        for k in range(columns):
            lines.append("    vertex %.5f %.5f %.5f" % point(2 * math.pi * i / rows, 2 * math.pi * k / columns))
    for i in range(rows):
        for k in range(columns):
            a, b = i * columns + k, i * columns + (k + 1) % columns
            c, d = (i + 1) % rows * columns + k, (i + 1) % rows * columns + (k + 1) % columns
            lines.append(f"    face {a + 1} {b + 1} {d + 1} {c + 1}")
    return lines + ["end", f"instance {name} material white"]


def ring(x, y, z, radius, thin, lean):
    def point(a, b):
        u, v, w = (radius + thin * math.cos(b)) * math.cos(a), (radius + thin * math.cos(b)) * math.sin(a), thin * math.sin(b)
        return x + u, y + v * math.cos(lean) - w * math.sin(lean), z + v * math.sin(lean) + w * math.cos(lean)
    return point


def scene(light):
    lines = ["camera eye 0.5 4.2 9 look 0.2 0.9 0.3 up 0 1 0 fov 45", "material white colour 0.9", light,
             "box min -12 -1 -12 max 12 0 12 material white",
             "box min -0.8 -0.85 -0.7 max 0.8 0.85 0.7 at 1.9 0.86 -0.6 rotate 0 28 0 material white"]
    lines += mesh("large", 40, 24, ring(-1.7, 1.6, 0.2, 0.8, 0.4, 0.7))
    lines += mesh("small", 32, 16, ring(0.4, 1.3, 2.0, 0.9, 0.3, 1.0))
    return "\n".join(lines) + "\n"


def draw(folder, text, *options):
    """Returns the green channel of each pixel."""
    path, out = os.path.join(folder, "scene.tia"), os.path.join(folder, "out.ppm")
    with open(path, "w", encoding="ascii") as file:
        file.write(text)
    subprocess.run([TIA, *options, "-j", "1", "-s", f"{WIDTH}x{HEIGHT}", "-o", out, path], check=True)
    with open(out, "rb") as file:
        return file.read()[-3 * WIDTH * HEIGHT + 1::3]


def part(got, exact, full, unlit):
    """Returns the error as a fraction of the unshadowed light."""
    return min(1, (got - exact) / (full - unlit)) if full > unlit else 1


def biases(folder, light, name, sizes):
    text = scene(LIGHTS[light])
    exact = draw(folder, text, "--shadows", "zfail")
    face = draw(folder, text.replace("material white colour 0.9", "material white colour 0 emission 1"), "--shadows", "zfail")
    unlit = draw(folder, scene("light ambient emission 0"), "--shadows", "zfail")
    full = draw(folder, text, "--shadows", "map", "--map-size", "64", "--filter", "none", "--bias", "constant=1000")
    seen = sum(1 for value in face if value)
    print(f"{light}, filter {name}: {seen} pixels see a face; wrongly dark + wrongly lit, per cent")
    print("| bias | " + " | ".join(map(str, sizes)) + " |")
    print("|---|" + "--:|" * len(sizes))
    for bias in BIASES:
        row = []
        for size in sizes:
            got = draw(folder, text, "--shadows", "map", "--map-size", str(size), "--filter", name, "--bias", bias)
            pixels = list(zip(got, exact, full, unlit))
            dark = sum(part(b, a, f, u) for a, b, f, u in pixels if a < b)
            lit = sum(part(a, b, f, u) for a, b, f, u in pixels if a > b)
            row.append(f"{100 * dark / seen:.3f}+{100 * lit / seen:.3f}")
        print(f"| {bias.replace('=', ' ')} | " + " | ".join(row) + " |", flush=True)


def filters(folder, bias, sizes):
    """Prints the table of filters, for a square light with 64 samples. All filters but PCSS take the light as a point at its
    middle."""
    area = "light rectangle at 3 7 4 sides 0.443 0 0 0 0 0.443 emission 1 samples "
    exact = draw(folder, scene(area + "64"), "--shadows", "zfail")
    unlit = draw(folder, scene("light ambient emission 0"), "--shadows", "zfail")
    full = draw(folder, scene(area + "64"), "--shadows", "map", "--map-size", "64", "--bias",
                "constant=1000", "--filter", "pcss")
    known = [i for i in range(len(exact)) if full[i] > unlit[i] + 24]
    print(f"a light of radius 0.5, bias {bias}, {len(known)} pixels: mean error of visibility against 64 volumes, per cent off by > 1/4")
    print("| filter | " + " | ".join(map(str, sizes)) + " |")
    print("|---|" + "--:|" * len(sizes))
    for name in FILTERS:
        row = []
        for size in sizes:
            light = area + "64" if name == "pcss" else "light at 3 7 4 emission 1"
            got = draw(folder, scene(light), "--shadows", "map", "--map-size", str(size), "--filter", name, "--bias", bias)
            errors = [min(1, abs(got[i] - exact[i]) / (full[i] - unlit[i])) for i in known]
            off = sum(1 for e in errors if e > 0.25)
            row.append(f"{sum(errors) / len(errors):.5f}, {100 * off / len(errors):.3f}")
        print(f"| {name} | " + " | ".join(row) + " |", flush=True)


def main():
    if len(sys.argv) < 3 or sys.argv[2] not in [*LIGHTS, "filters"]:
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        if sys.argv[2] == "filters":
            filters(folder, (sys.argv[3:] or ["plane=1"])[0], SIZES)
            return
        name = sys.argv[3] if sys.argv[3:] and sys.argv[3] in FILTERS else "none"
        sizes = [int(size) for size in sys.argv[3:] if size not in FILTERS]
        biases(folder, sys.argv[2], name, sizes or SIZES)


main()
