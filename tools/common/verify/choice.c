#include "choice.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <time.h>
#include <unistd.h>

enum { MILLION = 1000000, DEFAULT_SHARE = MILLION / 100 };

const char *choice_parse_share(void *share, char *text)
{
    size_t length = strlen(text);
    uint64_t value = 0, whole = 0;
    unsigned decimals = 0;
    const char *at = text;

    if (length && text[length - 1] == '%')
        text[--length] = '\0';
    if (length && text[length - 1] == ' ')
        text[--length] = '\0';
    for (; *at >= '0' && *at <= '9' && whole <= 100; at++)
        whole = whole * 10 + (uint64_t)(*at - '0');
    bool fine = at > text && whole <= 100;
    if (*at == '.')
        for (at++; *at >= '0' && *at <= '9' && decimals < 4; at++, decimals++)
            value = value * 10 + (uint64_t)(*at - '0');
    for (; decimals < 4; decimals++)
        value *= 10;
    value += whole * 10000;
    *(uint32_t *)share = (uint32_t)value;
    return fine && *at == '\0' && at[-1] != '.' && value > 0 && value <= MILLION ? NULL : "";
}

const char *choice_check(const struct choice_wish *w)
{
    int given = (w->share != 0) + (w->count != 0) + w->all + w->has_rows;

    if (given > 1)
        return "--share, --count, --rows and --all: only one of them";
    return w->seeded && (w->all || w->has_rows) ? "--seed: is for random rows" : NULL;
}

/* ---- random numbers: splitmix64, by Steele, Lea and Flood, "Fast splittable pseudorandom number generators" (2014)
 * --- */

static uint64_t next(uint64_t *state)
{
    uint64_t z = *state += UINT64_C(0x9e3779b97f4a7c15);

    z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
    return z ^ z >> 31;
}

/* Returns a number below `limit`, each with the same chance. */
static uint64_t below(uint64_t *state, uint64_t limit)
{
    uint64_t rest = (UINT64_MAX % limit + 1) % limit, value;

    do
        value = next(state);
    while (value > UINT64_MAX - rest);
    return value % limit;
}

/* Returns a seed that cannot be predicted. */
static uint64_t unknown_seed(void)
{
    uint64_t seed = 0;

    if (getrandom(&seed, sizeof seed, 0) != (ssize_t)sizeof seed)
        seed = (uint64_t)time(NULL) << 20 ^ (uint64_t)getpid();
    return seed;
}

/* ---- the choice ---- */

static uint64_t count_of(const struct choice_wish *w, uint64_t total)
{
    uint64_t share = w->share ? w->share : DEFAULT_SHARE;
    uint64_t count = w->count ? w->count : total / MILLION * share + (total % MILLION * share + MILLION - 1) / MILLION;

    return w->all || w->has_rows || count > total ? total : count;
}

static int by_key(const void *left, const void *right)
{
    uint64_t a = *(const uint64_t *)left, b = *(const uint64_t *)right;

    return (a > b) - (a < b);
}

int choice_make(struct choice *choice, const struct choice_wish *wish, uint64_t total, choice_place *place,
                const void *rows)
{
    uint64_t left = count_of(wish, total), state;

    *choice = (struct choice){.total = total, .random = !wish->all && !wish->has_rows};
    if (left < SIZE_MAX / sizeof *choice->keys)
        choice->keys = malloc(((size_t)left + 1) * sizeof *choice->keys);
    choice->seed = state = wish->seeded ? wish->seed : unknown_seed();
    for (uint64_t i = 0; i < total && left && choice->keys; i++) {
        uint32_t frame;
        unsigned y;
        if (choice->random && below(&state, total - i) >= left) /* selection sampling: Knuth, 3.4.2, algorithm S */
            continue;
        left -= choice->random;
        place(rows, i, &frame, &y);
        if (!wish->has_rows || (y >= wish->first_row && y <= wish->last_row))
            choice->keys[choice->count++] = choice_key(frame, y);
    }
    if (choice->count)
        qsort(choice->keys, (size_t)choice->count, sizeof *choice->keys, by_key);
    return choice->keys ? 0 : -1;
}

void choice_free(struct choice *choice)
{
    free(choice->keys);
    choice->keys = NULL;
}

bool choice_has(const struct choice *choice, uint32_t frame, unsigned y)
{
    uint64_t key = choice_key(frame, y);

    return choice->count && bsearch(&key, choice->keys, (size_t)choice->count, sizeof key, by_key);
}

double choice_unseen(const struct choice *choice, double forged)
{
    return choice->count == choice->total ? 0 : pow(1 - forged, (double)choice->count);
}
