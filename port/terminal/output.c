#include "output.h"

#include <errno.h>
#include <poll.h>
#include <unistd.h>

#include "clock.h"
#include "console/console.h"
#include "console/guardian.h"
#include "descriptor.h"
#include "window_title.h"

#define LAST_WRITE_MS 150 /* time that output_leave waits for a terminal that accepts nothing */

/* Texts that save the window's title and enter the alternate screen, with neither cursor nor automatic wrap, and undo
 * that. The text for leaving first ends a control sequence or a picture's string that was cut off: CAN does so on some
 * terminals, ST on the others. For kitty it also ends the picture's data, without requesting an answer. A terminal
 * without an alternate screen is cleared. */
#define CUT "\030\033\\"
#define LEAVE TITLE_RESTORE "\033[?2026l\033[0m\033[2J\033[H\033[?7h\033[?25h\033[?1049l"
static const char enter_text[] = TITLE_SAVE "\033[?1049h\033[?25l\033[?7l", leave_text[] = CUT LEAVE,
                  leave_kitty[] = CUT "\033_Gm=0,q=2;\033\\" LEAVE;

static const char *leaving(const struct output *output)
{
    return output->kitty ? leave_kitty : leave_text;
}

bool output_is_lost(const struct output *output)
{
    return terminal_is_lost(&output->since);
}

static void forget(struct output *output)
{
    output->sent = output->text.count = 0;
}

/* Takes the window. The counts are read before the check, so that a stop in between is noticed later. */
bool output_take(struct output *output)
{
    struct terminal_stops now = terminal_stops_now();

    if (!descriptor_in_front(output->fd))
        return false;
    output->since = now;
    (void)guardian_keep_text(output->fd, leaving(output));
    guardian_sync();
    forget(output);
    text_add(&output->text, enter_text);
    return true;
}

void output_enter(struct output *output)
{
    terminal_signals_begin();
    output->since.put_back = guardian_put_back() - 1; /* if taking the window fails, the window counts as lost */
    (void)output_take(output);
    output->entered = true;
}

bool output_is_left(const struct output *output)
{
    return output->sent < output->text.count;
}

static int send_unless(bool (*is_gone)(const struct terminal_stops *since), struct output *output, int timeout_ms)
{
    uint64_t end = clock_now_us() + (uint64_t)(timeout_ms < 0 ? 0 : timeout_ms) * 1000;

    while (output_is_left(output) && !is_gone(&output->since)) {
        ssize_t n = terminal_write(output->fd, output->text.bytes + output->sent, output->text.count - output->sent);
        struct pollfd ready = {.fd = output->fd, .events = POLLOUT};
        if (n >= 0)
            output->sent += (size_t)n;
        else if (errno == EAGAIN && console_wait(&ready, 1, timeout_ms < 0 ? -1 : clock_left_ms(end)) <= 0)
            return TIA_OK;
        else if (errno != EAGAIN && errno != EINTR)
            return TIA_ERR_DEVICE;
    }
    forget(output);
    return TIA_OK;
}

int output_send(struct output *output, int timeout_ms)
{
    return send_unless(terminal_is_lost, output, timeout_ms);
}

/* Sends the last text. The rest of a frame, including the part that the kernel has buffered, is dropped: a slow
 * terminal would need too much time to show it. */
static void send_last(struct output *output)
{
    uint64_t end = clock_now_us() + LAST_WRITE_MS * 1000;

    if (output_is_left(output))
        descriptor_drop_output(output->fd);
    forget(output);
    text_add(&output->text, leaving(output));
    do /* a signal ends a wait, too */
        (void)send_unless(terminal_is_put_back, output, clock_left_ms(end));
    while (output_is_left(output) && clock_left_ms(end) > 0);
}

void output_leave(struct output *output)
{
    if (terminal_is_put_back(&output->since))
        forget(output);
    else
        send_last(output);
    terminal_signals_end();
    /* otherwise the guardian sends the text when the terminal accepts it */
    if (!output_is_left(output))
        guardian_forget_text(output->fd, leaving(output));
    output->entered = false;
}

void output_cut(struct output *output)
{
    descriptor_drop_output(output->fd);
    forget(output);
    text_add(&output->text, output->kitty ? CUT "\033_Gm=0,q=2;\033\\" LINE_END : CUT LINE_END);
    (void)output_send(output, LAST_WRITE_MS);
}

void output_free(struct output *output)
{
    if (output->fd >= 0)
        (void)close(output->fd);
    output->fd = -1;
    output->sent = 0;
    text_free(&output->text);
}
