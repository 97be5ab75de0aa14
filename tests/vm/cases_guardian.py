"""Cases about the guardian: what becomes of the console when it dies, alone or with tia, and while tia
is stopped."""
from cases_console import is_active, other_text
from guest import Failure


def guardians(s):
    """The process numbers of the guardian and its spare, in one line."""
    return s.guest.sh('for p in /proc/[0-9]*; do [ "$(cat $p/comm 2>/dev/null)" = console-guard ] && '
                      'echo -n "${p#/proc/} "; done; true').strip()


def replace_guardian(s):
    old = set(guardians(s).split())
    s.guest.sh('kill -9 ' + ' '.join(old))

    def found():
        new = set(guardians(s).split())
        return len(new) == 2 and not new & old
    s.guest.wait(found, 'a new guardian and its spare')


def first_guardian(s):
    """The one that is not the spare, tia's child."""
    return s.guest.sh("for p in %s; do [ \"$(sed 's/.*) //' /proc/$p/stat | cut -d' ' -f2)\" = %s ] && echo $p; done; true"
                      % (guardians(s), s.pid()))


def guardian_killed(s):
    """Another one stands in at once, again and again, and puts the console back."""
    s.start()
    for _ in range(3):
        replace_guardian(s)
    s.guest.tap('a')
    s.frame('a')
    s.kill('KILL')
    s.ends(137)


def killed_with_its_guardian(s):
    """In one moment: the spare puts the console back."""
    for turn in (1, -1):
        s.start()
        s.guest.sh('kill -9 ' + ' '.join([s.pid(), first_guardian(s)][::turn]))
        s.ends(137)


def chosen_by_nobody(s):
    """Root's guardian outlives every choice of the kernel's."""
    s.start()
    scores = [s.guest.sh('cat /proc/%s/oom_score_adj' % pid) for pid in guardians(s).split()]
    if scores != ['-1000', '-1000']:
        raise Failure('its and its spare\'s oom_score_adj are %s' % scores)
    s.guest.tap('esc')
    s.ends(0)


def kill_both(s):
    s.start()
    s.guest.sh('kill -9 %s %s' % (s.pid(), guardians(s)))
    s.status()
    s.guest.wait(lambda: not guardians(s), 'the end of the guardian')


def chvt(s, number):
    s.guest.sh('timeout 20 chvt %d' % number)
    s.guest.wait(lambda: is_active(s, number), 'console %d' % number)


def both_killed(s):
    """In one moment. Then a new tia finds a console that nobody has and leaves it whole; so does the
    text mode that systemd gives a getty, which a DRM display has not even taken away."""
    kill_both(s)
    said = s.guest.sh('tia %s -i none -n 1 </dev/null 2>&1; echo $?' % ' '.join(s.display))
    if said != '0':
        raise Failure('a new tia: %r' % said)
    s.console.alive(s.line)
    kill_both(s)
    if s.setup.display == 'fbdev':
        s.guest.sh('probe text 1')
    s.guest.wait(s.console.sees_text, 'the text of the console')
    s.console.forget()
    s.guest.type('typed\n')
    s.guest.wait(lambda: s.console.read() == ['typed'], lambda: 'keys on the console: it read %r' % s.console.read())
    # The kernel frees the console of a dead process when it is to be switched.
    other_text(s)
    s.console.forget()
    s.console.alive()


def both_killed_and_switched(s):
    """By keys: the kernel frees the console of a dead process, and both consoles take keys. After a DRM display they
    show their text. On a framebuffer the kernel need not draw any, and a getty's text mode is none that is new: the
    next tia helps."""
    fbdev = s.setup.display == 'fbdev'
    text = other_text(s)
    kill_both(s)
    switch_by_keys(s, 2)
    types_there(s)
    if not fbdev:
        s.guest.wait(lambda: s.eye.sees(s.guest) == text, 'the text of console 2')
    switch_by_keys(s, 1)
    s.guest.sh('probe text 1')
    s.console.forget()
    s.guest.type('typed\n')
    s.guest.wait(lambda: s.console.read() == ['typed'], lambda: 'keys on the console: it read %r' % s.console.read())
    if not fbdev:
        s.guest.wait(s.console.sees_text, 'the text of the console')
    s.guest.sh('tia %s -i none -n 1 </dev/null' % ' '.join(s.display))
    s.console.alive('typed')


def switch_by_keys(s, number):
    s.guest.tap('ctrl-alt-f%d' % number)
    s.guest.wait(lambda: is_active(s, number), 'console %d by keys' % number)


def types_there(s):
    s.console.forget()
    s.guest.type('there\n')
    s.guest.wait(lambda: s.console.read(2) == ['there'], lambda: 'keys on console 2: it read %r' % s.console.read(2))


def stopped(s):
    """A stopped tia keeps nobody from another console, there and back, and goes on where it is; also after its guardian
    was replaced."""
    text = other_text(s)
    s.start('-k', 'a', first='a')
    s.kill('STOP')
    chvt(s, 2)
    types_there(s)
    chvt(s, 1)
    s.kill('CONT')
    s.frame('a')
    s.wait_grabbed(1)
    s.guest.tap('right')
    s.frame('a<right>')
    replace_guardian(s)
    s.kill('STOP')
    s.guest.press('ctrl', 'alt', 'f2')
    s.guest.wait(lambda: is_active(s, 2), 'console 2 by keys')
    s.guest.release('f2', 'alt', 'ctrl')
    s.kill('CONT')
    s.guest.wait(lambda: s.eye.sees(s.guest) == text, 'the text of console 2')
    types_there(s)
    s.guest.tap('ctrl-alt-f1')
    s.frame('a<right>')
    s.guest.tap('left')
    s.frame('a<right><left>')
    s.console.forget()
    s.guest.tap('esc')
    s.status()
    s.console.alive()


def killed_while_stopped(s):
    """With another console in front, which it stays."""
    text = other_text(s)
    s.start()
    s.kill('STOP')
    chvt(s, 2)
    s.kill('KILL')
    s.status()
    s.guest.wait(lambda: s.eye.sees(s.guest) == text, 'the text of console 2')
    s.guest.tap('ctrl-alt-f1')
    s.ends(137)


def switches_under_way(s):
    """The states of the processes that wait for a switch."""
    return s.guest.sh('for p in /proc/[0-9]*; do [ "$(cat $p/comm 2>/dev/null)" = chvt ] && '
                      'sed "s/.*) //;s/ .*//" $p/stat; done; true').split()


def killed_while_switching(s):
    """A switch that waits for a tia that cannot answer any more is completed by its guardian: it does not wait for ever."""
    text = other_text(s)
    s.start()
    s.guest.sh('kill -STOP %s %s; chvt 2 >/dev/null 2>&1 &' % (guardians(s), s.pid()))
    s.guest.wait(lambda: switches_under_way(s) == ['S'], 'a switch that waits')
    s.guest.sh('kill -KILL %s; kill -CONT %s' % (s.pid(), guardians(s)))
    s.status()
    s.guest.wait(lambda: not switches_under_way(s), 'the end of the switch')
    s.guest.wait(lambda: is_active(s, 2) and s.eye.sees(s.guest) == text, 'the text of console 2')
    s.guest.tap('ctrl-alt-f1')
    s.ends(137)


ALL = [guardian_killed, killed_with_its_guardian, chosen_by_nobody, both_killed, both_killed_and_switched, stopped,
       killed_while_stopped, killed_while_switching]
