/* ports.h - the tables of the displays and inputs of this build.
 *
 * A port consists of its functions (tia/port.h), `create` and `destroy` for its context, and a row in a table of
 * ports.c.
 */
#ifndef PORT_PORTS_H
#define PORT_PORTS_H

#include "device.h"

/* Displays in the order in which `auto` tries them; the last row has the name NULL. */
extern const struct port_display port_displays[];
/* Inputs; the last row has the name NULL. */
extern const struct port_input port_inputs[];

#endif
