/* pointer.h - mice, tablets and touch screens: event devices of the kernel that report positions or movements in x and
 * y.
 *
 * They are not grabbed. Their events while another program has the console are discarded.
 */
#ifndef PORT_EVDEV_POINTER_H
#define PORT_EVDEV_POINTER_H

#include <linux/input.h>
#include <poll.h>

#include "device.h"

#define POINTERS 16
#define POINTER_EVENTS 64

/* A pointing device. Without a descriptor it is only the state of its event decoder. */
struct pointer {
    int fd;
    char path[64];
    bool absolute;
    int32_t low[2], high[2]; /* absolute device: its range in x and y */
    int32_t at[2];           /* absolute: position; relative: movement since the last report */
    int32_t wheel;           /* steps not reported yet, positive away from the user */
    bool moved, drag;
    struct input_event events[POINTER_EVENTS];
    size_t next, count; /* read and not yet taken: [next, count) */
};

/* Takes an event of the kernel; true if *event is to be reported: a position, or the sum of all movements since the
 * last. */
bool pointer_take(struct pointer *pointer, const struct input_event *input, struct tia_event *event);

/* Takes a step of its wheel; true if *event is the key + or -. */
bool pointer_wheel(struct pointer *pointer, struct tia_event *event);

struct pointers {
    struct pointer all[POINTERS];
    unsigned count;
};

/* Uses the node if it is a pointer, can be read and is not used yet. */
void pointers_try(struct pointers *pointers, const char *path);

/* Gives the next event: 1, or 0 if there is none. Pointers that are unplugged are dropped. */
int pointers_poll(struct pointers *pointers, struct tia_event *event);
/* Discards all pending events. */
void pointers_discard(struct pointers *pointers);
void pointers_close(struct pointers *pointers);

/* Adds the descriptors to wait for, POINTERS at most. */
nfds_t pointers_list(const struct pointers *pointers, struct pollfd *fds);
bool pointers_wait_not(const struct pointers *pointers);

#endif
