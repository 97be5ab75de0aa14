#include "session.h"

#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "arithmetic.h"
#include "clock.h"
#include "common/signals.h"
#include "eye_setup.h"
#include "fail.h"
#include "gaze_options.h"
#include "pixels/pages.h"
#include "save.h"
#include "scenes.h"

struct session *session_create(struct options *options)
{
    struct session *session = calloc(1, sizeof *session);
    if (session) {
        session->options = options;
        session->is_moved = options->scene_path != NULL;
        signals_catch_waiting();
    }
    return session;
}

/* ---- devices ---- */

int session_open_input(struct session *session, const struct port_input *port)
{
    struct port_wish wish = {
        .device = session->options->input.device, .pointer = session->is_moved, .why = session->why};
    session->input_ctx = port->create(&wish);
    if (!session->input_ctx)
        return EXIT_RUNNING; /* no memory for it */
    int status = port->ops->open(session->input_ctx);
    if (status) {
        port->ops->close(session->input_ctx);
        port->destroy(session->input_ctx);
        session->input_ctx = NULL;
        return status == TIA_ERR_MEMORY ? EXIT_RUNNING : EXIT_INPUT;
    }
    session->input = port;
    return EXIT_FINE;
}

/* True if a terminal prints pictures where the cursor is. */
static bool prints(const struct options *options)
{
    return options->in_line || options->frames == 1;
}

static struct port_wish display_wish(struct session *session)
{
    const struct options *options = session->options;
    bool swaps = rotation_swaps(options->rotate);
    return (struct port_wish){.device = options->display.device,
                              .width = swaps ? options->height : options->width,
                              .height = swaps ? options->width : options->height,
                              .connector = options->connector,
                              .mode = options->mode,
                              .in_line = prints(options),
                              .row = true,
                              .why = session->why};
}

/* Shows the progress of pictures that are printed, since nothing is seen before they are complete. */
static void begin_progress(struct session *session)
{
    const struct options *options = session->options;
    uint64_t pixels = (uint64_t)session->mode.width * session->mode.height;

    session->letterbox.drawn = progress_drawn;
    session->letterbox.drawn_ctx = &session->progress;
    progress_begin(&session->progress, options, pixels, options->frames ? options->frames : 1);
    progress_start(&session->progress);
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
                                            .keeps = session->is_moved || session->save_to,
                                            .set_text = port->text,
                                            .text = &session->overlay.text,
                                            .why = session->why};
    int status = letterbox_display.open(&session->letterbox, &session->mode);
    if (status == TIA_ERR_MEMORY)
        return EXIT_RUNNING;
    if (!status && strcmp(port->name, "terminal") == 0 && prints(options))
        begin_progress(session);
    return !status ? EXIT_FINE : EXIT_DISPLAY;
}

