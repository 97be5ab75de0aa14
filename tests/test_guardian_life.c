/* The guardian's own life: when the parent is notified of a death, and the end of a guardian that dies or is stopped
 * itself. */
#include "pseudo.h"

#include <dirent.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>

/* Returns the number in a line of a file of /proc that begins with `name`, or -1. */
static long number_in(const char *path, const char *name)
{
    FILE *file = fopen(path, "re");
    char line[256];
    long number = -1;

    while (file && number < 0 && fgets(line, sizeof line, file))
        if (strncmp(line, name, strlen(name)) == 0)
            number = strtol(line + strlen(name), NULL, 10);
    if (file)
        (void)fclose(file);
    return number;
}

/* Returns the guardian of process `of`, or 0 if there is none but `but`. */
static pid_t find_guardian(pid_t of, pid_t but)
{
    DIR *processes = opendir("/proc");
    struct dirent *entry;
    char path[64], name[32];
    pid_t found = 0;

    while (found == 0 && processes && (entry = readdir(processes)) != NULL) {
        long pid = strtol(entry->d_name, NULL, 10);
        (void)snprintf(path, sizeof path, "/proc/%ld/status", pid);
        (void)snprintf(name, sizeof name, "Name:\tconsole-guard");
        if (pid > 0 && pid != but && number_in(path, "PPid:\t") == of && number_in(path, name) == 0)
            found = (pid_t)pid;
    }
    if (processes)
        (void)closedir(processes);
    return found;
}

/* True when a thread of this process is traced. */
static bool is_traced(void)
{
    DIR *threads = opendir("/proc/self/task");
    struct dirent *entry;
    char path[320];
    bool found = false;

    while (!found && threads && (entry = readdir(threads)) != NULL) {
        (void)snprintf(path, sizeof path, "/proc/self/task/%s/status", entry->d_name);
        found = number_in(path, "TracerPid:\t") > 0;
    }
    if (threads)
        (void)closedir(threads);
    return found;
}

/* The terminal is cooked before a parent is notified of the death. */
TEST(cooked_before_the_parent_knows)
{
    int status = 0;

    for (int i = 0; i < 20; i++) {
        if (!open_terminal())
            return;
        pid_t child = fork();
        if (child == 0) {
            keep_and_make_raw();
            _exit(is_traced() ? raise(SIGKILL) : 1);
        }
        (void)waitpid(child, &status, 0);
        if (WIFEXITED(status))
            SKIP("tracing is forbidden here");
        else
            CHECK_MSG(!is_raw(), "raw in try %d", i);
        close_terminal();
        if (WIFEXITED(status))
            return;
    }
}

enum { STOPS = 4, MESSAGES = 5 };

/* Stops the process with a raw terminal, and makes it raw again after the stop; then the process dies. The guardian has
 * messages to read when the next stop comes. */
static void stop_and_die(void)
{
    keep_and_make_raw();
    if (!is_traced())
        _exit(1);
    for (int i = 0; i < STOPS; i++) {
        (void)raise(SIGSTOP);
        unsigned put_back;
        do { /* as tty.c does whenever it polls for keys */
            put_back = guardian_put_back();
            for (int j = 0; j < MESSAGES; j++)
                guardian_keep_again(terminal);
            guardian_sync();
            make_raw();
        } while (put_back != guardian_put_back());
    }
    (void)raise(SIGKILL);
    _exit(2);
}

/* True if the child has stopped; fails with a message if it cannot stop. */
static bool has_stopped(pid_t child)
{
    int status = 0;

    (void)waitpid(child, &status, WUNTRACED);
    if (WIFEXITED(status))
        SKIP("tracing is forbidden here");
    return WIFSTOPPED(status);
}

static pid_t stopped_child(void)
{
    if (!open_terminal())
        return 0;
    pid_t child = fork();
    if (child == 0)
        stop_and_die();
    if (has_stopped(child))
        return child;
    close_terminal();
    return 0;
}

/* The terminal is cooked before a parent is notified of a stop, and guarded again when the process continues. */
TEST(cooked_before_the_parent_knows_of_a_stop)
{
    for (int i = 0; i < 20; i++) {
        pid_t child = stopped_child();
        if (child == 0)
            return;
        int stops = 0;
        do {
            CHECK_MSG(!is_raw(), "raw after stop %d in try %d", stops, i);
            stops++;
            (void)kill(child, SIGCONT);
        } while (has_stopped(child));
        CHECK_MSG(!is_raw(), "raw after the death in try %d", i);
        CHECK_EQ(stops, STOPS);
        close_terminal();
    }
}

/* The terminal's state after a stop is the shell's: the death of the stopped process does not change it. */
TEST(put_back_once)
{
    pid_t child = stopped_child();

    if (child == 0)
        return;
    make_raw();
    (void)kill(child, SIGKILL);
    (void)waitpid(child, NULL, 0);
    CHECK(is_raw());
    close_terminal();
}

/* Threads stop on their own, with SIGCONT between and after the stops: the process continues, and is guarded. */
TEST(stopped_and_continued_at_once)
{
    for (int i = 0; i < 50; i++) {
        pid_t child = stopped_child();
        if (child == 0)
            return;
        for (int j = 0; j < i; j++) {
            (void)kill(child, SIGCONT);
            (void)kill(child, SIGSTOP);
        }
        do
            (void)kill(child, SIGCONT);
        while (has_stopped(child));
        CHECK_MSG(cooked_again(), "raw after %d stops", i);
        close_terminal();
    }
}

