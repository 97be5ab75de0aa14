#!/usr/bin/env python3
"""Writes the models of the gallery's scenes: knot.ply, a trefoil; fjord.pgm, a height field of 16 bits, and fjord.ppm, its
colours; globe.ppm, the map of a world.

scene_models.py FOLDER
"""
import math
import os
import sys

# ---- the trefoil ----

TURNS, SIDES = 168, 16 # around the knot, around its tube
THICK = 0.62


def trefoil(t):
    return (math.sin(t) + 2 * math.sin(2 * t), math.cos(t) - 2 * math.cos(2 * t), -math.sin(3 * t) * 1.2)


def unit(v):
    length = math.sqrt(sum(c * c for c in v))
    return [c / length for c in v]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def rings():
    """Yields a point of the curve and two directions across it. These turn as little as they can from ring to ring; the rest of
    the whole turn is spread over all rings, so that the tube closes."""
    step = 2 * math.pi / TURNS
    along = [unit([b - a for a, b in zip(trefoil((i - 0.5) * step), trefoil((i + 0.5) * step))]) for i in range(TURNS + 1)]
    side = [unit(cross(along[0], (0.0, 0.0, 1.0)))]
    for i in range(1, TURNS + 1):
        part = sum(a * b for a, b in zip(side[-1], along[i]))
        side.append(unit([a - part * b for a, b in zip(side[-1], along[i])]))
    other = cross(along[0], side[0])
    twist = math.atan2(sum(a * b for a, b in zip(side[-1], other)), sum(a * b for a, b in zip(side[-1], side[0])))
    for i in range(TURNS):
        turn = -twist * i / TURNS
        u, v = side[i], cross(along[i], side[i])
        yield (trefoil(i * step), [math.cos(turn) * a + math.sin(turn) * b for a, b in zip(u, v)],
               [math.cos(turn) * b - math.sin(turn) * a for a, b in zip(u, v)])


def knot():
    """A tube around the trefoil as a PLY file, with a normal at each vertex."""
    lines = ["ply", "format ascii 1.0", "comment a trefoil, written by tools/generate/scene_models.py", f"element vertex {TURNS * SIDES}"]
    lines += [f"property float {name}" for name in ("x", "y", "z", "nx", "ny", "nz")]
    lines += [f"element face {TURNS * SIDES}", "property list uchar int vertex_indices", "end_header"]
    for point, u, v in rings():
        for k in range(SIDES):
            angle = 2 * math.pi * k / SIDES
            normal = [math.cos(angle) * a + math.sin(angle) * b for a, b in zip(u, v)]
            values = [p + THICK * n for p, n in zip(point, normal)] + normal
            lines.append(" ".join(f"{value:.3f}" for value in values))
    for i in range(TURNS):
        for k in range(SIDES):
            corners = [(i + di) % TURNS * SIDES + (k + dk) % SIDES for di, dk in ((0, 0), (0, 1), (1, 1), (1, 0))]
            lines.append("4 " + " ".join(map(str, corners)))
    return "\n".join(lines) + "\n"


# ---- the fjord ----

SIZE = 128


def lattice(x, z, octave):
    """A number of 0 to 1 at a point of a lattice, by an integer hash."""
    n = (x * 374761393 + z * 668265263 + octave * 2246822519) & 0xffffffff
    n = (n ^ n >> 13) * 1274126177 & 0xffffffff
    return (n ^ n >> 16) / 0xffffffff


def smooth(x, z, octave):
    """Numbers of the lattice, interpolated."""
    i, k = math.floor(x), math.floor(z)
    u, w = ((t * t * (3 - 2 * t)) for t in (x - i, z - k))
    front = lattice(i, k, octave) * (1 - u) + lattice(i + 1, k, octave) * u
    back = lattice(i, k + 1, octave) * (1 - u) + lattice(i + 1, k + 1, octave) * u
    return front * (1 - w) + back * w


def ridges(x, z):
    """Sums octaves with a ridge where each is a half; one counts less where the sum is low, so that hollows are smooth."""
    total, weight, size = 0.0, 1.0, 0.5
    for octave in range(6):
        ridge = 1 - abs(2 * smooth(x, z, octave) - 1)
        total += size * weight * ridge * ridge
        weight, size, x, z = min(1.0, 1.6 * ridge), size / 2, 2 * x + 3.7, 2 * z + 1.3
    return total


