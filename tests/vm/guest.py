"""A guest: Linux in QEMU under software emulation, watched and typed at from outside.

    with Guest(qemu=['-vga', 'std'], append='vga=0x314') as guest:
        guest.sh('ls /dev')             # a shell line; raises when it fails
        guest.screen()                  # what the display controller scans out
        guest.tap('ctrl-alt-f2')        # keys of QEMU's keyboard, by QEMU's names
"""
import contextlib
import json
import os
import re
import select
import shutil
import socket
import subprocess
import tempfile
import time

import image
import picture

# QEMU's names of keys whose character is not their name.
QCODES = {' ': 'spc', '\n': 'ret', '-': 'minus', '/': 'slash', '.': 'dot'}


class Failure(Exception):
    """A test's finding; `want` is the picture that should have been seen."""

    def __init__(self, text, want=None):
        super().__init__(text)
        self.want = want


class Line:
    """Lines from a UNIX socket that QEMU listens on, each with a deadline."""

    def __init__(self, path, process, deadline):
        self.socket, self.buffer = socket.socket(socket.AF_UNIX), b''
        while True:
            try:
                self.socket.connect(path)
                return
            except OSError:
                if process.poll() is not None or time.monotonic() > deadline:
                    raise Failure('QEMU did not start')
                time.sleep(0.02)

    def read(self, deadline):
        while b'\n' not in self.buffer:
            left = deadline - time.monotonic()
            if left <= 0 or not select.select([self.socket], [], [], left)[0]:
                raise Failure('no answer in time; so far: %r' % self.buffer[-500:])
            data = self.socket.recv(65536)
            if not data:
                raise Failure('the guest ended; so far: %r' % self.buffer[-500:])
            self.buffer += data
        line, self.buffer = self.buffer.split(b'\n', 1)
        return line.rstrip(b'\r').decode('utf-8', 'replace')

    def write(self, text):
        self.socket.sendall(text.encode() + b'\n')


class Guest:
    running = []        # those that a signal has to end
    PATIENCE = 120      # seconds for anything to happen: a limit for hung guests, no measure of speed

    def __init__(self, qemu=(), append='', modules=(), memory='256M', machine='pc', accel='tcg'):
        self.directory = tempfile.mkdtemp(prefix='tia-vm.')
        self.log, self.waiting = open(os.path.join(self.directory, 'session.log'), 'w+'), False
        self.kernel_log = os.path.join(self.directory, 'kernel.log')
        kernel = image.BZIMAGE if 'vga=' in append else image.VMLINUX
        command = ['qemu-system-x86_64', '-accel', accel, '-cpu', 'max', '-machine', machine, '-m', memory,
                   '-nodefaults', '-no-user-config', '-no-reboot', '-display', 'none', '-kernel', kernel,
                   '-initrd', image.IMAGE, '-serial', 'file:' + self.kernel_log,
                   '-serial', 'unix:%s/agent,server=on,wait=off' % self.directory,
                   '-qmp', 'unix:%s/qmp,server=on,wait=off' % self.directory, *qemu,
                   '-append', 'console=ttyS0 panic=-1 quiet no_timer_check mitigations=off nokaslr %s mods=%s' % (append, ','.join(modules))]
        if '-vga' not in command:
            command += ['-vga', 'none']
        self.note('$ ' + ' '.join(command))
        self.process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=self.log, stderr=self.log)
        self.running.append(self)
        try:
            self._connect()
        except BaseException:
            self.close()
            raise

    def _connect(self):
        deadline = time.monotonic() + self.PATIENCE
        self.monitor = Line(self.directory + '/qmp', self.process, deadline)
        self.monitor.read(deadline)
        self.qmp('qmp_capabilities')
        self.agent = Line(self.directory + '/agent', self.process, deadline)
        while not self.agent.read(deadline).endswith('@ready'):
            pass

    def note(self, text):
        if self.waiting:        # the first look is enough
            return
        self.log.write(text + '\n')
        self.log.flush()

    def leave(self, directory):
        """Leaves the screen and the logs in a directory."""
        with contextlib.suppress(Failure, OSError):
            self.screen().save(os.path.join(directory, 'screen.png'))
        for name in ('session.log', 'kernel.log'):
            shutil.copy(os.path.join(self.directory, name), directory)

    def close(self):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        self.running.remove(self)
        self.log.close()
        shutil.rmtree(self.directory, ignore_errors=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    # ---- the three ways in: QEMU's monitor, the keyboard, the agent ----

    def qmp(self, execute, **arguments):
        self.monitor.write(json.dumps({'execute': execute, 'arguments': arguments}))
        while True:
            answer = json.loads(self.monitor.read(time.monotonic() + self.PATIENCE))
            if 'error' in answer:
                raise Failure('%s: %s' % (execute, answer['error']['desc']))
            if 'return' in answer:
                return answer['return']

    def press(self, *keys, down=True):
        """The edges of some keys, in this order, all at once."""
        self.note('keys %s %s' % (' '.join(keys), 'down' if down else 'up'))
        self._edges([(key, down) for key in keys])

    def release(self, *keys):
        self.press(*keys, down=False)

    def tap(self, keys):
        """Keys joined by "-", all down and up again. It takes the guest's clock no time, so that
        no key begins to repeat, however slow the guest is."""
        self.note('tap ' + keys)
        names = keys.split('-')
        self._edges([(key, True) for key in names] + [(key, False) for key in reversed(names)])

    def _edges(self, edges):
        self.qmp('input-send-event', events=[
            {'type': 'key', 'data': {'down': down, 'key': {'type': 'qcode', 'data': key}}} for key, down in edges])

    def type(self, text):
        for character in text:
            self.tap(QCODES.get(character, character))

    def type_slowly(self, keys):
        """Taps keys one by one; each has left the keyboard's own short queue before the next."""
        for key in keys:
            self.tap(key)
            self.sh(':')

    def sh(self, line, check=True):
        """Runs a shell line in the guest and returns its output."""
        self.note('# ' + line)
        self.agent.write(line)
        lines, status = [], None
        while status is None:
            text = self.agent.read(time.monotonic() + self.PATIENCE)
            end = re.match(r'(.*)@rc (\d+)$', text)
            status = int(end[2]) if end else None
            lines.append(end[1] if end else text)
        output = '\n'.join(lines).rstrip('\n')
        self.note(output)
        if check and status:
            raise Failure('guest: %s: status %d: %s' % (line, status, output))
        return output

    # ---- what is seen ----

    def screen(self):
        path = os.path.join(self.directory, 'screen.ppm')
        self.qmp('screendump', filename=path)
        return picture.read_ppm(path)

    def kernel_messages(self):
        return open(self.kernel_log, errors='replace').read()

    def wait(self, condition, what):
        """The first true value of condition(); Failure when there is none."""
        deadline, pause = time.monotonic() + self.PATIENCE / 4, 0.01
        outer = self.waiting
        try:
            while time.monotonic() < deadline:
                value = condition()
                if value:
                    return value
                time.sleep(pause)
                self.waiting, pause = True, min(2 * pause, 0.1)
        finally:
            self.waiting = outer
        raise Failure('waited in vain: ' + (what() if callable(what) else what))

    def shows(self, want, what):
        """Waits until the controller scans out exactly this picture."""
        try:
            self.wait(lambda: self.screen() == want, what)
        except Failure:
            raise Failure('%s: %s' % (what, self.screen().differs(want)), want)
