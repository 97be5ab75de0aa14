/* display.c - a terminal's window as a display.
 *
 * Frames are drawn into memory. present encodes the changes strip by strip, and sends the text. After 20 ms of encoding
 * or of waiting for the terminal, the rest is left to go_on. The rest of a frame is sent before the next frame, since
 * the grid counts it as shown.
 */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>

#include "clock.h"
#include "descriptor.h"
#include "display_state.h"
#include "picture_place.h"
#include "terminal.h"

#define SLICE_MS 20 /* time limit of present and go_on */

static void terminal_close(void *ctx)
{
    struct terminal *t = ctx;

    if (t->output.entered)
        output_leave(&t->output);
    if (t->in_line && output_is_left(&t->output))
        output_cut(&t->output);
    output_free(&t->output);
    t->columns = t->rows = 0;
    place_forget();
    grid_free(&t->grid);
    free(t->grid.dither);
    t->grid.dither = NULL;
    symbols_free(&t->symbols);
    sheet_free(&t->sheet);
    sheet_free(&t->before);
    t->text = NULL;
    shown_free(&t->shown);
    canvas_free(&t->canvas);
}

/* ---- frames ---- */

/* True if the process has the window; false in the background. After a stop, the last frame is shown again, since the
 * shell has used the window. */
static bool has_window(struct terminal *t)
{
    if (!output_is_lost(&t->output))
        return true;
    if (!output_take(&t->output))
        return false;
    t->clear = t->fresh = true;
    t->encoding = false;
    return true;
}

/* Continues to send a frame. A frame that is not encoded yet waits until the previous one is sent. A frame that was cut
 * off by a stop is shown again only after the viewer has polled the keys, since the terminal may have hung up. */
static int terminal_go_on(void *ctx)
{
    struct terminal *t = ctx;
    uint64_t end = clock_now_us() + SLICE_MS * 1000;
    int status = TIA_OK;

    while (!status && has_window(t)) {
        if (output_send(&t->output, clock_left_ms(end)))
            return display_failed_with(t, errno);
        if (output_is_left(&t->output) || clock_left_ms(end) == 0)
            return TIA_BUSY;
        if (output_is_lost(&t->output)) {
            terminal_resume_again();
            return TIA_OK;
        }
        if (!t->encoding && !t->fresh)
            return TIA_OK;
        status = display_encode(t);
    }
    return status;
}

static void describe(const struct terminal *t, struct tia_mode *mode)
{
    *mode = (struct tia_mode){
        .width = t->canvas.width,
        .height = t->canvas.height,
        .concurrent = true,
        .format = ways_format(t->pictures, t->colours),
    };
}

static int terminal_mode(void *ctx, struct tia_mode *mode)
{
    struct terminal *t = ctx;
    int status = display_fit(t);

    describe(t, mode);
    bool again = t->output.entered && output_is_lost(&t->output) && descriptor_in_front(t->output.fd);
    return !status && again ? TIA_BUSY : status;
}

static int terminal_open(void *ctx, struct tia_mode *mode)
{
    struct terminal *t = ctx;
    int status = display_open_window(t);

    if (!status)
        status = display_environment(t);
    if (!status)
        status = display_choose_pictures(t);
    if (!status)
        status = display_fit(t);
    if (!status) {
        t->output.kitty = t->pictures == PICTURES_KITTY;
        t->symbols.prints = t->in_line;
    }
    if (!status && !t->in_line) {
        output_enter(&t->output);
        t->clear = true;
        status = output_send(&t->output, SLICE_MS) ? display_failed_with(t, errno) : TIA_OK;
    }
    if (status)
        terminal_close(t);
    else
        describe(t, mode);
    return status;
}

static int terminal_acquire(void *ctx, struct tia_tile tile, struct tia_surface *surface)
{
    return canvas_tile(&((struct terminal *)ctx)->canvas, tile, surface);
}

static int terminal_submit(void *ctx, struct tia_tile tile)
{
    const struct terminal *t = ctx;

    return tile_inside(tile, t->canvas.width, t->canvas.height) ? TIA_OK : TIA_ERR_ARGUMENT;
}

/* Prints a frame at the cursor. Waits until the terminal has taken it, or until a signal. */
static int print_frame(struct terminal *t)
{
    int status = display_print(t);

    if (!status && output_send(&t->output, -1))
        status = display_failed_with(t, errno);
    return status;
}

static int terminal_present(void *ctx)
{
    struct terminal *t = ctx;

    if (t->in_line && t->output.fd >= 0)
        return print_frame(t);
    if (!t->output.entered)
        return TIA_ERR_ARGUMENT;
    t->fresh = true;
    return terminal_go_on(t);
}

const struct tia_display port_terminal_display = {
    .open = terminal_open,
    .mode = terminal_mode,
    .acquire = terminal_acquire,
    .submit = terminal_submit,
    .present = terminal_present,
    .close = terminal_close,
    .go_on = terminal_go_on,
};

void port_terminal_text(void *ctx, struct port_text *text)
{
    struct terminal *t = ctx;
    const struct sheet_window window = display_sheet_window(t);
    struct sheet sheet = {.known = false};

    t->text = text;
    if (t->columns && t->rows)
        sheet_compose(&sheet, text, &window);
    sheet_free(&sheet);
}

void *port_terminal_create(const struct port_wish *wish)
{
    struct terminal *t = calloc(1, sizeof *t);

    if (!t) {
        (void)snprintf(wish->why, PORT_WHY, "terminal: out of memory");
        return NULL;
    }
    t->device = ways_find(wish->device, &t->way) ? NULL : wish->device;
    t->why = wish->why;
    t->in_line = wish->in_line;
    t->row = wish->row && !t->in_line;
    t->max_width = wish->width ? wish->width : TIA_SIZE_MAX;
    t->max_height = wish->height ? wish->height : TIA_SIZE_MAX;
    t->output.fd = -1;
    return t;
}

void port_terminal_destroy(void *ctx)
{
    free(ctx);
}

void port_terminal_list(port_line *line, void *arg)
{
    char why[PORT_WHY] = "", text[PORT_WHY + 64];
    struct terminal t = {.why = why, .output.fd = -1};
    unsigned columns, rows;

    if (display_open_window(&t) || display_environment(&t)) {
        line(arg, why);
    } else {
        display_read_window(&t, &columns, &rows);
        (void)snprintf(text, sizeof text, "%ux%u, %s", display_pixels_across(&t, columns),
                       display_pixels_down(&t, rows),
                       t.grid.direct    ? "24-bit colours"
                       : t.grid.letters ? "no colours (set COLORTERM=truecolor if it has them)"
                       : t.grid.few     ? "16 colours (set COLORTERM=truecolor if it has more)"
                                        : "256 colours (set COLORTERM=truecolor if it has more)");
        line(arg, text);
    }
    terminal_close(&t);
}
