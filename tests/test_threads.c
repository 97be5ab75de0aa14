/* The thread pool: every job runs once, on the threads of the pool, with signals blocked, and the threads end. */
#include "common/thread_pool.h"

#include <dirent.h>
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stdatomic.h>
#include <time.h>

#include "check.h"

enum { JOBS = 1000, ROUNDS = 300 };

static atomic_uint done[JOBS];

static void count_job(void *arg, unsigned index)
{
    (void)arg;
    atomic_fetch_add(&done[index], 1u);
}

/* Returns the number of this process's threads, from the kernel. */
static int tasks(void)
{
    int count = 0;
    DIR *directory = opendir("/proc/self/task");
    for (struct dirent *entry; directory && (entry = readdir(directory)) != NULL;)
        count += entry->d_name[0] != '.';
    if (directory)
        (void)closedir(directory);
    return count;
}

static void every_job_once_on(unsigned threads)
{
    struct threads *pool = threads_create(threads);
    CHECK(pool);
    for (unsigned i = 0; i < JOBS; i++)
        atomic_store(&done[i], 0u);
    unsigned expected[JOBS] = {0};
    for (unsigned round = 0; round < ROUNDS; round++) {
        unsigned count = round % 7 == 0 ? round % 3 : round * 3;
        threads_run(pool, count_job, NULL, count);
        for (unsigned i = 0; i < count; i++)
            expected[i]++;
        CHECK_EQ(atomic_load(&done[count > 0 ? count - 1 : 0]), expected[count > 0 ? count - 1 : 0]);
    }
    for (unsigned i = 0; i < JOBS; i++)
        CHECK_EQ(atomic_load(&done[i]), expected[i]);
    threads_destroy(pool);
}

TEST(every_job_runs_once_on_1_thread)
{
    every_job_once_on(1);
}
TEST(every_job_runs_once_on_2_threads)
{
    every_job_once_on(2);
}
TEST(every_job_runs_once_on_7_threads)
{
    every_job_once_on(7);
}

static void sleep_us(long us)
{
    (void)nanosleep(&(struct timespec){0, us * 1000}, NULL);
}

static void slow_job(void *arg, unsigned index)
{
    (void)arg;
    sleep_us(index * 40);
    atomic_fetch_add(&done[index], 1u);
}

/* A round can begin while threads still spin or when all sleep, and the pool can end in either state. */
TEST(every_job_runs_once_after_pauses)
{
    struct threads *pool = threads_create(2);
    for (unsigned i = 0; i < 4; i++)
        atomic_store(&done[i], 0u);
    for (unsigned round = 1; round <= 200; round++) {
        threads_run(pool, round % 3 == 0 ? slow_job : count_job, NULL, 4);
        for (unsigned i = 0; i < 4; i++)
            CHECK_EQ(atomic_load(&done[i]), round);
        sleep_us(round % 5 * 60);
    }
    threads_destroy(pool);
}

static long cpu_us(void)
{
    struct timespec t;
    (void)clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (long)t.tv_sec * 1000000 + t.tv_nsec / 1000;
}

/* Threads use little processor time while idle between two frames of a display at 60 Hz. */
TEST(idle_threads_take_no_processor)
{
    struct threads *pool = threads_create(2);
    long start = cpu_us();
    for (unsigned round = 0; round < 12; round++) {
        threads_run(pool, count_job, NULL, 4);
        sleep_us(16000);
    }
    CHECK(cpu_us() - start < 12 * 16000 / 20);
    threads_destroy(pool);
}

TEST(one_thread_is_the_caller)
{
    int before = tasks();
    struct threads *pool = threads_create(1);
    CHECK_EQ(tasks(), before);
    CHECK_EQ(threads_count(pool), 1);
    threads_destroy(pool);
    pool = threads_create(0);
    CHECK_EQ(threads_count(pool), 1);
    threads_destroy(pool);
}

