"""Boards in QEMU, and an AVR in simavr, for the tests: what they print, the keys they get, the screen they show."""
import json
import os
import re
import select
import shutil
import socket
import subprocess
import tempfile
import time

LIMIT = 120                     # seconds for anything; only a failure takes so long

# The arguments that make the board of each image, from the image's folder.
MACHINES = {
    'versatilepb': ['qemu-system-arm', '-M', 'versatilepb'],
    'vexpress-a9': ['qemu-system-arm', '-M', 'vexpress-a9'],
    'mps2-an385': ['qemu-system-arm', '-M', 'mps2-an385'],
    'mps2-an386': ['qemu-system-arm', '-M', 'mps2-an386'],
    'mps2-an500': ['qemu-system-arm', '-M', 'mps2-an500'],
    'lm3s6965evb': ['qemu-system-arm', '-M', 'lm3s6965evb'],
    'stm32vldiscovery': ['qemu-system-arm', '-M', 'stm32vldiscovery'],
    'microbit': ['qemu-system-arm', '-M', 'microbit'],
    'rv32': ['qemu-system-riscv32', '-M', 'virt', '-bios', 'none'],
}
AVR = 'atmega1284p'
# The boards with programs of their own that draw spheres in little memory.
SMALL = (('mps2-an385', 'Cortex-M3'), ('mps2-an386', 'Cortex-M4'), ('mps2-an500', 'Cortex-M7'), ('microbit', 'Cortex-M0'),
         ('rv32', 'rv32imac'), (AVR, 'ATmega1284P'))
PANELS = ('versatilepb', 'vexpress-a9')
PACKAGES = {'qemu-system-arm': 'qemu-system-arm', 'qemu-system-riscv32': 'qemu-system-misc',
            'arm-none-eabi-gcc': 'gcc-arm-none-eabi', 'riscv64-unknown-elf-gcc': 'gcc-riscv64-unknown-elf',
            'avr-gcc': 'gcc-avr'}
AVR_FILES = {'/usr/lib/avr/include/avr/io.h': 'avr-libc', '/usr/include/simavr/sim_avr.h': 'libsimavr-dev',
             '/usr/include/libelf.h': 'libelf-dev'}


def missing(board):
    """The packages that `board` needs and this machine has not."""
    tools = [binutil(board, 'gcc')] + ([] if board == AVR else [MACHINES[board][0]])
    return [PACKAGES[tool] for tool in tools if not shutil.which(tool)] + \
           [package for path, package in AVR_FILES.items() if board == AVR and not os.path.exists(path)]


def binutil(board, tool):
    """nm or size for the board's images."""
    return {'rv32': 'riscv64-unknown-elf-', AVR: 'avr-'}.get(board, 'arm-none-eabi-') + tool


class Failed(Exception):
    pass


def command(board, image, *more):
    if board == AVR:
        return [os.path.join(os.path.dirname(os.path.dirname(image)), 'simavr'), image, *more]
    return MACHINES[board] + ['-nodefaults', '-display', 'none', '-no-reboot', '-kernel', image] + list(more)


ENVIRONMENT = dict(os.environ, QEMU_AUDIO_DRV='none')


def run(board, image, *more):
    """Runs a program that ends by itself: what it printed, once it ended with status 0."""
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, 'out')
        console = [] if board == AVR else [
            '-chardev', 'file,id=console,path=' + out, '-serial', 'none',
            '-semihosting-config', 'enable=on,target=native,chardev=console']
        try:
            done = subprocess.run(command(board, image, *console, *more), stdin=subprocess.DEVNULL, env=ENVIRONMENT,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=LIMIT * 5, text=True)
        except subprocess.TimeoutExpired:
            raise Failed('did not end')
        text = open(out).read() if os.path.exists(out) else done.stdout if board == AVR else ''
        if done.returncode:
            raise Failed('ended with status %d: %s%s' % (done.returncode, text[-300:], done.stdout[-300:]))
        return text


class Panel:
    """A board with a panel and a keyboard, while it runs."""

    def __init__(self, board, image):
        self.folder = tempfile.mkdtemp(prefix='board.')
        self.serial = os.path.join(self.folder, 'serial')
        self.log = open(os.path.join(self.folder, 'log'), 'w+')
        control = os.path.join(self.folder, 'qmp')
        self.process = subprocess.Popen(
            command(board, image, '-serial', 'file:' + self.serial, '-qmp', 'unix:%s,server=on,wait=off' % control),
            stdin=subprocess.DEVNULL, stdout=self.log, stderr=self.log, env=ENVIRONMENT)
        self.buffer = b''
        try:
            self.connect(control)
        except BaseException:
            self.close()
            raise

    def connect(self, path):
        self.socket = socket.socket(socket.AF_UNIX)
        end = time.monotonic() + LIMIT
        while True:
            try:
                self.socket.connect(path)
                break
            except OSError:
                if self.process.poll() is not None or time.monotonic() > end:
                    raise Failed('QEMU did not start: ' + open(self.log.name).read()[-300:])
                time.sleep(0.02)
        self.answer()
        self.ask('qmp_capabilities')

    def answer(self):
        end = time.monotonic() + LIMIT
        while b'\n' not in self.buffer:
            if not select.select([self.socket], [], [], max(0, end - time.monotonic()))[0]:
                raise Failed('QEMU does not answer')
            data = self.socket.recv(65536)
            if not data:
                raise Failed('QEMU ended')
            self.buffer += data
        line, self.buffer = self.buffer.split(b'\n', 1)
        return json.loads(line)

    def ask(self, name, **arguments):
        self.socket.sendall(json.dumps({'execute': name, 'arguments': arguments}).encode() + b'\n')
        while True:
            answer = self.answer()
            if 'error' in answer:
                raise Failed('%s: %s' % (name, answer['error']['desc']))
            if 'return' in answer:
                return answer['return']

    def text(self):
        return open(self.serial).read() if os.path.exists(self.serial) else ''

    def until(self, pattern):
        """Waits until the serial line has said something that matches."""
        end = time.monotonic() + LIMIT
        while not re.search(pattern, self.text(), re.M):
            ended = self.process.poll() is not None
            if ended and re.search(pattern, self.text(), re.M):
                break
            if ended or time.monotonic() > end:
                raise Failed('the serial line never said "%s", but: %s' % (pattern, self.text()[-300:]))
            time.sleep(0.01)

    def type(self, name):
        """A key goes down and comes up at once, so that it never counts as held."""
        edges = [{'type': 'key', 'data': {'down': down, 'key': {'type': 'qcode', 'data': name}}}
                 for down in (True, False)]
        self.ask('input-send-event', events=edges)

    def screen(self):
        """Width, height and the RGB bytes of what the panel shows."""
        path = os.path.join(self.folder, 'screen.ppm')
        self.ask('screendump', filename=path)
        data = open(path, 'rb').read()
        head = re.match(rb'P6\s+(\d+)\s+(\d+)\s+255\s', data)
        return int(head[1]), int(head[2]), data[head.end():]

    def close(self):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        self.log.close()
        shutil.rmtree(self.folder, ignore_errors=True)

    def __enter__(self):
        return self

    def __exit__(self, *unused):
        self.close()
