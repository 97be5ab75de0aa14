/* functions.h - the functions of GL that a program calls. */
#ifndef BENCH_GL_FUNCTIONS_H
#define BENCH_GL_FUNCTIONS_H

#include <stdio.h>
#include <string.h>

#include "osmesa/gl.h"
#include "osmesa/osmesa.h"

/* Fills a table with functions of an open osmesa display. Returns false if a function is missing, with its name in
 * `why`, PORT_WHY characters. */
static inline bool gl_functions_load(void *display, void *table, const struct gl_row *rows, size_t count, char *why)
{
    for (size_t i = 0; i < count; i++) {
        gl_proc proc = port_osmesa_proc(display, rows[i].name);
        if (!proc) {
            (void)snprintf(why, PORT_WHY, "GL has no %s", rows[i].name);
            return false;
        }
        memcpy((char *)table + rows[i].offset, &proc, sizeof proc);
    }
    return true;
}

#endif
