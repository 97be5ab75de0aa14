"""films.py - a scene that moves, for the tests of films and of their parts."""
import struct
import zlib

from command import fine

WIDTH, HEIGHT, FRAMES = 40, 30, 8
SIZE = ("-s", f"{WIDTH}x{HEIGHT}")
STILL = """
camera eye {eye} 0 0 fov 25
background 0.8
material ground colour 0.6
material ball colour 1 0.5 0.2
sphere centre 0 -10004 -20 radius 10000 material ground
sphere centre 0 -1 -20 radius 3 material ball
light name lamp at {lamp} radius 3
light name other at 20 20 -20 emission 0.5 0 0
key d light 1 at 20 20 -20 radius 3
"""
MOTION = """
animate lamp at 0: -20 20 -20  1: 20 20 -20  2: 20 20 0
animate camera eye 0: 0 0 0  2: 1 0 0
"""


def scene(name, text):
    with open(name, "w", encoding="utf-8") as file:
        file.write(text)
    return name


def moving():
    return scene("film.tia", STILL.format(eye=0, lamp="-20 20 -20") + MOTION)


def contents(name):
    with open(name, "rb") as file:
        return file.read()


def lamp_at(time):
    """Where the keyframes above say that it is: two straight lines."""
    return f"{40 * time - 20} 20 -20" if time <= 1 else f"20 20 {20 * time - 40}"


def still(time, lamp=None):
    """The picture at a time, of a scene in which nothing moves."""
    scene("still.tia", STILL.format(eye=time / 2, lamp=lamp or lamp_at(time)))
    fine("-o", "still.565", *SIZE, "still.tia")
    return contents("still.565")


def film(*args, name="f%02d.565"):
    return fine("-o", name, *SIZE, "--fps", "4", *args, moving())


def frames(count=FRAMES):
    return [contents(f"f{i:02}.565") for i in range(count)]


def checksum(frame, number, first_row, rows, film):
    """Of a part's frame, as tia-join's manual has it."""
    return zlib.crc32(struct.pack("<4I", number, first_row, rows, film) + frame)


def film_of(data):
    """The S of a part's first line."""
    return int(data[:data.index(b"\n")][-8:], 16)


def yuv(frame, number, rows, film):
    """A frame of a .y4m from a .565, by the manual's formulas; // rounds down."""
    planes = ([], [], [])
    for low, high in zip(frame[0::2], frame[1::2]):
        r, g, b = high >> 3, (high & 7) << 3 | low >> 5, low & 31
        r, g, b = r << 3 | r >> 2, g << 2 | g >> 4, b << 3 | b >> 2
        planes[0].append((66 * r + 129 * g + 25 * b + 128) // 256 + 16)
        planes[1].append((-38 * r - 74 * g + 112 * b + 128) // 256 + 128)
        planes[2].append((112 * r - 94 * g - 18 * b + 128) // 256 + 128)
    line = f"FRAME XTIA={checksum(frame, number, 0, rows, film):08x}\n"
    return line.encode() + bytes(planes[0]) + bytes(planes[1]) + bytes(planes[2])
