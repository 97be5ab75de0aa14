"""Cases about pictures: what the keys draw is, pixel by pixel, what the host draws."""
import json
import time

import picture
from guest import Failure
from session import whole_screen

MOVES = ['<left>', '<right>', '<up>', '<down>', '<pgup>', '<pgdn>']
QEMU_KEY = {'<left>': 'left', '<right>': 'right', '<up>': 'up', '<down>': 'down', '<pgup>': 'pgup', '<pgdn>': 'pgdn'}
REPEAT = 0.033333       # seconds from step to step of a held key, TIA_HOLD_STEP_US


def conforms(s):
    """The suite that every display passes, by itself."""
    said = s.guest.sh('test_ports %s 2>&1' % s.setup.display, check=False)
    if said != 'ok ' + s.setup.display:
        raise Failure('test_ports: ' + said)
    s.console.alive()


def frames(s):
    """Light keys and arrows, tapped, and a key that quits: all where the setup's long cases run, else two of each."""
    every = s.full or s.setup.long
    s.start('--stats', '--checksum')
    for key in 'dswa' if every else 'da':
        s.guest.tap(key)
        s.frame(key)
    typed = 'a'
    for key in MOVES if every else MOVES[:2]:
        s.guest.tap(QEMU_KEY[key])
        typed += key
        s.frame(typed)
    s.guest.tap('esc')
    s.ends(0)
    stats = json.loads(s.file('err').splitlines()[-1])
    if stats['format'] != s.setup.format:
        raise Failure('the format is %s, not %s' % (stats['format'], s.setup.format))


def automatic(s):
    """Without -d tia finds the display by itself."""
    s.run('--stats')
    s.frame('')
    s.guest.tap('esc')
    s.ends(0)
    found = json.loads(s.file('err'))['display']
    if found != s.setup.display:
        raise Failure('took %s' % found)


def held(s):
    """A held key moves the light by whole steps until it is let go; then none is added."""
    s.start('-k', 'a', '--checksum', first='a')
    for key in ('<right>', '<down>'):
        drawn, start = s.frames_drawn(), time.monotonic()
        s.guest.press(QEMU_KEY[key])
        s.guest.wait(lambda: s.frames_drawn() >= drawn + 4, 'a held key to repeat')
        s.guest.release(QEMU_KEY[key])
        s.guest.tap('pgup')     # a frame with this key knows of the release
        n = s.steps('a', key, '<pgup>', most=2 + int((time.monotonic() - start) / REPEAT))
        if n < 4:
            raise Failure('%s acted %d times in 4 frames' % (key, n))
        s.guest.tap('a')
        s.frame('a')
    s.guest.tap('q')
    s.ends(0)


def latency(s):
    """Keys that queue while tia cannot run are all in the next frame; --stats tells how long
    a key took to be seen."""
    s.start('-k', 'a', '--stats', '--checksum', first='a')
    drawn = s.frames_drawn()
    s.kill('STOP')
    for _ in range(4):      # few enough for the kernel's queue
        s.guest.type_slowly(['right', 'up'])
    s.kill('CONT')
    s.frame('a' + 4 * '<right><up>')
    if s.frames_drawn() != drawn + 1:
        raise Failure('%d frames for keys that one could show' % (s.frames_drawn() - drawn))
    s.guest.tap('esc')
    s.ends(0)
    stats = json.loads(s.file('err').splitlines()[-1])
    p50, p95 = stats['input_to_flip_ms']['p50'], stats['input_to_flip_ms']['p95']
    if not 0 < p50 <= p95:
        raise Failure('key to flip: p50 %r, p95 %r' % (p50, p95))


def panning(s):
    """A driver with two pages shows one while the other is drawn, and gets its position back."""
    s.start('--checksum')
    seen = set()
    for key in 'adad':
        s.guest.tap(key)
        s.frame(key)
        seen.add(s.guest.sh('probe fb /dev/fb0').split('yoffset=')[1])
    if seen != {'0', str(s.setup.size[1])}:
        raise Failure('the pages shown began at rows %s' % ', '.join(sorted(seen)))
    s.guest.tap('esc')
    s.ends(0)
    if 'yoffset=0' not in s.guest.sh('probe fb /dev/fb0'):
        raise Failure('the page in front was not put back')


