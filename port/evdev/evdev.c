/* evdev.c - the keyboards and pointers of /dev/input as one input. */
#include "evdev.h"

#include <dirent.h>
#include <errno.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/inotify.h>
#include <unistd.h>

#include "clock.h"
#include "console/console.h"
#include "console/node.h"
#include "keyboard.h"
#include "pointer.h"

#define DIRECTORY "/dev/input"
#define KEYBOARDS 32
#define DESCRIPTORS (KEYBOARDS + POINTERS + 1)

/* Time limit for close to wait until all keys are up. A keyboard that repeats by itself (PS/2) would type a key that is
 * still down, usually the one that quits, into the shell. Nobody holds a key this long by accident. */
#define RELEASE_MS 1000

struct evdev {
    const char *device;
    char *why;
    int watch; /* inotify on DIRECTORY; -1: none */
    bool is_open;
    struct console_listener listener;
    struct keyboard keyboards[KEYBOARDS];
    unsigned count;
    struct pointers pointers;
    char failure[PORT_WHY]; /* message for the first node that failed, or for the directory */
    bool no_memory;         /* there was no memory for reading the directory */
};

/* ---- keyboards that come and go ---- */

static bool is_used(const struct evdev *evdev, const char *path)
{
    for (unsigned i = 0; i < evdev->count; i++)
        if (!evdev->keyboards[i].unplugged && strcmp(evdev->keyboards[i].path, path) == 0)
            return true;
    return false;
}

/* Opens a node as a keyboard or a pointer. udev creates a node before it grants permission to open the node, so changes
 * of the mode are watched, too. */
static void try_node(struct evdev *evdev, const char *path)
{
    struct keyboard *keyboard = &evdev->keyboards[evdev->count];
    char why[PORT_WHY];
    int status;

    if (evdev->count == KEYBOARDS || is_used(evdev, path))
        return;
    status = keyboard_open(keyboard, path, why);
    if (status == TIA_ERR_UNSUPPORTED && !evdev->device)
        pointers_try(&evdev->pointers, path);
    if (!status) {
        evdev->count++;
        if (console_state() == CONSOLE_OURS)
            keyboard_grab(keyboard);
    } else if (!*evdev->failure && (status != TIA_ERR_UNSUPPORTED || evdev->device)) {
        (void)snprintf(evdev->failure, PORT_WHY, "%s", why);
    }
}

/* Opens the directory; NULL on failure. Records the failure, unless the directory does not exist: such a machine has no
 * keyboard. */
static DIR *open_directory(struct evdev *evdev)
{
    DIR *directory = opendir(DIRECTORY);
    int error = errno;
    char reason[PORT_WHY];

    evdev->no_memory = !directory && error == ENOMEM;
    if (!directory && error != ENOENT && !*evdev->failure)
        (void)snprintf(evdev->failure, PORT_WHY, DIRECTORY ": %.80s", node_error(error, reason));
    return directory;
}

static void try_all_nodes(struct evdev *evdev)
{
    DIR *directory = evdev->device ? NULL : open_directory(evdev);
    char path[sizeof evdev->keyboards[0].path];

    if (evdev->device)
        try_node(evdev, evdev->device);
    if (!directory)
        return;
    for (struct dirent *entry; (entry = readdir(directory)) != NULL;)
        if (strncmp(entry->d_name, "event", 5) == 0 &&
            snprintf(path, sizeof path, DIRECTORY "/%s", entry->d_name) < (int)sizeof path)
            try_node(evdev, path);
    (void)closedir(directory);
}

static void watch_nodes(struct evdev *evdev)
{
    char events[4096];

    if (evdev->watch < 0 || read(evdev->watch, events, sizeof events) <= 0)
        return;
    while (read(evdev->watch, events, sizeof events) > 0)
        ;
    try_all_nodes(evdev);
}

static void drop_keyboard(struct evdev *evdev, unsigned i)
{
    keyboard_close(&evdev->keyboards[i]);
    evdev->keyboards[i] = evdev->keyboards[--evdev->count];
}

/* ---- the console comes and goes ---- */