def height(u, v):
    """The height at a point of the square: water bends from the front to the back, ridges rise at both sides."""
    water = 0.5 + 0.13 * math.sin(5.2 * v + 0.6)
    away = abs(u - water)
    side = min(1.0, max(0.0, (away - 0.045) / 0.3))
    return side * side * (3 - 2 * side) * (0.35 + 0.8 * ridges(3.1 * u + 9.2, 3.1 * v + 4.4)) * (0.75 + 0.5 * (1 - v))


def heights():
    """Rows of heights from 0 to 1, the far side first."""
    rows = [[height(x / (SIZE - 1), y / (SIZE - 1)) for x in range(SIZE)] for y in range(SIZE)]
    most = max(map(max, rows))
    return [[h / most for h in row] for row in rows]


def fjord(rows):
    """The heights as a PGM file of 16 bits."""
    data = b"".join(int(h * 65535 + 0.5).to_bytes(2, "big") for row in rows for h in row)
    return f"P5\n# a fjord, written by tools/generate/scene_models.py\n{SIZE} {SIZE}\n65535\n".encode() + data


def mixed(a, b, share):
    share = min(1.0, max(0.0, share))
    return [p + (q - p) * share for p, q in zip(a, b)]


def picture(rows):
    """A PPM file of rows of colours from 0 to 1."""
    data = bytes(int(c * 255 + 0.5) for row in rows for colour in row for c in colour)
    return f"P6\n# written by tools/generate/scene_models.py\n{len(rows[0])} {len(rows)}\n255\n".encode() + data


MEADOW, FOREST, ROCK, SNOW = (0.38, 0.43, 0.17), (0.10, 0.19, 0.11), (0.42, 0.38, 0.34), (0.95, 0.96, 1.0)


def ground(rows, x, y):
    """The colour of a place: meadows and forests below, then rock, and snow where it is high and not too steep."""
    across = rows[y][min(x + 1, SIZE - 1)] - rows[y][max(x - 1, 0)]
    along = rows[min(y + 1, SIZE - 1)][x] - rows[max(y - 1, 0)][x]
    steep, h = math.hypot(across, along) * SIZE / 10, rows[y][x]
    patch = sum(smooth(x / 6 * 2 ** i, y / 6 * 2 ** i, 7 + i) / 2 ** i for i in range(3)) / 1.75
    colour = mixed(MEADOW, FOREST, 6 * (patch - 0.5) + 12 * (h - 0.08))
    colour = mixed(colour, ROCK, 7 * (h - 0.42 + 0.5 * (patch - 0.5)) + 1.5 * (steep - 0.8))
    return mixed(colour, SNOW, 10 * (h - 0.52 + 0.4 * (patch - 0.5)) - 2 * max(0.0, steep - 0.7))


# ---- the globe ----

DEEP, SEA, SHORE, LAND, ICE = (0.03, 0.13, 0.30), (0.07, 0.30, 0.46), (0.80, 0.70, 0.42), (0.30, 0.40, 0.16), (0.92, 0.93, 0.93)


def relief(x, y, z):
    """A number around 0.5 at a point of the unit sphere, without a seam: noise seen along the three axes."""
    return sum((smooth(2 ** i * (1.3 * a + 9.5), 2 ** i * (1.3 * b + 6.1), 20 + 3 * i + k) - 0.5) * 0.58 ** i
               for i in range(5) for k, (a, b) in enumerate(((x, y), (y, z), (z, x)))) / 2 + 0.5


def world(width, height):
    rows = []
    for j in range(height):
        angle = math.pi * (0.5 - (j + 0.5) / height)
        rows.append([])
        for i in range(width):
            turn = 2 * math.pi * (i + 0.5) / width
            h = relief(math.cos(angle) * math.cos(turn), math.sin(angle), math.cos(angle) * math.sin(turn)) - 0.54
            colour = mixed(DEEP, SEA, 1 + 6 * h) if h < 0 else mixed(SHORE, LAND, 9 * h)
            rows[-1].append(mixed(colour, ICE, 12 * (abs(math.sin(angle)) + 0.4 * h - 0.9)))
    return rows


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__.strip().splitlines()[-1])
    rows = heights()
    colours = [[ground(rows, x, y) for x in range(SIZE)] for y in range(SIZE)]
    for name, data in (("knot.ply", knot().encode()), ("fjord.pgm", fjord(rows)), ("fjord.ppm", picture(colours)),
                       ("globe.ppm", picture(world(192, 96)))):
        with open(os.path.join(sys.argv[1], name), "wb") as file:
            file.write(data)


main()
