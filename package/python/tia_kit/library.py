"""The shared library, tools/kit/kit.h, by ctypes."""
import ctypes
import os
import threading
from ctypes import POINTER, c_char_p, c_int, c_int32, c_size_t, c_uint8, c_uint16, c_uint32, c_void_p


class TiaError(ValueError):
    """A scene, an option or a state that is refused, with the reason in one line."""


SIZE_OF_FILE = ctypes.CFUNCTYPE(c_int32, c_void_p, c_uint32)
READ_FILE = ctypes.CFUNCTYPE(None, c_void_p, c_uint32, c_void_p)
PIXELS, BYTES, NUMBERS = POINTER(c_uint16), POINTER(c_uint8), POINTER(c_int32)
LOCK = threading.Lock()  # the library is for one thread at a time

FUNCTIONS = {
    "kit_version": (c_char_p, []),
    "kit_why": (c_char_p, []),
    "kit_set_files": (None, [SIZE_OF_FILE, READ_FILE]),
    "kit_draw": (c_int, [c_char_p, NUMBERS, PIXELS]),
    "kit_crc": (c_uint32, [PIXELS, c_uint32]),
    "kit_expand": (None, [PIXELS, c_uint32, BYTES]),
    "kit_compare": (c_uint32, [PIXELS, PIXELS, c_uint32, BYTES]),
    "kit_raster_create": (c_void_p, [c_uint32, c_uint32, c_uint32]),
    "kit_raster_free": (None, [c_void_p]),
    "kit_raster_clear": (None, [c_void_p, c_uint32]),
    "kit_raster_triangle": (c_int, [c_void_p, NUMBERS, NUMBERS, c_uint32]),
    "kit_raster_faces": (POINTER(c_uint32), [c_void_p]),
    "kit_raster_stencil": (BYTES, [c_void_p]),
}


def _load():
    loaded = ctypes.CDLL(os.path.join(os.path.dirname(os.path.abspath(__file__)), "libtia-kit.so"))
    for name, (result, arguments) in FUNCTIONS.items():
        function = getattr(loaded, name)
        function.restype, function.argtypes = result, arguments
    return loaded


kit = _load()


def version():
    """The version of tia."""
    return kit.kit_version().decode()


def why():
    """The reason of the library's last error."""
    return kit.kit_why().decode(errors="replace")


def numbers(values):
    """An array of 32-bit integers; TiaError for what is none."""
    values = list(values)
    for value in values:
        if not isinstance(value, int) or not -2**31 <= value < 2**31:
            raise TiaError(f"{value!r}: not a whole number of 32 bits")
    return (c_int32 * len(values))(*values)
