#!/usr/bin/env python3
"""Writes the gallery's scenes that are too long to type: flake.tia, castle.tia, and vase.tia with vase.ppm.

scenes.py FOLDER
"""
import math
import os
import sys


def number(value):
    """Formats a number with at most four decimals, without trailing zeros."""
    text = f"{value:.4f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def numbers(*values):
    return " ".join(number(v) for v in values)


# ---- flake: balls upon balls ----

FLAKE = """\
# flake.tia - a flake of spheres: each ball carries nine of a third of its size, down to the fourth generation.
# {count} balls that mirror each other; the bounding volume hierarchy makes them almost as fast as a few.
# Written by tools/generate/scenes.py.

camera eye 2.4 2.1 4.8 look -0.02 0.08 0 fov 38
samples 16
depth 5
background 0.30 0.42 0.62

light sphere at 6 9 7 radius 1.2 emission 1.2 1.1 0.95 samples 16
light directional direction 1 -0.4 -0.3 emission 0.22 0.26 0.36
light ambient emission 0.08 0.09 0.12

texture tiles checker even 0.46 0.46 0.48 odd 0.75 0.72 0.66 repeat 0.7
material floor texture tiles colour 1 mirror 0.12
plane point 0 -1.35 0 normal 0 1 0 material floor

# Each generation has another metal.
"""
METALS = (("gold", "colour 0.30 0.20 0.05 mirror 0.62 0.46 0.18"), ("copper", "colour 0.32 0.15 0.08 mirror 0.58 0.32 0.22"),
          ("steel", "colour 0.12 0.14 0.18 mirror 0.62 0.66 0.72"), ("silver", "colour 0.25 0.25 0.27 mirror 0.60 0.60 0.62"))


def unit(v):
    length = math.sqrt(sum(c * c for c in v))
    return tuple(c / length for c in v)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def buds(axis):
    """Yields the directions of nine balls around `axis`: six at its equator, three nearer its pole."""
    a = unit(cross((0.36, 0.48, 0.8), axis))
    b = cross(axis, a)
    for count, lift, turn in ((6, math.radians(90), 0), (3, math.radians(35), math.radians(30))):
        for k in range(count):
            angle = turn + 2 * math.pi * k / count
            ring = [math.cos(angle) * p + math.sin(angle) * q for p, q in zip(a, b)]
            yield unit([math.sin(lift) * r + math.cos(lift) * n for r, n in zip(ring, axis)])


def grow(centre, radius, axis, generation, balls):
    balls[generation].append((*centre, radius))
    if generation + 1 < len(balls):
        for way in buds(axis):
            grow([c + radius * 4 / 3 * w for c, w in zip(centre, way)], radius / 3, way, generation + 1, balls)


def flake():
    balls = [[] for _ in METALS]
    grow((0, 0, 0), 1, unit((0.25, 1, 0.2)), 0, balls)
    lines = [FLAKE.format(count=sum(map(len, balls)))]
    for (name, looks), generation in zip(METALS, balls):
        lines.append(f"material {name} {looks} specular 0.6 exponent 120\n")
        lines.extend(f"sphere centre {numbers(x, y, z)} radius {number(r)} material {name}\n" for x, y, z, r in generation)
    return "".join(lines)


# ---- castle: cells of a grid ----

CASTLE = """\
# castle.tia - a castle of cells on an island in a calm sea: one grid of {size} cells, traversed cell by cell, so
# that a ray's time grows with its length and not with the number of cells. Written by tools/generate/scenes.py.

camera eye 36 26 54 look -1.2 5.0 0 fov 35
samples 16
background 0.62 0.76 0.94

light directional direction -0.75 -0.85 -0.35 emission 0.95 0.88 0.72
light ambient emission 0.30 0.34 0.42

material sea colour 0.05 0.16 0.24 mirror 0.50 0.55 0.58
plane point 0 2.4 0 normal 0 1 0 material sea

# A cell's number n is the nth material from the one that the instance names: 1 is grass.
material grass colour 0.36 0.56 0.20
material sand colour 0.86 0.78 0.54
material earth colour 0.46 0.34 0.22
material stone colour 0.74 0.71 0.66
material dark colour 0.50 0.48 0.47
material roof colour 0.72 0.22 0.14
material wood colour 0.42 0.27 0.14
material leaves colour 0.16 0.36 0.14
material lit colour 0.9 0.7 0.3 emission 0.75 0.5 0.15
material flag colour 0.90 0.75 0.15

instance island material grass

# Rows along x; after each {rows} rows, one for each height y, the next z begins.
grid island size {size_words} corner {corner} cell 1
"""
GRASS, SAND, EARTH, STONE, DARK, ROOF, WOOD, LEAVES, LIT, FLAG = range(1, 11)
SIDE, HIGH = 48, 26
YARD = 6                        # height of the castle's yard


