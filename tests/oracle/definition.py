#!/usr/bin/python3
"""Pictures of balls by the formulas of docs/definition.md alone, to compare with tia's.

Every number is a value with a bound on its error. Doubles decide most pixels. A pixel with a comparison that they
leave open is computed again with 256 binary digits, and then with 1500. Lengths are in units of 2^-16, so that all
lengths of a scene are integers; apart from the bias, the formulas do not depend on the unit.

    definition.py SCENE.json|SCENE.tia WIDTHxHEIGHT [--dither] [--keys KEYS] [--output FILE.565] [--pixels X,Y ...]
"""
import argparse
import sys
import zlib

import gmpy2
import numpy as np

import definition_scene

LEVELS = (53, 256, 1500)
BIAS = 8  # 2^-13 in units of 2^-16
MAXIMA = np.array([[31], [63], [31]])
BAYER = np.array([[0, 32, 8, 40, 2, 34, 10, 42], [48, 16, 56, 24, 50, 18, 58, 26], [12, 44, 4, 36, 14, 46, 6, 38],
                  [60, 28, 52, 20, 62, 30, 54, 22], [3, 35, 11, 43, 1, 33, 9, 41], [51, 19, 59, 27, 49, 17, 57, 25],
                  [15, 47, 7, 39, 13, 45, 5, 37], [63, 31, 55, 23, 61, 29, 53, 21]])


class Level:
    """The arithmetic in use: doubles, or gmpy2's numbers in arrays of objects. Both round to nearest."""

    @classmethod
    def use(cls, bits):
        gmpy2.get_context().precision = cls.bits = bits
        cls.type = float if bits == 53 else object
        cls.number = float if bits == 53 else gmpy2.mpfr
        cls.zero, cls.one, cls.inf = (cls.number(i) for i in ("0", "1", "inf"))
        cls.unit = cls.one / 2**bits
        cls.grow = 1 + 16 * cls.unit

    @classmethod
    def apply(cls, function, values):
        return np.frompyfunc(function, 1, 1)(values).astype(cls.type)


class Balls:
    """An array of numbers, m, with bounds, e: the true value X has |X - m| <= e. A vector or colour is a row of three.

    Rounding to nearest gives |fl(x) - x| <= u |fl(x)| with u = 2^-bits: the term `unit |m|` below. A bound is a sum of
    terms >= 0 computed with fewer than 10 roundings, each by a factor of at least 1 - u, so the factor 1 + 16 u makes
    it an upper bound again. Nothing underflows: a value that is not 0 is at least a rounding error of at most 8
    factors above 2^-31, far above 2^-1000. A bound that is infinite or not a number decides nothing.
    """

    def __init__(self, m, e):
        self.m, self.e = m, e

    @staticmethod
    def rounded(m, e):
        return Balls(m, (e + Level.unit * abs(m)) * Level.grow)

    def __add__(self, b):
        return self.rounded(self.m + b.m, self.e + b.e)

    def __sub__(self, b):
        return self.rounded(self.m - b.m, self.e + b.e)

    def __mul__(self, b):
        # XY - mn = m(Y - n) + n(X - m) + (X - m)(Y - n)
        return self.rounded(self.m * b.m, abs(self.m) * b.e + abs(b.m) * self.e + self.e * b.e)

    def __truediv__(self, b):
        # X/Y - m/n = ((X - m) - (m/n)(Y - n))/Y, and |Y| >= |n| - e
        sure = (abs(b.m) > 2 * b.e).astype(bool)
        n, least = np.where(sure, b.m, Level.one), np.where(sure, abs(b.m) - b.e, Level.one)
        q = self.m / n
        return self.rounded(q, np.where(sure, (self.e + abs(q) * b.e) / least, Level.inf))

    def sqrt(self):
        # For X >= 0: |sqrt X - sqrt m| = |X - m|/(sqrt X + sqrt m) <= e/sqrt m
        m = np.maximum(self.m, Level.zero)
        s = np.sqrt(m) if Level.bits == 53 else Level.apply(gmpy2.sqrt, m)
        some = (s > 0).astype(bool)
        e = np.where(some, self.e / np.where(some, s, Level.one), Level.inf)
        return self.rounded(s, np.where((self.e == 0).astype(bool), Level.zero, e))

    def sum(self):
        return self[0] + self[1] + self[2]

    def __getitem__(self, chosen):
        return Balls(self.m[chosen], self.e[chosen])

    def __setitem__(self, chosen, b):
        self.m[chosen], self.e[chosen] = b.m, b.e


