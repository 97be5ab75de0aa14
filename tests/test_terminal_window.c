/* The terminal as a display, while the process is stopped and continues. */
#include "pseudo.h"

#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>

#include "terminal/terminal.h"

enum { COLUMNS = 10, ROWS = 4 };

static char why[PORT_WHY], sent[65536];

/* Returns the text written to the terminal since the last call. */
static const char *written(void)
{
    struct pollfd ready = {.fd = master, .events = POLLIN};
    size_t count = 0;

    while (poll(&ready, 1, 0) > 0 && count < sizeof sent - 1) {
        ssize_t n = read(master, sent + count, sizeof sent - 1 - count);
        if (n <= 0)
            break;
        count += (size_t)n;
    }
    sent[count] = '\0';
    return sent;
}

static void *opened(struct tia_mode *mode)
{
    struct winsize size = {ROWS, COLUMNS, 0, 0};
    char name[64];

    (void)snprintf(name, sizeof name, "%s", ptsname(master));
    (void)setenv("TERM", "xterm-256color", true);
    (void)ioctl(terminal, TIOCSWINSZ, &size);
    void *t = port_terminal_create(&(const struct port_wish){.device = name, .why = why});
    CHECK_MSG(t && port_terminal_display.open(t, mode) == TIA_OK, "%s", why);
    return t;
}

static bool is_pending(int number)
{
    sigset_t pending;

    return sigpending(&pending) == 0 && sigismember(&pending, number) == 1;
}

/* After a SIGCONT just before a frame is written, nothing is written, the next wait ends at once, and then the window
 * is entered again. */
TEST(continued_before_a_frame_is_written)
{
    struct tia_mode mode;

    if (!open_terminal())
        return;
    void *t = opened(&mode);
    (void)written();
    CHECK(!is_pending(SIGCONT));
    (void)raise(SIGCONT);
    CHECK_EQ(port_terminal_display.present(t), TIA_OK);
    CHECK_MSG(!*written(), "%zu bytes", strlen(sent));
    CHECK(is_pending(SIGCONT));
    CHECK_EQ(port_terminal_display.mode(t, &mode), TIA_BUSY);
    CHECK_EQ(port_terminal_display.go_on(t), TIA_OK);
    CHECK(strstr(written(), "\033[?1049h") && strstr(sent, "\033[?2026l"));
    CHECK(!is_pending(SIGCONT));
    CHECK_EQ(port_terminal_display.mode(t, &mode), TIA_OK);
    port_terminal_display.close(t);
    port_terminal_destroy(t);
    close_terminal();
}

/* A SIGCONT while the window is left does not keep the window. */
TEST(continued_before_the_window_is_left)
{
    struct tia_mode mode;

    if (!open_terminal())
        return;
    void *t = opened(&mode);
    CHECK_EQ(port_terminal_display.present(t), TIA_OK);
    (void)written();
    (void)raise(SIGCONT);
    port_terminal_display.close(t);
    CHECK(strstr(written(), "\033[?1049l") != NULL);
    port_terminal_destroy(t);
    close_terminal();
}

int main(void)
{
    RUN(continued_before_a_frame_is_written);
    RUN(continued_before_the_window_is_left);
    return check_status();
}
