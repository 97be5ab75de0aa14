#!/usr/bin/env python3
"""Writes the models of scenes/obj: models.py FOLDER."""
import math
import os
import sys


def write(folder, name, lines):
    with open(os.path.join(folder, name), "w", encoding="ascii") as file:
        file.write("\n".join(lines) + "\n")


def crate(folder):
    """Writes a cube of six quads, each with the whole texture. It uses texture coordinates and negative indices."""
    write(folder, "crate.mtl", ["# wood, from crate.ppm", "newmtl wood", "Kd 1 1 1", "Ks 0.2 0.2 0.2", "Ns 20", "illum 2",
                                "map_Kd crate.ppm", "", "newmtl floor", "Kd 0.55 0.6 0.65", "illum 1"])
    lines = ["# A crate on a floor.", "mtllib crate.mtl", "o crate"]
    lines += [f"v {x} {y} {z}" for z in (-1, 1) for y in (0, 2) for x in (-1, 1)]
    lines += ["vt 0 0", "vt 1 0", "vt 1 1", "vt 0 1", "usemtl wood"]
    for face in ((5, 6, 8, 7), (2, 1, 3, 4), (1, 5, 7, 3), (6, 2, 4, 8), (7, 8, 4, 3), (1, 2, 6, 5)):
        lines.append("f " + " ".join(f"{v}/{t}" for v, t in zip(face, (1, 2, 3, 4))))
    lines += ["o floor"] + [f"v {x} 0 {z}" for x, z in ((-4, 4), (4, 4), (4, -4), (-4, -4))]
    lines += ["usemtl floor", "f -4 -3 -2 -1"]
    write(folder, "crate.obj", lines)
    with open(os.path.join(folder, "crate.ppm"), "wb") as file:
        file.write(b"P6\n16 16\n255\n")
        for y in range(16):
            for x in range(16):
                frame = x in (0, 1, 14, 15) or y in (0, 1, 14, 15) or x == y
                shade = 130 if frame else 200 if x % 4 else 165
                file.write(bytes((shade, shade * 3 // 4, shade // 2)))


def icosphere(steps):
    """Returns vertices on the unit sphere and triangles between them, counterclockwise as seen from outside."""
    golden = (1 + math.sqrt(5)) / 2
    corners = [(-1, golden, 0), (1, golden, 0), (-1, -golden, 0), (1, -golden, 0), (0, -1, golden), (0, 1, golden),
               (0, -1, -golden), (0, 1, -golden), (golden, 0, -1), (golden, 0, 1), (-golden, 0, -1), (-golden, 0, 1)]
    points = [tuple(x / math.hypot(1, golden) for x in corner) for corner in corners]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6),
             (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10),
             (8, 6, 7), (9, 8, 1)]
    for _ in range(steps):
        between = {}

        def middle(a, b):
            key = min(a, b), max(a, b)
            if key not in between:
                sums = [x + y for x, y in zip(points[a], points[b])]
                between[key] = len(points)
                points.append(tuple(x / math.hypot(*sums) for x in sums))
            return between[key]

        finer = []
        for a, b, c in faces:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        faces = finer
    return points, faces


def ball(folder):
    """Writes a ball of triangles with the normals of a sphere."""
    points, faces = icosphere(2)
    lines = ["# A smooth ball of 320 triangles."]
    lines += ["v " + " ".join(f"{2 * x:.6f}" for x in p) for p in points]
    lines += ["vn " + " ".join(f"{x:.6f}" for x in p) for p in points]
    lines += ["s 1"] + ["f " + " ".join(f"{i + 1}//{i + 1}" for i in face) for face in faces]
    write(folder, "ball.obj", lines)


def star(folder):
    """Writes a star of glass: two concave polygons of ten corners and the quads between them."""
    write(folder, "star.mtl", ["newmtl glass", "Kd 0.1 0.4 0.9", "Ks 0.3 0.3 0.3", "Ns 100", "Tf 0.9 1 1", "d 0.25", "Ni 1.5",
                               "illum 7"])
    lines = ["# A star of glass.", "mtllib star.mtl", "usemtl glass"]
    for z in (0.4, -0.4):
        for i in range(10):
            radius, angle = (2, 0.8)[i % 2], math.pi * (i / 5 + 0.5)
            lines.append(f"v {radius * math.cos(angle):.6f} {radius * math.sin(angle):.6f} {z}")
    lines.append("f " + " ".join(str(i) for i in range(1, 11)))
    lines.append("f " + " ".join(str(i) for i in range(20, 10, -1)))
    lines += [f"f {i + 1} {i + 11} {(i + 1) % 10 + 11} {(i + 1) % 10 + 1}" for i in range(10)]
    write(folder, "star.obj", lines)


for model in (crate, ball, star):
    model(sys.argv[1])
