#include "compare.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static const char *const rules[RULES] = {"edges", "ties", "depth", "stencil"};
static const char *const compares[8] = {"never", "less", "equal", "lequal", "greater", "notequal", "gequal", "always"};
static const char *const operations[8] = {"keep", "zero",   "replace",   "incr",
                                          "decr", "invert", "incr_wrap", "decr_wrap"};

static void print(const struct conform_tested *t, const char *format, ...) __attribute__((format(printf, 2, 3)));
static void print(const struct conform_tested *t, const char *format, ...)
{
    char text[512];
    va_list list;

    va_start(list, format);
    (void)vsnprintf(text, sizeof text, format, list);
    va_end(list);
    t->say(t->say_ctx, text);
}

static void print_face(const struct conform_tested *t, const char *who, uint32_t face, unsigned stencil)
{
    if (face == TIA_NO_FACE)
        print(t, "%s no triangle, stencil %u", who, stencil);
    else
        print(t, "%s triangle %u, stencil %u", who, (unsigned)face, stencil);
}

static void print_side(const struct conform_tested *t, const char *name, const struct tia_stencil *s)
{
    print(t, "      %s: %s reference %u mask %02x write %02x, fail %s zfail %s zpass %s\n", name, compares[s->test],
          (unsigned)s->reference, (unsigned)s->mask, (unsigned)s->write, operations[s->fail], operations[s->zfail],
          operations[s->zpass]);
}

static void print_finding(const struct conform_tested *tested, const struct finding *f)
{
    print(tested, "%s: pixel (%u, %u): ", rules[f->rule], f->x, f->y);
    print_face(tested, "OpenGL shows", f->face[1], f->stencil[1]);
    print_face(tested, "; exact:", f->face[0], f->stencil[0]);
    print(tested, " (stencil at first %u)\n", (unsigned)f->trial.clear);
    for (unsigned i = 0; i < f->trial.count; i++) {
        const struct triangle *t = &f->trial.triangles[i];
        print(tested, "    triangle %u:", i);
        for (int k = 0; k < 3; k++)
            print(tested, " (%g, %g)", (double)t->x[k] / 256, (double)t->y[k] / 256);
        print(tested, " distance %d, depth %s%s%s%s\n", (int)t->level, compares[t->state.depth],
              t->state.depth_write ? "" : ", writes no depth", t->state.skip_front ? ", culls front" : "",
              t->state.skip_back ? ", culls back" : "");
        print_side(tested, "front", &t->state.front);
        print_side(tested, "back", &t->state.back);
    }
}

int conform_compare(const struct conform_plan *plan, const struct conform_tested *tested)
{
    static struct pixels exact, found;
    static struct finding smallest[RULES], finding;
    unsigned long pixels = 0, trials[RULES] = {0};
    uint64_t seed = plan->seed;

    for (unsigned i = 0; i < plan->trials; i++) {
        struct trial trial;
        unsigned first;
        memset(&trial, 0, sizeof trial);
        trial_random(&trial, &seed, plan->step);
        if (!trial_exact(NULL, &trial, &exact) || !tested->draw(tested->ctx, &trial, &found))
            return CONFORM_FAILED;
        unsigned differing = trial_differs(&exact, &found, &first);
        if (!differing)
            continue;
        pixels += differing;
        if (!trial_shrink(&trial, tested->draw, tested->ctx, &finding)) {
            print(tested, "unsteady: a trial differs only sometimes\n");
            continue;
        }
        if (trials[finding.rule]++ == 0 || finding.trial.count < smallest[finding.rule].trial.count)
            smallest[finding.rule] = finding;
    }
    for (int r = 0; r < RULES; r++)
        if (trials[r])
            print_finding(tested, &smallest[r]);
    print(tested, "%s: %lu of %llu pixels differ; trials by the rule that they break:", tested->driver, pixels,
          (unsigned long long)plan->trials * PIXELS);
    for (int r = 0; r < RULES; r++)
        print(tested, " %s %lu%s", rules[r], trials[r], r + 1 < RULES ? "," : "\n");
    return pixels ? CONFORM_DIFFERS : CONFORM_SAME;
}
