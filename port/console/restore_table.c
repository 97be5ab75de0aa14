#include "console/restore_table.h"

#include <errno.h>
#include <semaphore.h>
#include <stdatomic.h>
#include <string.h>
#include <sys/mman.h>

struct saved kept[KEPT_MOST];
static struct {
    atomic_uint put_back, guardian, finished;
    sem_t answered;
} * shared;

static bool is_same(const struct saved *a, const struct saved *b)
{
    if (a->kind != b->kind || strcmp(a->path, b->path) != 0)
        return false;
    return a->kind != TEXT || strcmp(a->was.text, b->was.text) == 0;
}

struct saved *kept_find(const struct saved *like)
{
    for (int i = 0; i < KEPT_MOST; i++)
        if (kept[i].kind != NOTHING && is_same(&kept[i], like))
            return &kept[i];
    return NULL;
}

bool kept_any(enum kind kind)
{
    for (int i = 0; i < KEPT_MOST; i++)
        if (kept[i].kind == kind)
            return true;
    return false;
}

bool kept_nothing(void)
{
    for (int i = 0; i < KEPT_MOST; i++)
        if (kept[i].kind != NOTHING)
            return false;
    return true;
}

void kept_share(void)
{
    void *page = shared ? NULL : mmap(NULL, sizeof *shared, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);

    if (!page || page == MAP_FAILED)
        return;
    shared = page;
    (void)sem_init(&shared->answered, 1, 0);
}

void kept_count_put_back(void)
{
    if (shared)
        (void)atomic_fetch_add(&shared->put_back, 1);
}

unsigned kept_put_back(void)
{
    return shared ? atomic_load(&shared->put_back) : 0;
}

unsigned kept_guardian(void)
{
    return shared ? atomic_load(&shared->guardian) : 0;
}

bool kept_take_over(unsigned before)
{
    return !shared || atomic_compare_exchange_strong(&shared->guardian, &before, before + 1);
}

void kept_finish(void)
{
    if (shared)
        atomic_store(&shared->finished, atomic_load(&shared->guardian));
}

bool kept_is_finished(unsigned guardian)
{
    return !shared || atomic_load(&shared->finished) == guardian;
}

void kept_answer(void)
{
    if (shared)
        (void)sem_post(&shared->answered);
}

void kept_forget_answers(void)
{
    while (shared && sem_trywait(&shared->answered) == 0)
        ;
}

void kept_await_answer(int timeout_ms)
{
    struct timespec end;

    (void)clock_gettime(CLOCK_REALTIME, &end);
    end.tv_nsec += timeout_ms * 1000000L;
    end.tv_sec += end.tv_nsec / 1000000000;
    end.tv_nsec %= 1000000000;
    while (shared && sem_timedwait(&shared->answered, &end) != 0 && errno == EINTR)
        ;
}

static struct saved *free_place(void)
{
    for (int i = 0; i < KEPT_MOST; i++)
        if (kept[i].kind == NOTHING)
            return &kept[i];
    return NULL;
}

int kept_note(const struct saved *message)
{
    struct saved *place = kept_find(message);

    if (!place && !message->forget)
        place = free_place();
    if (!place)
        return -1;
    *place = *message;
    if (message->forget)
        place->kind = NOTHING;
    return 0;
}
