/* memory.h - the reference display: the caller's own RGB565 memory, and a record of the calls.
 *
 *     struct port_memory m = {.width = 64, .height = 48, .surface = {pixels, 2, 128}};
 *     port_memory_display.open(&m, &mode);
 *
 * The display needs no OS. Unlike a device, it returns TIA_ERR_ARGUMENT for every call that tia/port.h does not allow:
 * a program that runs without an error here uses other displays correctly.
 */
#ifndef PORT_MEMORY_H
#define PORT_MEMORY_H

#include <stdatomic.h>

#include <tia/port.h>

enum memory_call_kind { MEMORY_OPEN, MEMORY_MODE, MEMORY_ACQUIRE, MEMORY_SUBMIT, MEMORY_PRESENT, MEMORY_CLOSE };

struct memory_call {
    enum memory_call_kind kind;
    struct tia_tile tile; /* tile of an acquire or a submit */
    int result;
};

struct port_memory {
    /* Set by the caller before open, or between two frames to resize the display. */
    struct tia_surface surface; /* the picture; step and pitch as for any surface */
    uint16_t width, height;
    uint16_t tile_width, tile_height;
    bool concurrent;
    bool hidden;               /* mode returns TIA_HIDDEN, and drawing is an error */
    int fail_open;             /* if not 0, open fails with this status */
    struct memory_call *calls; /* record of the calls, or NULL */
    size_t call_capacity;      /* further calls are counted but not recorded */

    /* Maintained by the display; zero before open. */
    atomic_size_t call_count;
    atomic_uint acquired; /* tiles acquired but not submitted */
    unsigned frames;      /* frames presented so far */
    bool is_open;
};

extern const struct tia_display port_memory_display;

#endif
