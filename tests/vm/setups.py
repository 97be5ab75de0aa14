"""The guests: one for each driver, small screens where the driver lets one choose, because
software emulation draws slowly."""
from dataclasses import dataclass, field

import cases_console as console
import cases_display as display
import cases_hands as hands
import cases_keys as keys
import image
import picture
from session import Memory, Scanout, VkmsChecksum

# The columns of the table.
GROUPS = {
    'pictures': [display.frames, display.automatic],
    'held keys': [display.held],
    'latency': [display.latency],
    'pages, pacing': [display.panning, display.pacing],
    'keyboards': [keys.usb, keys.usb_hotplug, keys.virtio, keys.virtio_hotplug, keys.two, keys.unreadable, keys.none],
    'changing hands': hands.ALL,
    'quitting': [console.keys_that_quit, console.terminal_keys],
    'signals': [console.signals, console.exhausted],
    'serial line': [console.serial],
    'consoles': [console.switch, console.ends_away],
    'placing': [display.rotated, display.centred, display.modes],
    'going away': [display.vanishes],
    'in use': [console.second, console.master],
    '100 kills': [console.kills],
    '200 switches': [console.switches],
    '1,000 keys': [keys.thousand],
}
BOCHS = ['-device', 'VGA,xres=640,yres=480']
ALL = [display.frames, display.held, console.signals, console.switch, console.second]


@dataclass
class Setup:
    name: str
    title: str                      # for the table
    display: str                    # tia's -d
    size: tuple                     # of the picture that tia must draw
    qemu: list
    modules: list = field(default_factory=list)
    append: str = ''
    prepare: str = 'true'           # a shell line once the guest is up
    format: str = 'XRGB8888'        # as tia names it
    eye: object = field(default_factory=Scanout)
    cases: list = field(default_factory=list)
    machine: str = 'pc'
    keyboard: bool = True

    def missing(self):
        """Why this guest cannot be had here, or None."""
        if 'vkms' in self.modules and not image.has_module('vkms'):
            return "vkms could not be built (package linux-headers-amd64)"
        return None


def vesafb(name, mode, size, depth, **more):
    return Setup(name, 'vesafb, %s' % depth, 'fbdev', size, ['-vga', 'std'], append='vga=%#x' % mode,
                 modules=['evdev'], **more)


def drm(name, qemu, modules, size, title='', **more):
    return Setup(name, title or name, 'drm', size, qemu, modules=['evdev', *modules], **more)


SETUPS = [
    vesafb('vesafb16', 0x311, (640, 480), '16 bpp', format='RGB565',
           cases=[*ALL, display.automatic, display.latency, console.keys_that_quit, console.terminal_keys, console.serial, console.ends_away, console.exhausted,
                  display.rotated, display.centred, console.kills]),
    vesafb('vesafb16-800', 0x314, (800, 600), '16 bpp, 800x600', format='RGB565', cases=[display.frames]),
    vesafb('vesafb32', 0x342, (640, 480), '32 bpp', cases=ALL),
    vesafb('vesafb15', 0x310, (640, 480), '15 bpp', format='RGB555', eye=Scanout(picture.shift555), cases=[display.frames]),
    vesafb('vesafb24', 0x312, (640, 480), '24 bpp', format='RGB888', cases=[display.frames]),
    Setup('vfb', 'vfb, red at bit 0', 'fbdev', (640, 480), [], modules=['evdev'], eye=Memory(2 * 640 * 480), format='BGR565',
          prepare='modprobe vfb vfb_enable=1 mode_option=640x480-16', cases=ALL),
    Setup('cirrusfb', 'cirrusfb, two pages', 'fbdev', (640, 480), ['-vga', 'cirrus'], modules=['evdev'], format='RGB565',
          prepare='modprobe cirrusfb mode_option=640x480-16', cases=[*ALL, display.panning]),
    drm('cirrus', ['-vga', 'cirrus'], ['cirrus'], (1024, 768), format='RGB565',
        cases=[*ALL, display.modes, console.master]),
    drm('bochs', BOCHS, ['bochs'], (640, 480),
        cases=[*ALL, display.automatic, display.latency, console.keys_that_quit, console.terminal_keys, console.serial, console.ends_away, console.exhausted,
               console.master, display.rotated, display.centred, display.modes, console.kills]),
    Setup('bochs-fb', 'bochs, as a framebuffer', 'fbdev', (640, 480), BOCHS, modules=['evdev', 'bochs'], cases=ALL),
    drm('virtio-gpu', ['-device', 'virtio-vga,xres=800,yres=600'], ['virtio_pci', 'virtio-gpu'], (800, 600),
        cases=[*ALL, console.master, display.vanishes]),
    drm('qxl', ['-device', 'qxl-vga'], ['qxl'], (1024, 768), cases=[*ALL, console.master]),
    drm('vkms', [], ['vkms'], (1024, 768), format='RGB565', eye=VkmsChecksum(), cases=[*ALL, console.master, display.pacing]),
    drm('keyboards', [*BOCHS, '-device', 'qemu-xhci,id=usb'],
        ['bochs', 'uinput', 'virtio_pci', 'virtio_input', 'xhci-pci', 'usbhid', 'hid-generic'], (640, 480),
        title='PS/2, USB, virtio, uinput keyboards',
        cases=[keys.usb, keys.usb_hotplug, keys.virtio, keys.virtio_hotplug, keys.two, keys.unreadable, *hands.ALL]),
    drm('no-keyboard', BOCHS, ['bochs'], (640, 480), title='no keyboard', machine='pc,i8042=off', keyboard=False,
        cases=[keys.none]),
    # What takes long, in guests of their own, so that they share the processors.
    drm('switches', BOCHS, ['bochs'], (640, 480), title='bochs, again and again', cases=[console.switches]),
    drm('thousand', BOCHS, ['bochs'], (640, 480), title='bochs, 1,000 keys', cases=[keys.thousand]),
]