def balls(integers, shift=0):
    """The numbers integer/2^shift. Integers of more digits than the level's are rounded."""
    integers = np.array(integers, dtype=object)
    m = Level.apply(Level.number, integers)
    e = np.where((m == integers).astype(bool), Level.zero, Level.unit * abs(m))
    return Balls(m / 2**shift, e / 2**shift)


def column(integers, shift=0):
    return balls([[i] for i in integers], shift)


def largest(*values):
    """The largest absolute value. Its error is at most the largest one."""
    m, e = abs(values[0].m), values[0].e
    for value in values[1:]:
        m, e = np.maximum(m, abs(value.m)), np.maximum(e, value.e)
    return Balls(m, e)


def settle(x, scale):
    """The tie rule: x is 0 where it is exactly 0, or |X| < 2^-400 scale, which only the last level shows. The factors
    1/2 and 2 cover the rounding of this comparison itself; in between x is left open, by an infinite bound."""
    low, high = (scale.m - scale.e) / 2**401, (scale.m + scale.e) / 2**399
    equal = ((abs(x.m) + x.e < low) | ((x.m == 0) & (x.e == 0))).astype(bool)
    apart = (abs(x.m) - 2 * x.e > high).astype(bool)
    return Balls(np.where(equal, Level.zero, x.m), np.where(equal, Level.zero, np.where(apart, x.e, Level.inf)))


def positive(x, at_zero=0.0):
    """Truth of X > 0, or with at_zero=1 of X >= 0: 1 yes, 0 no, 1/2 open, so that np.minimum is `and`. Where |m| > 2e,
    X has the sign of m; where both are 0, X is 0."""
    truth = np.full(x.m.shape, 0.5)
    truth[(x.m > 2 * x.e).astype(bool)] = 1
    truth[(x.m < -2 * x.e).astype(bool)] = 0
    truth[((x.m == 0) & (x.e == 0)).astype(bool)] = at_zero
    return truth