static void enter(void *arg)
{
    struct evdev *evdev = arg;

    for (unsigned i = 0; i < evdev->count; i++)
        keyboard_grab(&evdev->keyboards[i]);
    pointers_discard(&evdev->pointers);
}

static bool any_pressed(struct evdev *evdev)
{
    for (unsigned i = 0; i < evdev->count; i++)
        if (evdev->keyboards[i].grabbed && keyboard_is_pressed(&evdev->keyboards[i]))
            return true;
    return false;
}

static nfds_t list_descriptors(const struct evdev *evdev, struct pollfd fds[DESCRIPTORS])
{
    nfds_t count = pointers_list(&evdev->pointers, fds);

    for (unsigned i = 0; i < evdev->count; i++)
        if (!evdev->keyboards[i].unplugged)
            fds[count++] = (struct pollfd){.fd = evdev->keyboards[i].fd, .events = POLLIN};
    if (evdev->watch >= 0)
        fds[count++] = (struct pollfd){.fd = evdev->watch, .events = POLLIN};
    return count;
}

static void discard(struct evdev *evdev)
{
    for (unsigned i = 0; i < evdev->count; i++)
        keyboard_discard(&evdev->keyboards[i]);
    pointers_discard(&evdev->pointers);
}

static void await_release(struct evdev *evdev)
{
    struct pollfd fds[DESCRIPTORS];
    uint64_t now = clock_now_us(), end = now + RELEASE_MS * 1000u;

    for (; now < end && any_pressed(evdev); now = clock_now_us()) {
        (void)poll(fds, list_descriptors(evdev, fds), (int)((end - now + 999) / 1000));
        watch_nodes(evdev);
        discard(evdev);
    }
}

static void leave(void *arg)
{
    struct evdev *evdev = arg;

    if (console_state() == CONSOLE_FREE)
        await_release(evdev);
    for (unsigned i = 0; i < evdev->count; i++)
        keyboard_release(&evdev->keyboards[i]);
}

/* ---- the input ---- */

static void evdev_close(void *ctx)
{
    struct evdev *evdev = ctx;

    if (!evdev->is_open)
        return;
    console_ignore(&evdev->listener);
    await_release(evdev);
    for (; evdev->count > 0; drop_keyboard(evdev, 0))
        keyboard_release(&evdev->keyboards[0]);
    pointers_close(&evdev->pointers);
    if (evdev->watch >= 0)
        (void)close(evdev->watch);
    evdev->watch = -1;
    evdev->is_open = false;
}

static int evdev_open(void *ctx)
{
    struct evdev *evdev = ctx;

    evdev->is_open = true;
    evdev->failure[0] = 0;
    evdev->watch = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
    if (evdev->watch >= 0)
        (void)inotify_add_watch(evdev->watch, DIRECTORY, IN_CREATE | IN_ATTRIB | IN_MOVED_TO);
    console_listen(&evdev->listener);
    try_all_nodes(evdev);
    if (evdev->count > 0)
        return TIA_OK;
    evdev_close(evdev);
    (void)snprintf(evdev->why, PORT_WHY, "%s",
                   evdev->no_memory  ? "memory: exhausted"
                   : *evdev->failure ? evdev->failure
                                     : "keyboard: there is none in " DIRECTORY " (plug one in)");
    return evdev->no_memory ? TIA_ERR_MEMORY : TIA_ERR_DEVICE;
}

/* True if a keyboard still reports the key as pressed: a key held on two keyboards is released when it is up on
 * both. */
static bool is_reported(const struct evdev *evdev, unsigned code)
{
    for (unsigned i = 0; i < evdev->count; i++)
        if (key_set_has(&evdev->keyboards[i].state.reported, code))
            return true;
    return false;
}

static struct key_modifiers modifiers(const struct evdev *evdev)
{
    struct key_modifiers found = {false, false, false};

    for (unsigned i = 0; i < evdev->count; i++)
        key_state_modifiers(&evdev->keyboards[i].state, &found);
    return found;
}

