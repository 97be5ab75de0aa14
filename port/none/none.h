/* none.h - a display that shows nothing and an input without keys. */
#ifndef PORT_NONE_H
#define PORT_NONE_H

#include "device.h"

extern const struct tia_display port_none_display;
void *port_none_create(const struct port_wish *wish);
void port_none_destroy(void *ctx);
void port_none_list(port_line *line, void *arg);

extern const struct tia_input port_none_input;
void *port_none_input_create(const struct port_wish *wish);
void port_none_input_destroy(void *ctx);

#endif
