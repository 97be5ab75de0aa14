/* test_ports.c - the conformance suite with every display that this machine can open.
 *
 * Displays that do not take the screen and a terminal (a pseudo-terminal and a model of one) are always tested. A
 * display that takes the screen is tested only if named: `test_ports drm fbdev:/dev/fb1`.
 */
#include <poll.h>
#include <pthread.h>
#include <pty.h>
#include <stdlib.h>
#include <unistd.h>

#include "check.h"
#include "conform.h"
#include "ports.h"
#include "terminal_model.h"

/* ---- displays by name ---- */

static char why[PORT_WHY];

static const struct port_display *display_named(const char *name)
{
    for (const struct port_display *d = port_displays; d->name; d++)
        if (strcmp(d->name, name) == 0)
            return d;
    return NULL;
}

static void conform_row(const struct port_display *row, const struct port_wish *wish)
{
    void *ctx = row->create(wish);

    CHECK_MSG(ctx, "create: %s", why);
    if (!ctx)
        return;
    subject.ops = row->ops;
    subject.ctx = ctx;
    subject.why = why;
    conform();
    row->destroy(ctx);
}

/* Tests a display, or skips one that cannot be opened here, with its reason. */
static void conform_where_it_opens(const struct port_display *row, const char *device)
{
    struct port_wish wish = {.device = device, .why = why};
    void *ctx = row->create(&wish);
    int status = ctx ? row->ops->open(ctx, &mode) : TIA_ERR_DEVICE;

    if (ctx) {
        row->ops->close(ctx);
        row->destroy(ctx);
    }
    subject = (struct subject){0};
    if (!status)
        conform_row(row, &wish);
    else
        SKIP("%.200s", why);
}

TEST(none)
{
    struct port_wish wish = {.width = 77, .height = 55, .why = why};

    subject = (struct subject){0};
    conform_row(display_named("none"), &wish);
    CHECK(mode.width == 77 && mode.height == 55);
    wish.width = wish.height = 0;
    conform_row(display_named("none"), &wish);
    CHECK(mode.width == 640 && mode.height == 480);
}

/* ---- a terminal ---- */

struct screen {
    struct model model;
    pthread_mutex_t lock;
    pthread_cond_t shown;
    int master, quit[2];
    pthread_t reader;
    char device[64];
};

/* Reads slowly and in small pieces, so that the display has to wait for its terminal. */
static void *read_screen(void *arg)
{
    struct screen *s = arg;
    struct pollfd ready[2] = {{.fd = s->master, .events = POLLIN}, {.fd = s->quit[0], .events = POLLIN}};
    char bytes[700];

    while (poll(ready, 2, -1) > 0) {
        ssize_t n = ready[0].revents & POLLIN ? read(s->master, bytes, sizeof bytes) : 0;
        (void)pthread_mutex_lock(&s->lock);
        if (n > 0)
            model_feed(&s->model, bytes, (size_t)n);
        (void)pthread_cond_broadcast(&s->shown);
        (void)pthread_mutex_unlock(&s->lock);
        if (n <= 0 && ready[1].revents)
            break;
    }
    return NULL;
}

static bool screen_open(struct screen *s, unsigned columns, unsigned rows, int *slave)
{
    struct winsize size = {.ws_col = (uint16_t)columns, .ws_row = (uint16_t)rows};

    *s = (struct screen){.model = model_new(columns, rows)};
    (void)pthread_mutex_init(&s->lock, NULL);
    (void)pthread_cond_init(&s->shown, NULL);
    return openpty(&s->master, slave, s->device, NULL, &size) == 0 && pipe(s->quit) == 0 &&
           pthread_create(&s->reader, NULL, read_screen, s) == 0;
}

static void screen_close(struct screen *s, int slave)
{
    (void)close(s->quit[1]);
    (void)pthread_join(s->reader, NULL);
    (void)close(slave);
    (void)close(s->master);
    (void)close(s->quit[0]);
    model_free(&s->model);
}

static void await_frames(void *arg, unsigned frames)
{
    struct screen *s = arg;

    (void)pthread_mutex_lock(&s->lock);
    while (s->model.frames < frames)
        (void)pthread_cond_wait(&s->shown, &s->lock);
    (void)pthread_mutex_unlock(&s->lock);
}