TEST(threads_come_and_go)
{
    int before = tasks();
    for (unsigned i = 0; i < 20; i++) {
        struct threads *pool = threads_create(5);
        CHECK_EQ(threads_count(pool), 5);
        CHECK_EQ(tasks(), before + 4);
        threads_destroy(pool);
        /* the kernel removes a joined thread's entry a moment after it has ended */
        for (unsigned wait = 0; wait < 100000 && tasks() != before; wait++)
            (void)sched_yield();
        CHECK_EQ(tasks(), before);
    }
    threads_destroy(NULL);
}

TEST(the_number_of_threads_is_limited)
{
    struct threads *pool = threads_create(1000000);
    CHECK(pool && threads_count(pool) >= 1 && threads_count(pool) <= THREADS_MAX);
    threads_destroy(pool);
}

static pthread_t caller;
static atomic_uint others, open_to_signals;
static pthread_barrier_t meeting;

/* Counts the threads other than the caller, and their unblocked signals. Waits until all threads have arrived, so that
 * each runs exactly one job. */
static void look_at_mask(void *arg, unsigned index)
{
    (void)arg, (void)index;
    sigset_t mask;
    (void)pthread_sigmask(SIG_BLOCK, NULL, &mask);
    static const int asked[] = {SIGINT, SIGTERM, SIGHUP, SIGWINCH, SIGUSR1, SIGUSR2, SIGCHLD, SIGALRM};
    for (size_t i = 0; i < sizeof asked / sizeof asked[0]; i++)
        if (!pthread_equal(pthread_self(), caller) && sigismember(&mask, asked[i]) == 0)
            atomic_fetch_add(&open_to_signals, 1u);
    if (!pthread_equal(pthread_self(), caller))
        atomic_fetch_add(&others, 1u);
    (void)pthread_barrier_wait(&meeting);
}

TEST(jobs_run_at_once_and_take_no_signals)
{
    sigset_t before, after;
    (void)pthread_sigmask(SIG_BLOCK, NULL, &before);
    struct threads *pool = threads_create(4);
    (void)pthread_sigmask(SIG_BLOCK, NULL, &after);
    CHECK(sigismember(&after, SIGINT) == sigismember(&before, SIGINT));
    if (threads_count(pool) != 4) {
        SKIP("no more threads to be had here");
        threads_destroy(pool);
        return;
    }
    caller = pthread_self();
    (void)pthread_barrier_init(&meeting, NULL, 4);
    threads_run(pool, look_at_mask, NULL, 4);
    (void)pthread_barrier_destroy(&meeting);
    CHECK_EQ(atomic_load(&others), 3);
    CHECK_EQ(atomic_load(&open_to_signals), 0);
    threads_destroy(pool);
}

TEST(the_affinity_mask_counts)
{
    cpu_set_t before, one;
    CHECK(sched_getaffinity(0, sizeof before, &before) == 0);
    CHECK_EQ(threads_processors(), CPU_COUNT(&before));
    size_t cpu = 0;
    while (!CPU_ISSET(cpu, &before))
        cpu++;
    CPU_ZERO(&one);
    CPU_SET(cpu, &one);
    CHECK(sched_setaffinity(0, sizeof one, &one) == 0);
    CHECK_EQ(threads_processors(), 1);
    (void)sched_setaffinity(0, sizeof before, &before);
}

int main(void)
{
    RUN(every_job_runs_once_on_1_thread);
    RUN(every_job_runs_once_on_2_threads);
    RUN(every_job_runs_once_on_7_threads);
    RUN(every_job_runs_once_after_pauses);
    RUN(idle_threads_take_no_processor);
    RUN(one_thread_is_the_caller);
    RUN(threads_come_and_go);
    RUN(the_number_of_threads_is_limited);
    RUN(jobs_run_at_once_and_take_no_signals);
    RUN(the_affinity_mask_counts);
    return check_status();
}
