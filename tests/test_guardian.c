/* The guardian restores a pseudo-terminal after each kind of death, and only then. */
#include "pseudo.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/* Runs `guarded` in a process that then dies of signal `number`, or ends by itself if it is 0. */
static void in_process(void (*guarded)(void), int number)
{
    pid_t child = fork();

    if (child == 0) {
        (void)signal(SIGSEGV, SIG_DFL); /* the default, not a sanitizer's handler */
        guarded();
        if (number != 0)
            (void)raise(number);
        _exit(0);
    }
    (void)waitpid(child, NULL, 0);
}

static void keep_and_put_back(void)
{
    if (keep_terminal(terminal) != 0)
        return;
    guardian_forget_terminal(terminal);
    make_raw();
}

static void keep_and_kill_group(void)
{
    (void)setpgid(0, 0);
    (void)signal(SIGTERM, SIG_IGN);
    keep_and_make_raw();
    (void)kill(0, SIGTERM);
    (void)kill(0, SIGKILL);
}

static void dies_of(int number)
{
    if (!open_terminal())
        return;
    in_process(keep_and_make_raw, number);
    CHECK_MSG(cooked_again(), "still raw after signal %d", number);
    close_terminal();
}

TEST(killed)
{
    dies_of(SIGKILL);
}
TEST(crashed)
{
    dies_of(SIGSEGV);
}
TEST(terminated)
{
    dies_of(SIGTERM);
}
TEST(left_without_a_word)
{
    dies_of(0);
}

TEST(whole_group_killed)
{
    if (!open_terminal())
        return;
    in_process(keep_and_kill_group, 0);
    CHECK(cooked_again());
    close_terminal();
}

/* ---- a terminal that is gone, and another of the same name ---- */

struct pty {
    int master, terminal;
};

static struct pty open_pty(void)
{
    struct pty p = {-1, -1};

    if (open_terminal())
        p = (struct pty){master, terminal};
    return p;
}

static void close_pty(struct pty p)
{
    (void)close(p.terminal);
    (void)close(p.master);
}

static void keep(struct pty p)
{
    terminal = p.terminal;
    keep_and_make_raw();
}

/* Guards three terminals and closes the middle one, writes a byte to `ready`, and dies when `end` is readable or
 * closed. */
static void keep_three(const struct pty p[3], int ready, int end)
{
    char byte = 0;

    for (int i = 0; i < 3; i++)
        keep(p[i]);
    close_pty(p[1]);
    (void)!write(ready, &byte, 1);
    (void)close(ready);
    (void)!read(end, &byte, 1);
    (void)raise(SIGKILL);
}

/* Waits for the kernel's next tick: two terminals made within one have the same times. */
static void pass_a_tick(void)
{
    struct timespec start, now;

    (void)clock_gettime(CLOCK_REALTIME_COARSE, &start);
    do
        (void)clock_gettime(CLOCK_REALTIME_COARSE, &now);
    while (now.tv_sec == start.tv_sec && now.tv_nsec == start.tv_nsec);
}

/* Opens the terminal of this name. The kernel assigns the lowest free name, so lower ones are opened until this one is
 * next. */
static struct pty open_pty_named(const char *name)
{
    struct pty below[64], p = open_pty();
    int count = 0;

    while (p.terminal >= 0 && strcmp(ttyname(p.terminal), name) != 0 && count < 64) {
        below[count++] = p;
        p = open_pty();
    }
    while (count > 0)
        close_pty(below[--count]);
    return p;
}

/* The guardian processes its entries in its own order: once the first and the last are cooked again, the one in the
 * middle has been processed. */
TEST(another_terminal_of_the_same_name)
{
    struct pty p[3] = {open_pty(), open_pty(), open_pty()}, other;
    char name[64], byte;
    int ready[2], end[2];

    if (p[2].terminal < 0 || ttyname_r(p[1].terminal, name, sizeof name) != 0 || pipe(ready) != 0 || pipe(end) != 0)
        return;
    pid_t child = fork();
    if (child == 0) {
        (void)close(end[1]);
        keep_three(p, ready[1], end[0]);
    }
    (void)!read(ready[0], &byte, 1);
    close_pty(p[1]);
    pass_a_tick();
    other = open_pty_named(name);
    CHECK(other.terminal >= 0);
    make_raw();
    (void)close(end[1]);
    (void)waitpid(child, NULL, 0);
    for (int i = 0; i < 3; i += 2) {
        terminal = p[i].terminal;
        CHECK(cooked_again());
    }
    terminal = other.terminal;
    CHECK(is_raw());
    close_pty(other);
    close_pty(p[0]);
    close_pty(p[2]);
}

/* After a clean end no terminal is restored: its state then belongs to another program. */
TEST(told_of_a_clean_end)
{
    if (!open_terminal())
        return;
    in_process(keep_and_put_back, SIGKILL);
    CHECK(is_raw());
    close_terminal();
}

/* The guardian ends when its last entry is forgotten, and is reaped. */
TEST(ends_when_there_is_nothing_to_keep)
{
    if (!open_terminal())
        return;
    for (int i = 0; i < 3; i++) {
        CHECK_EQ(keep_terminal(terminal), 0);
        CHECK_EQ(keep_terminal(terminal), 0);
        guardian_forget_terminal(terminal);
        CHECK(waitpid(-1, NULL, WNOHANG) < 0);
        guardian_forget_terminal(terminal);
    }
    close_terminal();
}

/* The guardian holds no descriptor of the process: a reader of the process's output reaches the end of the file. */
TEST(holds_no_descriptor_of_ours)
{
    int ends[2];
    char c;

    if (!open_terminal())
        return;
    CHECK_EQ(pipe(ends), 0);
    CHECK_EQ(keep_terminal(terminal), 0);
    (void)close(ends[1]);
    struct pollfd end = {.fd = ends[0], .events = POLLIN};
    CHECK_EQ(poll(&end, 1, 10000), 1);
    CHECK_EQ(read(ends[0], &c, 1), 0);
    guardian_forget_terminal(terminal);
    (void)close(ends[0]);
    close_terminal();
}

TEST(what_is_no_terminal_is_not_kept)
{
    int null = open("/dev/null", O_RDWR | O_CLOEXEC);

    CHECK_EQ(keep_terminal(null), -1);
    guardian_forget_terminal(null);
    guardian_forget_vt("/dev/tty1");
    (void)close(null);
}

int main(void)
{
    RUN(killed);
    RUN(crashed);
    RUN(terminated);
    RUN(left_without_a_word);
    RUN(whole_group_killed);
    RUN(another_terminal_of_the_same_name);
    RUN(told_of_a_clean_end);
    RUN(ends_when_there_is_nothing_to_keep);
    RUN(holds_no_descriptor_of_ours);
    RUN(what_is_no_terminal_is_not_kept);
    return check_status();
}