def shore(x, z):
    """Returns the ground's height: an island, higher towards the back."""
    u, v = (x - 23.5) / 23.5, (z - 23.5) / 23.5
    wave = 0.10 * math.sin(3.1 * u + 1) + 0.09 * math.sin(4.3 * v + 2.2 * u) + 0.05 * math.cos(9 * u - 7 * v)
    return 8.2 * (1 - (u * u + v * v) ** 1.3 + wave * 1.6)


class Cells:
    def __init__(self):
        self.cells = {}

    def put(self, x, y, z, cell):
        if 0 <= x < SIDE and 0 <= y < HIGH and 0 <= z < SIDE:
            self.cells[x, y, z] = cell

    def fill(self, xs, ys, zs, cell):
        for x in xs:
            for y in ys:
                for z in zs:
                    self.put(x, y, z, cell)

    def rows(self):
        for z in range(SIDE):
            for y in range(HIGH):
                yield [self.cells.get((x, y, z), 0) for x in range(SIDE)]


def ground(cells):
    for x in range(SIDE):
        for z in range(SIDE):
            top = round(shore(x, z))
            if 12 <= x <= 35 and 12 <= z <= 35 and top >= 3:
                top = YARD
            for y in range(min(top, HIGH)):
                cells.put(x, y, z, EARTH if y < top - 1 else SAND if top <= 3 else GRASS)


