#include "overlay.h"

#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "clock.h"
#include "label.h"
#include "progress.h"
#include "scenes.h"

/* The keys of the built-in scene. */
#define HINT_PUT "a d s w put the light"
#define HINT_MOVE "arrows move it"
#define HINT_QUIT "other keys quit"

/* The keys of other scenes for help and to quit. */
#define HINT_HELP "?: help"
#define HINT_END "q: quit"

enum { PROGRESS_SIZE = 2 * PROGRESS_TIME + 32 };

/* A text of several lines. */
struct lines {
    char *text;
    size_t size, used;
};

__attribute__((format(printf, 2, 3))) static void add_line(struct lines *lines, const char *format, ...)
{
    va_list arguments;

    if (lines->used > 0 && lines->used + 1 < lines->size)
        lines->text[lines->used++] = '\n';
    va_start(arguments, format);
    int length = vsnprintf(lines->text + lines->used, lines->size - lines->used, format, arguments);
    va_end(arguments);
    size_t room = lines->size - lines->used - 1;
    lines->used += length < 0 ? 0 : (size_t)length < room ? (size_t)length : room;
}

static void add_stats(const struct overlay *overlay, const struct tia_frame *frame, struct lines *lines)
{
    uint64_t between = overlay->between_us;

    add_line(lines, "frame %" PRIu32 ", %" PRIu64 ".%" PRIu64 " ms", frame->number, frame->draw_us / 1000,
             frame->draw_us % 1000 / 100);
    if (between != 0)
        add_line(lines, "%" PRIu64 ".%" PRIu64 " frames/s", UINT64_C(1000000) / between,
                 UINT64_C(10000000) / between % 10);
    if (overlay->key_us != 0)
        add_line(lines, "key to picture %" PRIu64 ".%" PRIu64 " ms", overlay->key_us / 1000,
                 overlay->key_us % 1000 / 100);
    add_line(lines, "%ux%u, %s, threads %u%s", overlay->width, overlay->height, frame->simd, overlay->threads,
             frame->relit ? ", relit" : "");
    if (frame->block > 2 || (frame->block == 2 && frame->samples <= 1))
        add_line(lines, "blocks of %u", frame->block);
    if (frame->samples)
        add_line(lines, "samples: %" PRIu32, frame->samples);
}

/* Adds a text in lines as wide as the picture. */
static void add_wrapped(const struct overlay *overlay, const char *text, struct lines *lines)
{
    size_t columns = overlay->width / (TIA_TEXT_WIDTH * label_text(text, overlay->height).scale);

    columns = columns > 8 ? columns : 8;
    while (*text != '\0') {
        size_t length = strlen(text), used = length;
        for (used = length > columns ? columns : length; used < length && used > columns / 2 && text[used] != ' ';)
            used--;
        if (used < length && text[used] != ' ')
            used = columns;
        add_line(lines, "%.*s", (int)used, text);
        text += used;
        text += strspn(text, " ");
    }
}

/* Adds the help, with a colon between keys and meaning. */
static void add_help(const char *help, struct lines *lines)
{
    while (*help != '\0') {
        int keys = (int)strcspn(help, "\t"), length = (int)strcspn(help, "\n");
        add_line(lines, "%.*s: %.*s", keys, help, length - keys - 1, help + keys + 1);
        help += length + (help[length] == '\n');
    }
}

static void add_moves(const struct overlay *overlay, struct lines *lines)
{
    const struct moves *moves = overlay->moves;
    const struct tia_viewer_state *viewer = overlay->viewer;

    if (moves_help(moves))
        add_help(moves_help(moves), lines);
    if (moves->broken[0] != '\0')
        add_wrapped(overlay, moves->broken, lines);
    if (moves->until_us > clock_now_us())
        add_line(lines, "%s", moves->message);
    if (viewer->light > 0)
        add_line(lines, "light %" PRIu32 " of %" PRIu32, viewer->light + 1, viewer->light_count);
    if (viewer->paused)
        add_line(lines, "paused");
}

static unsigned percent(const struct tia_frame *frame)
{
    return frame->done * 100u >> 16;
}

/* Writes how much of a coarse picture is drawn, the time passed if --progress asks for it, and the time left. */
static void format_progress(const struct overlay *overlay, const struct tia_frame *frame, char text[PROGRESS_SIZE])
{
    char passed[PROGRESS_TIME], left[PROGRESS_TIME];

    progress_time(passed, (double)frame->draw_us / 1e6);
    progress_time(left, (double)frame->left_us / 1e6);
    if (overlay->options->progress)
        (void)snprintf(text, PROGRESS_SIZE, "%u %%, %s passed, %s left", percent(frame), passed, left);
    else
        (void)snprintf(text, PROGRESS_SIZE, "%u %%, %s left", percent(frame), left);
}

