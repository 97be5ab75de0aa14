"""Cases about a keyboard that changes hands, between the console and tia, while its keys are down."""
from cases_console import is_active
from cases_keys import plug, unplug
from guest import Failure


def stays(s, count, what, seconds=1):
    """This count does not change for a while."""
    before = count()
    s.guest.sh('sleep %d' % seconds)
    if count() != before:
        raise Failure('%s: %d, and %d more' % (what, before, count() - before))


def lines(s):
    """How many lines the console has read, empty ones too."""
    return int(s.guest.sh('wc -l </tmp/tty1'))


def held_at_the_start(s):
    """Enter is still down when tia starts: it quits nothing and the console gets no more of it."""
    plug(s, 'usb-kbd')
    s.console.forget()
    s.guest.press('ret')
    s.guest.wait(lambda: lines(s) > 1, 'Enter to repeat')
    s.start(serial=True)
    stays(s, lambda: lines(s), 'lines on the console')
    s.guest.release('ret')
    s.console.forget()
    s.guest.tap('a')
    s.frame('a')
    s.guest.tap('esc')
    s.ends(0)
    unplug(s)


def modifiers_at_the_start(s):
    """Modifiers that come up while tia has the keyboard are up for the console."""
    for key in ('alt', 'ctrl', 'shift'):
        s.guest.press(key)
        s.start()
        s.guest.release(key)
        s.guest.tap('d')
        s.frame('d')
        s.guest.tap('esc')
        s.ends(0)


def held_at_the_end(s):
    """The key that quits, and Ctrl-C, are down for a while: neither is typed on the console."""
    plug(s, 'usb-kbd')
    for keys in (('q',), ('ctrl', 'c')):
        s.start()
        s.guest.press(*keys)
        s.guest.sh('sleep 0.6')
        s.guest.release(*reversed(keys))
        s.ends(0)
    unplug(s)


def held_at_a_kill(s):
    """A key that is down when tia is killed types nothing, however long it stays down; afterwards it
    types again."""
    plug(s, 'usb-kbd')
    for key in ('x', 'ret'):
        s.start()
        s.guest.tap('a')
        s.frame('a')
        s.kill('STOP')      # the key would end it
        s.guest.press(key)
        s.kill('KILL')
        s.status()
        s.guest.sh('sleep 1')
        s.guest.release(key)
        s.ends(137)
    unplug(s)


def modifiers_through_switches(s):
    """Ctrl and Alt stay down while F2 and F1 are pressed in turn."""
    s.start('-k', 's', first='s')
    s.guest.press('ctrl', 'alt')
    for i in range(3):
        for number in (2, 1):
            s.guest.tap('f%d' % number)
            s.guest.wait(lambda: is_active(s, number), 'console %d, time %d' % (number, i))
    s.guest.release('ctrl', 'alt')
    s.frame('s')
    s.guest.tap('left')
    s.frame('s<left>')
    s.guest.tap('esc')
    s.ends(0)


PPOLL = 271     # its number on x86-64; only the console's wait for events calls it


def reads_all(s):
    """Waits until tia has read its events and waits for others. A key that is pressed before may be lost, too: the kernel
    empties a full queue when the next event comes."""
    s.guest.wait(lambda: s.guest.sh('cat /proc/%s/syscall' % s.pid()).startswith('%d ' % PPOLL), 'tia to wait for events')


def events_lost(s):
    """More keys than the kernel keeps, among them the release of a held one: it is up."""
    s.start('-k', 'a', '--checksum', first='a')
    drawn = s.frames_drawn()
    s.guest.press('right')
    s.guest.wait(lambda: s.frames_drawn() >= drawn + 3, 'a held key to repeat')
    s.kill('STOP')
    s.guest.type_slowly(60 * ['up'])
    s.guest.release('right')
    s.kill('CONT')
    reads_all(s)
    s.guest.tap('w')
    s.frame('w')
    stays(s, s.frames_drawn, 'frames after the release was lost')
    s.guest.tap('esc')
    s.ends(0)


def right_to_read_later(s):
    """A keyboard plugged in is read as soon as its node may be opened, as udev does it."""
    s.guest.sh('chmod 666 /dev/input/event0; rm -rf /tmp/session')
    s.run('-d', 'none', '-s', '64x48', '-i', 'evdev', '--checksum', wrap='probe as 1000 ', serial=True)
    s.guest.wait(s.frames_drawn, 'the first frame')
    plug(s, 'usb-kbd')
    s.guest.sh('chmod 600 /dev/input/event1')
    s.guest.tap('a')
    stays(s, s.frames_drawn, 'frames by a keyboard that may not be read')
    s.guest.sh('chmod 666 /dev/input/event1')
    s.guest.wait(lambda: 'event1' in s.guest.sh('ls -l /proc/%s/fd' % s.pid()), 'the keyboard to be opened')
    s.guest.tap('d')
    s.guest.wait(lambda: s.frames_drawn() == 2, 'a frame by a keyboard that may be read')
    s.guest.tap('q')
    if s.status() != 0:
        raise Failure('tia ended with status %d: %s' % (s.status(), s.file('err')))
    unplug(s)


ALL = [modifiers_at_the_start, modifiers_through_switches, events_lost, held_at_the_start, held_at_the_end,
       held_at_a_kill, right_to_read_later]
