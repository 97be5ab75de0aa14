"""Scenes drawn."""
import ctypes
import os
from array import array

from .library import LOCK, PIXELS, READ_FILE, SIZE_OF_FILE, TiaError, kit, numbers, why
from .picture import Picture

INTEGRATORS = ("whitted", "ao", "path")
MOST = 8192
FILE_MOST = 2**31 - 1


class _Files:
    """The files of a scene: those of a dictionary, and without one those of the disk."""

    def __init__(self, files):
        self.files = None if files is None else {name: bytes(content) for name, content in files.items()}
        self.kept = {}
        self.callbacks = SIZE_OF_FILE(self.size), READ_FILE(self.read)

    def size(self, name, length):
        name = ctypes.string_at(name, length)
        try:
            if self.files is not None:
                content = self.files[os.fsdecode(name)]
            elif os.path.isfile(name):
                with open(name, "rb") as file:
                    content = file.read(FILE_MOST)
            else:
                return -1
        except (OSError, KeyError, MemoryError):
            return -1
        self.kept[name] = content
        return len(content)

    def read(self, name, length, to):
        content = self.kept.pop(ctypes.string_at(name, length))
        ctypes.memmove(to, content, len(content))


def _options(size, integrator, samples, seed, dither, time):
    if integrator is not None and integrator not in INTEGRATORS:
        raise TiaError(f"integrator: {integrator!r} is none of {', '.join(INTEGRATORS)}")
    width, height = size
    return numbers([width, height, -1 if integrator is None else INTEGRATORS.index(integrator), samples,
                    -1 if seed is None else seed, int(bool(dither)), round(time * 65536)])


def draw(scene, size, *, files=None, integrator=None, samples=0, seed=None, dither=False, time=0):
    """Draws a scene file as `tia -n 1 -s WIDTHxHEIGHT SCENE` does, and returns a Picture.

    `scene` is a path (.tia, .nff, .obj), `size` is (width, height). With `files`, a dictionary of names to bytes, the scene and
    all that it refers to come from there and nothing from the disk. `integrator`, `dither` and `time` (seconds) are the
    command's options of these names, `samples` is --spp for ao and path and --samples else, and `seed` replaces the scene's. TiaError has the reason of a refusal."""
    options = _options(size, integrator, samples, seed, dither, time)
    if not 1 <= options[0] <= MOST or not 1 <= options[1] <= MOST:
        raise TiaError(f"size: {options[0]}x{options[1]} is not in 1x1..{MOST}x{MOST}")
    pixels = array("H", bytes(2 * options[0] * options[1]))
    there = _Files({os.fspath(name): content for name, content in files.items()} if files is not None else None)
    with LOCK:
        kit.kit_set_files(*there.callbacks)
        status = kit.kit_draw(os.fsencode(scene), options, ctypes.cast(pixels.buffer_info()[0], PIXELS))
        reason = why() if status else ""
    if status:
        raise TiaError(reason)
    return Picture(options[0], options[1], pixels)
