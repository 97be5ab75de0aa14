"""A pseudo-terminal with the command in it, and a model of what a person would see there.

The model knows the few sequences that a picture of half blocks and rows of text need; anything else is an error.
The last row of a window of three rows or more is the status: a window has twice as many rows of pixels as other rows.
"""
import fcntl
import os
import pty
import re
import select
import signal
import struct
import subprocess
import termios
import time

from command import LIMIT_S, TIA, check, same

# A sequence or a character that another one, or CAN, cuts short is none; ST without a string does nothing.
# The window's title ends with ST.
TOKEN = re.compile(rb"(?:\x1b(?:\[[?0-9;]*|\][^\0-\x1f]*)?|\xe2\x96?)?\x18|\x1b\][^\0-\x1f]*(?=\x1b)|\x1b\\|"
                   rb"(?:\xe2\x96?(?=\x1b)|\x1b\[[?0-9;]*(?=\x1b))?"
                   rb"\x1b\[([?0-9;]*)([A-Za-z])|([ -~])|(\xe2\x96\x80)", re.S)
UNFINISHED = re.compile(rb"\x1b(\[[?0-9;]*|\][^\0-\x1f]*)?$|\xe2\x96?$")
GREYS = [(8 + 10 * i,) * 3 for i in range(24)]
LEVELS = (0, 95, 135, 175, 215, 255)
PALETTE = [None] * 16 + [(r, g, b) for r in LEVELS for g in LEVELS for b in LEVELS] + GREYS
MODES = {"?1049": "alternate", "?25": "cursor", "?7": "wrap", "?2004": "paste", "?2026": "frame", "?1003": "mouse", "?1006": "numbers"}
AS_BEFORE = dict(alternate=False, cursor=True, wrap=True, paste=False, frame=False, mouse=False, numbers=False,
                 title=False)


