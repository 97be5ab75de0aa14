"""Pictures of RGB565 pixels: their CRC, differences, files."""
import ctypes
import os
import struct
import zlib
from array import array

from .library import BYTES, PIXELS, TiaError, kit


class Picture:
    """width, height, and `pixels`: an array('H') of RGB565, row by row from the top."""

    def __init__(self, width, height, pixels):
        self.width, self.height = width, height
        self.pixels = pixels if isinstance(pixels, array) and pixels.typecode == "H" else array("H", pixels)
        if width < 1 or height < 1 or len(self.pixels) != width * height:
            raise TiaError(f"{len(self.pixels)} pixels are no picture of {width}x{height}")

    def __eq__(self, other):
        return isinstance(other, Picture) and (self.width, self.height, self.pixels) == (other.width, other.height, other.pixels)

    __hash__ = None

    def __repr__(self):
        return f"<Picture {self.width}x{self.height} {crc(self):08x}>"

    def rgb(self):
        """Bytes of 8-bit red, green and blue, as `tia` writes them to files."""
        bytes_ = (ctypes.c_uint8 * (3 * len(self.pixels)))()
        kit.kit_expand(_address(self), len(self.pixels), bytes_)
        return bytes(bytes_)


def _address(picture):
    return ctypes.cast(picture.pixels.buffer_info()[0], PIXELS)


def crc(picture):
    """The CRC-32 that `tia --checksum` prints of the picture, as a number."""
    return kit.kit_crc(_address(picture), len(picture.pixels))


def compare(a, b):
    """Returns the number of pixels that differ, and a picture of them as (width, height, bytes of 8-bit RGB): red where a
    channel differs by more than one level, yellow where none does, and what agrees in grey. TiaError for two sizes."""
    if (a.width, a.height) != (b.width, b.height):
        raise TiaError(f"{a.width}x{a.height} and {b.width}x{b.height} pixels: the sizes differ")
    rgb = (ctypes.c_uint8 * (3 * len(a.pixels)))()
    differing = kit.kit_compare(_address(a), _address(b), len(a.pixels), ctypes.cast(rgb, BYTES))
    return differing, (a.width, a.height, bytes(rgb))


def _png(width, height, rgb):
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    lines = b"".join(b"\0" + rgb[3 * width * y:3 * width * (y + 1)] for y in range(height))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(lines)) + chunk(b"IEND", b""))


def save(path, picture):
    """Writes a Picture, or the second result of compare, to a .png or .ppm file; its directory is made."""
    width, height, rgb = (picture.width, picture.height, picture.rgb()) if isinstance(picture, Picture) else picture
    path = os.fspath(path)
    if not path.endswith((".png", ".ppm")):
        raise TiaError(f"{path}: neither .png nor .ppm")
    data = _png(width, height, rgb) if path.endswith(".png") else b"P6\n%d %d\n255\n" % (width, height) + rgb
    os.makedirs(os.path.dirname(path) or ".", exist_ok=True)
    with open(path, "wb") as file:
        file.write(data)


def load(path):
    """Reads a .ppm file that save or `tia` wrote. TiaError for others, and for colours that are no expanded RGB565."""
    with open(path, "rb") as file:
        parts = file.read().split(b"\n", 3)
    size = parts[1].split() if len(parts) == 4 else []
    if parts[0] != b"P6" or len(size) != 2 or not (size[0].isdigit() and size[1].isdigit()) or parts[2] != b"255":
        raise TiaError(f"{path}: not a .ppm file that tia wrote")
    width, height = int(size[0]), int(size[1])
    if len(parts[3]) != 3 * width * height:
        raise TiaError(f"{path}: cut off")
    picture = Picture(width, height, [(r >> 3) << 11 | (g >> 2) << 5 | b >> 3 for r, g, b in zip(*[iter(parts[3])] * 3)])
    if picture.rgb() != parts[3]:
        raise TiaError(f"{path}: its colours are not those of RGB565")
    return picture


def assert_same(picture, golden, difference="difference.png"):
    """AssertionError if two pictures differ in a pixel, with the first one, the CRCs, and the file `difference`: the picture of
    compare."""
    differing, seen = compare(picture, golden)
    if not differing:
        return
    at = next(i for i, (a, b) in enumerate(zip(picture.pixels, golden.pixels)) if a != b)
    save(difference, seen)
    raise AssertionError(f"{differing} of {len(golden.pixels)} pixels differ, the first at ({at % golden.width}, "
                         f"{at // golden.width}): {picture.pixels[at]:04x}, not {golden.pixels[at]:04x}; CRC {crc(picture):08x}, "
                         f"not {crc(golden):08x}; see {difference}")
