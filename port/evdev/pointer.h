/* pointer.h - mice, tablets and touch screens: event devices of the kernel that report a position or a movement in x
 * and y.
 *
 * They are not grabbed. Their events are discarded while another program has the console.
 */
#ifndef PORT_EVDEV_POINTER_H
#define PORT_EVDEV_POINTER_H

#include <linux/input.h>
#include <poll.h>

#include "device.h"

#define POINTERS 16
#define POINTER_EVENTS 64

/* A pointer. pointer_take and pointer_wheel do not use the descriptor. */
struct pointer {
    int fd;
    char path[64];
    bool absolute;
    int32_t low[2], high[2]; /* absolute pointers: range in x and y */
    int32_t at[2];           /* position, or movement since the last report */
    int32_t wheel;           /* steps that are not reported yet, positive away from the user */
    bool moved, drag;
    struct input_event events[POINTER_EVENTS];
    size_t next, count; /* unread part of the events: [next, count) */
};

/* Processes an event of the kernel; true when *event is to be reported: a position, or all movement since the last
 * report. */
bool pointer_take(struct pointer *pointer, const struct input_event *input, struct tia_event *event);

/* Takes a step of the wheel: *event is then the key + or -; false if no step is left. */
bool pointer_wheel(struct pointer *pointer, struct tia_event *event);

struct pointers {
    struct pointer all[POINTERS];
    unsigned count;
};

/* Uses the node if it is a pointer, can be read and is not used yet. */
void pointers_try(struct pointers *pointers, const char *path);

/* Returns 1 and the next event, or 0 when there is none. Removes pointers that were unplugged. */
int pointers_poll(struct pointers *pointers, struct tia_event *event);
void pointers_discard(struct pointers *pointers);
void pointers_close(struct pointers *pointers);

/* Writes the descriptors to wait for, POINTERS at most, to `fds`. Returns their number. */
nfds_t pointers_list(const struct pointers *pointers, struct pollfd *fds);
/* True if an event that was already read is still to be reported. */
bool pointers_wait_not(const struct pointers *pointers);

#endif
