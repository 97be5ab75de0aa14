"""What a guest boots: Debian's own kernel, and a first file system of busybox, drivers and programs.

Nothing is installed and nobody needs to be root: the kernel's package is downloaded and unpacked
in BUILD/vm, once. Debian does not build vkms, the one driver with vertical blanks; where the
kernel's headers are installed it is built from Debian's kernel source.
"""
import contextlib
import fcntl
import glob
import lzma
import os
import re
import shutil
import stat
import subprocess
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
BUILD = os.path.abspath(os.environ.get('BUILD', 'build'))
WORK = os.path.join(BUILD, 'vm')
KERNEL = os.path.join(WORK, 'kernel')
BZIMAGE = os.path.join(KERNEL, 'vmlinuz')   # starts in real mode: understands vga=
VMLINUX = os.path.join(KERNEL, 'vmlinux')   # unpacked, for QEMU's PVH entry: boots 2 s sooner
IMAGE = os.path.join(WORK, 'image.cpio')

MODULES = ('evdev uinput bochs virtio-gpu cirrus qxl vkms cirrusfb vfb virtio_pci virtio_input '
           'usbhid hid-generic xhci-pci psmouse').split()


class Missing(Exception):
    """The machine lacks something; the text names the package."""


def tool(name, package):
    """The path of a program, or Missing."""
    path = shutil.which(name, path=os.environ.get('PATH', '') + ':/usr/sbin:/sbin')
    if not path:
        raise Missing('no %s (package %s)' % (name, package))
    return path


