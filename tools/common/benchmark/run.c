#include "run.h"

#include <string.h>
#include <sys/utsname.h>

#include "common/record/record.h"
#include "cpu.h"

enum { LEVELS = 8, COUNTS = 16 };

struct level {
    const struct tia_simd *simd;
    char name[8];
};

struct run {
    const struct benchmark_wish *wish;
    struct benchmark_stage stages[BENCHMARK_FRAMES];
    struct level levels[LEVELS];
    unsigned counts[COUNTS]; /* numbers of threads */
    unsigned level_count, count_count;
    struct threads *pool;
    struct benchmark_limit limit;
    struct benchmark_line line;
    bool wrong; /* a frame was wrong */
    char *why;
};

/* ---- what is measured ---- */

/* Adds an instruction set. It is called as the frames say that it draws: "scalar" draws no spans, for example. */
static int add_level(struct run *r, const struct tia_simd *simd)
{
    struct level *level = &r->levels[r->level_count];
    const char *name = "plain";
    int status = r->level_count < LEVELS ? TIA_OK : TIA_ERR_MEMORY;

    for (unsigned i = 0; i < BENCHMARK_FRAMES && !status && strcmp(name, "plain") == 0; i++) {
        status = benchmark_prepare(&r->stages[i], simd, 1);
        name = status ? name : tia_view_simd(r->stages[i].view);
    }
    if (status)
        return status;
    level->simd = simd;
    (void)snprintf(level->name, sizeof level->name, "%s", name);
    r->level_count++;
    return TIA_OK;
}

static int add_levels(struct run *r)
{
    const struct tia_simd *widest = r->wish->widest, *simd = NULL;
    int status = add_level(r, NULL);

    for (unsigned i = 0; !status && simd != widest && (simd = tia_simd_at(i)) != NULL; i++)
        status = add_level(r, simd);
    return status;
}

static void add_counts(struct run *r)
{
    for (unsigned count = 1; count < r->wish->threads && r->count_count + 1 < COUNTS; count *= 2)
        r->counts[r->count_count++] = count;
    r->counts[r->count_count++] = r->wish->threads;
}

static void fill_line(struct run *r)
{
    struct benchmark_line *line = &r->line;
    struct utsname system;
    char name[256];

    line->set = BENCHMARK_SET;
    line->definition = RECORD_DEFINITION;
    line->threads = r->wish->threads;
    line->by_frames = r->wish->each > 0;
    line->each = line->by_frames ? r->wish->each : (uint32_t)(r->limit.us / 1000);
    benchmark_set_text(line->version, sizeof line->version, TIA_VERSION);
    benchmark_cpu(name, sizeof name);
    benchmark_set_text(line->cpu, sizeof line->cpu, name);
    benchmark_set_text(line->machine, sizeof line->machine, uname(&system) ? "unknown" : system.machine);
#ifdef __clang__
    benchmark_set_text(line->compiler, sizeof line->compiler, __VERSION__);
#else
    benchmark_set_text(line->compiler, sizeof line->compiler, "gcc " __VERSION__);
#endif
    for (unsigned i = 0; i < BENCHMARK_FRAMES; i++)
        line->crcs[i] = r->wish->frames[i].crc;
}

static int begin(struct run *r)
{
    int status = TIA_OK;

    for (unsigned i = 0; i < BENCHMARK_FRAMES && !status; i++)
        status = benchmark_open(&r->stages[i], &r->wish->frames[i]);
    status = status ? status : add_levels(r);
    if (status)
        return status;
    add_counts(r);
    r->limit.frames = r->wish->each;
    r->limit.us = r->wish->us / (r->level_count * r->count_count * BENCHMARK_FRAMES);
    fill_line(r);
    return TIA_OK;
}

/* ---- the table ---- */

static void print_head(const struct run *r)
{
    const struct benchmark_line *line = &r->line;
    FILE *out = r->wish->out;

    (void)fprintf(out, "tia %s, benchmark %u: frames per second, by CPU time with 1 thread, else by the clock\n",
                  line->version, line->set);
    (void)fprintf(out, "%s, %s, %s, %u thread%s\n", line->cpu, line->machine, line->compiler, line->threads,
                  line->threads == 1 ? "" : "s");
    (void)fprintf(out, "\n%-8s%8s", "level", "threads");
    for (unsigned i = 0; i < BENCHMARK_FRAMES; i++)
        (void)fprintf(out, "%12s", r->wish->frames[i].name);
    (void)fprintf(out, "%12s\n", "total");
    (void)fflush(out);
}

