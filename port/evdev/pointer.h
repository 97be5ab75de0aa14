/* pointer.h - mice, tablets and touch screens: event devices of the kernel that have a place or a movement in x and y.
 *
 * They are not grabbed. What they say while another program has the console is thrown away.
 */
#ifndef PORT_EVDEV_POINTER_H
#define PORT_EVDEV_POINTER_H

#include <linux/input.h>
#include <poll.h>

#include "device.h"

#define POINTERS 16
#define POINTER_EVENTS 64

/* One of them. Without a descriptor it is what its events mean. */
struct pointer {
    int fd;
    char path[64];
    bool absolute;
    int32_t low[2], high[2]; /* of an absolute one: its range in x and y */
    int32_t at[2];           /* its place, or by how much it has moved since the last report */
    int32_t wheel;           /* steps that are not reported yet, away from the hand */
    bool moved, drag;
    struct input_event events[POINTER_EVENTS];
    size_t next, count; /* read and not yet taken: [next, count) */
};

/* Takes an event of the kernel. True: *event is one to report, a place or a movement of all since the last. */
bool pointer_take(struct pointer *pointer, const struct input_event *input, struct tia_event *event);

/* Takes a step of its wheel: true: *event is the key + or -. */
bool pointer_wheel(struct pointer *pointer, struct tia_event *event);

struct pointers {
    struct pointer all[POINTERS];
    unsigned count;
};

/* Uses the node if it is a pointer, can be read and is not used yet. */
void pointers_try(struct pointers *pointers, const char *path);

/* 1 and the next event; 0: there is none. Pointers that are unplugged are forgotten. */
int pointers_poll(struct pointers *pointers, struct tia_event *event);
void pointers_discard(struct pointers *pointers);
void pointers_close(struct pointers *pointers);

/* Adds what to wait for, POINTERS at most; whether there are events without waiting. */
nfds_t pointers_list(const struct pointers *pointers, struct pollfd *fds);
/* True if events can be taken without a wait. */
bool pointers_wait_not(const struct pointers *pointers);

#endif
