/* ports.h - the displays and inputs that this build has, by name.
 *
 * A port is its functions (tia/port.h), a pair that makes and ends its context, and a row in one
 * of the tables of ports.c.
 */
#ifndef PORT_PORTS_H
#define PORT_PORTS_H

#include "device.h"

/* In the order in which `auto` tries them; the end has name NULL. */
extern const struct port_display port_displays[];
extern const struct port_input port_inputs[];

#endif
