"""Cases about mice and tablets of every kind: the eye looks where they are, and a drag orbits. The pictures must be those
of --gaze on the host, and of keys in the guest: both need no pointer."""
import os

import picture
from cases_console import is_active
from cases_keys import unplug as unplug_keyboard
from guest import Failure
from session import whole_screen

SIZE = 180, 120             # the drags of tablets below go by its pixels, each a degree wide
SCENE = 'pointer.tia'
HOST_SCENE = os.path.join(os.path.dirname(os.path.abspath(__file__)), SCENE)
EYE = ['--view-angle', '20', '--m', '0.1']      # coarse a few pixels from the gaze
FULL = 32768                # of QEMU's absolute axes


def start(s, *options):
    """Runs tia with the scene and waits for its picture, in the middle of the black screen."""
    def compose(keys):
        return whole_screen(s.setup.size, SIZE, picture.host_frame(*SIZE, keys, *options, HOST_SCENE))
    s.start('-s', '%dx%d' % SIZE, '--checksum', *options, '/scenes/' + SCENE, compose=compose)


def typed(s):
    """The pictures after some keys: typed once for all cases of a guest."""
    if not hasattr(s, 'after'):
        s.after = {}
        for keys in ('hk+l', 'hhh'):
            start(s)
            for i, key in enumerate(keys):
                drawn = s.frames_drawn()
                s.guest.tap({'+': 'equal'}.get(key, key))
                s.guest.wait(lambda: s.frames_drawn() > drawn, 'a frame after ' + key)
                s.after[keys[:i + 1]] = s.console.steady()
            s.guest.tap('esc')
            s.ends(0)
        if len({after.rgb for after in s.after.values()}) != len(s.after):
            raise Failure('keys lead to the same picture')
    return s.after


NAMES = {'ps2': 'PS/2 Mouse', 'usb-mouse': 'HID Mouse', 'usb-tablet': 'HID Tablet', 'virtio-mouse-pci': 'Virtio Mouse',
         'virtio-tablet-pci': 'Virtio Tablet'}


def plug(s, kind):
    """Plugs a pointer in, unless it is built in, and waits until tia has opened it and QEMU sends it what is moved."""
    if kind != 'ps2':
        before = opened(s)
        s.guest.qmp('device_add', driver=kind, id='plugged', **({'bus': 'usb.0'} if kind.startswith('usb') else {}))
        s.guest.wait(lambda: opened(s) > before, kind)
    s.guest.wait(lambda: any(mouse['current'] and NAMES[kind] in mouse['name'] for mouse in s.guest.qmp('query-mice')),
                 kind + ' to be asked by the guest')


def unplug(s, kind):
    """Pulls it out, and waits until tia, if it runs, has let it go."""
    if kind == 'ps2':
        return
    before = opened(s)
    unplug_keyboard(s)
    s.guest.wait(lambda: not before or opened(s) < before, 'tia to let %s go' % kind)


def opened(s):
    """How many event devices tia has open."""
    return s.guest.sh('ls -l /proc/%s/fd' % s.pid(), check=False).count('/dev/input/event')


def send(s, *events):
    s.note('pointer %s' % (events,))
    s.guest.qmp('input-send-event', events=[{'type': kind, 'data': data} for kind, data in events])


def button(name, down):
    return 'btn', {'button': name, 'down': down}


def move(s, x, y):
    send(s, *[('rel', {'axis': axis, 'value': value}) for axis, value in (('x', x), ('y', y)) if value])


