/* evdev.h - all keyboards, mice, tablets and touch screens of a Linux machine, through the kernel's event devices.
 *
 * Keyboards may be plugged in and out while the input is open. While this program has the console (console/console.h),
 * they are grabbed, and Ctrl-Alt-Fn switches consoles. If wish.device names a keyboard, no other device is used.
 */
#ifndef PORT_EVDEV_H
#define PORT_EVDEV_H

#include "device.h"

extern const struct tia_input port_evdev_input;
void *port_evdev_create(const struct port_wish *wish);
void port_evdev_destroy(void *ctx);

#endif