void session_close(struct session *session)
{
    if (session->letterbox.drawn)
        progress_end(&session->progress);
    session->letterbox.drawn = NULL;
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

/* Returns memory for the viewer. Does not use realloc, since the old contents are not needed. */
static void *get_memory(void *ctx, size_t size)
{
    struct session *session = ctx;
    if (size > session->memory_bytes) {
        free(session->memory);
        session->memory = pages_alloc(size);
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
    if (letterbox->set_text)
        overlay_words(&session->overlay, frame);
    else
        overlay_text(&session->overlay, frame, letterbox->label, sizeof letterbox->label);
}

static int frame_done(void *ctx, const struct tia_frame *frame)
{
    struct session *session = ctx;
    bool coarse = frame->block > 1 && !frame->moving;
    stats_paced(&session->stats.paced, frame, clock_now_us());
    stats_key(&session->stats, frame->key_us, coarse);
    if (coarse)
        return TIA_OK;
    if (session->is_moved)
        moves_shown(&session->moves, frame);
    overlay_shown(&session->overlay, frame);
    session->stats.frames++;
    session->stats.simd = frame->simd;
    stats_add(&session->stats.draw, frame->draw_us);
    session->stats.pixels += frame->pixels;
    session->stats.all_pixels += (uint64_t)session->letterbox.rotation.width * session->letterbox.rotation.height;
    if (session->save_to && save_picture(&session->letterbox, session->save_to, session->options->format, session->why))
        return TIA_ERR_DEVICE;
    return session->options->checksum ? print_checksum(session, frame->number) : TIA_OK;
}

/* ---- the run ---- */

/* Chooses the output of --checksum. Lines on a terminal would spoil its picture: they are stored and printed
 * afterwards. */
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

static enum tia_effect weigh(void *ctx, const struct tia_event *event)
{
    return moves_weigh(&((struct session *)ctx)->moves, event);
}

static enum tia_effect act(void *ctx, const struct tia_event *event, struct tia_camera *camera)
{
    return moves_act(&((struct session *)ctx)->moves, event, camera);
}

static const struct tia_control control = {weigh, act};

/* True if --fps is a target frame rate, not the rate of a film. */
static bool viewer_paces(const struct options *options)
{
    return options->rate_given && options->frames == 0;
}

static struct tia_viewer viewer_of(struct session *session)
{
    const struct options *options = session->options;
    bool paces = viewer_paces(options);
    return (struct tia_viewer){
        .core = options->core,
        .simd = options->simd,
        .estimator = arithmetic_estimator(options->core),
        .scene = &options->scene,
        .variant = options->scene_path ? &session->variant : NULL,
        .lights = {.array = session->lights.array,
                   .kept = session->lights.kept,
                   .detached = session->lights.detached,
                   .capacity = session->lights.capacity},
        .pacing = {.frame_limit = options->frames,
                   .time = options->time,
                   .rate = {options->rate_given && !paces ? options->rate[0] : 0, options->rate[1]},
                   .pace = {paces ? options->rate[0] : 0, options->rate[1]}},
        .ports = {.display = &letterbox_display,
                  .display_ctx = &session->letterbox,
                  .input = session->is_moved ? &pointed_input : session->input->ops,
                  .input_ctx = session->is_moved ? (void *)&session->pointed : session->input_ctx,
                  .clock = &clock_monotonic},
        .hooks = {.memory = get_memory,
                  .frame_drawn = frame_drawn,
                  .frame_done = frame_done,
                  .control = session->is_moved ? &control : NULL,
                  .ctx = session},
        .job = {.workers = threads_workers(session->pool), .stop = signals_asked},
        .dither = options->dither,
        .keys = options->keys,
        .key_count = options->key_count,
        .gaze = gaze_of(options),
        .state = &session->viewer,
    };
}

/* Begins the overlay. It shows hints if there is a keyboard. */
static void begin_overlay(struct session *session)
{
    const struct options *options = session->options;
    bool types = strcmp(session->input->name, "none") != 0;

    session->overlay = (struct overlay){.options = options,
                                        .threads = threads_count(session->pool),
                                        .moves = session->is_moved ? &session->moves : NULL,
                                        .viewer = &session->viewer,
                                        .hints = types};
    session->moves = (struct moves){.options = options,
                                    .letterbox = &session->letterbox,
                                    .viewer = &session->viewer,
                                    .text = &session->overlay.text};
    session->pointed =
        (struct pointed){session->input->ops, session->input_ctx, &session->letterbox, &session->moves, options->watch};
    (void)snprintf(session->moves.broken, PORT_WHY, "%s", options->broken);
}

/* Reads the changed scene. The time and an eye that keys have moved stay, also if the unit of length is another now. */
static bool read_again(struct session *session)
{
    struct tia_viewer_state *state = &session->viewer;
    struct tia_placement before = session->options->file.placement;
    struct tia_scene tried;

    if (!scenes_read_again(session->options, session->moves.broken))
        return true;
    session->moves.broken[0] = '\0';
    tried = session->options->scene;
    if (state->moved) {
        eye_carry(&state->camera, &before, &session->options->file.placement);
        tried.camera = state->camera;
        state->moved = !tia_scene_check(&tried, NULL);
    }
    state->light_count = session->options->scene.light_count;
    state->light = 0;
    lights_free(&session->lights);
    return lights_copy(&session->lights, &session->options->scene);
}

/* Prepares the next scene or view if a key has selected one; false: the session ends. If a scene cannot be loaded, the
 * current one stays, with a message. */
static bool move_on(struct session *session)
{
    enum move_to to = session->moves.to;

    session->moves.to = MOVE_NOWHERE;
    session->options->key_count = 0;
    session->viewer.goes_on = true;
    if (to == MOVE_NEXT_VIEW) {
        scenes_next_view(session->options);
        moves_say(&session->moves, view_name(session->options->views.view));
        return true;
    }
    if (to == MOVE_NOWHERE)
        return false;
    if (to == MOVE_READ_AGAIN)
        return read_again(session);
    if (!scenes_go(session->options, to == MOVE_NEXT_SCENE ? 1 : -1, session->why)) {
        moves_say(&session->moves, session->why);
        session->why[0] = '\0';
        return true;
    }
    session->moves.broken[0] = '\0';
    moves_say(&session->moves, session->options->scene_path);
    session->viewer.goes_on = false;
    lights_free(&session->lights);
    return lights_copy(&session->lights, &session->options->scene);
}

/* Saves an incomplete picture that was to be saved, and returns the result of move_on. The message about the picture
 * appears in the next scene or, if the session ends, on standard error after the display is closed. */
static bool go_on(struct session *session)
{
    char text[PORT_WHY];
    bool saved = moves_finish(&session->moves, text), more = move_on(session);

    if (saved && more)
        moves_say(&session->moves, text);
    else if (saved)
        (void)snprintf(session->last, sizeof session->last, "%s", text);
    return more;
}

/* Runs the session. Creates the threads after opening the display: opening may fork, and threads do not survive a
 * fork. */
int session_run(struct session *session)
{
    int status = TIA_ERR_MEMORY;
    session->why[0] = '\0';
    session->pool = threads_create(session->options->threads);
    if (session->pool && lights_copy(&session->lights, &session->options->scene) && !open_lines(session)) {
        begin_overlay(session);
        do {
            struct tia_viewer viewer = viewer_of(session);
            status = tia_viewer_run(&viewer);
        } while (!status && go_on(session));
    }
    (void)snprintf(session->format, sizeof session->format, "%s", session->mode.format);
    if (viewer_paces(session->options))
        session->stats.paced.asked_us = UINT64_C(1000000) * session->options->rate[1] / session->options->rate[0];
    session->stats.gazes = session->options->gazes;
    session->stats.display = session->display->name;
    session->stats.format = session->format;
    session->stats.width = session->letterbox.rotation.width;
    session->stats.height = session->letterbox.rotation.height;
    session->stats.scale_bits = session->options->scene.scale_bits;
    session->stats.threads = session->pool ? threads_count(session->pool) : 1;
    if (status < 0 && session->why[0] == '\0')
        fail_view_reason(session->why, PORT_WHY, status,
                         &(struct fail_view){&session->options->scene, session->lights.array,
                                             session->viewer.light_count, session->stats.width, session->stats.height});
    return status == TIA_ERR_RANGE ? EXIT_USAGE : status < 0 ? EXIT_RUNNING : EXIT_FINE;
}

int session_end(struct session *session, int status)
{
    if (session->last[0] != '\0')
        note("%s", session->last);
    if (session->moves.line[0] != '\0' && (puts(session->moves.line) < 0 || fflush(stdout) != 0) && status == EXIT_FINE)
        status = fail_output();
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
