"""Pictures as a display controller shows them: 8 bits a channel, expanded from RGB565."""
import array
import os
import re
import struct
import subprocess
import sys
import tempfile
import zlib
from functools import lru_cache

BUILD = os.path.abspath(os.environ.get('BUILD', 'build'))


class Picture:
    def __init__(self, width, height, rgb):
        self.width, self.height, self.rgb = width, height, rgb

    def __eq__(self, other):
        return isinstance(other, Picture) and vars(self) == vars(other)

    def differs(self, other):
        """What distinguishes two pictures, in words; '' when nothing does."""
        if (self.width, self.height) != (other.width, other.height):
            return '%dx%d, not %dx%d' % (self.width, self.height, other.width, other.height)
        wrong = [i for i in range(0, len(self.rgb), 3) if self.rgb[i:i + 3] != other.rgb[i:i + 3]]
        if not wrong:
            return ''
        y, x = divmod(wrong[0] // 3, self.width)
        return '%d pixels differ, the first at (%d, %d): %s, not %s' % (
            len(wrong), x, y, tuple(self.rgb[wrong[0]:wrong[0] + 3]), tuple(other.rgb[wrong[0]:wrong[0] + 3]))

    def save(self, path):
        """Writes a PNG."""
        def chunk(kind, data):
            return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))
        pitch = 3 * self.width
        rows = b''.join(b'\0' + self.rgb[i:i + pitch] for i in range(0, len(self.rgb), pitch))
        with open(path, 'wb') as out:
            head = struct.pack('>IIBBBBB', self.width, self.height, 8, 2, 0, 0, 0)
            out.write(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', head) + chunk(b'IDAT', zlib.compress(rows, 1)) +
                      chunk(b'IEND', b''))


def read_ppm(path):
    data = open(path, 'rb').read()
    head = re.match(rb'P6\s+(\d+)\s+(\d+)\s+255\s', data)
    return Picture(int(head[1]), int(head[2]), data[head.end():])


# ---- RGB565 to what is seen ----

def replicate(value):
    """8 bits a channel by bit replication: QEMU's VGA does it for RGB565, tia for XRGB8888."""
    r, g, b = value >> 11, value >> 5 & 63, value & 31
    return bytes((r << 3 | r >> 2, g << 2 | g >> 4, b << 3 | b >> 2))


def shift555(value):
    """On a 15-bit display, for which QEMU's VGA shifts, green has lost its lowest bit."""
    return bytes((value >> 11 << 3, (value >> 6 & 31) << 3, (value & 31) << 3))


@lru_cache
def table(expand):
    return [expand(value) for value in range(65536)]


def pixels565(data):
    """Little-endian RGB565 bytes as numbers."""
    pixels = array.array('H', data)
    if sys.byteorder == 'big':
        pixels.byteswap()
    return pixels


def expanded(width, height, data, expand=replicate):
    look = table(expand)
    return Picture(width, height, b''.join([look[p] for p in pixels565(data)]))


def vkms_pixel(value):
    """A pixel of vkms' composer, 16 bits a channel: A, R, G, B, scaled in fixed point and rounded."""
    channels = (value >> 11, 31), (value >> 5 & 63, 63), (value & 31, 31)
    return struct.pack('<4H', 0xffff, *(int(65535 * c / top + 0.5) for c, top in channels))


def vkms_crc(data):
    """The checksum that vkms reports for a full screen of these RGB565 pixels: the kernel's
    crc32_le, which starts from 0 and is not inverted at the end, over what it composed."""
    look = table(vkms_pixel)
    return zlib.crc32(b''.join([look[p] for p in pixels565(data)]), 0xffffffff) ^ 0xffffffff


@lru_cache(maxsize=64)
def host_frame(width, height, keys, *options):
    """The RGB565 bytes that tia on the host draws after these keys."""
    with tempfile.TemporaryDirectory() as scratch:
        path = os.path.join(scratch, 'frame.565')
        subprocess.run([os.path.join(BUILD, 'tia'), '-o', path, '-s', '%dx%d' % (width, height), '-k', keys, *options],
                       check=True, stdin=subprocess.DEVNULL)
        return open(path, 'rb').read()


@lru_cache(maxsize=1024)
def checksum(width, height, keys):
    """The checksum that tia must tell of that frame."""
    return zlib.crc32(host_frame(width, height, keys))
