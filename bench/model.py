#!/usr/bin/env python3
"""model.py - writes a bumpy sphere of 4 N^2 faces as an .obj file, for measurements of loading.

    bench/model.py 880 > model.obj      3097600 faces, 121 MB
    bench/model.py --normals 480 > ...  with normals and texture coordinates
"""
import math
import sys


def vertex(row, column, rows, normals):
    theta, phi = math.pi * row / rows, math.pi * column / rows
    direction = math.sin(theta) * math.cos(phi), math.cos(theta), math.sin(theta) * math.sin(phi)
    radius = 1 + 0.05 * math.sin(9 * theta) * math.cos(13 * phi) + 0.01 * math.sin(97 * theta + 31 * phi)
    text = "v %.6f %.6f %.6f\n" % tuple(radius * x for x in direction)
    if normals:
        text += "vn %.4f %.4f %.4f\nvt %.5f %.5f\n" % (*direction, column / rows / 2, row / rows)
    return text


def faces(row, columns, corner):
    for column in range(columns):
        right = (column + 1) % columns
        a, b = corner(row * columns + column + 1), corner(row * columns + right + 1)
        c, d = corner((row + 1) * columns + right + 1), corner((row + 1) * columns + column + 1)
        yield "f %s %s %s\nf %s %s %s\n" % (a, b, c, a, c, d)


def main():
    normals = "--normals" in sys.argv
    rows = int(sys.argv[-1])
    corner = (lambda i: f"{i}/{i}/{i}") if normals else str
    for row in range(rows + 1):
        sys.stdout.write("".join(vertex(row, column, rows, normals) for column in range(2 * rows)))
    for row in range(rows):
        sys.stdout.write("".join(faces(row, 2 * rows, corner)))


main()
