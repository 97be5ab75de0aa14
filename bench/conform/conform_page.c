/* conform_page.c - tia-conform in a web page: the script draws, and gets what was found. */
#include "compare.h"

#include <string.h>

#define IMPORT(name) __attribute__((import_module("conform"), import_name(name)))
#define EXPORT(name) __attribute__((export_name(name)))

/* Draws a trial, given by the numbers of trial_numbers, and writes the bytes of trial_take. Returns 0 on failure. */
IMPORT("draw") int page_draw(const int32_t *numbers, unsigned count, uint8_t *bytes);
/* Receives text in parts. */
IMPORT("say") void page_say(const char *text, unsigned length);

static bool draw(void *ctx, const struct trial *trial, struct pixels *pixels)
{
    static int32_t numbers[TRIAL_NUMBERS];
    static uint8_t bytes[2 * PIXELS];

    (void)ctx;
    if (!page_draw(numbers, trial_numbers(trial, numbers), bytes))
        return false;
    trial_take(pixels, bytes);
    return true;
}

static void say(void *ctx, const char *text)
{
    (void)ctx;
    page_say(text, (unsigned)strlen(text));
}

/* Compares WebGL with the exact rasteriser; returns an enum conform_result. */
EXPORT("conform") int conform_page(unsigned trials, unsigned step, unsigned seed);
int conform_page(unsigned trials, unsigned step, unsigned seed)
{
    const struct conform_plan plan = {trials, step, seed};
    const struct conform_tested tested = {draw, NULL, "WebGL 2", say, NULL};

    return conform_compare(&plan, &tested);
}