def walls(cells):
    low, high = 13, 34
    for a in range(low, high + 1):
        for b, along_x in ((low, True), (high, True), (low, False), (high, False)):
            x, z = (a, b) if along_x else (b, a)
            cells.fill([x], range(3, YARD + 5), [z], STONE if (a // 3) % 4 else DARK)
            if a % 2 == 0:
                cells.put(x, YARD + 5, z, STONE)
    # The gate in the front wall, and its way down to the shore.
    cells.fill(range(22, 26), range(YARD, YARD + 4), [high], 0)
    cells.fill([22, 25], [YARD + 3], [high], WOOD)
    for step, z in enumerate(range(high + 1, 46)):
        cells.fill(range(22, 26), range(0, max(YARD - step // 2, 2)), [z], DARK)
        cells.fill(range(22, 26), range(max(YARD - step // 2, 2), YARD + 3), [z], 0)


def tower(cells, cx, cz, radius, top, roofed):
    for x in range(cx - radius - 1, cx + radius + 2):
        for z in range(cz - radius - 1, cz + radius + 2):
            away = math.hypot(x - cx, z - cz)
            if away < radius + 0.4:
                cells.fill([x], range(2, top), [z], STONE)
            if radius - 0.6 <= away < radius + 0.4:
                if (x + z) % 2 == 0:
                    cells.put(x, top, z, STONE)
            for k in range(radius + 4 if roofed else 0):
                if away < (radius + 0.9) * (1 - k / (radius + 4)):
                    cells.put(x, top + k, z, ROOF)
    for y in (top - 3, top - 7):
        for x, z in ((cx, cz + radius), (cx + radius, cz)):
            cells.put(x, y, z, LIT)


def keep(cells):
    cells.fill(range(19, 29), range(YARD, YARD + 11), range(17, 26), STONE)
    for a in range(19, 29, 2):
        cells.fill([a], [YARD + 11], [17, 25], STONE)
    for b in range(17, 26, 2):
        cells.fill([19, 28], [YARD + 11], [b], STONE)
    for x in (21, 26):
        for y in (YARD + 4, YARD + 8):
            cells.fill([x], [y, y + 1], [25], LIT)
    for z in (19, 23):
        for y in (YARD + 4, YARD + 8):
            cells.fill([28], [y, y + 1], [z], LIT)
    cells.fill(range(23, 25), range(YARD, YARD + 3), [25], WOOD)
    for k in range(5):
        cells.fill(range(20 + k, 28 - k), [YARD + 11 + k], range(18, 25), ROOF)


def flags(cells):
    for x, z, y in ((13, 13, 23), (34, 13, 23)):
        cells.fill([x], range(y - 3, y), [z], WOOD)
        cells.fill(range(x + 1, x + 3), [y - 1], [z], FLAG)


def tree(cells, x, z):
    y = round(shore(x, z))
    cells.fill([x], range(y, y + 2), [z], WOOD)
    for dx in range(-2, 3):
        for dy in range(0, 5):
            for dz in range(-2, 3):
                if dx * dx + dz * dz + (dy - 1.4) ** 2 < 4.2:
                    cells.put(x + dx, y + 2 + dy, z + dz, LEAVES)


def castle():
    cells = Cells()
    ground(cells)
    for x, z in ((8, 28), (7, 22), (10, 38), (15, 40), (38, 39), (31, 42), (40, 30), (42, 23), (39, 17), (9, 14)):
        tree(cells, x, z)
    walls(cells)
    keep(cells)
    for cx, cz, top, roofed in ((13, 13, 16, True), (34, 13, 16, True), (13, 34, 14, False), (34, 34, 14, False)):
        tower(cells, cx, cz, 3, top, roofed)
    flags(cells)
    head = CASTLE.format(size=f"{SIDE} x {HIGH} x {SIDE}", rows=HIGH, size_words=numbers(SIDE, HIGH, SIDE),
                         corner=numbers(-SIDE / 2, 0, -SIDE / 2))
    return head + "".join("row " + " ".join(map(str, row)) + "\n" for row in cells.rows()) + "end\n"


# ---- vase: a surface of revolution with a picture ----

VASE = """\
# vase.tia - a porcelain vase: a mesh of {faces} faces with smooth normals, a texture that repeats three times
# around it, and a glaze of a highlight and a weak mirror, cheaper than Fresnel's equations. This file and vase.ppm are
# written by tools/generate/scenes.py.

camera eye 0.6 3.3 9.0 look 0.35 1.62 0 fov 33
samples 16
background 0.20 0.18 0.19

# A window at the left, a reflector at the right.
light rectangle at -5.5 5.5 3.5 sides 0 1.4 0  0.9 0 1.4 emission 1.15 1.10 1.00 samples 20
light rectangle at 7 4 4 sides 0 1.5 0  1 0 -1.2 emission 0.20 0.22 0.28 samples 12
light ambient emission 0.14 0.14 0.16

texture pattern image vase.ppm bilinear repeat 3 1
material porcelain texture pattern colour 1 mirror 0.07 specular 0.8 exponent 160
material inside colour 0.80 0.82 0.85

texture weave checker even 0.52 0.17 0.14 odd 0.60 0.22 0.17 repeat 3
material cloth texture weave colour 1
material wall colour 0.52 0.50 0.46
material lemon colour 0.92 0.76 0.12 specular 0.25 exponent 30 facing 0.06 0.04 0
material pewter colour 0.10 mirror 0.62 0.62 0.64 specular 0.6 exponent 90

plane normal 0 1 0 material cloth
plane point 0 0 -4.5 normal 0 0 1 material wall

instance vase material porcelain

# Fruit on a plate.
disc centre 2.35 0.06 0.9 normal 0 1 0 radius 1.05 material pewter
cone base 2.35 0.06 0.9 top 2.35 0.16 0.9 radii 1.05 1.25 material pewter
sphere radius 0.42 at 2.05 0.46 0.75 rotate 0 30 12 scale 1.25 1 1 material lemon
sphere radius 0.40 at 2.75 0.45 1.15 rotate 0 110 -10 scale 1.25 1 1 material lemon
sphere radius 0.40 at -1.9 0.40 1.9 rotate 0 65 0 scale 1.3 1 1 material lemon

"""
# Radius and height along the outside of the vase, from its foot to its lip.
PROFILE = ((0.62, 0.0), (0.70, 0.05), (0.66, 0.16), (0.72, 0.30), (0.98, 0.62), (1.20, 1.02), (1.30, 1.45), (1.24, 1.90),
           (1.02, 2.32), (0.74, 2.65), (0.54, 2.92), (0.47, 3.16), (0.50, 3.36), (0.62, 3.50), (0.70, 3.55))
AROUND, ALONG = 40, 2            # corners around; pieces between two points of the profile


def curve(t):
    """Returns the point at t on a Catmull-Rom spline through the profile, and the tangent there."""
    i = min(int(t), len(PROFILE) - 2)
    f = t - i
    p = [PROFILE[min(max(i + k, 0), len(PROFILE) - 1)] for k in (-1, 0, 1, 2)]
    at, along = [], []
    for c in (0, 1):
        p0, p1, p2, p3 = (q[c] for q in p)
        c1, c2, c3 = (p2 - p0) / 2, p0 - 2.5 * p1 + 2 * p2 - p3 / 2, (p3 - p0) / 2 + 1.5 * (p1 - p2)
        at.append(p1 + f * (c1 + f * (c2 + f * c3)))
        along.append(c1 + f * (2 * c2 + 3 * f * c3))
    return at, along


def vase():
    rings = (len(PROFILE) - 1) * ALONG + 1
    vertices, normals, uvs, faces = [], [], [], []
    for j in range(rings):
        (r, y), (dr, dy) = curve(j / ALONG)
        length = math.hypot(dr, dy)
        for i in range(AROUND):
            a = 2 * math.pi * i / AROUND
            vertices.append(f"vertex {numbers(r * math.cos(a), y, r * math.sin(a))}\n")
            normals.append(f"normal {numbers(dy / length * math.cos(a), -dr / length, dy / length * math.sin(a))}\n")
        uvs.extend(f"uv {numbers(i / AROUND, y / PROFILE[-1][1])}\n" for i in range(AROUND + 1))
    for j in range(rings - 1):
        for i in range(AROUND):
            corners = []
            for dj, di in ((0, 0), (1, 0), (1, 1), (0, 1)):
                v = (j + dj) * AROUND + (i + di) % AROUND + 1
                corners.append(f"{v}/{(j + dj) * (AROUND + 1) + i + di + 1}/{v}")
            faces.append("face " + " ".join(corners) + "\n")
    head = VASE.format(faces=2 * len(faces))
    return head + "".join(["mesh vase\n", *vertices, *normals, *uvs, *faces, "end\n"])


PICTURE_W, PICTURE_H = 96, 224
WHITE, BLUE, PALE = (238, 240, 242), (24, 52, 140), (120, 150, 208)


def petal(u, v, leaves, size):
    """Returns a negative number inside a flower around the origin, a positive one outside."""
    r, a = math.hypot(u, v), math.atan2(v, u)
    return r - size * (0.62 + 0.38 * math.cos(leaves * a))


def paint(u, v):
    """Returns the picture's colour at u, v in 0..1, with v downwards from the lip."""
    x = (u - 0.5) * 2.4          # about as wide as high on the belly
    for band, width in ((0.035, 0.012), (0.065, 0.005), (0.245, 0.006), (0.27, 0.012), (0.80, 0.012), (0.825, 0.005), (0.965, 0.02)):
        if abs(v - band) < width:
            return BLUE
    if 0.08 < v < 0.235:         # scales on the neck
        return PALE if math.sin(u * 12 * math.pi) * math.sin((v - 0.08) * 40 * math.pi) > 0.35 else WHITE
    if 0.83 < v < 0.945:         # waves on the foot
        return BLUE if abs(v - 0.888 - 0.03 * math.sin(u * 8 * math.pi)) < 0.012 else WHITE
    y = (v - 0.535) * 3.55
    flower = petal(x, y, 8, 0.62)
    if flower < 0:
        core = math.hypot(x, y)
        return BLUE if core < 0.13 or flower > -0.07 else PALE if core < 0.34 else WHITE if core < 0.19 else PALE if int(core * 14) % 2 else BLUE
    for sx in (-1.2, 1.2):       # half a flower at each edge: they meet around the vase
        for sy in (-0.55, 0.55):
            other = petal(x - sx, y - sy, 5, 0.34)
            if other < 0:
                return BLUE if other > -0.06 or math.hypot(x - sx, y - sy) < 0.07 else PALE
    vine = 0.62 * math.sin((u + 0.25) * 2 * math.pi)
    if abs(y - vine) < 0.045 or abs(y + vine) < 0.045:
        return BLUE
    return WHITE


def picture():
    grid = 4                     # samples along each side of a texel
    data = bytearray()
    for y in range(PICTURE_H):
        for x in range(PICTURE_W):
            samples = [paint((x + (i + 0.5) / grid) / PICTURE_W, (y + (j + 0.5) / grid) / PICTURE_H)
                       for i in range(grid) for j in range(grid)]
            data.extend(round(sum(s[c] for s in samples) / grid ** 2) for c in range(3))
    return b"P6\n%d %d\n255\n" % (PICTURE_W, PICTURE_H) + bytes(data)


def main():
    files = {"flake.tia": flake().encode(), "castle.tia": castle().encode(), "vase.tia": vase().encode(), "vase.ppm": picture()}
    for name, data in files.items():
        with open(os.path.join(sys.argv[1], name), "wb") as file:
            file.write(data)


main()
