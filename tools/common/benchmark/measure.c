#include "measure.h"

#include <time.h>

#include "clock.h"

/* Returns the CPU time of this process in nanoseconds. */
static uint64_t cpu_ns(void)
{
    struct timespec t;

    (void)clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (uint64_t)t.tv_sec * 1000000000u + (uint64_t)t.tv_nsec;
}

static uint64_t now_ns(const struct threads *pool)
{
    return threads_count(pool) == 1 ? cpu_ns() : 1000 * clock_now_us();
}

/* Returns `frames` per 1000 seconds. */
static uint32_t rate_of(uint64_t frames, uint64_t ns)
{
    uint64_t us = ns / 1000 ? ns / 1000 : 1, rate = frames * 1000000000u / us;

    return rate > UINT32_MAX ? UINT32_MAX : rate ? (uint32_t)rate : 1;
}

/* Draws a frame; *ns increases by its time. */
static int draw(struct benchmark_stage *stage, const struct tia_simd *simd, struct threads *pool, uint64_t *ns,
                uint32_t *crc)
{
    uint64_t begun = now_ns(pool);
    int status = benchmark_draw(stage, simd, pool);

    *ns += now_ns(pool) - begun;
    *crc = status ? 0 : benchmark_check_pixels(stage, pool);
    return status;
}

int benchmark_measure(struct benchmark_stage *stage, const struct tia_simd *simd, struct threads *pool,
                      const struct benchmark_limit *limit, struct benchmark_score *score)
{
    uint64_t end = clock_now_us() + limit->us, ns = 0;
    uint32_t frames = 0;
    int status = draw(stage, simd, pool, &ns, &score->crc); /* allocates memory, and fills the caches */

    score->rate = 0;
    for (ns = 0; !status && score->crc == stage->frame->crc; frames++) {
        if (frames > 0 && (limit->frames ? frames >= limit->frames : clock_now_us() >= end))
            break;
        status = draw(stage, simd, pool, &ns, &score->crc);
    }
    if (!status && score->crc == stage->frame->crc)
        score->rate = rate_of(frames, ns);
    return status;
}
