#!/usr/bin/python3
"""Scenes in which comparisons of docs/definition.md have equal sides, as files DIRECTORY/tie-NAME.WIDTHxHEIGHT.tia.

    definition_ties.py DIRECTORY
"""
import os
import sys

import definition_check

ONE, FULL = 65536, 2**30
RED, GREEN, GREY, WHITE, GLOW = 0, 1, 2, 3, 4
MATERIALS = [([FULL, 0, 0], [0, 0, 0]), ([0, FULL, 0], [0, 0, 0]), ([FULL // 2] * 3, [0, 0, 0]),
             ([FULL] * 3, [0, 0, 0]), ([0, 0, 0], [FULL // 2, FULL * 37 // 128, FULL * 101 // 128])]


def units(*values):
    return [round(v * ONE) for v in values]


def sphere(x, y, z, r, material):
    return {"centre": units(x, y, z), "radius": round(r * ONE), "material": material}


def light(x, y, z, r=0, emission=(FULL, FULL, FULL)):
    return {"centre": units(x, y, z), "radius": round(r * ONE), "emission": list(emission)}


def scene(spheres, lights, fov=90.0, eye=(0, 0, 0), background=(FULL // 2, FULL // 128 * 55, FULL // 128 * 99)):
    materials = [{"colour": colour, "transmission": [0, 0, 0], "emission": emission}
                 for colour, emission in MATERIALS]
    materials.append({"colour": [FULL] * 3, "transmission": [FULL // 2, FULL // 4, FULL], "emission": [0, 0, 0]})
    moved = [{**s, "centre": [a + b for a, b in zip(s["centre"], units(*eye))]} for s in spheres + lights]
    return {"camera": {"eye": units(*eye), "fov": round(fov * ONE)}, "background": list(background),
            "materials": materials, "spheres": moved[:len(spheres)], "lights": moved[len(spheres):]}


def order(fov):
    """Balls, and a ball and a light, at equal distances."""
    far = light(-3, 8, 2)
    pair = [sphere(-1, 0, -5, 1.5, RED), sphere(1, 0, -5, 1.5, GREEN)]
    diagonal = [sphere(1, 0, -5, 1.5, RED), sphere(0, 1, -5, 1.5, GREEN)]
    twice = [sphere(0.5, 0.25, -5, 2, RED), sphere(0.5, 0.25, -5, 2, GREEN)]
    yield "mirror", "61x41", scene(pair, [light(0, 8, 2)], fov)
    yield "mirror-turned", "61x41", scene(pair[::-1], [light(0, 8, 2)], fov, (1.5, -0.25, 3))
    yield "diagonal", "60x60", scene(diagonal, [far], fov)
    yield "twice", "40x30", scene(twice, [far], fov)
    yield "twice-turned", "41x31", scene(twice[::-1], [far], fov)
    yield "light-and-ball", "40x30", scene(twice[:1], [light(0.5, 0.25, -5, 2, (FULL // 2, FULL // 3, 0)), far], fov)
    yield "lights", "41x31", scene([sphere(0, 0, -9, 1, RED)], [light(-1, 0, -5, 1.5, (FULL, 0, 0)),
                                                                light(1, 0, -5, 1.5, (0, FULL, 0))], fov)


def tangents(fov):
    """A view ray that touches a ball: at the centre of the picture, and along (2, 3, -6)."""
    yield "tangent", "41x31", scene([sphere(2, 0, -10, 2, GREY)], [light(-3, 1, 5)], fov)
    yield "tangents", "41x31", scene([sphere(2, 0, -10, 2, RED), sphere(0, 2, -10, 2, GREEN),
                                      sphere(0, 0, -15, 2, GREY)], [light(-3, 1, 5)], fov)
    touching = sphere(2 * 2 + 3 * 0.125, 3 * 2 - 6 * 0.125, -6 * 2 - 2 * 0.125, 7 * 0.125, GREY)
    yield "tangent-236", "43x30", scene([touching], [light(3, -30, -5)], fov)


def eyes(fov):
    """An eye on a ball: before it, beside it, on two."""
    before, beside = sphere(0, 0, -3, 3, GREY), sphere(3, 0, 0, 3, RED)
    lights = [light(1, 2, 8, 0.5), light(2, 9, -3)]
    yield "eye-on", "41x31", scene([before], lights, fov, (2.5, 1, 0))
    yield "eye-beside", "41x31", scene([beside, sphere(0, 0, -9, 2, GREEN)], lights, fov)
    yield "eye-on-two", "41x31", scene([beside, before, sphere(0, 0, -9, 2, GREEN)], lights, fov)
    yield "eye-on-twice", "41x31", scene([sphere(3, 0, 0, 3, GREEN), beside], lights, fov)
    above = light(0, 3, 0, 3, (FULL, 0, 0))
    yield "eye-on-light", "41x31", scene([sphere(0, 0, -9, 2, GREEN)], [above, lights[0]], fov)


def places(fov):
    """A light on the visible ball, on another one, and in the plane that touches the ball."""
    ball = sphere(0, 0, -20, 3, GREY)
    yield "light-on", "41x31", scene([ball], [light(0, 0, -17), light(3, 0, -20)], fov)
    yield "light-on-round", "41x31", scene([ball], [light(0, 3, -20, 0.5)], fov)
    other = sphere(6, 0, -14, 3, RED)
    yield "light-on-other", "41x31", scene([ball, other], [light(3, 0, -14), light(6, 3, -14)], fov)
    yield "light-aside", "41x31", scene([ball], [light(5, 0, -17), light(0, -5, -17)], fov)
    yield "light-in", "41x31", scene([ball, sphere(5, 1, -14, 2, RED)], [light(5, 1, -14), light(4, 1, -13)], fov)


def shadows(fov):
    """Equal sides in shadows, at the centre of the picture, where P = (0, 0, -17) and N = (0, 0, 1)."""
    ball, bias = sphere(0, 0, -20, 3, GREY), 2.0**-13
    touched = sphere(4 + 3 / 4, 0, -17 + bias + 3 - 1, 1.25, 5)
    yield "edge", "41x31", scene([ball, touched], [light(12, 0, -8)], fov)
    yield "edge-less", "41x31", scene([ball, {**touched, "radius": touched["radius"] - 1}], [light(12, 0, -8)], fov)
    at_end = sphere(12 - 3 / 4, 0, -8 + bias + 1, 1.25, 5)
    yield "end", "41x31", scene([ball, at_end], [light(12, 0, -8)], fov)
    past = {**at_end, "radius": at_end["radius"] + 1}
    yield "end-past", "41x31", scene([ball, past], [light(12, 0, -8)], fov)
    at_end = sphere(12 + 3 / 4, 0, -8 + bias - 1, 1.25, 5)
    yield "end-in", "41x31", scene([ball, at_end], [light(12, 0, -8)], fov)
    behind = sphere(0, 0, -17 + bias, 2.0**-10, 5)
    yield "centre-at-start", "41x31", scene([ball, behind], [light(12, 0, -8)], fov)
    # Beside the centre: P = (4, 6, -12), seen along (2, 3, -6); the light's direction is at right angles to A.
    slanted = sphere(4, 6, -14, 2, GREY)
    beside = {"centre": [4 * ONE + 20, 6 * ONE + 60, -12 * ONE + 38], "radius": 70, "material": 5}
    for name, radius in (("start", 70), ("start-in", 71)):
        yield name, "43x30", scene([slanted, {**beside, "radius": radius}], [light(-5, 6, -6)], fov)


def halves(fov):
    """Channels of exactly k + 1/2 without dithering, or an integer with it: by emission, and by light."""
    yield "half-emission", "41x31", scene([sphere(0, 0, -5, 3, GLOW)], [], fov)
    yield "half-light", "41x31", scene([sphere(0, 0, -5, 3, WHITE)],
                                       [light(0, 0, 0, 0, (FULL // 2, FULL * 37 // 128, FULL * 101 // 128))], fov)
    parts = [light(0, 0, z, 0, (FULL // 4, FULL * 13 // 128, FULL * 99 // 128)) for z in (0, 1)]
    yield "half-lights", "41x31", scene([sphere(0, 0, -5, 3, WHITE)], parts, fov)
    yield "half-round", "41x31", scene([], [light(0, 0, -9, 4, (FULL // 2, FULL * 91 // 128, 2**31 - 1))], fov)
    three = [light(3, 0, 2, 0, (FULL * 5 // 8, FULL * 15 // 128, FULL * 55 // 128))]  # its cosine is 4/5 at the centre
    yield "half-cosine", "41x31", scene([sphere(0, 0, -5, 3, WHITE)], three, fov)


def insides(fov):
    """An eye in a ball, in two, and in a light; lights in the ball, outside of it, and on it."""
    around, near = sphere(1, 2, 0.5, 9, GREY), sphere(0, 0, -4, 1, WHITE)
    twice = [around, {**around, "material": GREEN}]
    yield "in-centre-twice", "41x31", scene([{**s, "centre": [0, 0, 0]} for s in twice], [light(1, 2, -3)], fov)
    yield "in-twice", "41x31", scene(twice, [light(1, 2, -3)], fov)
    yield "in-light-outside", "40x30", scene([{**around, "material": 5}], [light(1, 20, -3, 0.5)], fov)
    yield "in-nested", "40x30", scene([around, near, sphere(0, -1, -100, 50, RED)],
                                      [light(1, 4, -3, 0.5), light(0, 30, 0)], fov)
    yield "in-light", "40x30", scene([near], [light(0, 1, 0, 20, (FULL, FULL // 2, 0)), light(3, 3, -2)], fov)
    yield "in-light-on", "41x30", scene([sphere(0, 0, 0, 5, WHITE)], [light(3, 0, -4), light(0, 0, 5)], fov)


def main(directory):
    for fov in (90.0, 25.0, 61.5):
        for group in (order, tangents, eyes, places, shadows, halves, insides):
            for name, size, made in group(fov):
                definition_check.write(made, os.path.join(directory, f"tie-{name}-{fov:g}.{size}.tia"))


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