static tia_rgb565 screen_pixel(void *arg, unsigned x, unsigned y)
{
    uint32_t c = model_pixel(&((struct screen *)arg)->model, x, y);

    return (tia_rgb565)((c >> 19 & 31) << 11 | (c >> 10 & 63) << 5 | (c >> 3 & 31));
}

static void conform_terminal(unsigned columns, unsigned rows)
{
    struct screen screen;
    int slave;

    if (!screen_open(&screen, columns, rows, &slave)) {
        SKIP("no pseudo-terminal");
        return;
    }
    struct port_wish wish = {.device = screen.device, .why = why};
    subject = (struct subject){.pixel = screen_pixel, .settle = await_frames, .arg = &screen};
    conform_row(display_named("terminal"), &wish);
    CHECK(mode.width == columns && mode.height == 2 * rows);
    screen_close(&screen, slave);
    CHECK(!screen.model.alternate && screen.model.cursor_shown && screen.model.wrap);
    CHECK(screen.model.unknown == 0 && screen.model.titles == 0);
}

TEST(terminal)
{
    (void)setenv("TERM", "xterm-256color", 1);
    (void)setenv("COLORTERM", "truecolor", 1);
    conform_terminal(61, 21);
    conform_terminal(1, 1);
}

/* A failed open has a reason, and closing is safe after it. */
TEST(a_failed_open_can_be_closed)
{
    static const struct {
        const char *name, *device, *why;
    } rows[] = {{"terminal", "/dev/null", "/dev/null: is not a terminal"},
                {"terminal", "/nowhere/tty", "/nowhere/tty: no such file or directory"}};

    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const struct port_display *row = display_named(rows[i].name);
        struct port_wish wish = {.device = rows[i].device, .why = why};
        void *ctx = row->create(&wish);
        CHECK(row->ops->open(ctx, &mode) < 0);
        CHECK_MSG(strcmp(why, rows[i].why) == 0, "\"%.100s\", not \"%s\"", why, rows[i].why);
        row->ops->close(ctx);
        row->ops->close(ctx);
        row->destroy(ctx);
    }
}

TEST(every_row_is_complete)
{
    for (const struct port_display *d = port_displays; d->name; d++) {
        CHECK_MSG(d->summary && d->create && d->destroy && d->list && d->ops, "%s", d->name);
        CHECK_MSG(d->ops->open && d->ops->mode && d->ops->acquire, "%s", d->name);
        CHECK_MSG(d->ops->submit && d->ops->present && d->ops->close, "%s", d->name);
        CHECK_MSG(display_named(d->name) == d, "%s is there twice", d->name);
    }
    for (const struct port_input *i = port_inputs; i->name; i++) {
        CHECK_MSG(i->summary && i->create && i->destroy && i->ops, "%s", i->name);
        CHECK_MSG(i->ops->open && i->ops->poll && i->ops->wait && i->ops->close, "%s", i->name);
    }
}

static const struct port_display *chosen;
static const char *chosen_device;

TEST(conform_chosen)
{
    conform_where_it_opens(chosen, chosen_device);
}

/* Tests the display NAME or NAME:DEVICE; false when there is none. */
static bool conform_argument(const char *argument)
{
    char name[40];
    size_t length = strcspn(argument, ":");

    (void)snprintf(name, sizeof name, "%.*s", (int)length, argument);
    chosen = display_named(name);
    chosen_device = argument[length] ? argument + length + 1 : NULL;
    if (chosen) {
        check_choose("");
        check_run(name, conform_chosen);
    }
    return chosen != NULL;
}

static void run_all(void)
{
    RUN(every_row_is_complete);
    RUN(a_failed_open_can_be_closed);
    RUN(none);
    RUN(terminal);
    for (chosen = port_displays; chosen->name; chosen++)
        if (!chosen->takes_screen && strcmp(chosen->name, "terminal") != 0 && strcmp(chosen->name, "none") != 0)
            check_run(chosen->name, conform_chosen);
}

int main(int argc, char **argv)
{
    int displays = 0;

    (void)setenv("LC_ALL", "C.UTF-8", 1); /* symbols need UTF-8 */
    for (int i = 1; i < argc; i++)
        displays += conform_argument(argv[i]);
    if (!displays)
        run_all();
    return check_status();
}
