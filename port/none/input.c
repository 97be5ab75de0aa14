/* input.c - an input without keys; only signals and the timeout end its wait. */
#include <stdio.h>
#include <stdlib.h>

#include "console/console.h"
#include "none.h"

static int none_open(void *ctx)
{
    (void)ctx;
    return TIA_OK;
}

static int none_poll(void *ctx, struct tia_event *event)
{
    (void)ctx;
    (void)event;
    return 0;
}

static int none_wait(void *ctx, int timeout_ms)
{
    (void)ctx;
    return console_wait(NULL, 0, timeout_ms) < 0 ? TIA_ERR_DEVICE : TIA_OK;
}

static void none_close(void *ctx)
{
    (void)ctx;
}

const struct tia_input port_none_input = {
    .open = none_open,
    .poll = none_poll,
    .wait = none_wait,
    .close = none_close,
};

void *port_none_input_create(const struct port_wish *wish)
{
    char *ctx = malloc(1); /* there is no state, but NULL would mean failure */

    if (!ctx)
        (void)snprintf(wish->why, PORT_WHY, "memory: exhausted");
    return ctx;
}

void port_none_input_destroy(void *ctx)
{
    free(ctx);
}