class Picture:
    """A picture of a scene; pixels() is its entry."""

    def __init__(self, scene, width, height, dither):
        self.width, self.height, self.dither, self.fov = width, height, dither, scene["camera"]["fov"]
        self.background, self.materials, self.digits, things = scene["background"], scene["materials"], None, []
        for thing in scene["spheres"] + scene["lights"]:
            centre = [i - j for i, j in zip(thing["centre"], scene["camera"]["eye"])]
            things.append({**thing, "centre": centre, "c": sum(i * i for i in centre) - thing["radius"]**2})
        n = len(scene["spheres"])
        self.things, self.spheres, self.lights = things, things[:n], things[n:]

    def rays(self, x, y):
        """v. The cotangent is computed with 64 digits more; it multiplies relative errors of its argument z by
        2z/sin 2z < 18 for F <= 170, so 2u covers these and the final rounding."""
        v = balls([2 * x + 1 - self.width, self.height - 2 * y - 1, np.full(len(x), -self.height)])
        if self.fov != 90 * 65536:
            gmpy2.get_context().precision = Level.bits + 64
            z = -self.height * gmpy2.cot(gmpy2.const_pi() * self.fov / (360 * 65536))
            gmpy2.get_context().precision = Level.bits
            v.m[2] = float(z) if Level.bits == 53 else +z
            v.e[2] = 2 * Level.unit * abs(v.m[2])
        return v

    def meet(self, thing, v, vv):
        """Truth that the rays meet a ball or a light; t there; and the largest part of t."""
        parts = column(thing["centre"]) * v
        b = settle(parts.sum(), largest(*parts))
        left, right = b * b, balls([thing["c"]]) * vv
        d = settle(left - right, largest(left, right))
        root, size = d.sqrt() / vv, b / vv
        if thing["c"] < 0:
            return np.ones(len(b.m)), size + root, largest(size, root)
        return np.minimum(positive(b, 1.0), positive(d, 1.0)), size - root, largest(size)

    def visible(self, v):
        """The visible object's index, lights after spheres, -1 for none; its t; and which pixels are open."""
        n, vv = len(v.m[0]), (v * v).sum()
        index, unsure, best, size = np.full(n, -1), np.zeros(n, bool), balls([0] * n), balls([0] * n)
        for i, thing in enumerate(self.things):
            if thing["radius"] == 0:
                continue
            hit, t, part = self.meet(thing, v, vv)
            nearer = positive(settle(best - t, largest(size, part)))
            truth = np.minimum(hit, np.where(index < 0, 1.0, nearer))
            take, unsure = truth == 1, unsure | (truth == 0.5)
            index[take] = i
            best[take], size[take] = t[take], part[take]
        return index, best, unsure

    def blocks(self, sphere, light, start, w):
        """Truth that a ball blocks the light on its way from start along w."""
        inside = sum((i - j)**2 for i, j in zip(sphere["centre"], light["centre"])) <= sphere["radius"]**2
        if sphere["c"] < 0:
            return np.full(len(w.m[0]), 0.0 if inside else 1.0)
        way, ww = column(sphere["centre"]) - start, (w * w).sum()
        square = largest(*way, *w) * largest(*way, *w)
        a = settle((way * w).sum(), square)
        h = (way * way).sum() - balls([sphere["radius"]**2])
        reach = settle(a * a - h * ww, square * square)
        before = 1.0 if inside else positive(settle(ww - a, square))
        return np.minimum(np.minimum(positive(a), positive(reach, 1.0)), before)

    def arriving(self, light, p, n):
        """E T (N.w)/|w|, which is 0 where the light is not in J; and which pixels are open."""
        q = column(light["centre"])
        w = q - p
        # The parts of N.w are N_i Q_i and N_i P_i: w itself can be 0, and then has no digits to compare with.
        cosine = settle((n * w).sum(), largest(*n * q, *n * p))
        lit = positive(cosine)
        unsure, chosen = lit == 0.5, np.flatnonzero(lit == 1)
        w, start = w[:, chosen], p[:, chosen] + balls([BIAS]) * n[:, chosen]
        part = column(light["emission"], 30) * (cosine[chosen] / (w * w).sum().sqrt())
        for sphere in self.spheres:
            blocked = self.blocks(sphere, light, start, w)
            unsure[chosen[blocked == 0.5]] = True
            part[:, blocked == 1] *= column(self.materials[sphere["material"]]["transmission"], 30)
        result = balls(np.zeros((3, len(lit)), int))
        result[:, chosen] = part
        return result, unsure

    def shade(self, thing, t, v, d):
        """Values of the channels of a visible ball; and which pixels are open."""
        p, centre, material = t * v, column(thing["centre"]), self.materials[thing["material"]]
        n = (p - centre if thing["c"] >= 0 else centre - p) / balls([thing["radius"]])
        total, unsure = balls(np.zeros((3, len(d)), int)), np.zeros(len(d), bool)
        for light in self.lights:
            part, openly = self.arriving(light, p, n)
            unsure |= openly
            total += column(material["colour"], 30) * part
        s = column(material["emission"], 30) + total
        s = Balls(np.minimum(s.m, Level.one), s.e)  # min(1, X) is as near to min(1, m) as X to m
        self.digits = balls(MAXIMA) * s + balls(d, 7)
        nearest = np.rint(self.digits.m) if Level.bits == 53 else Level.apply(gmpy2.rint, self.digits.m)
        reached = positive(settle(self.digits - Balls(nearest, 0 * nearest), balls(MAXIMA)), 1.0)
        none = ((total.m == 0) & (total.e == 0)).astype(bool)
        values = np.where(none, levels(material["emission"], d), nearest.astype(int) - (reached == 0))
        return values, unsure | ((reached == 0.5) & ~none).any(axis=0)

    def pixels(self, x, y):
        """RGB565 of pixels by the level's arithmetic; and which are open."""
        v = self.rays(x, y)
        index, t, unsure = self.visible(v)
        d = 2 * BAYER[y % 8, x % 8] + 1 if self.dither else np.full(len(x), 64)
        result = np.zeros(len(x), np.int64)
        for i in np.unique(index[~unsure]):
            chosen = np.flatnonzero((index == i) & ~unsure)
            if 0 <= i < len(self.spheres):
                values, openly = self.shade(self.things[i], t[chosen], v[:, chosen], d[chosen])
                unsure[chosen[openly]] = True
            else:
                values = levels(self.background if i < 0 else self.things[i]["emission"], d[chosen])
            result[chosen] = values[0] * 2048 + values[1] * 32 + values[2]
        return result, unsure