static void print_rate(FILE *out, uint32_t rate, const char *none)
{
    char text[32];

    (void)snprintf(text, sizeof text, "%u.%03u", (unsigned)(rate / 1000), (unsigned)(rate % 1000));
    (void)fprintf(out, "%12s", rate ? text : none);
    (void)fflush(out);
}

/* Names each frame of a row that was wrong. */
static void print_wrong(const struct run *r, const struct benchmark_row *row, const struct benchmark_score *scores)
{
    for (unsigned i = 0; i < BENCHMARK_FRAMES; i++)
        if (!scores[i].rate)
            (void)fprintf(r->wish->out, "%s, %u thread%s, %s: no score: CRC %08x, expected %08x\n", row->level,
                          row->threads, row->threads == 1 ? "" : "s", r->wish->frames[i].name, (unsigned)scores[i].crc,
                          (unsigned)r->wish->frames[i].crc);
}

static int measure_row(struct run *r, const struct level *level)
{
    struct benchmark_row *row = &r->line.rows[r->line.row_count++];
    struct benchmark_score scores[BENCHMARK_FRAMES];
    int status = TIA_OK;

    memcpy(row->level, level->name, sizeof row->level);
    row->threads = threads_count(r->pool);
    (void)fprintf(r->wish->out, "%-8s%8u", row->level, row->threads);
    for (unsigned i = 0; i < BENCHMARK_FRAMES && !status; i++) {
        status = benchmark_measure(&r->stages[i], level->simd, r->pool, &r->limit, &scores[i]);
        row->rates[i] = status ? 0 : scores[i].rate;
        if (!status)
            print_rate(r->wish->out, row->rates[i], "no score");
        r->wrong = r->wrong || !row->rates[i];
    }
    if (status)
        return status;
    print_rate(r->wish->out, benchmark_total(row->rates), "-");
    (void)fputc('\n', r->wish->out);
    print_wrong(r, row, scores);
    return fflush(r->wish->out) || ferror(r->wish->out) ? TIA_ERR_DEVICE : TIA_OK;
}

/* Measures an instruction set with a number of threads. */
static int measure(struct run *r, const struct level *level, unsigned count)
{
    int status = TIA_ERR_MEMORY;

    r->pool = threads_create(count);
    if (r->pool && threads_count(r->pool) == count)
        status = measure_row(r, level);
    else
        (void)snprintf(r->why, BENCHMARK_WHY, "%u threads cannot be started", count);
    threads_destroy(r->pool);
    return status;
}

/* Prints the totals of the widest instruction set, and the line. */
static void print_result(const struct run *r)
{
    const struct benchmark_row *last = &r->line.rows[r->line.row_count - 1];
    static char text[BENCHMARK_LINE]; /* too large for the stack */
    FILE *out = r->wish->out;

    (void)fprintf(out, "\ntotal, %s:", last->level);
    for (unsigned i = 0; i < r->line.row_count; i++) {
        const struct benchmark_row *row = &r->line.rows[i];
        uint32_t total = benchmark_total(row->rates);
        if (strcmp(row->level, last->level) == 0)
            (void)fprintf(out, "%s %u.%03u with %u thread%s", row->threads > 1 ? "," : "", (unsigned)(total / 1000),
                          (unsigned)(total % 1000), row->threads, row->threads == 1 ? "" : "s");
    }
    (void)benchmark_print(&r->line, text);
    (void)fprintf(out, "\n\n%s\n", text);
}

static int run(struct run *r)
{
    int status = begin(r);

    if (status)
        return status;
    print_head(r);
    for (unsigned i = 0; i < r->level_count; i++)
        for (unsigned k = 0; k < r->count_count && !status; k++)
            status = measure(r, &r->levels[i], r->counts[k]);
    if (!status && !r->wrong)
        print_result(r);
    return status;
}

static int result_of(const struct run *r, int status)
{
    bool unwritten = fflush(r->wish->out) != 0 || ferror(r->wish->out);

    if (status == TIA_ERR_DEVICE || (!status && unwritten))
        return BENCHMARK_NO_OUTPUT;
    if (!status)
        return r->wrong ? BENCHMARK_WRONG : BENCHMARK_FINE;
    if (!r->why[0])
        (void)snprintf(r->why, BENCHMARK_WHY, "%s",
                       status == TIA_ERR_MEMORY ? "memory: exhausted" : "a frame cannot be drawn");
    return BENCHMARK_FAILED;
}

int benchmark_run(const struct benchmark_wish *wish, char *why)
{
    static struct run r; /* too large for the stack */

    r = (struct run){.wish = wish, .why = why};
    why[0] = '\0';
    int result = result_of(&r, run(&r));
    for (unsigned i = 0; i < BENCHMARK_FRAMES; i++)
        benchmark_close(&r.stages[i]);
    return result;
}
