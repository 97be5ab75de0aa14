"""Cases about the console below: it is alive after every kind of end, and others have it in between."""
import random
import time

from guest import QCODES, Failure


def signals(s):
    """Every deadly signal leaves a living console; a crash is survived by the guardian."""
    for signal, status in (('TERM', 143), ('INT', 130), ('HUP', 129), ('SEGV', 139), ('KILL', 137)):
        s.start()
        s.kill(signal)
        s.ends(status)


def keys_that_quit(s):
    """Ctrl-C and any typing key quit; modifiers and locks do nothing, here or to the console."""
    for key in ('ctrl-c', 'x', 'f5', 'ret'):
        s.start()
        for modifier in ('shift', 'ctrl', 'alt', 'caps_lock', 'num_lock'):
            s.guest.tap(modifier)
        s.guest.tap('a')
        s.frame('a')
        s.guest.tap(key)
        s.ends(0)


def held_through(s):
    """Keys that are down when tia begins or ends type nothing into the console: neither the return
    that started it nor the one that ends it."""
    s.console.forget()
    s.guest.sh('rm -rf /tmp/session')
    s.line = 'session tia -k s ' + ' '.join(s.display)
    s.guest.type_slowly(QCODES.get(character, character) for character in s.line)
    s.guest.press('ret')
    s.frame('s')
    s.guest.release('ret')
    s.guest.tap('d')
    s.frame('d')
    s.guest.press('q')
    s.guest.sh('sleep 0.5')
    s.guest.release('q')
    s.ends(0)


def serial(s):
    """Without a VT of its own, tia takes the console in front."""
    s.start(serial=True)
    s.guest.tap('s')
    s.frame('s')
    s.guest.tap('spc')
    s.ends(0)
    s.start(serial=True)
    s.kill('KILL')
    s.ends(137)


def terminal_keys(s):
    """-i tty listens to the console itself, whose settings come back."""
    s.start('-i', 'tty')
    s.guest.tap('a')
    s.guest.tap('right')
    s.frame('a<right>')
    s.guest.tap('pgup')
    s.frame('a<right><pgup>')
    s.guest.tap('ctrl-c')
    s.ends(0)


def other_text(s):
    """What the console on tty2 shows."""
    s.guest.sh('chvt 2')
    text = s.console.steady(unlike=s.console.text)
    s.guest.sh('chvt 1')
    s.guest.wait(s.console.sees_text, 'the console')
    return text


def is_active(s, number):
    return s.guest.sh('probe vt 1').startswith('active=%d ' % number)


def is_master(s):
    """Whether tia is the display's master, in the kernel's list: command, pid, dev, master, ..."""
    clients = [line.split() for line in s.guest.sh('cat /sys/kernel/debug/dri/0/clients').splitlines()]
    return any(client[0] == 'tia' and client[3] == 'y' for client in clients)


def switch(s):
    """Ctrl-Alt-F2 gives screen and keyboard away, Ctrl-Alt-F1 takes them back."""
    text = other_text(s)
    s.start('-k', 'a', first='a')
    if s.setup.display == 'drm' and not is_master(s):
        raise Failure('tia is not master of the display')
    s.guest.tap('ctrl-alt-f2')
    s.guest.wait(lambda: is_active(s, 2), 'console 2')
    s.guest.wait(lambda: s.eye.sees(s.guest) == text, 'the text of console 2')
    if s.guest.sh('probe grabbed'):
        raise Failure('a keyboard is grabbed behind the back of console 2')
    if s.setup.display == 'drm' and is_master(s):
        raise Failure('tia is still master of the display behind the back of console 2')
    s.guest.type('other\n')
    s.guest.wait(lambda: s.console.read(2) == ['other'], lambda: 'keys on console 2: it read %r' % s.console.read(2))
    s.guest.tap('ctrl-alt-f1')
    s.frame('a')
    s.guest.tap('right')
    s.frame('a<right>')
    s.guest.tap('esc')
    s.ends(0)


def ends_away(s):
    """A tia that ends while another console is in front leaves that one alone."""
    text = other_text(s)
    for signal, status in (('TERM', 143), ('KILL', 137)):
        s.start()
        s.guest.tap('ctrl-alt-f2')
        s.guest.wait(lambda: is_active(s, 2), 'console 2')
        s.kill(signal)
        s.status()
        s.guest.wait(lambda: s.eye.sees(s.guest) == text, 'the text of console 2')
        s.guest.tap('ctrl-alt-f1')
        s.ends(status)


def second(s):
    """A second tia on the same screen is refused and does not disturb the first."""
    s.start()
    answer = s.guest.sh('tia %s -i none -n 1 </dev/null 2>&1; echo $?' % ' '.join(s.display)).splitlines()
    if answer[-1] != '3' or len(answer) != 2 or 'in use by tia' not in answer[0]:
        raise Failure('a second tia: %r' % answer)
    s.guest.tap('d')
    s.frame('d')
    s.guest.tap('esc')
    s.ends(0)


def start_another(s):
    """From the serial line, with the console's keyboard."""
    s.guest.sh('(tia %s -k "" </dev/null >/dev/null 2>/tmp/another.err; echo $? >/tmp/another) &' % ' '.join(s.display))


def ended(s):
    """The statuses of those of the two that have ended, the one on the console first; '': both run."""
    return [name + '=' + status for name, status in (('console', s.file('status')),
            ('serial', s.guest.sh('cat /tmp/another 2>/dev/null', check=False))) if status]


