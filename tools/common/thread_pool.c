#include "thread_pool.h"

#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdlib.h>

/* Enough for the core, whose stack depth is bounded, and for compressing a file. The default of 8 MB could exceed a
 * limit on the address space. */
#define STACK_BYTES (512u * 1024u)

struct threads {
    pthread_mutex_t lock;
    pthread_cond_t begin, end;
    pthread_mutex_t door; /* for enter and leave */
    unsigned started;     /* threads besides the caller */
    unsigned busy;        /* those of them that may still run jobs of this round */
    unsigned round;       /* counts the calls of run */
    bool quit;
    void (*job)(void *arg, unsigned index);
    void *arg;
    unsigned count;
    atomic_uint next; /* the next job to run */
    pthread_t thread[];
};

unsigned threads_processors(void)
{
    cpu_set_t set;
    if (sched_getaffinity(0, sizeof set, &set) != 0)
        return 1;
    unsigned count = (unsigned)CPU_COUNT(&set);
    return count < 1 ? 1 : count > THREADS_MAX ? THREADS_MAX : count;
}

/* `next` can exceed `count` by one per thread. It cannot wrap, since there are at most TIA_SIZE_MAX^2 = 2^26 jobs. */
static void run_jobs(struct threads *pool)
{
    for (;;) {
        unsigned index = atomic_fetch_add(&pool->next, 1u);
        if (index >= pool->count)
            return;
        pool->job(pool->arg, index);
    }
}

static void *work(void *arg)
{
    struct threads *pool = arg;
    unsigned seen = 0;
    (void)pthread_mutex_lock(&pool->lock);
    for (;;) {
        while (pool->round == seen && !pool->quit)
            (void)pthread_cond_wait(&pool->begin, &pool->lock);
        if (pool->quit)
            break;
        seen = pool->round;
        (void)pthread_mutex_unlock(&pool->lock);
        run_jobs(pool);
        (void)pthread_mutex_lock(&pool->lock);
        if (--pool->busy == 0)
            (void)pthread_cond_signal(&pool->end);
    }
    (void)pthread_mutex_unlock(&pool->lock);
    return NULL;
}

/* Blocks all signals, so that none interrupts a job, except those for faults in the job itself. */
static void block_signals(sigset_t *before)
{
    static const int faults[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
    sigset_t all;
    (void)sigfillset(&all);
    for (size_t i = 0; i < sizeof faults / sizeof faults[0]; i++)
        (void)sigdelset(&all, faults[i]);
    (void)pthread_sigmask(SIG_SETMASK, &all, before);
}

/* Blocks signals first, since new threads inherit the signal mask. */
static void start(struct threads *pool, unsigned count)
{
    sigset_t before;
    pthread_attr_t attributes;
    if (count == 0 || pthread_attr_init(&attributes) != 0)
        return;
    (void)pthread_attr_setstacksize(&attributes, STACK_BYTES);
    block_signals(&before);
    while (pool->started < count && pthread_create(&pool->thread[pool->started], &attributes, work, pool) == 0)
        pool->started++;
    (void)pthread_sigmask(SIG_SETMASK, &before, NULL);
    (void)pthread_attr_destroy(&attributes);
}

struct threads *threads_create(unsigned count)
{
    unsigned others = count > THREADS_MAX ? THREADS_MAX - 1 : count > 0 ? count - 1 : 0;
    struct threads *pool = calloc(1, sizeof *pool + others * sizeof pool->thread[0]);
    if (!pool)
        return NULL;
    (void)pthread_mutex_init(&pool->lock, NULL);
    (void)pthread_cond_init(&pool->begin, NULL);
    (void)pthread_cond_init(&pool->end, NULL);
    (void)pthread_mutex_init(&pool->door, NULL);
    start(pool, others);
    return pool;
}

unsigned threads_count(const struct threads *pool)
{
    return pool->started + 1;
}

static void run(void *ctx, void (*job)(void *arg, unsigned index), void *arg, unsigned count)
{
    struct threads *pool = ctx;
    (void)pthread_mutex_lock(&pool->lock);
    pool->job = job;
    pool->arg = arg;
    pool->count = count;
    atomic_store(&pool->next, 0u);
    if (pool->started > 0 && count > 1) {
        pool->busy = pool->started;
        pool->round++;
        (void)pthread_cond_broadcast(&pool->begin);
    }
    (void)pthread_mutex_unlock(&pool->lock);
    run_jobs(pool);
    (void)pthread_mutex_lock(&pool->lock);
    while (pool->busy > 0)
        (void)pthread_cond_wait(&pool->end, &pool->lock);
    (void)pthread_mutex_unlock(&pool->lock);
}

static bool enter(void *ctx)
{
    return pthread_mutex_trylock(&((struct threads *)ctx)->door) == 0;
}

static void leave(void *ctx)
{
    (void)pthread_mutex_unlock(&((struct threads *)ctx)->door);
}

const struct tia_workers threads_workers = {run, enter, leave};

void threads_destroy(struct threads *pool)
{
    if (!pool)
        return;
    (void)pthread_mutex_lock(&pool->lock);
    pool->quit = true;
    (void)pthread_cond_broadcast(&pool->begin);
    (void)pthread_mutex_unlock(&pool->lock);
    for (unsigned i = 0; i < pool->started; i++)
        (void)pthread_join(pool->thread[i], NULL);
    (void)pthread_cond_destroy(&pool->begin);
    (void)pthread_cond_destroy(&pool->end);
    (void)pthread_mutex_destroy(&pool->lock);
    (void)pthread_mutex_destroy(&pool->door);
    free(pool);
}
