/* test_ports.c - one conformance suite for every display that this machine can open.
 *
 * The memory display, the displays that do not take the screen, and a terminal (a pseudo-terminal
 * and a model of one) are always tested. A display that takes the screen is tested only when
 * asked for by its name: `test_ports drm fbdev:/dev/fb1`.
 */
#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <pty.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "check.h"
#include "memory/memory.h"
#include "ports.h"
#include "terminal_model.h"

/* What the suite tests. */
struct subject {
    const struct tia_display *ops;
    void *ctx;
    const char *why;
    /* Pixel (x, y) of the frame presented last, as RGB565; NULL: it cannot be read. */
    tia_rgb565 (*pixel)(void *arg, unsigned x, unsigned y);
    /* NULL, or waits until so many frames have been shown, those left out that changed nothing. */
    void (*settle)(void *arg, unsigned frames);
    void *arg;
    unsigned frames, last;
};

static struct subject subject;
static struct tia_mode mode;

/* 40503 is odd: every colour comes before one comes again, and neighbours differ. */
static tia_rgb565 wanted(unsigned x, unsigned y, unsigned frame)
{
    return (tia_rgb565)((x + y * mode.width + frame * 7919) * 40503u);
}

/* ---- frames ---- */

static void fill(const struct tia_surface *surface, struct tia_tile tile, unsigned frame)
{
    for (unsigned y = 0; y < tile.height; y++)
        for (unsigned x = 0; x < tile.width; x++) {
            char *at = (char *)surface->pixels + (ptrdiff_t)y * surface->pitch + (ptrdiff_t)x * surface->step;
            *(tia_rgb565 *)(void *)at = wanted(tile.x + x, tile.y + y, frame);
        }
}

static bool draw_tile(struct tia_tile tile, unsigned frame)
{
    struct tia_surface surface = {0};

    if (subject.ops->acquire(subject.ctx, tile, &surface) != TIA_OK || !surface.pixels || surface.step % 2 ||
        surface.pitch % 2)
        return false;
    fill(&surface, tile, frame);
    return subject.ops->submit(subject.ctx, tile) == TIA_OK;
}

/* The picture cut into tiles of a size that the mode allows and that does not divide it. */
struct cut {
    unsigned width, height, columns, rows, frame, first, every;
    bool failed;
};

static struct cut cut_for(unsigned frame)
{
    struct cut cut = {.width = 37, .height = 19, .frame = frame, .every = 1};

    if (mode.tile_width && mode.tile_width < cut.width)
        cut.width = mode.tile_width;
    if (mode.tile_height && mode.tile_height < cut.height)
        cut.height = mode.tile_height;
    cut.columns = (mode.width + cut.width - 1) / cut.width;
    cut.rows = (mode.height + cut.height - 1) / cut.height;
    return cut;
}

static unsigned smaller(unsigned a, unsigned b)
{
    return a < b ? a : b;
}

/* Every `every`th tile from `first` on, the last one first. */
static void *draw_cut(void *arg)
{
    struct cut *cut = arg;

    for (unsigned n = cut->first; n < cut->columns * cut->rows; n += cut->every) {
        unsigned i = cut->columns * cut->rows - 1 - n;
        unsigned x = i % cut->columns * cut->width, y = i / cut->columns * cut->height;
        struct tia_tile tile = {(uint16_t)x, (uint16_t)y, (uint16_t)smaller(cut->width, mode.width - x),
                                (uint16_t)smaller(cut->height, mode.height - y)};
        cut->failed |= !draw_tile(tile, cut->frame);
    }
    return NULL;
}

static void check_frame(unsigned frame)
{
    if (subject.settle)
        subject.settle(subject.arg, subject.frames);
    for (unsigned y = 0; subject.pixel && y < mode.height; y++)
        for (unsigned x = 0; x < mode.width; x++)
            CHECK_MSG(subject.pixel(subject.arg, x, y) == wanted(x, y, frame), "frame %u: %u,%u is %04x, not %04x",
                      frame, x, y, subject.pixel(subject.arg, x, y), wanted(x, y, frame));
}

static void present(unsigned frame)
{
    CHECK_MSG(subject.ops->present(subject.ctx) == TIA_OK, "frame %u: present: %s", frame, subject.why);
    subject.frames += frame != subject.last;
    subject.last = frame;
    check_frame(frame);
}

static void one_thread(unsigned frame)
{
    struct cut cut = cut_for(frame);

    (void)draw_cut(&cut);
    CHECK_MSG(!cut.failed, "frame %u: a tile failed: %s", frame, subject.why);
    present(frame);
}

