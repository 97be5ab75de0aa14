/* pointer.c - mice, tablets and touch screens. */
#include "pointer.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

#include "key_codes.h"

/* ---- meaning of events ---- */

static int32_t limited(int64_t value, int32_t low, int32_t high)
{
    return (int32_t)(value < low ? low : value > high ? high : value);
}

static void take_relative(struct pointer *pointer, const struct input_event *input)
{
    if (input->code == REL_X || input->code == REL_Y) {
        int32_t *at = &pointer->at[input->code == REL_Y];
        *at = limited((int64_t)*at + input->value, -INT16_MAX, INT16_MAX);
        pointer->moved = true;
    } else if (input->code == REL_WHEEL) {
        pointer->wheel = limited((int64_t)pointer->wheel + input->value, -INT16_MAX, INT16_MAX);
    }
}

static void take_absolute(struct pointer *pointer, const struct input_event *input)
{
    if (input->code == ABS_X || input->code == ABS_Y) {
        pointer->at[input->code == ABS_Y] = input->value;
        pointer->moved = true;
    }
}

/* Processes a button. For an absolute pointer, a change counts as a movement: a drag must begin with a position, which
 * the kernel does not repeat for a pointer that has not moved. */
static void take_button(struct pointer *pointer, bool drag)
{
    pointer->moved = pointer->moved || (pointer->absolute && drag != pointer->drag);
    pointer->drag = drag;
}

/* Returns the position on an axis, 0..65535; 32768 if the axis has no range. */
static int32_t part_of_axis(const struct pointer *pointer, int axis)
{
    int64_t low = pointer->low[axis], high = pointer->high[axis];

    if (high <= low)
        return 32768;
    return (int32_t)((limited(pointer->at[axis], pointer->low[axis], pointer->high[axis]) - low) * 65535 /
                     (high - low));
}

static void report(struct pointer *pointer, struct tia_event *event)
{
    *event = (struct tia_event){.kind = pointer->absolute ? TIA_EVENT_POINT : TIA_EVENT_MOVE, .drag = pointer->drag};
    event->x = pointer->absolute ? part_of_axis(pointer, 0) : pointer->at[0];
    event->y = pointer->absolute ? part_of_axis(pointer, 1) : pointer->at[1];
    if (!pointer->absolute)
        pointer->at[0] = pointer->at[1] = 0;
    pointer->moved = false;
}

bool pointer_take(struct pointer *pointer, const struct input_event *input, struct tia_event *event)
{
    if (input->type == EV_REL)
        take_relative(pointer, input);
    else if (input->type == EV_ABS && pointer->absolute)
        take_absolute(pointer, input);
    else if (input->type == EV_KEY && (input->code == BTN_LEFT || input->code == BTN_TOUCH))
        take_button(pointer, input->value != 0);
    if (input->type != EV_SYN || input->code != SYN_REPORT || !pointer->moved)
        return false;
    report(pointer, event);
    return true;
}

bool pointer_wheel(struct pointer *pointer, struct tia_event *event)
{
    bool away = pointer->wheel > 0;

    if (!pointer->wheel)
        return false;
    pointer->wheel -= away ? 1 : -1;
    *event = (struct tia_event){.kind = TIA_EVENT_TAP, .key = away ? TIA_KEY_PLUS : TIA_KEY_MINUS};
    return true;
}

/* ---- devices ---- */

static bool has(int fd, unsigned type, unsigned code)
{
    struct key_set codes = {{0}};

    return ioctl(fd, EVIOCGBIT(type, sizeof codes.words), codes.words) >= 0 && key_set_has(&codes, code);
}

static void get_range(struct pointer *pointer, int axis)
{
    struct input_absinfo info;

    if (ioctl(pointer->fd, EVIOCGABS(axis ? ABS_Y + 0u : ABS_X + 0u), &info) < 0)
        return;
    pointer->low[axis] = info.minimum;
    pointer->high[axis] = info.maximum;
    pointer->at[axis] = info.value;
}

