#include "session.h"

#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "clock.h"
#include "common/signals.h"
#include "fail.h"

struct session *session_create(const struct options *options)
{
    struct session *session = calloc(1, sizeof *session);
    if (session) {
        session->options = options;
        signals_catch_waiting();
    }
    return session;
}

/* ---- devices ---- */

int session_open_input(struct session *session, const struct port_input *port)
{
    struct port_wish wish = {.device = session->options->input_device, .why = session->why};
    session->input_ctx = port->create(&wish);
    if (!session->input_ctx)
        return EXIT_INPUT;
    if (port->ops->open(session->input_ctx)) {
        port->ops->close(session->input_ctx);
        port->destroy(session->input_ctx);
        session->input_ctx = NULL;
        return EXIT_INPUT;
    }
    session->input = port;
    return EXIT_FINE;
}

static struct port_wish display_wish(struct session *session)
{
    const struct options *options = session->options;
    bool swaps = rotation_swaps(options->rotate);
    return (struct port_wish){.device = options->display_device,
                              .width = swaps ? options->height : options->width,
                              .height = swaps ? options->width : options->height,
                              .connector = options->connector,
                              .mode = options->mode,
                              .why = session->why};
}

int session_open_display(struct session *session, const struct port_display *port)
{
    const struct options *options = session->options;
    struct port_wish wish = display_wish(session);
    session->display_ctx = port->create(&wish);
    if (!session->display_ctx)
        return EXIT_DISPLAY;
    session->display = port;
    session->letterbox = (struct letterbox){.screen = port->ops,
                                            .screen_ctx = session->display_ctx,
                                            .name = port->name,
                                            .width = options->width,
                                            .height = options->height,
                                            .degrees = options->rotate,
                                            .checksum = options->checksum,
                                            .why = session->why};
    int status = letterbox_display.open(&session->letterbox, &session->mode);
    if (status == TIA_ERR_MEMORY)
        return EXIT_RUNNING;
    return !status ? EXIT_FINE : EXIT_DISPLAY;
}

void session_close(struct session *session)
{
    if (session->display) {
        letterbox_display.close(&session->letterbox);
        session->display->destroy(session->display_ctx);
        session->display = NULL;
    }
    if (session->input) {
        session->input->ops->close(session->input_ctx);
        session->input->destroy(session->input_ctx);
        session->input = NULL;
    }
}

/* ---- callbacks of the viewer ---- */

/* Not realloc: the old contents are not needed. */
static void *get_memory(void *ctx, size_t size)
{
    struct session *session = ctx;
    if (size > session->memory_bytes) {
        free(session->memory);
        session->memory = malloc(size);
        session->memory_bytes = session->memory ? size : 0;
    }
    return session->memory;
}

static int print_checksum(struct session *session, uint32_t number)
{
    if (fprintf(session->lines, "%" PRIu32 " %08" PRIx32 "\n", number, session->letterbox.crc) < 0 ||
        fflush(session->lines) != 0) {
        (void)snprintf(session->why, PORT_WHY, "standard output: %s", strerror(errno));
        return TIA_ERR_DEVICE;
    }
    return TIA_OK;
}

static void frame_drawn(void *ctx, const struct tia_frame *frame)
{
    struct session *session = ctx;
    struct letterbox *letterbox = &session->letterbox;
    session->overlay.width = letterbox->rotation.width;
    session->overlay.height = letterbox->rotation.height;
    overlay_text(&session->overlay, frame, letterbox->label, sizeof letterbox->label);
}

static int frame_done(void *ctx, const struct tia_frame *frame)
{
    struct session *session = ctx;
    if (frame->block > 1) {
        if (frame->key_us != 0)
            stats_add(&session->stats.coarse, frame->key_us);
        return TIA_OK;
    }
    overlay_shown(&session->overlay, frame);
    session->stats.frames++;
    session->stats.level = frame->level;
    stats_add(&session->stats.draw, frame->draw_us);
    if (frame->key_us != 0)
        stats_add(&session->stats.flip, frame->key_us);
    return session->options->checksum ? print_checksum(session, frame->number) : TIA_OK;
}

/* ---- the run ---- */

/* Chooses where --checksum prints. On the terminal that shows the picture, lines would spoil it: they are kept and
 * printed afterwards. */
static int open_lines(struct session *session)
{
    session->lines = stdout;
    if (session->options->checksum && isatty(STDOUT_FILENO) != 0)
        session->lines = open_memstream(&session->text, &session->text_bytes);
    return session->lines ? TIA_OK : TIA_ERR_MEMORY;
}

static int close_lines(struct session *session)
{
    if (!session->lines || session->lines == stdout)
        return TIA_OK;
    (void)fclose(session->lines);
    int result = fputs(session->text, stdout);
    free(session->text);
    session->text = NULL;
    return result >= 0 && fflush(stdout) == 0 ? TIA_OK : TIA_ERR_DEVICE;
}

static struct tia_viewer viewer_of(struct session *session)
{
    const struct options *options = session->options;
    return (struct tia_viewer){.core = options->core,
                               .level = options->level,
                               .scene = &options->scene,
                               .lights = session->lights.array,
                               .light_capacity = session->lights.capacity,
                               .detached = session->lights.detached,
                               .variant = options->scene_path ? &session->variant : NULL,
                               .options = {.dither = options->dither},
                               .frame_limit = options->frames,
                               .keys = options->keys,
                               .key_count = options->key_count,
                               .time = options->time,
                               .rate = {options->rate_given ? options->rate[0] : 0, options->rate[1]},
                               .display = &letterbox_display,
                               .input = session->input->ops,
                               .clock = &clock_monotonic,
                               .workers = &threads_workers,
                               .display_ctx = &session->letterbox,
                               .input_ctx = session->input_ctx,
                               .workers_ctx = session->pool,
                               .memory = get_memory,
                               .memory_ctx = session,
                               .frame_drawn = frame_drawn,
                               .frame_done = frame_done,
                               .frame_ctx = session,
                               .stop = signals_asked};
}

/* Creates the threads after opening the display: opening may fork, and threads do not survive that. */
int session_run(struct session *session)
{
    int status = TIA_ERR_MEMORY;
    session->why[0] = '\0';
    session->pool = threads_create(session->options->threads);
    if (session->pool && lights_copy(&session->lights, &session->options->scene) && !open_lines(session)) {
        struct tia_viewer viewer = viewer_of(session);
        session->overlay = (struct overlay){.options = session->options, .threads = threads_count(session->pool)};
        status = tia_viewer_run(&viewer);
    }
    (void)snprintf(session->format, sizeof session->format, "%s", session->mode.format);
    session->stats.display = session->display->name;
    session->stats.format = session->format;
    session->stats.width = session->letterbox.rotation.width;
    session->stats.height = session->letterbox.rotation.height;
    session->stats.scale_bits = session->options->scene.scale_bits;
    session->stats.threads = session->pool ? threads_count(session->pool) : 1;
    if (status < 0 && session->why[0] == '\0')
        fail_view_reason(session->why, PORT_WHY, status, &session->options->scene, session->stats.width,
                         session->stats.height);
    return status == TIA_ERR_RANGE ? EXIT_USAGE : status < 0 ? EXIT_RUNNING : EXIT_FINE;
}

int session_end(struct session *session, int status)
{
    if (close_lines(session) && status == EXIT_FINE)
        status = fail_output();
    if (session->options->stats && session->stats.display && status == EXIT_FINE && stats_print(&session->stats) != 0)
        status = EXIT_RUNNING;
    threads_destroy(session->pool);
    lights_free(&session->lights);
    free(session->memory);
    free(session);
    return signals_end(status);
}
