"""Cases about keyboards: every kind, coming, going, several, out of reach, and none."""
import random

from cases_display import MOVES, QEMU_KEY
from guest import Failure

UINPUT = {'<left>': 105, '<right>': 106, '<up>': 103, '<down>': 108}


def nodes(s):
    """The event devices. Not by ls, which fails when one goes while it looks."""
    return s.guest.sh('echo /dev/input/event*')


def plug(s, kind):
    """Plugs a keyboard of this kind in; what is typed now comes from it."""
    before = nodes(s)
    device = {'usb-kbd': {'bus': 'usb.0'}, 'virtio-keyboard-pci': {}}[kind]
    s.guest.qmp('device_add', driver=kind, id='plugged', **device)
    s.guest.wait(lambda: nodes(s) != before, kind)


def unplug(s):
    before = nodes(s)
    s.guest.qmp('device_del', id='plugged')
    s.guest.wait(lambda: nodes(s) != before, 'the keyboard to go')


def plugged_before(s, kind):
    plug(s, kind)
    s.start()
    s.guest.tap('w')
    s.frame('w')
    s.guest.tap('esc')
    s.ends(0)
    unplug(s)


def plugged_while_running(s, kind):
    """Plugged in while running, and pulled out while a key is down: that key is up again."""
    s.start('-k', 's', '--checksum', first='s')
    plug(s, kind)
    s.wait_grabbed(2)
    drawn = s.frames_drawn()
    s.guest.press('right')
    s.guest.wait(lambda: s.frames_drawn() >= drawn + 3, 'a held key to repeat')
    unplug(s)
    s.guest.tap('w')            # a frame that was on its way would go on from here
    s.frame('w')
    s.guest.sh('sleep 1')
    s.guest.tap('left')
    s.frame('w<left>')
    s.guest.tap('esc')
    s.ends(0)
    s.guest.release('right')


def usb(s):
    plugged_before(s, 'usb-kbd')


def usb_hotplug(s):
    plugged_while_running(s, 'usb-kbd')


def virtio(s):
    plugged_before(s, 'virtio-keyboard-pci')


def virtio_hotplug(s):
    plugged_while_running(s, 'virtio-keyboard-pci')


def comes_and_goes(s):
    """A keyboard plugged in and out again and again, with a key down and without: no frame comes by itself afterwards, and
    no file stays open."""
    moves = random.Random(3)
    s.start('-k', 's', '--checksum', first='s')
    counts = set()
    for i in range(s.times(50)):
        plug(s, 'usb-kbd')
        s.wait_grabbed(2)
        key = moves.choice(('right', 'left', 'up', 'pgdn'))
        s.guest.press(key)
        if i % 3:
            drawn = s.frames_drawn()
            s.guest.wait(lambda: s.frames_drawn() > drawn, 'a frame')
        unplug(s)
        s.guest.tap('w')
        s.frame('w')
        s.guest.release(key)
        counts.add(s.guest.sh('ls /proc/%s/fd | wc -l' % s.pid()))
    if len(counts) != 1:
        raise Failure('open files after each: %s' % counts)
    s.guest.tap('esc')
    s.ends(0)


def two(s):
    """Two keyboards at once, keys down on both."""
    before = nodes(s)
    s.guest.sh('mkfifo /tmp/keys; probe keyboard Second </tmp/keys >/dev/null 2>&1 & echo $! >/tmp/keys.pid')
    s.guest.sh('sleep 1000 >/tmp/keys & echo $! >/tmp/keys.open')
    s.start()
    s.wait_grabbed(2)
    s.guest.press('a')
    s.frame('a')
    s.guest.sh('echo "%d 1" >/tmp/keys; echo "%d 0" >/tmp/keys' % (2 * (UINPUT['<right>'],)))
    s.frame('a<right>')
    s.guest.release('a')
    s.guest.tap('up')
    s.frame('a<right><up>')
    s.guest.tap('esc')
    s.ends(0)
    s.guest.sh('kill $(cat /tmp/keys.open /tmp/keys.pid); rm /tmp/keys*')
    s.guest.wait(lambda: nodes(s) == before, 'the keyboard to go')


def unreadable(s):
    """Without the right to read the keyboard the screen is not taken; the message says why."""
    s.guest.sh('chmod 666 /dev/dri/* /dev/fb0; chown 1000 /dev/tty1; chgrp 104 /dev/input/event*')
    s.run(*s.display, wrap='probe as 1000 ')
    s.refused(4, '/dev/input/event', 'ermission denied', 'input')
    s.guest.sh('chown 0 /dev/tty1')


def none(s):
    """Without any keyboard the screen is taken only where no input is asked for."""
    s.run(*s.display)
    s.refused(4, 'keyboard')
    s.run(*s.display, '-i', 'none')
    s.refused(4)
    s.run(*s.display, '-i', 'none', '-n', '3', '--checksum')
    s.ends(0)
    if s.frames_drawn() != 3:
        raise Failure('%d frames, not 3' % s.frames_drawn())


def thousand(s, groups=10, at_once=5):
    """1,000 keys: every one is drawn and none reaches the console. They come five at a time,
    as many as the kernel keeps for a program that is busy drawing."""
    keys = random.Random(2)
    s.start()
    for _ in range(s.times(20)):
        typed = ''
        for group in range(groups):
            names = ['a' if not (typed or i) else keys.choice(MOVES) for i in range(at_once)]
            s.guest.type_slowly(QEMU_KEY.get(name, name) for name in names)
            typed += ''.join(names)
            s.frame(typed)
    s.guest.tap('esc')
    s.ends(0)