static void two_threads(unsigned frame)
{
    struct cut even = cut_for(frame), odd = even;
    pthread_t thread;

    even.every = odd.every = 2;
    odd.first = 1;
    if (pthread_create(&thread, NULL, draw_cut, &odd) != 0)
        return;
    (void)draw_cut(&even);
    (void)pthread_join(thread, NULL);
    CHECK_MSG(!even.failed && !odd.failed, "frame %u: a tile of two threads failed", frame);
    present(frame);
}

/* ---- the suite ---- */

static bool open_subject(void)
{
    struct tia_mode now;
    int status = subject.ops->open(subject.ctx, &mode);

    CHECK_MSG(status == TIA_OK, "open: %s", subject.why);
    if (status != TIA_OK)
        return false;
    CHECK(mode.width >= 1 && mode.width <= TIA_SIZE_MAX && mode.height >= 1 && mode.height <= TIA_SIZE_MAX);
    CHECK(mode.format && *mode.format);
    CHECK_EQ(subject.ops->mode(subject.ctx, &now), TIA_OK);
    CHECK(now.width == mode.width && now.height == mode.height && now.concurrent == mode.concurrent);
    CHECK(now.tile_width == mode.tile_width && now.tile_height == mode.tile_height);
    return true;
}

static void check_refused(unsigned x, unsigned y, unsigned width, unsigned height)
{
    struct tia_tile tile = {(uint16_t)x, (uint16_t)y, (uint16_t)width, (uint16_t)height};
    struct tia_surface surface;
    int status = subject.ops->acquire(subject.ctx, tile, &surface);

    CHECK_MSG(status == TIA_ERR_ARGUMENT, "tile %u,%u %ux%u: status %d", x, y, width, height, status);
}

static void check_limits(void)
{
    check_refused(mode.width, 0, 1, 1);
    check_refused(0, mode.height, 1, 1);
    check_refused(0, 0, 0, 1);
    check_refused(0, 0, 1, 0);
    check_refused(mode.width - 1u, 0, 2, 1);
    check_refused(0, mode.height - 1u, 1, 2);
    if (mode.tile_width && mode.tile_width < mode.width)
        check_refused(0, 0, mode.tile_width + 1u, 1);
    if (mode.tile_height && mode.tile_height < mode.height)
        check_refused(0, 0, 1, mode.tile_height + 1u);
}

static void conform(void)
{
    subject.ops->close(subject.ctx);
    for (unsigned round = 0; round < 2; round++) {
        subject.last = UINT32_MAX;
        if (!open_subject())
            return;
        for (unsigned frame = 0; frame < 3; frame++)
            one_thread(frame);
        one_thread(2); /* the same frame once more */
        if (mode.concurrent)
            two_threads(3);
        check_limits();
        one_thread(4);
        subject.ops->close(subject.ctx);
        subject.ops->close(subject.ctx);
    }
}

/* ---- memory ---- */

static tia_rgb565 memory_pixel(void *arg, unsigned x, unsigned y)
{
    const struct tia_surface *s = arg;

    return *(tia_rgb565 *)(void *)((char *)s->pixels + (ptrdiff_t)y * s->pitch + (ptrdiff_t)x * s->step);
}

static struct port_memory memory_of(unsigned width, unsigned height, ptrdiff_t step, ptrdiff_t pitch)
{
    return (struct port_memory){.surface = {NULL, step, pitch}, .width = (uint16_t)width, .height = (uint16_t)height};
}

/* Runs the suite in a block of memory that holds the whole surface; negative strides begin at its
 * end. Around the pixels nothing may change. */
static void conform_in(struct port_memory *memory)
{
    struct tia_surface *s = &memory->surface;
    size_t row = (size_t)(memory->width - 1) * (size_t)llabs(s->step);
    size_t column = (size_t)(memory->height - 1) * (size_t)llabs(s->pitch);
    size_t bytes = row + column + sizeof(tia_rgb565), guard = 64;
    char *block = malloc(bytes + 2 * guard), *first = block + guard;

    memset(block, 0x5a, bytes + 2 * guard);
    first += (s->step < 0 ? row : 0) + (s->pitch < 0 ? column : 0);
    s->pixels = (tia_rgb565 *)(void *)first;
    subject = (struct subject){&port_memory_display, memory, "", memory_pixel, NULL, s, 0, 0};
    conform();
    for (size_t i = 0; i < guard; i++)
        CHECK(block[i] == 0x5a && block[guard + bytes + i] == 0x5a);
    free(block);
}

TEST(memory)
{
    struct port_memory memory = memory_of(100, 75, 2, 200);

    memory.concurrent = true;
    conform_in(&memory);
    CHECK_EQ(memory.frames, 2 * 6);
}

TEST(memory_with_tile_limits)
{
    struct port_memory memory = memory_of(101, 77, 2, 256);

    memory.tile_width = 16;
    memory.tile_height = 5;
    conform_in(&memory);
}

