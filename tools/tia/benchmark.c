#include "benchmark.h"

#include <string.h>

#include "common/benchmark/run.h"
#include "fail.h"

enum { MINUTE_US = 60000000 };

/* Returns the name of the first given option that the benchmark has not; NULL: none. */
static const char *foreign_option(const struct options *options)
{
    static const char *const own[] = {"benchmark", "frames", "threads"};
    static char name[32];

    for (size_t at = 0; at < options->given_bytes; at += strlen(options->given + at) + 1) {
        const char *given = options->given + at;
        size_t length = strcspn(given, "="), i = 0;
        while (i < sizeof own / sizeof *own && (strlen(own[i]) != length || strncmp(own[i], given, length) != 0))
            i++;
        if (i < sizeof own / sizeof *own)
            continue;
        (void)snprintf(name, sizeof name, "%.*s", (int)length, given);
        return name;
    }
    return NULL;
}

int benchmark_options(const struct options *options)
{
    if (!options->benchmark)
        return EXIT_FINE;
    if (options->given_bytes == SIZE_MAX)
        return fail(EXIT_RUNNING, "memory: exhausted");
    const char *foreign = foreign_option(options);
    if (foreign)
        return fail(EXIT_USAGE, "--%s: not with --benchmark", foreign);
    if (options->scene_path)
        return fail(EXIT_USAGE, "%.200s: not with --benchmark, which has scenes of its own", options->scene_path);
    return EXIT_FINE;
}

int benchmark(const struct options *options)
{
    const struct benchmark_wish wish = {benchmark_frames, options->simd, options->threads,
                                        options->frames,  MINUTE_US,     stdout};
    char why[BENCHMARK_WHY];

    switch (benchmark_run(&wish, why)) {
    case BENCHMARK_FINE:
        return EXIT_FINE;
    case BENCHMARK_WRONG:
        return fail(EXIT_RUNNING, "--benchmark: frames are wrong: no total");
    case BENCHMARK_NO_OUTPUT:
        return fail_output();
    default:
        return fail(EXIT_RUNNING, "--benchmark: %s", why);
    }
}