static pid_t await_guardian(pid_t of, pid_t but)
{
    pid_t found = 0;

    for (int i = 0; i < 1000 && found == 0; i++) {
        (void)poll(NULL, 0, 10);
        found = find_guardian(of, but);
    }
    return found;
}

static void keep_and_lose_three_guardians(void)
{
    pid_t guardian = 0;

    keep_and_make_raw();
    for (int i = 0; i < 3; i++) {
        guardian = await_guardian(getpid(), guardian);
        if (guardian == 0)
            _exit(1);
        (void)kill(guardian, SIGKILL);
    }
    if (await_guardian(getpid(), guardian) == 0)
        _exit(1);
}

TEST(another_guardian_stands_in)
{
    int status = 0;

    if (!open_terminal())
        return;
    pid_t child = fork();
    if (child == 0) {
        keep_and_lose_three_guardians();
        (void)raise(SIGKILL);
    }
    (void)waitpid(child, &status, 0);
    CHECK_MSG(WIFSIGNALED(status), "no guardian after a guardian's death");
    CHECK(cooked_again());
    close_terminal();
}

/* Returns the first child of a process, or 0. */
static pid_t child_of(pid_t pid)
{
    char path[64];
    int child = 0;

    (void)snprintf(path, sizeof path, "/proc/%d/task/%d/children", (int)pid, (int)pid);
    FILE *file = fopen(path, "re");
    if (file && fscanf(file, "%d", &child) != 1)
        child = 0;
    if (file)
        (void)fclose(file);
    return child;
}

/* Process and guardian are killed in either order, so fast that neither can act in between. */
TEST(both_killed_at_once)
{
    for (int i = 0; i < 10; i++) {
        int ready[2];
        char byte = 0;
        if (!open_terminal() || pipe(ready) != 0)
            return;
        pid_t child = fork();
        if (child == 0) {
            keep_and_make_raw();
            (void)!write(ready[1], &byte, 1);
            (void)pause();
        }
        CHECK_EQ(read(ready[0], &byte, 1), 1);
        pid_t guardian = child_of(child);
        CHECK(guardian > 0 && child_of(guardian) > 0);
        (void)kill(i % 2 ? child : guardian, SIGKILL);
        (void)kill(i % 2 ? guardian : child, SIGKILL);
        (void)waitpid(child, NULL, 0);
        CHECK_MSG(cooked_again(), "still raw in try %d", i);
        (void)close(ready[0]);
        (void)close(ready[1]);
        close_terminal();
    }
}

/* The time at which the process dies in fork(), which is replaced below: before the child exists, or after. */
static enum { LIVES, DIES_BEFORE, DIES_AFTER } at_fork;

pid_t fork(void)
{
    if (at_fork == DIES_BEFORE)
        (void)kill(getpid(), SIGKILL);
    pid_t child = _Fork();
    if (at_fork == DIES_AFTER && child > 0)
        (void)kill(getpid(), SIGKILL);
    return child;
}

/* The process is killed while it makes the next guardian: the spare one restores the terminal all the same. */
TEST(killed_after_its_guardian)
{
    for (int i = 0; i < 10; i++) {
        if (!open_terminal())
            return;
        pid_t child = fork();
        if (child == 0) {
            keep_and_make_raw();
            at_fork = i % 2 ? DIES_BEFORE : DIES_AFTER;
            (void)kill(child_of(getpid()), SIGKILL);
            (void)pause();
        }
        (void)waitpid(child, NULL, 0);
        CHECK_MSG(cooked_again(), "still raw in try %d", i);
        close_terminal();
    }
}

/* Writes this process's own oom_score_adj: a higher one is always allowed, a lower one not for every user. */
static bool set_score(const char *value)
{
    int fd = open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC);
    bool done = fd >= 0 && write(fd, value, strlen(value)) > 0;

    (void)close(fd);
    return done;
}

static int score_of(pid_t pid)
{
    char path[64];
    int value = 9999;

    (void)snprintf(path, sizeof path, "/proc/%d/oom_score_adj", (int)pid);
    FILE *file = fopen(path, "re");
    if (file && fscanf(file, "%d", &value) != 1)
        value = 9999;
    if (file)
        (void)fclose(file);
    return value;
}

TEST(is_no_choice_when_memory_is_short)
{
    int lowest = set_score("-1000") ? -1000 : 0, before_it = score_of(getpid());
    char back[16];

    if (!set_score("500")) {
        SKIP("this kernel has no scores");
        return;
    }
    if (!open_terminal())
        return;
    CHECK_EQ(keep_terminal(terminal), 0);
    CHECK_EQ(score_of(await_guardian(getpid(), 0)), lowest);
    guardian_forget_terminal(terminal);
    close_terminal();
    (void)snprintf(back, sizeof back, "%d", before_it);
    (void)set_score(back);
}

/* A stopped guardian does not delay the end. */
TEST(ends_with_a_stopped_guardian)
{
    if (!open_terminal())
        return;
    CHECK_EQ(keep_terminal(terminal), 0);
    (void)kill(await_guardian(getpid(), 0), SIGSTOP);
    guardian_forget_terminal(terminal);
    CHECK_EQ(find_guardian(getpid(), 0), 0);
    close_terminal();
}

int main(void)
{
    RUN(cooked_before_the_parent_knows);
    RUN(cooked_before_the_parent_knows_of_a_stop);
    RUN(put_back_once);
    RUN(stopped_and_continued_at_once);
    RUN(another_guardian_stands_in);
    RUN(both_killed_at_once);
    RUN(killed_after_its_guardian);
    RUN(is_no_choice_when_memory_is_short);
    RUN(ends_with_a_stopped_guardian);
    return check_status();
}
