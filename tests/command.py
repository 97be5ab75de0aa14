"""What the tests of the command share: running it, reading its pictures, reporting cases."""
import os
import re
import resource
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
import traceback
import zlib
from array import array
from contextlib import contextmanager

from cases import chosen

QUICK = "CHECK_QUICK" in os.environ  # make check-quick: fewer cases of those that take long
TIA = os.path.abspath(os.path.join(os.environ.get("BUILD", "build"), "tia"))
# What a script starts in the background, or nohup, has signals ignored; the command leaves that so.
for ignored in (signal.SIGINT, signal.SIGQUIT, signal.SIGHUP, signal.SIGTERM):
    if signal.getsignal(ignored) == signal.SIG_IGN:
        signal.signal(ignored, signal.SIG_DFL)

LIMIT_S = 60            # far more than any case needs: only a hang takes that long


def make_files(root):
    """The Makefile, and the files of the tree that it includes."""
    with open(os.path.join(root, "Makefile"), encoding="utf-8") as file:
        return ["Makefile", *re.findall(r"^include (\S+)$", file.read(), re.M)]


class Skip(Exception):
    """The case cannot run here; the text names what is missing."""


def check(condition, text):
    if not condition:
        raise AssertionError(text)


def same(got, want, what):
    check(got == want, f"{what} is {got!r}, not {want!r}")


def tia(*args, **options):
    """Runs the command without a terminal; stdout and stderr are captured as bytes."""
    options.setdefault("stdout", subprocess.PIPE)
    options.setdefault("timeout", LIMIT_S)
    return subprocess.run([TIA, *args], stdin=subprocess.DEVNULL, stderr=subprocess.PIPE, start_new_session=True,
                          **options)


@contextmanager
def started(*args, **options):
    """The command while it runs; whatever happens, nothing stays behind."""
    running = subprocess.Popen([TIA, *args], stdin=subprocess.DEVNULL, stderr=options.pop("stderr", subprocess.PIPE),
                               **options)
    try:
        yield running
    finally:
        running.kill()
        running.communicate()


def status_of(running):
    """Its exit status, soon."""
    try:
        return running.wait(timeout=LIMIT_S)
    except subprocess.TimeoutExpired:
        raise AssertionError(f"it still runs after {LIMIT_S} s") from None


def wait_for(condition, what):
    end = time.monotonic() + LIMIT_S
    while not condition():
        check(time.monotonic() < end, f"{what} did not happen")
        time.sleep(0.002)


def fine(*args, **options):
    """Must succeed without a word on standard error; returns standard output."""
    done = tia(*args, **options)
    same(done.returncode, 0, f"the status of {args} ({done.stderr.decode()})")
    same(done.stderr, b"", f"the standard error of {args}")
    return (done.stdout or b"").decode()


def message_of(tool):
    """A pattern: a message, and perhaps the line of a scene with a mark below it."""
    return rf"({re.escape(tool)}: .*\n( *[0-9]+ \| .*\n +\| .*\n)?)"


def is_message(text, tool):
    return bool(re.fullmatch(message_of(tool), text))


def refused(status, *args, says="", **options):
    """Must fail with `status` and one message, which has `says` in it, or several with lines of a scene below them, and leave no
    file behind."""
    before = sorted(os.listdir("."))
    done = tia(*args, **options)
    text = done.stderr.decode()
    same(done.returncode, status, f"the status of {args} ({text!r})")
    check(re.fullmatch(message_of("tia") + "+", text), f"{args} said {text!r}")
    check(says in text, f"{args} said {text!r}, not {says!r}")
    same(done.stdout or b"", b"", f"the standard output of {args}")
    same(sorted(os.listdir(".")), before, f"the directory after {args}")


def formats():
    """What this build writes."""
    return [name for name in ("png", "ppm", "bmp", "565")
            if tia("-o", "-", "--format", name, "-s", "1x1").returncode == 0]


def needs_png():
    if "png" not in formats():
        raise Skip("built without libpng (libpng-dev)")