def levels(colour, d):
    """floor(n min(1, S) + d) of a colour of the scene, exactly in integers; d is in 128ths."""
    return (MAXIMA * np.minimum(np.array([[i] for i in colour]), 2**30) * 128 + d * 2**30) // 2**37


def draw(scene, width, height, dither=False, pixels=None, counts=None):
    """RGB565 of all pixels, or of a list of (x, y). A pixel that no level decides raises ValueError."""
    picture = Picture(scene, width, height, dither)
    places = np.array(pixels or [(x, y) for y in range(height) for x in range(width)], np.int64)
    result, todo = np.zeros(len(places), np.int64), np.arange(len(places))
    for bits in LEVELS:
        Level.use(bits)
        still = [todo[:0]]
        for part in np.array_split(todo, len(todo) // 65536 + 1) if len(todo) else []:
            with np.errstate(all="ignore"):
                result[part], unsure = picture.pixels(*places[part].T)
            still.append(part[unsure])
        todo = np.concatenate(still)
        if counts is not None:
            counts.append(len(todo))
    if len(todo):
        raise ValueError(f"{len(todo)} undecided pixels, the first at {tuple(places[todo[0]])}")
    return result.astype("<u2")


def digits_of(scene, width, height, dither, x, y):
    """n min(1, S) + d of the channels of a pixel on a ball, with 1500 binary digits; an empty list elsewhere."""
    picture = Picture(scene, width, height, dither)
    Level.use(LEVELS[-1])
    picture.pixels(np.array([x]), np.array([y]))
    return picture.digits.m[:, 0] if picture.digits else []


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name, default in (("scene", None), ("size", None), ("--keys", ""), ("--output", None)):
        parser.add_argument(name, default=default)
    parser.add_argument("--dither", action="store_true")
    parser.add_argument("--pixels", nargs="+", type=lambda pixel: tuple(map(int, pixel.split(","))))
    options = parser.parse_args()
    scene = definition_scene.read(options.scene, options.keys)
    width, height = map(int, options.size.split("x"))
    picture = draw(scene, width, height, options.dither, options.pixels)
    for pixel, value in zip(options.pixels or [], picture):
        print(*pixel, value >> 11, value >> 5 & 63, value & 31)
    picture.tofile(options.output or "/dev/null")
    print(f"{zlib.crc32(picture.tobytes()):08x}")


if __name__ == "__main__":
    sys.exit(main())
