#include "spare.h"

#include <errno.h>
#include <poll.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "restore_table.h"

/* Time limit, after the first guardian's death, for the guarded process to die. */
#define PATIENCE_MS 1000

static struct saved *table; /* copy of the table, in memory that both guardians share */

static void await_end(int first)
{
    char nothing;

    while (read(first, &nothing, 1) < 0 && errno == EINTR)
        ;
}

/* Copies the table, without the descriptors, which were closed with the first guardian. */
static void take_table(void)
{
    (void)memcpy(kept, table, sizeof kept);
    for (int i = 0; i < KEPT_MOST; i++)
        kept[i].fd = -1;
}

static _Noreturn void stand_by(unsigned guardian, int first, int process, void (*put_back)(void))
{
    struct pollfd end = {.fd = process, .events = POLLIN};

    (void)setpgid(0, 0);
    await_end(first);
    if (!kept_is_finished(guardian) && poll(&end, 1, PATIENCE_MS) > 0 && kept_take_over(guardian)) {
        take_table();
        put_back();
    }
    _exit(0);
}

/* The spare closes standard input, the guardian's end of the socket: when the first guardian dies, the guarded process
 * must see end-of-file. */
void spare_start(int process, void (*put_back)(void))
{
    void *page = mmap(NULL, sizeof kept, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    int ends[2];

    if (process < 0 || page == MAP_FAILED || pipe(ends) != 0)
        return;
    table = page;
    unsigned guardian = kept_guardian();
    spare_follow();
    if (fork() == 0) {
        (void)close(STDIN_FILENO);
        (void)close(ends[1]);
        stand_by(guardian, ends[0], process, put_back);
    }
    (void)close(ends[0]);
}

void spare_follow(void)
{
    if (table)
        (void)memcpy(table, kept, sizeof kept);
}
