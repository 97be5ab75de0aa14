#include "thread_pool.h"

#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdlib.h>

#include "clock.h"

/* Size of a thread's stack: enough for the core, whose stack depth is bounded, and for compressing a file. The default
 * of 8 MB could exceed a limit on the address space. ThreadSanitizer keeps its data about a thread on the thread's
 * stack as well. */
#ifdef __SANITIZE_THREAD__
#define STACK_BYTES (4096u * 1024u)
#else
#define STACK_BYTES (512u * 1024u)
#endif

/* Time that a thread spins while it waits for the next round, or for the end of the current one, before it sleeps:
 * waking a thread takes about 50 microseconds, a tenth of a frame of 1920x1080. After spinning in vain, a thread sleeps
 * at once the next SLEEP_TIMES times. So hardly any CPU time is wasted if frames come at a display's pace, or if
 * threads share a processor. */
#define SPIN_US 100u
#define SLEEP_TIMES 8u

/* A pool. `round` and `busy` change without the lock. A thread that must be woken is counted in `asleep`, or sets
 * `waits`, before it checks its condition for the last time; the thread that changes the condition reads `asleep` or
 * `waits` afterwards. All of these accesses are in one total order, so at least one of the two threads reads the value
 * that the other has written. */
struct threads {
    pthread_mutex_t lock; /* protects waiting for `begin` and `end` */
    pthread_cond_t begin, end;
    pthread_mutex_t door; /* lock for enter and leave */
    unsigned started;     /* number of threads besides the caller */
    bool spins;           /* each thread has a processor */
    atomic_uint round;    /* counts the calls of threads_run that need other threads, and that of threads_destroy */
    atomic_uint busy;     /* number of threads that may still run jobs of this round */
    atomic_uint asleep;   /* number of threads that wait for `begin` */
    atomic_bool waits;    /* the caller waits for `end` */
    atomic_bool quit;
    void (*job)(void *arg, unsigned index);
    void *arg;
    unsigned count;
    unsigned sleeps;  /* the caller's argument `sleeps` of spin */
    atomic_uint next; /* the next job to run */
    struct tia_workers workers;
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

/* Runs jobs until none is left. `next` can exceed `count` by one per thread; it cannot wrap, since there are at most
 * TIA_SIZE_MAX^2 = 2^26 jobs. */
static void run_jobs(struct threads *pool)
{
    for (;;) {
        unsigned index = atomic_fetch_add(&pool->next, 1u);
        if (index >= pool->count)
            return;
        pool->job(pool->arg, index);
    }
}

static bool has_begun(struct threads *pool, unsigned seen)
{
    return atomic_load(&pool->round) != seen;
}

static bool has_ended(struct threads *pool, unsigned seen)
{
    (void)seen;
    return atomic_load(&pool->busy) == 0;
}

/* Lets the core's other hardware thread run, and saves power. */
static void pause_briefly(void)
{
#if defined __x86_64__ || defined __i386__
    __builtin_ia32_pause();
#elif defined __aarch64__
    __asm__ volatile("yield");
#endif
}

/* Spins for at most SPIN_US; returns true if `done` became true. `*sleeps`, one for each thread, is the number of times
 * that the thread will sleep without spinning. */
static bool spin(struct threads *pool, bool (*done)(struct threads *pool, unsigned seen), unsigned seen,
                 unsigned *sleeps)
{
    if (!pool->spins || *sleeps > 0) {
        *sleeps -= *sleeps > 0;
        return false;
    }
    uint64_t until = clock_now_us() + SPIN_US;
    for (unsigned i = 1; !done(pool, seen); i++) {
        pause_briefly();
        if (i % 16 == 0 && clock_now_us() > until) {
            *sleeps = SLEEP_TIMES;
            return false;
        }
    }
    return true;
}

static void wait_to_begin(struct threads *pool, unsigned seen, unsigned *sleeps)
{
    if (spin(pool, has_begun, seen, sleeps))
        return;
    (void)pthread_mutex_lock(&pool->lock);
    atomic_fetch_add(&pool->asleep, 1u);
    while (!has_begun(pool, seen))
        (void)pthread_cond_wait(&pool->begin, &pool->lock);
    atomic_fetch_sub(&pool->asleep, 1u);
    (void)pthread_mutex_unlock(&pool->lock);
}

static void wait_to_end(struct threads *pool)
{
    if (spin(pool, has_ended, 0, &pool->sleeps))
        return;
    (void)pthread_mutex_lock(&pool->lock);
    atomic_store(&pool->waits, true);
    while (!has_ended(pool, 0))
        (void)pthread_cond_wait(&pool->end, &pool->lock);
    atomic_store(&pool->waits, false);
    (void)pthread_mutex_unlock(&pool->lock);
}

static void begin_round(struct threads *pool)
{
    atomic_fetch_add(&pool->round, 1u);
    if (atomic_load(&pool->asleep) == 0)
        return;
    (void)pthread_mutex_lock(&pool->lock);
    (void)pthread_cond_broadcast(&pool->begin);
    (void)pthread_mutex_unlock(&pool->lock);
}

static void leave_round(struct threads *pool)
{
    if (atomic_fetch_sub(&pool->busy, 1u) != 1 || !atomic_load(&pool->waits))
        return;
    (void)pthread_mutex_lock(&pool->lock);
    (void)pthread_cond_signal(&pool->end);
    (void)pthread_mutex_unlock(&pool->lock);
}

static void *work(void *arg)
{
    struct threads *pool = arg;
    unsigned sleeps = 0;
    for (unsigned seen = 0;; seen++) {
        wait_to_begin(pool, seen, &sleeps);
        if (atomic_load(&pool->quit))
            return NULL;
        run_jobs(pool);
        leave_round(pool);
    }
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

/* Starts threads; blocks signals first, since new threads inherit the signal mask. */
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

unsigned threads_count(const struct threads *pool)
{
    return pool->started + 1;
}

void threads_run(struct threads *pool, void (*job)(void *arg, unsigned index), void *arg, unsigned count)
{
    bool alone = pool->started == 0 || count <= 1;
    pool->job = job;
    pool->arg = arg;
    pool->count = count;
    atomic_store(&pool->next, 0u);
    if (!alone) {
        atomic_store(&pool->busy, pool->started);
        begin_round(pool);
    }
    run_jobs(pool);
    if (!alone)
        wait_to_end(pool);
}

static void run(void *ctx, void (*job)(void *arg, unsigned index), void *arg, unsigned count)
{
    threads_run(ctx, job, arg, count);
}

static bool enter(void *ctx)
{
    return pthread_mutex_trylock(&((struct threads *)ctx)->door) == 0;
}

static void leave(void *ctx)
{
    (void)pthread_mutex_unlock(&((struct threads *)ctx)->door);
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
    pool->spins = others < threads_processors();
    start(pool, others);
    pool->workers = (struct tia_workers){run, enter, leave, pool, threads_count(pool)};
    return pool;
}

const struct tia_workers *threads_workers(const struct threads *pool)
{
    return pool ? &pool->workers : NULL;
}

void threads_destroy(struct threads *pool)
{
    if (!pool)
        return;
    atomic_store(&pool->quit, true);
    begin_round(pool);
    for (unsigned i = 0; i < pool->started; i++)
        (void)pthread_join(pool->thread[i], NULL);
    (void)pthread_cond_destroy(&pool->begin);
    (void)pthread_cond_destroy(&pool->end);
    (void)pthread_mutex_destroy(&pool->lock);
    (void)pthread_mutex_destroy(&pool->door);
    free(pool);
}