/* Upside down; a panel turned by a quarter: a step to the right is a row of the memory. */
TEST(memory_turned)
{
    struct port_memory flipped = memory_of(33, 9, -2, -80), turned = memory_of(33, 9, 64, -2);

    flipped.concurrent = true;
    conform_in(&flipped);
    conform_in(&turned);
}

TEST(memory_records_the_order_of_calls)
{
    tia_rgb565 pixels[4 * 3];
    struct memory_call calls[16];
    struct port_memory memory = memory_of(4, 3, 2, 8);
    static const enum memory_call_kind want[] = {MEMORY_OPEN,   MEMORY_MODE,    MEMORY_ACQUIRE,
                                                 MEMORY_SUBMIT, MEMORY_PRESENT, MEMORY_CLOSE};

    memory.surface.pixels = pixels;
    memory.calls = calls;
    memory.call_capacity = 16;
    subject = (struct subject){&port_memory_display, &memory, "", memory_pixel, NULL, &memory.surface, 0, 0};
    if (open_subject())
        one_thread(0);
    port_memory_display.close(&memory);
    CHECK_EQ(memory.call_count, 6);
    for (size_t i = 0; i < 6; i++)
        CHECK(calls[i].kind == want[i] && calls[i].result == TIA_OK);
    CHECK(calls[2].tile.width == 4 && calls[2].tile.height == 3);
}

TEST(memory_refuses_what_the_contract_forbids)
{
    tia_rgb565 pixels[4 * 3] = {0};
    struct port_memory memory = memory_of(4, 3, 2, 8);
    const struct tia_display *d = &port_memory_display;
    struct tia_tile tile = {0, 0, 2, 2};
    struct tia_surface surface;

    memory.surface.pixels = pixels;
    CHECK_EQ(d->mode(&memory, &mode), TIA_ERR_ARGUMENT);
    CHECK_EQ(d->acquire(&memory, tile, &surface), TIA_ERR_ARGUMENT);
    CHECK_EQ(d->present(&memory), TIA_ERR_ARGUMENT);
    CHECK_EQ(d->open(&memory, &mode), TIA_OK);
    CHECK_EQ(d->open(&memory, &mode), TIA_ERR_ARGUMENT);
    CHECK_EQ(d->submit(&memory, tile), TIA_ERR_ARGUMENT);
    CHECK_EQ(d->acquire(&memory, tile, &surface), TIA_OK);
    CHECK_EQ(d->acquire(&memory, tile, &surface), TIA_ERR_ARGUMENT); /* not concurrent */
    CHECK_EQ(d->present(&memory), TIA_ERR_ARGUMENT);
    CHECK_EQ(d->submit(&memory, tile), TIA_OK);
    memory.hidden = true;
    CHECK_EQ(d->mode(&memory, &mode), TIA_HIDDEN);
    CHECK_EQ(d->acquire(&memory, tile, &surface), TIA_ERR_ARGUMENT);
    d->close(&memory);
    memory.fail_open = TIA_ERR_DEVICE;
    CHECK_EQ(d->open(&memory, &mode), TIA_ERR_DEVICE);
    CHECK_EQ(d->acquire(&memory, tile, &surface), TIA_ERR_ARGUMENT);
    d->close(&memory);
}

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

/* A display that cannot be opened here is skipped, with its reason. */
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
    if (status == TIA_OK)
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

/* Reads slowly and little at a time, so that the display has to wait for its terminal. */
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
    CHECK_EQ(screen.model.unknown, 0);
}

TEST(terminal)
{
    (void)setenv("TERM", "xterm-256color", 1);
    (void)setenv("COLORTERM", "truecolor", 1);
    conform_terminal(61, 21);
    conform_terminal(1, 1);
}

/* What cannot be opened says why, and may be closed. */
TEST(a_failed_open_can_be_closed)
{
    static const struct {
        const char *name, *device, *why;
    } rows[] = {{"terminal", "/dev/null", "/dev/null: is no terminal"},
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

/* NAME or NAME:DEVICE. */
static int conform_argument(char *name)
{
    char *colon = strchr(name, ':');

    if (colon)
        *colon = 0;
    chosen = display_named(name);
    chosen_device = colon ? colon + 1 : NULL;
    if (chosen)
        check_run(name, conform_chosen);
    else
        printf("FAIL %s: no display of this name\n", name);
    return chosen ? 0 : 1;
}

static void run_all(void)
{
    RUN(memory);
    RUN(memory_with_tile_limits);
    RUN(memory_turned);
    RUN(memory_records_the_order_of_calls);
    RUN(memory_refuses_what_the_contract_forbids);
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
    int status = 0;

    if (argc == 1)
        run_all();
    for (int i = 1; i < argc; i++)
        status |= conform_argument(argv[i]);
    return status | check_status();
}