/* Prepares the device; false if it is not a pointer: joysticks have axes, too, but not these buttons. */
static bool examine(struct pointer *pointer)
{
    int fd = pointer->fd, clock = CLOCK_MONOTONIC;
    bool pressed = has(fd, EV_KEY, BTN_LEFT) || has(fd, EV_KEY, BTN_TOUCH);

    pointer->absolute = has(fd, EV_ABS, ABS_X) && has(fd, EV_ABS, ABS_Y);
    if (!pressed || (!pointer->absolute && !(has(fd, EV_REL, REL_X) && has(fd, EV_REL, REL_Y))))
        return false;
    get_range(pointer, 0);
    get_range(pointer, 1);
    return ioctl(fd, EVIOCSCLOCKID, &clock) == 0;
}

static bool is_used(const struct pointers *pointers, const char *path)
{
    for (unsigned i = 0; i < pointers->count; i++)
        if (strcmp(pointers->all[i].path, path) == 0)
            return true;
    return false;
}

void pointers_try(struct pointers *pointers, const char *path)
{
    struct pointer *pointer = &pointers->all[pointers->count];

    if (pointers->count == POINTERS || is_used(pointers, path))
        return;
    *pointer = (struct pointer){.fd = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC)};
    if (pointer->fd < 0)
        return;
    if (snprintf(pointer->path, sizeof pointer->path, "%s", path) < (int)sizeof pointer->path && examine(pointer))
        pointers->count++;
    else
        (void)close(pointer->fd);
}

/* Reads the pending events; false when the pointer is unplugged. */
static bool read_events(struct pointer *pointer)
{
    ssize_t n = read(pointer->fd, pointer->events, sizeof pointer->events);

    pointer->next = 0;
    pointer->count = n > 0 ? (size_t)n / sizeof pointer->events[0] : 0;
    return n >= 0 || errno == EAGAIN || errno == EINTR;
}

static void drop(struct pointers *pointers, unsigned i)
{
    (void)close(pointers->all[i].fd);
    pointers->all[i] = pointers->all[--pointers->count];
}

static uint64_t time_of(const struct input_event *input)
{
    return (uint64_t)input->input_event_sec * 1000000u + (uint64_t)input->input_event_usec;
}

static int poll_one(struct pointer *pointer, struct tia_event *event)
{
    if (pointer_wheel(pointer, event))
        return 1;
    for (;;) {
        if (pointer->next == pointer->count && !read_events(pointer))
            return TIA_ERR_DEVICE;
        if (pointer->next == pointer->count)
            return pointer_wheel(pointer, event);
        const struct input_event *input = &pointer->events[pointer->next++];
        if (pointer_take(pointer, input, event)) {
            event->time_us = time_of(input);
            return 1;
        }
    }
}

int pointers_poll(struct pointers *pointers, struct tia_event *event)
{
    for (unsigned i = pointers->count; i-- > 0;) {
        int status = poll_one(&pointers->all[i], event);
        if (status > 0)
            return 1;
        if (status < 0)
            drop(pointers, i);
    }
    return 0;
}

void pointers_discard(struct pointers *pointers)
{
    struct tia_event event;

    while (pointers_poll(pointers, &event))
        ;
}

void pointers_close(struct pointers *pointers)
{
    while (pointers->count > 0)
        drop(pointers, 0);
}

nfds_t pointers_list(const struct pointers *pointers, struct pollfd *fds)
{
    for (unsigned i = 0; i < pointers->count; i++)
        fds[i] = (struct pollfd){.fd = pointers->all[i].fd, .events = POLLIN};
    return pointers->count;
}

bool pointers_wait_not(const struct pointers *pointers)
{
    for (unsigned i = 0; i < pointers->count; i++)
        if (pointers->all[i].wheel || pointers->all[i].next < pointers->all[i].count)
            return true;
    return false;
}