def call(*command, cwd=None):
    """Runs a command quietly; its output is in the exception when it fails."""
    done = subprocess.run(command, cwd=cwd, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode:
        raise RuntimeError('%s: %s' % (' '.join(command), done.stdout[-2000:]))
    return done.stdout


# ---- the kernel ----

def download(package, directory):
    """The path of the package's file, downloaded unless it is there."""
    have = os.path.join(directory, package.replace('=', '_').replace(':', '%3a') + '_*.deb')
    if not glob.glob(have):
        try:
            call(tool('apt-get', 'apt'), 'download', package, cwd=directory)
        except RuntimeError as error:
            raise Missing('package %s cannot be downloaded: %s' % (package, str(error).splitlines()[-1]))
    return glob.glob(have)[0]


def headers():
    """The kernel releases whose headers are installed, the newest last."""
    return sorted(path.partition('headers-')[2] for path in glob.glob('/usr/src/linux-headers-*-amd64'))


def download_kernel(directory):
    """The package of the newest kernel, or of the one whose headers are here to build vkms with."""
    for release in reversed(headers()):
        with contextlib.suppress(Missing):
            return download('linux-image-' + release, directory)
    known = re.search(r'Depends: (linux-image-\d\S*)', call(tool('apt-cache', 'apt'), 'depends', 'linux-image-amd64'))
    if not known:
        raise Missing('package linux-image-amd64 is not known (run apt-get update)')
    return download(known[1], directory)


def unpack_vmlinux(bzimage, out):
    """Finds the compressed ELF kernel inside a bzImage."""
    data = open(bzimage, 'rb').read()
    start = data.find(b'\xfd7zXZ\0')
    while start >= 0:
        with contextlib.suppress(lzma.LZMAError):
            elf = lzma.LZMADecompressor(lzma.FORMAT_XZ).decompress(data[start:])
            if elf.startswith(b'\x7fELF'):
                open(out, 'wb').write(elf)
                return
        start = data.find(b'\xfd7zXZ\0', start + 1)
    raise RuntimeError('no XZ kernel in ' + bzimage)


def build_vkms(modules, version, release, directory):
    """Builds vkms.ko into `modules` when the kernel's headers are installed; else leaves it out."""
    if release not in headers():
        return
    series = '.'.join(release.split('.')[:2])
    source = download('linux-source-%s=%s' % (series, version), directory)
    subprocess.run('dpkg-deb --fsys-tarfile %s | tar -xO ./usr/src/linux-source-%s.tar.xz | '
                   'tar -xJ --wildcards "*/drivers/gpu/drm/vkms"' % (source, series),
                   shell=True, check=True, cwd=directory)
    vkms = os.path.join(directory, 'linux-source-' + series, 'drivers/gpu/drm/vkms')
    call('make', '-C', '/usr/src/linux-headers-' + release, 'M=' + vkms, 'CONFIG_DRM_VKMS=m', 'modules')
    os.makedirs(os.path.join(modules, 'extra'))
    call('strip', '--strip-debug', '-o', os.path.join(modules, 'extra/vkms.ko'), os.path.join(vkms, 'vkms.ko'))


def fetch_kernel():
    """Fills KERNEL: vmlinuz, vmlinux, and the modules of MODULES with what they need."""
    chosen = os.path.join(KERNEL, 'modules')    # an older version of this file chose others
    if os.path.exists(chosen) and open(chosen).read().split() == MODULES and (has_module('vkms') or not headers()):
        return
    busybox = static_busybox()
    with tempfile.TemporaryDirectory(dir=WORK) as scratch:
        deb = download_kernel(scratch)
        version = call('dpkg-deb', '-f', deb, 'Version').strip()
        call(tool('dpkg-deb', 'dpkg'), '-x', deb, scratch)
        release = os.path.basename(glob.glob(scratch + '/lib/modules/*')[0])
        modules = os.path.join(scratch, 'lib/modules', release)
        build_vkms(modules, version, release, scratch)
        call(busybox, 'depmod', '-b', scratch, release)
        shutil.rmtree(KERNEL, ignore_errors=True)
        os.makedirs(KERNEL)
        pick_modules(modules, os.path.join(KERNEL, 'root/lib/modules', release))
        call(busybox, 'depmod', '-b', os.path.join(KERNEL, 'root'), release)
        shutil.move(os.path.join(scratch, 'boot/vmlinuz-' + release), BZIMAGE)
        unpack_vmlinux(BZIMAGE, VMLINUX)
        with open(chosen, 'w') as out:
            out.write(' '.join(MODULES))


def pick_modules(tree, out):
    """Copies the modules of MODULES and all that modules.dep says they need."""
    for line in open(os.path.join(tree, 'modules.dep')):
        files = line.replace(':', ' ').split()
        if os.path.basename(files[0]).split('.')[0] in MODULES:
            for name in files:
                os.makedirs(os.path.join(out, os.path.dirname(name)), exist_ok=True)
                shutil.copy(os.path.join(tree, name), os.path.join(out, name))
    for name in ('modules.builtin', 'modules.order'):
        shutil.copy(os.path.join(tree, name), out)


def has_module(name):
    return bool(glob.glob(os.path.join(KERNEL, 'root/lib/modules/*/**', name + '.ko'), recursive=True))


# ---- the first file system ----

def static_busybox():
    path = tool('busybox', 'busybox-static')
    if libraries(path):
        raise Missing('%s is not static (package busybox-static)' % path)
    return path


def libraries(program):
    """The shared libraries of a program, as ldd finds them; none for a static one."""
    done = subprocess.run(['ldd', program], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    return re.findall(r'(/\S+) \(0x', done.stdout)


class Archive:
    """A cpio archive in the "newc" format, which the kernel unpacks at boot."""

    def __init__(self):
        self.out, self.count, self.known = [], 0, {'', '/'}

    def _entry(self, name, mode, data):
        self.count += 1
        name = name.strip('/').encode() + b'\0'
        fields = (self.count, mode, 0, 0, 1, 0, len(data), 0, 0, 0, 0, len(name), 0)
        head = b'070701' + b''.join(b'%08X' % field for field in fields) + name
        self.out += [head, b'\0' * (-len(head) % 4), data, b'\0' * (-len(data) % 4)]

    def directory(self, name):
        if name not in self.known:
            self.directory(os.path.dirname(name))
            self.known.add(name)
            self._entry(name, stat.S_IFDIR | 0o755, b'')

    def file(self, name, source):
        if name not in self.known:
            self.directory(os.path.dirname(name))
            self.known.add(name)
            mode = 0o755 if os.access(source, os.X_OK) else 0o644
            self._entry(name, stat.S_IFREG | mode, open(source, 'rb').read())

    def program(self, source):
        """A program in /bin, and its libraries where its loader looks for them."""
        self.file('/bin/' + os.path.basename(source), source)
        for library in libraries(source):
            self.file(library, library)

    def tree(self, source):
        for path, _, names in os.walk(source):
            for name in names:
                full = os.path.join(path, name)
                self.file('/' + os.path.relpath(full, source), full)

    def write(self, path):
        self._entry('TRAILER!!!', 0, b'')
        with open(path + '.new', 'wb') as out:
            out.write(b''.join(self.out))
        os.rename(path + '.new', path)


def pack():
    archive = Archive()
    for name in 'proc sys dev tmp root'.split():
        archive.directory('/' + name)
    archive.file('/bin/busybox', static_busybox())
    archive.file('/init', os.path.join(HERE, 'init'))
    for name in ('console', 'session'):
        archive.file('/bin/' + name, os.path.join(HERE, name))
    archive.file('/scenes/pointer.tia', os.path.join(HERE, 'pointer.tia'))
    for source in glob.glob(os.path.join(HERE, '../../scenes/*.*')):
        archive.file('/scenes/' + os.path.basename(source), source)
    archive.tree(os.path.join(KERNEL, 'root'))
    for name in ('tia', 'vm/probe', 'vm/controller', 'tests/test_ports'):
        archive.program(os.path.join(BUILD, name))
    archive.write(IMAGE)


def prepare():
    """Makes everything a guest needs; Missing names what the machine lacks."""
    tool('qemu-system-x86_64', 'qemu-system-x86')
    if os.uname().machine != 'x86_64':
        raise Missing('the guests are x86-64 and run the programs of this machine (%s)' % os.uname().machine)
    os.makedirs(WORK, exist_ok=True)
    with open(os.path.join(WORK, 'lock'), 'w') as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        fetch_kernel()
        pack()
