"""A run of tia inside a guest, on its console or from its serial line, and what must be true
before, while and after."""
import hashlib
import shlex

import picture
from guest import Failure


# ---- eyes: ways to see what a driver shows, comparable with what it should show ----

class Scanout:
    """QEMU's display controller: the very pixels that it would put on a monitor."""

    def __init__(self, expand=picture.replicate):
        self.expand = expand

    def sees(self, guest):
        return guest.screen()

    def expects(self, width, height, data):
        return picture.expanded(width, height, data, self.expand)


class VkmsChecksum:
    """vkms has no monitor; it tells the checksum of each frame that it has composed."""

    def sees(self, guest):
        line = guest.sh('cd /sys/kernel/debug/dri/0/crtc-0/crc && echo auto >control && head -n 1 data')
        return int(line.split()[1], 16)

    def expects(self, _width, _height, data):
        return picture.vkms_crc(data)


class Memory:
    """vfb shows nothing: its memory is its screen. Red is at bit 0 there, blue at bit 11."""

    def __init__(self, size):
        self.size = size

    def sees(self, guest):
        return guest.sh('head -c %d /dev/fb0 | md5sum' % self.size).split()[0]

    def expects(self, _width, _height, data):
        pixels = picture.pixels565(data)
        swapped = type(pixels)('H', (p >> 11 | p & 0x7e0 | (p & 31) << 11 for p in pixels))
        return hashlib.md5(swapped.tobytes()).hexdigest()


def whole_screen(size, inner, frame):
    """A smaller picture in the middle of a black screen: width, height and RGB565 bytes."""
    width, height = size
    left, top = (width - inner[0]) // 2, (height - inner[1]) // 2
    out = bytearray(2 * width * height)
    for y in range(inner[1]):
        start = 2 * ((top + y) * width + left)
        out[start:start + 2 * inner[0]] = frame[2 * y * inner[0]:2 * (y + 1) * inner[0]]
    return width, height, bytes(out)


class Console:
    """The text console on tty1, as it was before anything was started on it."""

    def __init__(self, guest, eye, keyboard=True):
        self.guest, self.eye, self.keyboard = guest, eye, keyboard
        guest.wait(lambda: guest.sh('[ -e /tmp/tty1 -a -e /tmp/tty2 ]; echo $?') == '0', 'two consoles')
        self.state, self.text = self._state(), self.steady()

    def _state(self):
        return self.guest.sh('probe vt 1; stty -g -F /dev/tty1; pidof tia; probe grabbed', check=False)

    def steady(self, unlike=None):
        """What is seen once it has stopped changing: drivers draw text some time later."""
        seen = [unlike]

        def found():
            seen.append(self.eye.sees(self.guest))
            return seen[-1] == seen[-2] != unlike
        self.guest.wait(found, 'a picture that stays')
        return seen[-1]

    def sees_text(self):
        return self.eye.sees(self.guest) == self.text

    def forget(self):
        self.guest.sh(': >/tmp/tty1; : >/tmp/tty2')

    def read(self, tty=1):
        """The lines that the console has read from its keyboard."""
        return self.guest.sh('cat /tmp/tty%d' % tty).splitlines()

    def alive(self, *before):
        """The console works: Mode, terminal settings and text are those from before tia; no process of it is left
        and no keyboard grabbed; what is typed arrives here, and of what was typed earlier no more
        than the lines `before`."""
        guest = self.guest
        guest.wait(lambda: self._state() == self.state,
                   lambda: 'the console as it was: %r, not %r' % (self._state(), self.state))
        guest.wait(self.sees_text, 'the text of the console')
        if self.keyboard:
            guest.type('alive\n')
        else:
            guest.sh('probe push 1 alive')
        guest.wait(lambda: self.read()[-1:] == ['alive'] or len(self.read()) > len(before) + 1,
                   lambda: 'keys on the console: it read %r' % self.read())
        if self.read() != [*before, 'alive']:
            raise Failure('keys leaked to the console: it read %r' % self.read())
        guest.wait(self.sees_text, 'the text of the console')


