"""Pictures with the same bits on every machine, for tests: draw, crc, compare, assert_same, and the exact rasteriser.

    from tia_kit import assert_same, draw, load
    assert_same(draw("scene.tia", (160, 120)), load("golden.ppm"), "build/difference.png")

All of it is documented in docs/kit.md of tia."""
from .picture import Picture, assert_same, compare, crc, load, save
from .library import TiaError, version
from .render import draw
from .raster import ALWAYS, EMPTY, Raster, Stencil, State

__all__ = ["ALWAYS", "EMPTY", "Picture", "Raster", "State", "Stencil", "TiaError", "assert_same", "compare", "crc", "draw", "load",
           "save", "version"]
__version__ = version()