def put(s, x, y):
    """A tablet's pen at the middle of a pixel of the picture."""
    places = [(2 * at + 1 + screen - size) * FULL // (2 * screen) for at, screen, size in zip((x, y), s.setup.size, SIZE)]
    send(s, *[('abs', {'axis': axis, 'value': value}) for axis, value in zip('xy', places)])


def looks_at(s, *place):
    """The picture is the one that is sharp there, of all places."""
    frame = picture.host_frame(*SIZE, '', '--gaze', '%d,%d' % place, *EYE, HOST_SCENE)
    s.guest.shows(s.eye.expects(*whole_screen(s.setup.size, SIZE, frame)), 'a gaze at %d, %d' % place)


def shows(s, keys):
    s.guest.shows(typed(s)[keys], 'the picture of ' + keys)


def mouse(s, kind):
    """A movement takes the gaze along, pixel by pixel; with the left button down it turns the scene by a quarter of a
    degree each, as h, j, k and l do by 5 degrees; the wheel zooms. Elsewhere it does nothing."""
    typed(s)
    start(s, '--gaze', '60,50', *EYE)
    plug(s, kind)
    move(s, 70, 0)
    looks_at(s, 130, 50)
    move(s, -20, 40)
    looks_at(s, 110, 90)
    s.guest.tap('esc')
    s.ends(0)
    unplug(s, kind)
    start(s)
    plug(s, kind)
    send(s, button('left', True))
    move(s, 20, 0)
    shows(s, 'h')
    move(s, 0, 20)
    shows(s, 'hk')
    send(s, button('left', False))
    move(s, 40, 40)
    send(s, button('wheel-up', True), button('wheel-up', False))
    shows(s, 'hk+')
    elsewhere(s)
    unplug(s, kind)
    s.guest.tap('l')
    shows(s, 'hk+l')
    s.guest.tap('esc')
    s.ends(0)


def elsewhere(s):
    """What it does while another console is in front is not for tia, once the kernel has told of it."""
    node = s.guest.sh("sed -n '/Mouse/,/^$/s/.*\\(event[0-9]*\\).*/\\1/p' /proc/bus/input/devices").split()[-1]
    s.guest.tap('ctrl-alt-f2')
    s.guest.wait(lambda: is_active(s, 2), 'console 2')
    s.guest.sh('head -c 96 /dev/input/%s >/tmp/moved & :' % node)      # button, x, and a SYN after each or both
    s.guest.wait(lambda: '/dev/input/' in s.guest.sh('ls -l /proc/$(pidof head)/fd', check=False), 'a reader')
    send(s, button('left', True))
    move(s, 40, 0)
    send(s, button('left', False))
    s.guest.wait(lambda: s.guest.sh('pidof head', check=False) == '', 'the mouse to be read')
    s.guest.tap('ctrl-alt-f1')
    s.guest.wait(lambda: is_active(s, 1), 'console 1')
    shows(s, 'hk+')


def nearly(a, b):
    """Hardly a pixel in a hundred differs: edges that an angle of a hundredth of a degree has moved."""
    return sum(x != y for x, y in zip(a.rgb, b.rgb)) < 3 * SIZE[0] * SIZE[1] // 100


def press(s):
    """The left button, until the kernel has told of it: QEMU puts what a USB tablet has not sent yet into one report, and
    then the pen would go down where it moves to next."""
    node = s.guest.sh("sed -n '/Tablet/,/^$/s/.*\\(event[0-9]*\\).*/\\1/p' /proc/bus/input/devices").split()[-1]
    s.guest.sh('cat /dev/input/%s >/tmp/pressed & :' % node)
    s.guest.wait(lambda: '/dev/input/' in s.guest.sh('ls -l /proc/$(pidof cat)/fd', check=False), 'a reader')
    send(s, button('left', True))
    s.guest.wait(lambda: '0001 0110 0001' in ' '.join(s.guest.sh('od -An -v -tx2 /tmp/pressed').split()), 'the button')
    s.guest.sh('kill $(pidof cat)')


def tablet(s, kind):
    """The gaze is where the pen is; a drag through the whole width is half a turn. It is counted in 2^-16 of the width,
    so that the picture is nearly that of keys."""
    typed(s)
    start(s, '--gaze', '60,50', *EYE)
    plug(s, kind)
    for place in ((130, 50), (20, 100)):
        put(s, *place)
        looks_at(s, *place)
    s.guest.tap('esc')
    s.ends(0)
    unplug(s, kind)
    start(s)
    plug(s, kind)
    put(s, 60, 60)
    press(s)
    for x, keys in ((65, 'h'), (75, 'hhh'), (70, 'hh')):
        put(s, x, 60)
        s.guest.wait(lambda: nearly(s.eye.sees(s.guest), typed(s)[keys]), 'nearly the picture of ' + keys)
    send(s, button('left', False))
    unplug(s, kind)
    s.guest.tap('esc')
    s.ends(0)


def ps2_mouse(s):
    mouse(s, 'ps2')


def usb_mouse(s):
    mouse(s, 'usb-mouse')


def virtio_mouse(s):
    mouse(s, 'virtio-mouse-pci')


def usb_tablet(s):
    tablet(s, 'usb-tablet')


def virtio_tablet(s):
    tablet(s, 'virtio-tablet-pci')


def none_there(s):
    """Without a mouse there is the plain picture, and the gaze stays."""
    start(s, '--gaze', '60,50', *EYE)
    s.guest.tap('esc')
    s.ends(0)


ALL = [ps2_mouse, usb_mouse, usb_tablet, virtio_mouse, virtio_tablet]
