/* The console where there is no VT: its listeners, and the places where signals are unblocked. Its effects on a real VT
 * are tested in guests (tests/vm). */
#include "check.h"
#include "console/console.h"
#include "without_vt.h"

#include <signal.h>
#include <stdbool.h>
#include <unistd.h>

static char told[64], why[PORT_WHY];

static void tell(const char *word, const char *who)
{
    (void)strcat(told, word);
    (void)strcat(told, who);
}

static void enter(void *arg)
{
    tell("+", arg);
}
static void leave(void *arg)
{
    tell("-", arg);
}

static char first_name[] = "a", second_name[] = "b";
static struct console_listener first = {.enter = enter, .leave = leave, .arg = first_name},
                               second = {.enter = enter, .leave = leave, .arg = second_name};

TEST(listeners_enter_in_turn_and_leave_in_reverse)
{
    if (!no_vt())
        return;
    told[0] = '\0';
    console_listen(&first);
    console_listen(&second);
    CHECK_EQ(console_state(), CONSOLE_FREE);
    CHECK_EQ(console_open(true, why), TIA_OK);
    CHECK_EQ(console_state(), CONSOLE_OURS);
    console_listen(&first); /* added again: now it is the last */
    console_close();
    CHECK_EQ(console_state(), CONSOLE_FREE);
    CHECK_MSG(strcmp(told, "+a+b-a-b") == 0, "'%s'", told);
    console_ignore(&second);
    CHECK_EQ(console_open(true, why), TIA_OK);
    console_ignore(&first);
    console_ignore(&first);
    console_close();
    console_close();
    CHECK_MSG(strcmp(told, "+a+b-a-b+a") == 0, "'%s'", told);
}

TEST(only_one_display_takes_it)
{
    if (!no_vt())
        return;
    CHECK_EQ(console_open(true, why), TIA_OK);
    CHECK_EQ(console_open(true, why), TIA_ERR_DEVICE);
    CHECK(strstr(why, "taken"));
    CHECK_EQ(console_state(), CONSOLE_OURS);
    console_close();
}

/* The signals that switch consoles have no effect when another program sends them, and closing restores the earlier
 * handlers. */
TEST(its_signals_are_its_own)
{
    struct sigaction before = {.sa_handler = SIG_IGN}, after;
    sigset_t mask;

    if (!no_vt())
        return;
    (void)sigaction(SIGUSR2, &before, NULL);
    CHECK_EQ(console_open(true, why), TIA_OK);
    (void)raise(SIGUSR1);
    (void)raise(SIGUSR2);
    CHECK_EQ(console_wait(NULL, 0, -1), 0);
    CHECK_EQ(console_state(), CONSOLE_OURS);
    console_switch(2);
    (void)raise(SIGUSR1); /* pending at the end, and deadly after it */
    console_close();
    (void)sigaction(SIGUSR1, NULL, &after);
    CHECK(after.sa_handler == SIG_DFL);
    (void)sigaction(SIGUSR2, NULL, &after);
    CHECK(after.sa_handler == SIG_IGN);
    (void)sigprocmask(SIG_SETMASK, NULL, &mask);
    CHECK(!sigismember(&mask, SIGUSR1) && !sigismember(&mask, SIGUSR2));
}

static volatile sig_atomic_t caught;

static void on_signal(int number)
{
    caught = number;
}

TEST(a_blocked_signal_comes_in_while_it_waits)
{
    struct sigaction action = {.sa_handler = on_signal};
    struct pollfd never;
    sigset_t set;
    int ends[2];

    CHECK_EQ(pipe(ends), 0);
    never = (struct pollfd){.fd = ends[0], .events = POLLIN, .revents = POLLIN};
    (void)sigaction(SIGTERM, &action, NULL);
    (void)sigemptyset(&set);
    (void)sigaddset(&set, SIGTERM);
    (void)sigprocmask(SIG_BLOCK, &set, NULL);
    (void)raise(SIGTERM);
    CHECK_EQ(caught, 0);
    CHECK_EQ(console_wait(&never, 1, -1), 0);
    CHECK_EQ(caught, SIGTERM);
    CHECK_EQ(never.revents, 0);
    (void)sigprocmask(SIG_UNBLOCK, &set, NULL);
    (void)close(ends[0]);
    (void)close(ends[1]);
}

TEST(waiting_is_poll)
{
    struct pollfd fds[2];
    int ends[2];

    CHECK_EQ(pipe(ends), 0);
    fds[0] = (struct pollfd){.fd = ends[0], .events = POLLIN};
    fds[1] = (struct pollfd){.fd = ends[1], .events = POLLOUT};
    CHECK_EQ(console_wait(fds, 1, 0), 0);
    CHECK_EQ(console_wait(fds, 1, 3), 0);
    CHECK_EQ(write(ends[1], "x", 1), 1);
    CHECK_EQ(console_wait(fds, 2, -1), 2);
    CHECK(fds[0].revents == POLLIN && fds[1].revents == POLLOUT);
    CHECK_EQ(console_wait(NULL, 0, 0), 0);
    (void)close(ends[0]);
    (void)close(ends[1]);
}

static int run_all(void)
{
    RUN(listeners_enter_in_turn_and_leave_in_reverse);
    RUN(only_one_display_takes_it);
    RUN(its_signals_are_its_own);
    RUN(a_blocked_signal_comes_in_while_it_waits);
    RUN(waiting_is_poll);
    return check_status();
}

int main(void)
{
    return in_process_without_vt(run_all);
}