static bool report(const struct evdev *evdev, const struct key_change *change, uint64_t time_us,
                   struct tia_event *event)
{
    if (!change->press && is_reported(evdev, change->code))
        return false;
    *event = (struct tia_event){.kind = change->press ? TIA_EVENT_PRESS : TIA_EVENT_RELEASE,
                                .key = change->key,
                                .time_us = time_us,
                                .shift = modifiers(evdev).shift};
    return true;
}

/* Gives an event that became due when a keyboard was unplugged, the console was switched or events were lost; false if
 * there is none. */
static bool settle(struct evdev *evdev, struct tia_event *event)
{
    struct key_change change;

    for (unsigned i = evdev->count; i-- > 0;) {
        while (key_state_settle(&evdev->keyboards[i].state, modifiers(evdev), &change))
            if (report(evdev, &change, clock_now_us(), event))
                return true;
        if (evdev->keyboards[i].unplugged)
            drop_keyboard(evdev, i);
    }
    return false;
}

static struct keyboard *oldest_event(struct evdev *evdev)
{
    struct keyboard *oldest = NULL;

    for (unsigned i = 0; i < evdev->count; i++) {
        struct keyboard *keyboard = &evdev->keyboards[i];
        keyboard_read(keyboard);
        if (!oldest || keyboard_next_us(keyboard) < keyboard_next_us(oldest))
            oldest = keyboard;
    }
    return oldest && keyboard_next_us(oldest) != UINT64_MAX ? oldest : NULL;
}

/* Takes a keyboard's next event; true if *event is to be reported. Ctrl-Alt-Fn switches the console here: the kernel's
 * console does not get the events of a grabbed keyboard. */
static bool take(struct evdev *evdev, struct keyboard *keyboard, struct tia_event *event)
{
    struct key_modifiers held = modifiers(evdev);
    uint64_t time_us = keyboard_next_us(keyboard);
    struct key_change change;

    if (!keyboard_take(keyboard, held, &change))
        return false;
    if (held.ctrl && held.alt && key_console(change.code)) {
        key_set_remove(&keyboard->state.reported, change.code);
        if (change.press)
            console_switch(key_console(change.code));
        return false;
    }
    return report(evdev, &change, time_us, event);
}

static int evdev_poll(void *ctx, struct tia_event *event)
{
    struct evdev *evdev = ctx;
    struct keyboard *keyboard;

    /* console switches come first: keys that another program got while this process was stopped must be dropped */
    if (console_state() != CONSOLE_FREE && console_wait(NULL, 0, 0) < 0)
        return TIA_ERR_DEVICE;
    watch_nodes(evdev);
    while (!settle(evdev, event)) {
        if (console_state() == CONSOLE_AWAY) {
            discard(evdev); /* drops all events: another program has the console */
            return 0;
        }
        keyboard = oldest_event(evdev);
        if (!keyboard)
            return pointers_poll(&evdev->pointers, event);
        if (take(evdev, keyboard, event))
            return 1;
    }
    return 1;
}

static int evdev_wait(void *ctx, int timeout_ms)
{
    struct evdev *evdev = ctx;
    struct pollfd fds[DESCRIPTORS];

    if (pointers_wait_not(&evdev->pointers))
        timeout_ms = 0;
    for (unsigned i = 0; i < evdev->count; i++)
        if (evdev->keyboards[i].next < evdev->keyboards[i].count)
            timeout_ms = 0;
    return console_wait(fds, list_descriptors(evdev, fds), timeout_ms) < 0 ? TIA_ERR_DEVICE : TIA_OK;
}

const struct tia_input port_evdev_input = {
    .open = evdev_open,
    .poll = evdev_poll,
    .wait = evdev_wait,
    .close = evdev_close,
};

void *port_evdev_create(const struct port_wish *wish)
{
    struct evdev *evdev = calloc(1, sizeof *evdev);

    if (!evdev) {
        (void)snprintf(wish->why, PORT_WHY, "memory: exhausted");
        return NULL;
    }
    evdev->device = wish->device;
    evdev->why = wish->why;
    evdev->watch = -1;
    evdev->listener = (struct console_listener){.enter = enter, .leave = leave, .arg = evdev};
    return evdev;
}

void port_evdev_destroy(void *ctx)
{
    free(ctx);
}
