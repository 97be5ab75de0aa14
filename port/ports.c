/* ports.c - the tables of displays and inputs. */
#include "ports.h"

#include <stddef.h>

#ifdef TIA_HAVE_DRM
#include "drm/drm.h"
#endif
#include "evdev/evdev.h"
#include "fbdev/fbdev.h"
#include "none/none.h"
#ifdef TIA_HAVE_OSMESA
#include "osmesa/osmesa.h"
#endif
#include "terminal/terminal.h"

/* Displays, in the order in which `auto` tries them; "none" and "osmesa" must be named. */
const struct port_display port_displays[] = {
#ifdef TIA_HAVE_DRM
    {
        .name = "drm",
        .summary = "a screen through the kernel's DRM, /dev/dri/cardN",
        .takes_screen = true,
        .ops = &port_drm_display,
        .create = port_drm_create,
        .destroy = port_drm_destroy,
        .list = port_drm_list,
    },
#endif
    {
        .name = "fbdev",
        .summary = "a Linux framebuffer, /dev/fbN",
        .takes_screen = true,
        .ops = &port_fbdev_display,
        .create = port_fbdev_create,
        .destroy = port_fbdev_destroy,
        .list = port_fbdev_list,
    },
    {
        .name = "terminal",
        .summary = "characters or pictures in the terminal of standard output",
        .ops = &port_terminal_display,
        .create = port_terminal_create,
        .destroy = port_terminal_destroy,
        .list = port_terminal_list,
        .text = port_terminal_text,
    },
    {
        .name = "none",
        .summary = "draws and shows nothing",
        .ops = &port_none_display,
        .create = port_none_create,
        .destroy = port_none_destroy,
        .list = port_none_list,
    },
#ifdef TIA_HAVE_OSMESA
    {
        .name = "osmesa",
        .summary = "OpenGL in memory, for tests (osmesa:osmesa, osmesa:egl)",
        .ops = &port_osmesa_display,
        .create = port_osmesa_create,
        .destroy = port_osmesa_destroy,
        .list = port_osmesa_list,
    },
#endif
    {.name = NULL},
};

const struct port_input port_inputs[] = {
    {
        .name = "evdev",
        .summary = "every keyboard and mouse of the machine, by /dev/input",
        .ops = &port_evdev_input,
        .create = port_evdev_create,
        .destroy = port_evdev_destroy,
    },
    {
        .name = "tty",
        .summary = "the terminal's keyboard",
        .ops = &port_tty_input,
        .create = port_tty_create,
        .destroy = port_tty_destroy,
    },
    {
        .name = "none",
        .summary = "nobody types",
        .ops = &port_none_input,
        .create = port_none_input_create,
        .destroy = port_none_input_destroy,
    },
    {.name = NULL},
};