class Session:
    """tia in a guest: start() runs it, frame() tells what must be on the screen."""

    def __init__(self, guest, setup, full):
        self.guest, self.setup, self.eye, self.full = guest, setup, setup.eye, full
        self.console = Console(guest, self.eye, setup.keyboard)
        self.display = ['-d', setup.display, *setup.options]
        self.compose = self.whole
        self.line = None            # what was typed on the console to start tia

    # ---- running ----

    def run(self, *arguments, serial=False, wrap='', command=''):
        """Starts tia: typed on the console, or from the first serial line, where there is no VT."""
        keys = [] if '-k' in arguments else ['-k', '']     # without -k, text on the picture tells of keys
        command = 'session ' + (command or wrap + shlex.join(['tia', *arguments, *keys]))
        self.console.forget()
        self.guest.sh('rm -rf /tmp/session')
        if serial:
            self.line = None
            self.guest.sh('probe as 0 setsid -c %s </dev/ttyS0 >/dev/null 2>&1 &' % command)
        else:
            self.line = command
            self.guest.sh('probe push 1 %s' % shlex.quote(command))

    def start(self, *options, first='', compose=None, **where):
        """Runs tia on the display and waits for its first picture."""
        self.compose = compose or self.whole
        self.run(*self.display, *options, **where)
        self.frame(first)

    def note(self, text):
        self.guest.note(text)

    def times(self, count):
        """How often to do what takes long."""
        return count if self.full else count // 8

    def wait_grabbed(self, count):
        """Waits until tia has so many keyboards."""
        self.guest.wait(lambda: len(self.guest.sh('probe grabbed').splitlines()) == count, '%d keyboards' % count)

    def file(self, name):
        return self.guest.sh('cat /tmp/session/%s 2>/dev/null' % name, check=False)

    def pid(self):
        return self.guest.wait(lambda: self.file('pid'), 'tia to start')

    def kill(self, signal):
        self.guest.sh('kill -%s %s' % (signal, self.pid()))

    def status(self):
        """Waits for the end of tia."""
        return int(self.guest.wait(lambda: self.file('status'), 'tia to end'))

    def ends(self, *statuses):
        """tia ends with one of these statuses, and the console is as it was."""
        status = self.status()
        if status not in statuses:
            raise Failure('tia ended with status %d: %s' % (status, self.file('err')))
        self.console.alive(*([self.line] if self.line else []))

    def refused(self, status, *words):
        """tia ends at once with this status and one line that has these words."""
        self.ends(status)
        error = self.file('err')
        if len(error.splitlines()) != 1 or not error.startswith('tia: ') or not all(w in error for w in words):
            raise Failure('not one line of "tia: WHAT: WHY" with %s: %r' % (', '.join(words), error))

    # ---- seeing ----

    def whole(self, keys):
        """What the screen holds after these keys: width, height and RGB565 bytes. Other ways to
        place the picture come with start(compose=...)."""
        return *self.setup.size, picture.host_frame(*self.setup.size, keys)

    def expected(self, keys):
        return self.eye.expects(*self.compose(keys))

    def frame(self, keys):
        """Waits until exactly the frame after these keys (-k's notation) is on the screen."""
        want, seen = self.expected(keys), []

        def found():
            seen[:] = [self.eye.sees(self.guest)]
            if self.file('status'):
                raise Failure('tia ended with status %s: %s' % (self.file('status'), self.file('err')))
            return seen[0] == want
        try:
            self.guest.wait(found, 'frame')
        except Failure as failure:
            if not isinstance(want, picture.Picture) or not seen or 'ended' in str(failure):
                raise Failure('after keys "%s": %s' % (keys, failure))
            raise Failure('after keys "%s": %s' % (keys, seen[0].differs(want)), want)

    def shown_or_ended(self, keys):
        """Waits until this frame is shown or tia has ended; says which."""
        want = self.expected(keys)

        def found():
            return 'ended' if self.file('status') else 'shown' if self.eye.sees(self.guest) == want else ''
        return self.guest.wait(found, 'a frame or the end')

    def steps(self, before, key, after, most):
        """The number of times, 1 to `most`, that `key` has acted between the keys `before` and the
        key `after`, which moves otherwise. What tia says with --checksum leads to it, what is on
        the screen proves it."""
        def found():
            told = int(self.file('out').split()[-1], 16)
            size = self.setup.size
            return next((n for n in range(1, most + 1) if picture.checksum(*size, before + n * key + after) == told), 0)
        n = self.guest.wait(found, 'a frame after "%s", some %s and %s' % (before, key, after))
        self.frame(before + n * key + after)
        return n

    def frames_drawn(self):
        """How many frames tia has told of with --checksum."""
        return len(self.file('out').splitlines())