def two_at_once(s):
    """Of two that start in one moment, on one display, one draws and the other is refused: for the display, or for the
    keyboard if it came between the other's keyboard and display."""
    reasons = {'3': 'in use by tia', '4': 'another program has grabbed it'}
    for _ in range(s.times(15)):
        s.guest.sh('rm -f /tmp/another*')
        start_another(s)
        s.run(*s.display)
        s.guest.wait(lambda: ended(s), 'one to be refused')
        refused = ended(s)
        said = s.guest.sh('cat /tmp/another.err') + s.file('err')
        if len(refused) != 1 or len(said.splitlines()) != 1 or reasons.get(refused[0][-1], '?') not in said:
            raise Failure('ended: %s, said: %r' % (refused, said))
        want = s.expected('')
        s.guest.wait(lambda: s.eye.sees(s.guest) == want, 'the picture of the other')
        s.guest.tap('esc')
        s.guest.wait(lambda: len(ended(s)) == 2, 'the end of the other')
        s.ends(0, 3, 4)


def master(s):
    """A display that another program is master of is refused by name."""
    s.guest.sh('probe master /dev/dri/card0 >/tmp/master & echo $! >/tmp/master.pid')
    s.guest.wait(lambda: s.guest.sh('cat /tmp/master') == 'master', 'another master')
    s.run(*s.display)
    s.refused(3, '/dev/dri/card0', 'probe')
    s.guest.sh('kill $(cat /tmp/master.pid)')


def exhausted(s):
    """No room on the disk, no memory to start with, and the kernel's out-of-memory killer."""
    s.run(command='sh -c "exec tia %s --checksum >/dev/full"' % ' '.join(s.display))
    s.refused(1)
    ends = set()
    # Above the program's own pages: with less the kernel kills it before its first instruction.
    for kilobytes in range(16000, 5000, -1000 if s.full else -2000):
        s.run(command='sh -c "ulimit -v %d; exec tia -k a %s"' % (kilobytes, ' '.join(s.display)))
        if s.shown_or_ended('a') == 'shown':
            s.guest.tap('esc')
        s.ends(0, 1, 3, 127, 134)   # 127 from the loader, 134 from GLib before main: below what libraries need
        ends.add(s.status())
    if not ends & {1, 3}:
        raise Failure('memory was short for nobody: statuses %s' % ends)
    s.start()
    s.guest.sh('echo 1000 >/proc/%s/oom_score_adj; echo f >/proc/sysrq-trigger' % s.pid())
    s.ends(137)


def limited(s):
    """A control group's limit on memory: tia shows its picture, refuses in one line, or is killed; the console lives."""
    group = '/tmp/cgroup/limited'
    s.guest.sh('mkdir -p /tmp/cgroup; mount -t cgroup2 none /tmp/cgroup; echo +memory >/tmp/cgroup/cgroup.subtree_control;'
               'mkdir %s' % group)
    ends = set()
    limits = 64, 256, 512, 800, 1200, 2000, 3000, 4000, 6000, 8000, 20000
    for kilobytes in limits if s.full else limits[::2]:
        s.guest.sh('echo %dK >%s/memory.max' % (kilobytes, group))
        s.run(command='sh -c "echo \\$\\$ >%s/cgroup.procs; exec tia -k a %s"' % (group, ' '.join(s.display)))
        if s.shown_or_ended('a') == 'shown':
            s.guest.tap('esc')
        s.ends(0, 1, 3, 137)
        ends.add(s.status())
    s.guest.sh('rmdir %s; umount /tmp/cgroup' % group)
    if not {0, 137} <= ends:
        raise Failure('statuses %s: no limit was too small, or none large enough' % ends)


# ---- many times ----

def kill_at_once(s):
    s.kill('KILL')


def kill_stopped(s):
    s.kill('STOP')
    s.kill('KILL')


def kill_continued(s):
    for signal in ('STOP', 'CONT', 'STOP', 'CONT', 'KILL'):
        s.kill(signal)


def kill_behind(s):
    """With console 2 in front, or a switch to it under way."""
    s.frame('')
    s.guest.tap('ctrl-alt-f2')
    s.kill('KILL')
    s.status()
    s.guest.sh('timeout 20 chvt 2; timeout 20 chvt 1')


def kills(s):
    """SIGKILL at random moments, from before the first instruction to long after the first frame, also of a tia that is
    or was stopped, or that is giving the console away."""
    moments = random.Random(1)
    ways = (kill_at_once, kill_stopped, kill_at_once, kill_continued, kill_at_once, kill_behind)
    for i in range(s.times(100)):
        s.run(*s.display)
        s.pid()
        time.sleep(moments.choice((0.02, 0.1, 0.5)) * moments.random())
        way = ways[i % len(ways)]
        try:
            way(s)
            s.ends(137)
        except Failure as failure:
            raise Failure('kill %d, %s: %s' % (i + 1, way.__name__, failure), getattr(failure, 'want', None))


def switches(s):
    """Console 2 and back, again and again; every tenth time all of it is looked at."""
    text = other_text(s)
    s.start('-k', 'd', first='d')
    for i in range(s.times(200)):
        s.guest.tap('ctrl-alt-f2')
        s.guest.wait(lambda: is_active(s, 2), 'console 2, time %d' % i)
        if i % 10 == 0:
            s.guest.wait(lambda: s.eye.sees(s.guest) == text, 'the text of console 2')
        s.guest.tap('ctrl-alt-f1')
        s.guest.wait(lambda: is_active(s, 1), 'console 1, time %d' % i)
        if i % 10 == 0:
            s.frame('d')
    s.frame('d')
    s.guest.tap('esc')
    s.ends(0)