void overlay_text(struct overlay *overlay, const struct tia_frame *frame, char *text, size_t size)
{
    struct lines lines = {text, size, 0};
    char progress[PROGRESS_SIZE];

    text[0] = '\0';
    overlay->labelled = overlay->labelled || frame->shadows != overlay->options->scene.shadows;
    if (overlay->labelled)
        add_line(&lines, "%s %" PRIu64 ".%" PRIu64 " ms", tia_shadows_name(frame->shadows), frame->draw_us / 1000,
                 frame->draw_us % 1000 / 100);
    if (overlay->hints && !overlay->moves && !overlay->options->key_text && overlay->viewer->light_count == 0)
        add_line(&lines, HINT_PUT "\n" HINT_MOVE "\n" HINT_QUIT);
    if (overlay->hints && overlay->moves && frame->block > 1 && overlay->shown_us == 0)
        add_line(&lines, HINT_HELP "  " HINT_END);
    if (overlay->moves)
        add_moves(overlay, &lines);
    if (overlay->options->stats_overlay)
        add_stats(overlay, frame, &lines);
    if (overlay->options->progress && frame->block > 1) {
        format_progress(overlay, frame, progress);
        add_line(&lines, "%s", progress);
    }
}

/* ---- text ---- */

/* Adds a part of the status. */
__attribute__((format(printf, 2, 3))) static void add_part(struct overlay *overlay, const char *format, ...)
{
    size_t used = strlen(overlay->status), size = sizeof overlay->status - used;
    va_list arguments;

    if (used > 0 && size > 1) {
        overlay->status[used] = '\t';
        used++, size--;
    }
    va_start(arguments, format);
    (void)vsnprintf(overlay->status + used, size, format, arguments);
    va_end(arguments);
}

/* Sets the title of the window: the scene's name and, if the picture is coarse, how much of it is drawn. */
static void set_window(struct overlay *overlay, const struct tia_frame *frame, const char *name)
{
    if (frame->block > 1)
        (void)snprintf(overlay->window_title, sizeof overlay->window_title, "%s %u %%", name, percent(frame));
    else
        (void)snprintf(overlay->window_title, sizeof overlay->window_title, "%s", name);
}

/* Adds the parts of the status, the most important first: not all fit into a small window. */
static void add_status(struct overlay *overlay, const struct tia_frame *frame)
{
    const struct tia_viewer_state *viewer = overlay->viewer;
    char name[81], progress[PROGRESS_SIZE];

    scenes_name(overlay->options, name, sizeof name);
    overlay->status[0] = '\0';
    set_window(overlay, frame, name[0] ? name : "tia");
    add_part(overlay, "%s", name[0] ? name : "tia");
    if (viewer->paused)
        add_part(overlay, "paused");
    if (overlay->hints && !overlay->moves) {
        add_part(overlay, viewer->light_count == 0 ? HINT_PUT : HINT_MOVE);
        add_part(overlay, HINT_QUIT);
    }
    if (frame->block > 1) {
        format_progress(overlay, frame, progress);
        add_part(overlay, "%s", progress);
    }
    if (overlay->hints && overlay->moves)
        add_part(overlay, HINT_HELP);
    add_part(overlay, "%" PRIu64 ".%" PRIu64 " ms", overlay->draw_us / 1000, overlay->draw_us % 1000 / 100);
    if (overlay->labelled)
        add_part(overlay, "%s", tia_shadows_name(frame->shadows));
    if (viewer->light > 0)
        add_part(overlay, "light %" PRIu32 " of %" PRIu32, viewer->light + 1, viewer->light_count);
    if (overlay->hints && overlay->moves)
        add_part(overlay, HINT_END);
}

void overlay_words(struct overlay *overlay, const struct tia_frame *frame)
{
    const struct moves *moves = overlay->moves;
    struct lines lines = {overlay->notes, sizeof overlay->notes, 0};

    overlay->labelled = overlay->labelled || frame->shadows != overlay->options->scene.shadows;
    if (frame->pixels > 0)
        overlay->draw_us = frame->draw_us;
    add_status(overlay, frame);
    overlay->notes[0] = '\0';
    if (moves && moves->broken[0] != '\0')
        add_line(&lines, "%s", moves->broken);
    if (moves && moves->until_us > clock_now_us())
        add_line(&lines, "%s", moves->message);
    if (overlay->options->stats_overlay)
        add_stats(overlay, frame, &lines);
    overlay->text.status = overlay->status;
    overlay->text.notes = overlay->notes;
    overlay->text.window_title = overlay->window_title;
    overlay->text.title = "Keys";
    overlay->text.scroll = "arrows: more";
    overlay->text.panel = moves ? moves_help(moves) : NULL;
}

void overlay_shown(struct overlay *overlay, const struct tia_frame *frame)
{
    uint64_t now = clock_now_us();

    overlay->between_us = overlay->shown_us != 0 ? now - overlay->shown_us : 0;
    overlay->shown_us = now;
    if (frame->key_us != 0)
        overlay->key_us = frame->key_us;
}
