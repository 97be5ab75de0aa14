#!/usr/bin/env python3
"""Measures the errors in docs/lightfield.md: the difference between an eye's view of a light field and the picture of a camera
at the eye's position.

lightfield.py BUILD: prints the tables, for the display of scenes/lightfield.tia.
"""
import os
import re
import subprocess
import sys
import tempfile

WIDTH, HEIGHT = 400, 225
SCREEN, LINE = (1.6, 0.9), dict(distance=2.4, above=0.15)
MIDDLE = 0.45   # height of the screen's middle above the ground
BUILD = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else "build")
SCENE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "scenes", "lightfield.tia")


def run(tool, *args):
    subprocess.run([os.path.join(BUILD, tool), *args], check=True)


def read(path):
    with open(path, "rb") as file:
        _, size, _, rgb = file.read().split(b"\n", 3)
    width, height = map(int, size.split())
    return [[tuple(rgb[3 * (y * width + x):3 * (y * width + x) + 3]) for x in range(width)] for y in range(height)]


def with_camera(x, y, z):
    """Returns the picture of a camera that looks through the screen from (x, y, z), relative to the screen's middle."""
    with open(SCENE, encoding="utf-8") as file:
        text = file.read()
    left, bottom = -SCREEN[0] / 2 - x, -SCREEN[1] / 2 - y
    camera = f"camera frustum eye {x} {MIDDLE + y} {z} window {left} {left + SCREEN[0]} {bottom} {bottom + SCREEN[1]} near {z}"
    with open("true.tia", "w", encoding="utf-8") as file:
        file.write(re.sub(r"(?m)^camera.*$", camera, text))
    run("tia", "true.tia", "-o", "true.ppm", "-s", f"{WIDTH}x{HEIGHT}", "--samples", "1")
    return read("true.ppm")


def error(eye, *args):
    """Returns the mean absolute error of the channels, 0 to 255, in the view of an eye."""
    run("tia-observe", SCENE, *args, "-e", ",".join(map(str, eye)), "-o", "seen.ppm")
    seen, true = read("seen.ppm"), with_camera(*eye)
    total = sum(abs(a - b) for row in zip(seen, true) for p in zip(*row) for a, b in zip(*p))
    return total / (3 * WIDTH * HEIGHT)


def numbers_of_pictures():
    print("| pictures | views | modules |\n|--:|--:|--:|")
    eye = (0.31, LINE["above"], LINE["distance"])
    for count in (8, 16, 32, 64, 128, 256):
        row = []
        for option in ("--views", "--modules"):
            run("tia", SCENE, "-o", "p%03d.ppm", option, str(count), "-s", f"{WIDTH}x{HEIGHT}", "--samples", "1")
            row.append(error(eye, "p%03d.ppm", option, str(count)))
        print(f"| {count} | {row[0]:.2f} | {row[1]:.2f} |")


def panels():
    """Prints the errors for panels of several sizes and numbers of lenses."""
    print("\n| panel | lenses | pixels to a lens | error |\n|--:|--:|--:|--:|")
    eye = (0.31, LINE["above"], LINE["distance"])
    for times, lenses in ((1, 41), (4, 41), (4, 81), (4, 161)):
        size, option = f"{WIDTH * times}x{HEIGHT * times}", ("--lenticular", f"pitch={lenses},slope=-6.1,center=0.2")
        run("tia", SCENE, "-o", "panel.ppm", *option, "-s", size, "--samples", "1")
        off = error(eye, "panel.ppm", *option, "-s", f"{WIDTH}x{HEIGHT}")
        print(f"| {size} | {lenses} | {WIDTH * times / lenses:.1f} | {off:.2f} |", flush=True)


def row_of(pixels):
    lit = [y for y, row in enumerate(pixels) if any(p != (0, 0, 0) for p in row)]
    return (min(lit) + max(lit) + 1) / 2


def ball(z, camera):
    with open("ball.tia", "w", encoding="ascii") as file:
        file.write(f"{camera}\nmaterial m emission 1\nlight ambient emission 0\n"
                   f"sphere centre 0 {MIDDLE} {-z} radius 0.008 material m\n")


def heights():
    print("\n| depth | eye above the line | by the formula, rows | measured |\n|--:|--:|--:|--:|")
    field = (f"camera lightfield centre 0 {MIDDLE} 0 width {SCREEN[0]} height {SCREEN[1]} distance {LINE['distance']} "
             f"above {LINE['above']} from -0.85 to 0.85")
    width, height = 180, 900
    for z in (-0.6, 0.0, 0.6, 1.5):
        for dy in (0.1, 0.4):
            x, y, d = 0, LINE["above"] + dy, LINE["distance"]
            ball(z, field)
            run("tia", "ball.tia", "-o", "b%d.ppm", "--views", "1", "-s", f"{width}x{height}")
            run("tia-observe", "ball.tia", "b%d.ppm", "--views", "1", "-e", f"{x},{y},{d}", "-o", "seen.ppm")
            bottom = -SCREEN[1] / 2 - y
            ball(z, f"camera frustum eye {x} {MIDDLE + y} {d} window {-SCREEN[0] / 2} {SCREEN[0] / 2} {bottom} "
                    f"{bottom + SCREEN[1]} near {d}")
            run("tia", "ball.tia", "-o", "true.ppm", "-s", f"{width}x{height}")
            formula = dy * z / (d + z) / SCREEN[1] * height
            print(f"| {z} | {dy} | {formula:.1f} | {row_of(read('seen.ppm')) - row_of(read('true.ppm')):.1f} |")


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        numbers_of_pictures()
        panels()
        heights()
