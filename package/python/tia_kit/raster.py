"""The exact rasteriser: triangles with depth and stencil tests, pixel by pixel as the rules of OpenGL demand."""
from array import array
from dataclasses import dataclass, field

from .library import LOCK, TiaError, kit, numbers, why

COMPARE = ("never", "less", "equal", "lequal", "greater", "notequal", "gequal", "always")
OPERATION = ("keep", "zero", "replace", "incr", "decr", "invert", "incr_wrap", "decr_wrap")
EMPTY = 0xffffffff  # no face at this pixel


def _index(names, name):
    if name not in names:
        raise TiaError(f"{name!r} is none of {', '.join(names)}")
    return names.index(name)


@dataclass(frozen=True)
class Stencil:
    """As glStencilFunc, glStencilMask and glStencilOp, in that order."""
    test: str = "always"
    reference: int = 0
    mask: int = 255
    write: int = 255
    fail: str = "keep"
    zfail: str = "keep"
    zpass: str = "keep"

    def _numbers(self):
        return [_index(COMPARE, self.test), self.reference, self.mask, self.write,
                *(_index(OPERATION, name) for name in (self.fail, self.zfail, self.zpass))]


ALWAYS = Stencil()


@dataclass(frozen=True)
class State:
    """A depth test, as glDepthFunc, and stencil tests for both sides. The corners of front faces run counterclockwise."""
    depth: str = "less"
    depth_write: bool = True
    ties_by_face: bool = False
    skip_front: bool = False
    skip_back: bool = False
    front: Stencil = field(default=ALWAYS)
    back: Stencil = field(default=ALWAYS)

    def _numbers(self):
        return numbers([_index(COMPARE, self.depth), int(self.depth_write), int(self.ties_by_face), int(self.skip_front),
                        int(self.skip_back), *self.front._numbers(), *self.back._numbers()])


class Raster:
    """Depth and stencil buffers of 1..1024 x 1..1024 pixels, for faces 0..faces - 1."""

    def __init__(self, width, height, faces=65536):
        self.width, self.height, self._raster = width, height, None
        sizes = numbers([width, height, faces])
        if min(sizes) < 1:
            raise TiaError("a size or a number of faces below 1")
        with LOCK:
            self._raster = kit.kit_raster_create(*sizes)
            reason = None if self._raster else why()
        if reason:
            raise TiaError(reason)

    def __del__(self):
        if self._raster:
            kit.kit_raster_free(self._raster)

    def clear(self, stencil=0):
        """Empties the depth buffer, and sets all stencil values."""
        kit.kit_raster_clear(self._raster, stencil & 255)

    def triangle(self, corners, face, state=State()):
        """Draws a triangle of three corners (x, y, w): its position from the upper left corner of the image, in 1/256 of a
        pixel, and its distance from the eye, 1 or more. All are whole numbers. A face keeps its plane until clear."""
        flat = numbers(number for corner in corners for number in corner)
        if len(flat) != 9:
            raise TiaError("a triangle has three corners of three numbers")
        if not 0 <= face < 2**32:
            raise TiaError(f"face {face}: not in 0..2^32 - 1")
        with LOCK:
            status = kit.kit_raster_triangle(self._raster, state._numbers(), flat, face)
            reason = why() if status else ""
        if status:
            raise TiaError(reason)

    def faces(self):
        """The face that each pixel shows, row by row from the top, or EMPTY."""
        return array("I", kit.kit_raster_faces(self._raster)[:self.width * self.height])

    def stencil(self):
        """The stencil values, row by row from the top."""
        return bytes(kit.kit_raster_stencil(self._raster)[:self.width * self.height])
