#!/usr/bin/env python3
"""Draws the pictures of docs/language.md: docs/language/NAME.png from NAME.tia, as small as lossless compression makes
them.

language_pictures.py BUILD [FOLDER [NAME...]]: BUILD has tia; FOLDER gets the pictures, by default docs/language; of all
scenes or of those named. A line "# tia OPTIONS" in a scene has the options that it is drawn with.
"""
import glob
import os
import re
import struct
import subprocess
import sys
import tempfile
import zlib

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../..")
SCENES = os.path.join(ROOT, "docs/language")
SIZE = "160x120"


def options(scene):
    """The options that a scene is drawn with, and those of all."""
    with open(scene, encoding="utf-8") as file:
        found = re.search(r"^# tia (.*)$", file.read(), re.M)
    return [*(found[1].split() if found else []), "-s", SIZE]


def draw(build, scene, out):
    subprocess.run([os.path.join(build, "tia"), scene, *options(scene), "-o", out], check=True, stdout=subprocess.DEVNULL)


def rows_of(ppm):
    """Width, and the rows of a binary .ppm of 8 bits."""
    head = re.match(rb"P6\s+(\d+)\s+(\d+)\s+255\s", ppm)
    width, height = int(head[1]), int(head[2])
    return width, [ppm[head.end() + 3 * width * y:][:3 * width] for y in range(height)]


def paeth(a, b, c):
    p = a + b - c
    return min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]


def filters(row, above, pixel):
    """The row by each of PNG's filters: none, left, above, their mean, Paeth's."""
    left, corner = bytes(pixel) + row[:-pixel], bytes(pixel) + above[:-pixel]
    return [row, bytes((x - a) & 255 for x, a in zip(row, left)), bytes((x - b) & 255 for x, b in zip(row, above)),
            bytes((x - (a + b) // 2) & 255 for x, a, b in zip(row, left, above)),
            bytes((x - paeth(a, b, c)) & 255 for x, a, b, c in zip(row, left, above, corner))]


def filtered(rows, pixel):
    """The picture by each filter alone, and by that of the smallest sum of differences in each row."""
    kinds = [filters(row, above, pixel) for row, above in zip(rows, [bytes(len(rows[0]))] + rows)]
    least = [min(range(5), key=lambda kind: sum(min(b, 256 - b) for b in each[kind])) for each in kinds]
    for chosen in [[kind] * len(rows) for kind in range(5)] + [least]:
        yield b"".join(bytes([kind]) + each[kind] for kind, each in zip(chosen, kinds))


def png(width, rows):
    """The shortest of several files with these pixels."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    found = []
    for data in filtered(rows, 3):
        for strategy in (zlib.Z_DEFAULT_STRATEGY, zlib.Z_FILTERED):
            packer = zlib.compressobj(9, zlib.DEFLATED, 15, 9, strategy)
            found.append(packer.compress(data) + packer.flush())
    header = struct.pack(">IIBBBBB", width, len(rows), 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", min(found, key=len)) + chunk(b"IEND", b"")


def scenes(names=()):
    found = sorted(glob.glob(os.path.join(SCENES, "*.tia")))
    return [scene for scene in found if not names or os.path.basename(scene)[:-4] in names]


def main():
    build, folder = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else SCENES
    with tempfile.TemporaryDirectory() as place:
        drawn = os.path.join(place, "drawn.ppm")
        for scene in scenes(sys.argv[3:]):
            name = os.path.basename(scene)[:-4] + ".png"
            print(f"  DRAW    docs/language/{name}", flush=True)
            draw(build, scene, drawn)
            with open(drawn, "rb") as file:
                packed = png(*rows_of(file.read()))
            with open(os.path.join(folder, name), "wb") as file:
                file.write(packed)


if __name__ == "__main__":
    main()