def pacing(s):
    """No two flips fall into one vertical blank, though frames wait for nothing else."""
    trace = '/sys/kernel/tracing'
    s.guest.sh('echo 1 >%s/events/drm/drm_vblank_event_delivered/enable' % trace)
    s.run(*s.display, '-i', 'none', '-n', '40', '--stats')
    s.ends(0)
    lines = s.guest.sh('cat %s/trace; echo 0 >%s/events/drm/enable; echo >%s/trace' % (trace, trace, trace))
    blanks = [int(line.split('seq=')[1].split(',')[0].rstrip(')')) for line in lines.splitlines() if 'seq=' in line]
    if len(blanks) < 39 or any(b <= a for a, b in zip(blanks, blanks[1:])):
        raise Failure('%d flips in the vertical blanks %s' % (len(blanks), blanks))


def controller(s):
    """The controller's own checksum is that of tia's pixels in each state, and another with a wrong pixel."""
    s.console.forget()      # what an earlier case typed
    said = s.guest.sh('controller /sys/kernel/debug/dri/0/crtc-0/crc 2>&1', check=False).splitlines()
    reported = [line for line in said if line.endswith('is what the controller reports')]
    if len(said) != 6 or reported != said or not said[5].startswith('state 1, a pixel changed') \
            or said[5].split()[-6] in [line.split()[-6] for line in said[:5]]:
        raise Failure('controller: ' + '; '.join(said))
    s.console.alive()


# ---- pictures that are not simply the screen ----

def turned(width, height, degrees):
    """Compositions for --rotate: the picture's pixel (x, y) clockwise by `degrees`."""
    def compose(keys):
        size = (height, width) if degrees % 180 else (width, height)
        frame = picture.pixels565(picture.host_frame(*size, keys))
        rows = [frame[i:i + size[0]] for i in range(0, len(frame), size[0])]
        for _ in range(degrees // 90):
            rows = [type(frame)('H', column) for column in zip(*reversed(rows))]
        return width, height, b''.join(row.tobytes() for row in rows)
    return compose


def rotated(s):
    """--rotate draws for a panel that hangs on its side or upside down."""
    for degrees in (90, 180, 270):
        s.start('--rotate', str(degrees), compose=turned(*s.setup.size, degrees))
        s.guest.tap('d')
        s.frame('d')
        s.guest.tap('esc')
        s.ends(0)


def centred(s):
    """-s draws a smaller picture in the middle of a black screen; a larger one is refused."""
    inner = (301, 200)

    def compose(keys):
        return whole_screen(s.setup.size, inner, picture.host_frame(*inner, keys))
    s.start('-s', '%dx%d' % inner, compose=compose)
    s.guest.tap('a')
    s.frame('a')
    s.guest.tap('esc')
    s.ends(0)
    wide = '%dx1' % (s.setup.size[0] + 1)
    s.run(*s.display, '-s', wide)
    s.refused(3, wide)


def modes(s):
    """--mode and --connector choose; what is not there is refused."""
    connector = s.guest.sh('cd /sys/class/drm; ls -d card0-*').split()[0][len('card0-'):]
    s.start('--connector', connector, '--mode', '640x480',
            compose=lambda keys: (640, 480, picture.host_frame(640, 480, keys)))
    s.guest.tap('s')
    s.frame('s')
    s.guest.tap('esc')
    s.ends(0)
    for options in (('--mode', '641x480'), ('--connector', 'Nowhere-1')):
        s.run(*s.display, *options)
        s.refused(3, options[1])


# ---- screens that go away ----

def ends_without(s, thing, take_away, bring_back):
    """Something goes away under a running tia, which at the next frame says so and ends; when it
    comes back the console is there."""
    s.start()
    s.guest.sh(take_away)
    s.guest.tap('a')
    status, error = s.status(), s.file('err')
    s.guest.sh(bring_back)
    if status != 1 or len(error.splitlines()) != 1 or not error.startswith('tia: ') or thing not in error:
        raise Failure('tia ended with status %d: %r' % (status, error))
    s.console.alive(s.line)


def device_gone(s):
    """The driver lets go of the device."""
    driver = s.guest.sh('readlink -f /sys/class/drm/card0/device/driver')
    device = s.guest.sh('cd %s; ls -d 0*' % driver).split()[0]
    ends_without(s, '/dev/dri/card0', 'echo %s >%s/unbind' % (device, driver), 'echo %s >%s/bind' % (device, driver))


def screen_gone(s):
    """The screen is pulled out of its connector."""
    connector = s.guest.sh('cd /sys/class/drm; ls -d card0-*').split()[0]
    status = '/sys/class/drm/%s/status' % connector
    ends_without(s, connector[len('card0-'):], 'echo off >%s' % status, 'echo detect >%s' % status)