def needs_f64():
    if tia("--arithmetic", "f64", "-o", "-", "--format", "565", "-s", "1x1").returncode == 2:
        raise Skip("built without double precision (make F64=yes)")


def needs_json():
    """Without libjansson no file is read."""
    scene = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "scenes", "lightfield.tia")
    if b"reads no .json" in tia(scene, "-o", "-", "--format", "565", "--calibration", "none.json").stderr:
        raise Skip("built without libjansson (libjansson-dev)")


def as_somebody():
    """For preexec_fn: gives up root's right to write everywhere."""
    if os.getuid() == 0:
        os.setgroups([])
        os.setgid(65534)
        os.setuid(65534)


def has_sanitizer(*kinds):
    with open(TIA, "rb") as file:
        program = file.read()
    return any(f"__{kind}_init".encode() in program for kind in kinds)


def preloaded(source, **more):
    """The environment of a command that calls the functions of a C source instead of libc's; and more variables."""
    if has_sanitizer("asan"):
        raise Skip("a sanitizer wants to be loaded first")
    with open("preloaded.c", "w", encoding="ascii") as file:
        file.write(source)
    subprocess.run([*os.environ.get("CC", "cc").split(), "-shared", "-fPIC", "-o", "preloaded.so", "preloaded.c", "-ldl"],
                   check=True, timeout=LIMIT_S)
    return {**os.environ, "LD_PRELOAD": os.path.abspath("preloaded.so"), **more}


def limited(**limits):
    """For preexec_fn: limited(DATA=1 << 20) sets RLIMIT_DATA."""
    if "DATA" in limits and has_sanitizer("asan", "tsan"):
        raise Skip("a sanitizer's own memory leaves no room for a limit")
    def apply():
        for name, value in limits.items():
            resource.setrlimit(getattr(resource, "RLIMIT_" + name), (value, value))
    return apply


# ---- pictures: each reader gives (width, height, RGB565 pixels) ----

def pack(rgb):
    """Bytes of 8-bit RGB to RGB565; the low bits must repeat the high ones."""
    pixels = array("H")
    for r, g, b in zip(rgb[0::3], rgb[1::3], rgb[2::3]):
        check(r & 7 == r >> 5 and g & 3 == g >> 6 and b & 7 == b >> 5, f"({r}, {g}, {b}) is no expanded RGB565")
        pixels.append((r >> 3) << 11 | (g >> 2) << 5 | b >> 3)
    return pixels


def read_565(data, width, height):
    same(len(data), width * height * 2, "the length of the .565")
    return width, height, array("H", struct.unpack(f"<{width * height}H", data))


def ppm_pixels(data):
    """(width, height, bytes of 8-bit RGB)"""
    magic, size, most, rgb = data.split(b"\n", 3)
    same((magic, most), (b"P6", b"255"), "the header of the .ppm")
    width, height = map(int, size.split())
    same(len(rgb), width * height * 3, "the length of the .ppm")
    return width, height, rgb


def read_ppm(data):
    width, height, rgb = ppm_pixels(data)
    return width, height, pack(rgb)


def read_bmp(data):
    length, offset, header, width, height = struct.unpack_from("<xxI4xIIii", data)
    planes, bits, packing = struct.unpack_from("<HHI", data, 26)
    same((data[:2], length, header, planes, bits, packing), (b"BM", len(data), 40, 1, 16, 3), "the header of the .bmp")
    same(struct.unpack_from("<III", data, 54), (0xf800, 0x7e0, 0x1f), "the masks of the .bmp")
    pitch = (width * 2 + 3) // 4 * 4
    same(len(data), offset + pitch * height, "the length of the .bmp")
    pixels = array("H")
    for y in reversed(range(height)):
        pixels.extend(struct.unpack_from(f"<{width}H", data, offset + y * pitch))
    return width, height, pixels


def floats(name):
    """The numbers of a .pfm file, bottom row first."""
    with open(name, "rb") as file:
        magic, size, _, data = file.read().split(b"\n", 3)
    same(magic, b"PF", f"the first line of {name}")
    width, height = map(int, size.split())
    return struct.unpack(f"<{width * height * 3}f", data)