class Screen:
    """What a terminal shows: two colours (r, g, b) a cell, and the character, which is None for a half block."""

    def __init__(self, columns, rows):
        self.mode = dict(AS_BEFORE)
        self.fore, self.back = (255, 255, 255), (0, 0, 0)
        self.x = self.y = self.frames = self.cells_written = self.blocks = 0
        self.rest = b""
        self.resize(columns, rows)

    def resize(self, columns, rows):
        self.columns, self.rows = columns, rows
        self.cells = [[(None, None)] * columns for _ in range(rows)]
        self.letters = [[" "] * columns for _ in range(rows)]

    def pixel_rows(self):
        return 2 * (self.rows - 1 if self.rows >= 3 else self.rows)

    def text(self):
        """The window's rows as text; a half block is a blank."""
        return ["".join(letter or " " for letter in row) for row in self.letters]

    def feed(self, data):
        data = self.rest + data
        cut = UNFINISHED.search(data)
        self.rest = cut[0] if cut else b""
        data = data[:cut.start()] if cut else data
        at = 0
        while at < len(data):
            token = TOKEN.match(data, at)
            check(token, f"the terminal got {data[at:at + 20]!r}")
            at = token.end()
            if token[2]:
                self.control(token[1].decode(), token[2].decode())
            elif token[3] or token[4]:
                self.put(token[3].decode() if token[3] else None)

    def put(self, letter):
        """A letter, which covers two pixels, or None for a half block."""
        check(self.x < self.columns and self.y < self.rows, f"a cell outside: {self.x}, {self.y}")
        self.cells[self.y][self.x] = ((self.fore, self.back) if letter is None else (self.back, self.back) if letter == " " else
                                      (None, None))
        self.letters[self.y][self.x] = letter
        self.cells_written += self.rows < 3 or self.y + 1 < self.rows
        self.blocks += letter is None
        self.x = min(self.x + 1, self.columns - 1)

    def control(self, text, final):
        if text in MODES and final in "hl":
            name, on = MODES[text], final == "h"
            self.frames += name == "frame" and self.mode[name] and not on
            self.mode[name] = on
            return
        numbers = [int(n or 0) for n in text.split(";")]
        if final == "t" and numbers in ([22, 2], [23, 2]):      # the window's title is put onto a stack, and taken from there
            self.mode["title"] = numbers == [22, 2]
        elif final == "H":
            self.y, self.x = (max(n, 1) - 1 for n in (numbers + [1])[:2])
        elif final == "C":
            self.x += max(numbers[0], 1)
        elif final == "m":
            self.colours(numbers)
        elif final == "J" and numbers == [2]:
            self.cells = [[(self.back, self.back)] * self.columns for _ in range(self.rows)]
            self.letters = [[" "] * self.columns for _ in range(self.rows)]
        else:
            check(False, f"the terminal got ESC [ {text} {final}")

    def colours(self, numbers):
        while numbers:
            kind = numbers.pop(0)
            if kind == 0:
                self.fore, self.back = (255, 255, 255), (0, 0, 0)
                continue
            if kind == 1:
                continue
            check(kind in (38, 48) and numbers and numbers[0] in (2, 5), f"the colour {kind} {numbers}")
            direct = numbers.pop(0) == 2
            colour = tuple(numbers[:3]) if direct else PALETTE[numbers[0]]
            del numbers[:3 if direct else 1]
            if kind == 38:
                self.fore = colour
            else:
                self.back = colour

    def pixels(self, x, y, width, height):
        """Colours of a rectangle of the window's pixels, row by row."""
        return [self.cells[v // 2][u][v % 2] for v in range(y, y + height) for u in range(x, x + width)]


class Terminal:
    """The command in a terminal of its own, as a shell would start it. `with` ends it."""

    def __init__(self, *args, size=(40, 13), settle=True, env=None, preexec=None, **options):
        self.screen, self.preexec = Screen(*size), preexec
        self.master, self.slave = pty.openpty()
        self.set_size(*size)
        self.before = termios.tcgetattr(self.slave)
        environment = {**os.environ, "TERM": "xterm-256color", "COLORTERM": "truecolor", "LC_ALL": "C.UTF-8",
                       **(env or {})}
        for name in [name for name, value in environment.items() if value is None]:
            del environment[name]
        options = {"stdin": self.slave, "stdout": self.slave, "stderr": subprocess.PIPE, **options}
        self.process = subprocess.Popen([TIA, *args], env=environment, preexec_fn=self.lead, **options)
        if settle:
            self.until(lambda: self.screen.frames, "the first frame")

    def lead(self):
        os.setsid()
        if self.preexec:
            self.preexec()
        fcntl.ioctl(self.slave, termios.TIOCSCTTY, 0)

    def set_size(self, columns, rows):
        fcntl.ioctl(self.slave, termios.TIOCSWINSZ, struct.pack("HHHH", rows, columns, 0, 0))

    def resize(self, columns, rows):
        self.pump(0)
        self.screen.resize(columns, rows)
        self.set_size(columns, rows)

    def type(self, text):
        os.write(self.master, text if isinstance(text, bytes) else text.encode())

    def pump(self, seconds):
        """Lets the screen show what was written; whether there was anything."""
        ready = select.select([self.master], [], [], seconds)[0]
        if not ready:
            return False
        try:
            self.screen.feed(os.read(self.master, 65536))
        except OSError:
            return False        # hung up
        return True

    def until(self, condition, what, after_the_end=False):
        """Waits for a condition, which only a living command can bring about unless `after_the_end`."""
        end = time.monotonic() + LIMIT_S
        while not condition():
            check(time.monotonic() < end, f"{what} did not come")
            silent = not self.pump(0.01)
            if after_the_end or not silent or self.process.poll() is None:
                continue
            if not self.pump(0) and not condition():
                check(False, f"{what} did not come: status {self.process.returncode}, {self.said()!r}")

    def is_raw(self):
        flags = termios.tcgetattr(self.slave)[3]
        return not flags & (termios.ICANON | termios.ECHO | termios.ISIG)

    def said(self):
        return self.process.stderr.read().decode() if self.process.stderr else ""

    def ended(self, status):
        """It has ended with this status and left the terminal as it was."""
        self.until(lambda: self.process.poll() is not None, "the end")
        self.until(lambda: not self.pump(0), "the end of the output")
        same(self.process.returncode, status, "the status")
        self.restored()

    def restored(self):
        same(termios.tcgetattr(self.slave), self.before, "the terminal's modes")
        want = AS_BEFORE
        same(self.screen.mode, want, "the state of the terminal's screen")
        same(self.screen.rest, b"", "the end of the output")

    def hang_up(self):
        os.close(self.master)
        self.master = -1

    def __enter__(self):
        return self

    def __exit__(self, *error):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGKILL)
            self.process.wait()
        if self.process.stderr:
            self.process.stderr.close()
        for fd in (self.master, self.slave):
            if fd >= 0:
                os.close(fd)
