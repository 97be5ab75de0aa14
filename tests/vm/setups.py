"""The guests: one for each driver, small screens where the driver lets one choose, because
software emulation draws slowly."""
from dataclasses import dataclass, field

import cases_console as console
import cases_display as display
import cases_guardian as guardian
import cases_hands as hands
import cases_keys as keys
import cases_pointer as pointer
import image
import picture
from session import Memory, Scanout, VkmsChecksum

# The columns of the table.
GROUPS = {
    'conformance': [display.conforms],
    'pictures': [display.frames, display.automatic, display.rotated, display.centred, display.modes,
                 display.controller],
    'held keys, latency': [display.held, display.latency],
    'pages, pacing': [display.panning, display.pacing],
    'keyboards': [keys.usb, keys.usb_hotplug, keys.virtio, keys.virtio_hotplug, keys.comes_and_goes, keys.two,
                  keys.unreadable, keys.none, *hands.ALL],
    'mice, tablets': [*pointer.ALL, pointer.none_there],
    'ends': [console.signals, console.exhausted, console.keys_that_quit, console.terminal_keys, console.held_through],
    'guardian': guardian.ALL,
    'consoles': [console.switch, console.ends_away, console.serial],
    'going away': [display.device_gone, display.screen_gone],
    'in use': [console.second, console.two_at_once, console.master],
    'memory': [console.limited],
    '100 SIGKILLs': [console.kills],
    '200 switches': [console.switches],
    '1,000 keys': [keys.thousand],
}
# What every driver has to show, what a DRM driver has to show too, and what is shown at one driver
# of each kind, because it is not the driver that does it.
BASIC = [display.conforms, display.frames, display.held, console.switch, console.second]
DRM = [*BASIC, console.master, display.screen_gone]
# What takes long is done at one driver of each kind, or at one; with --full at every driver.
LONG = [console.kills, console.signals]
LONGEST = [console.exhausted, console.limited]
THOROUGH = [display.automatic, display.latency, display.rotated, display.centred, console.keys_that_quit,
            console.terminal_keys, console.held_through, console.serial, console.ends_away,
            console.two_at_once, *guardian.ALL]


@dataclass
class Setup:
    name: str
    title: str                      # for the table
    display: str                    # tia's -d
    size: tuple                     # of the picture that tia must draw
    qemu: list
    modules: list = field(default_factory=list)
    append: str = ''
    options: list = field(default_factory=list)     # tia's, for this display
    prepare: str = 'true'           # a shell line once the guest is up
    format: str = 'XRGB8888'        # as tia names it
    eye: object = field(default_factory=Scanout)
    cases: list = field(default_factory=list)
    machine: str = 'pc'
    keyboard: bool = True
    long: bool = False              # its LONG cases are run without --full too
    longest: bool = False           # so are its LONGEST cases
    rare: bool = False              # run with --full, or by its name

    def all_cases(self, full):
        basic = set(BASIC) <= set(self.cases)
        thorough = set(THOROUGH) <= set(self.cases)
        return self.cases + (LONG if basic and (full or self.long) else []) + \
            (LONGEST if thorough and (full or self.longest) else [])

    def missing(self):
        """Why this guest cannot be had here, or None."""
        if 'vkms' in self.modules and not image.has_module('vkms'):
            return "vkms could not be built (package linux-headers-amd64)"
        return None


BOCHS = ['-device', 'VGA,xres=640,yres=480']


def fbdev(name, title, qemu, **more):
    more = {'size': (640, 480), 'modules': ['evdev'], **more}
    return Setup(name, 'fbdev: ' + title, 'fbdev', qemu=qemu, **more)


def vesafb(name, mode, title, **more):
    return fbdev(name, 'vesafb, ' + title, ['-vga', 'std'], append='vga=%#x' % mode, **more)


def drm(name, qemu, modules, size=(640, 480), title='', **more):
    return Setup(name, title or 'DRM: ' + name, 'drm', size, qemu, modules=['evdev', *modules], **more)


SETUPS = [
    vesafb('vesafb16', 0x311, '16 bpp', format='RGB565', cases=[*BASIC, *THOROUGH], long=True),
    drm('bochs', BOCHS, ['bochs'], cases=[*DRM, display.modes, display.device_gone, *THOROUGH],
        long=True, longest=True),
    vesafb('vesafb16-800', 0x314, '16 bpp, 800x600', size=(800, 600), format='RGB565', rare=True, cases=[display.frames]),
    vesafb('vesafb32', 0x342, '32 bpp', cases=BASIC),
    vesafb('vesafb15', 0x310, '15 bpp', format='RGB555', eye=Scanout(picture.shift555), cases=[display.frames]),
    vesafb('vesafb24', 0x312, '24 bpp', format='RGB888', cases=[display.frames]),
    fbdev('vfb', 'vfb, red at bit 0', [], format='BGR565', eye=Memory(2 * 640 * 480), cases=BASIC,
          prepare='modprobe vfb vfb_enable=1 mode_option=640x480-16'),
    fbdev('cirrusfb', 'cirrusfb, two pages', ['-vga', 'cirrus'], format='RGB565', cases=[*BASIC, display.panning],
          prepare='modprobe cirrusfb mode_option=640x480-16'),
    fbdev('bochs-fb', "bochs' emulation", BOCHS, modules=['evdev', 'bochs'], cases=BASIC),
    drm('cirrus', ['-vga', 'cirrus'], ['cirrus'], (1024, 768), format='RGB565',
        cases=[*DRM, display.modes, display.device_gone]),
    drm('virtio-gpu', ['-device', 'virtio-vga,xres=800,yres=600'], ['virtio_pci', 'virtio-gpu'], (800, 600),
        cases=[*DRM, display.device_gone]),
    # Its driver brings the kernel down when it has to let go of the device, with or without tia.
    drm('qxl', ['-device', 'qxl-vga'], ['qxl'], (1024, 768), cases=DRM),
    drm('vkms', [], ['vkms'], append='video=Virtual-1:640x480', options=['--mode', '640x480'], format='RGB565',
        eye=VkmsChecksum(), cases=[*DRM, display.pacing, display.controller]),
    drm('keyboards', [*BOCHS, '-device', 'qemu-xhci,id=usb'],
        ['bochs', 'uinput', 'virtio_pci', 'virtio_input', 'xhci-pci', 'usbhid', 'hid-generic'],
        title='PS/2, USB, virtio, uinput keyboards',
        cases=[keys.usb, keys.usb_hotplug, keys.virtio, keys.virtio_hotplug, keys.comes_and_goes, keys.two,
               keys.unreadable, *hands.ALL]),
    drm('pointers', [*BOCHS, '-device', 'qemu-xhci,id=usb'],
        ['bochs', 'psmouse', 'virtio_pci', 'virtio_input', 'xhci-pci', 'usbhid', 'hid-generic'],
        title='PS/2, USB, virtio mice and tablets', cases=pointer.ALL),
    drm('no-mouse', BOCHS, ['bochs'], title='no mouse', cases=[pointer.none_there]),
    drm('no-keyboard', BOCHS, ['bochs'], title='no keyboard', machine='pc,i8042=off', keyboard=False,
        cases=[keys.none]),
    # What takes long, in guests of their own, so that they share the processors.
    drm('switches', [*BOCHS, '-smp', '2'], ['bochs'], title='DRM: bochs, two processors', cases=[console.switches]),
    drm('thousand', BOCHS, ['bochs'], title='DRM: bochs, 1,000 keys', cases=[keys.thousand]),
]