def png_chunks(data):
    same(data[:8], b"\x89PNG\r\n\x1a\n", "the signature of the .png")
    at = 8
    while at < len(data):
        length, kind = struct.unpack_from(">I4s", data, at)
        body = data[at + 8:at + 8 + length]
        same(struct.unpack_from(">I", data, at + 8 + length)[0], zlib.crc32(kind + body), f"the CRC of {kind}")
        yield kind, body
        at += 12 + length


def paeth(a, b, c):
    pa, pb, pc = abs(b - c), abs(a - c), abs(a + b - 2 * c)
    return a if pa <= pb and pa <= pc else b if pb <= pc else c


def unfilter(kind, line, above):
    for i, value in enumerate(line):
        a, b, c = (line[i - 3] if i >= 3 else 0), above[i], (above[i - 3] if i >= 3 else 0)
        line[i] = (value + (0, a, b, (a + b) // 2, paeth(a, b, c))[kind]) & 255


def png_lines(data):
    """(width, height, its lines from the top, each of bytes of 8-bit RGB): whoever needs the first ones takes no more."""
    chunks = list(png_chunks(data))
    same((chunks[0][0], chunks[-1][0]), (b"IHDR", b"IEND"), "the first and last chunk")
    width, height, *form = struct.unpack(">IIBBBBB", chunks[0][1])
    same(form, [8, 2, 0, 0, 0], "bits, colour type and methods of the .png")
    raw = zlib.decompress(b"".join(body for kind, body in chunks if kind == b"IDAT"))
    same(len(raw), height * (1 + 3 * width), "the length of the .png's pixels")

    def lines():
        above = bytearray(3 * width)
        for start in range(0, len(raw), 1 + 3 * width):
            line = bytearray(raw[start + 1:start + 1 + 3 * width])
            if raw[start] != 0:
                unfilter(raw[start], line, above)
            yield line
            above = line

    return width, height, lines()


def png_pixels(data):
    """(width, height, bytes of 8-bit RGB)"""
    width, height, lines = png_lines(data)
    return width, height, b"".join(lines)


def read_png(data):
    width, height, rgb = png_pixels(data)
    return width, height, pack(rgb)


def same_png(name, other):
    """Whether two files are the same picture. Another zlib writes other bytes; the same bytes need not be decoded."""
    with open(name, "rb") as one, open(other, "rb") as two:
        a, b = one.read(), two.read()
    return a == b or png_pixels(a) == png_pixels(b)


# ---- cases ----

def long(case):
    """Marks a case that takes half a second or more: make check-quick leaves it out, unless it is named."""
    case.is_long = True
    return case


def one_line(why):
    """The lines of an exception's text, those of a failed program's output among them, beside each other."""
    return " | ".join(line.strip() for line in str(why).splitlines() if line.strip())


def run_cases(cases):
    """Each case, a function, runs in an empty directory of its own. Names on the command line choose."""
    failed = False
    names = chosen([case.__name__ for case in cases])
    if QUICK and not sys.argv[1:]:
        cases = [case for case in cases if not getattr(case, "is_long", False)]
    for case in [case for case in cases if case.__name__ in names]:
        directory, home = tempfile.mkdtemp(prefix="tia-"), os.getcwd()
        os.chmod(directory, 0o755)
        os.chdir(directory)
        try:
            case()
            print(f"ok {case.__name__}")
        except Skip as why:
            print(f"skip {case.__name__}: {why}")
        except AssertionError as why:
            print(f"FAIL {case.__name__}: {one_line(why) or 'failed'}")
            failed = True
        except Exception as why:        # pylint: disable=broad-except
            traceback.print_exc()
            print(f"FAIL {case.__name__}: {type(why).__name__}: {one_line(why)}")
            failed = True
        finally:
            os.chdir(home)
            shutil.rmtree(directory)
        sys.stdout.flush()
    return failed
