#include "math/fast.h"

#include "words.h"

#include "math/noinline.h"
#include "render/span/span_proved.h"
#include "words_proved.h"

#define ONE ((uint32_t)1 << 26)    /* q y^2 */
#define NEAR ((uint32_t)1 << 14)   /* the largest error of q y^2 before a step */
#define ACCURATE (-9 * 256)        /* the largest error of t, see span_error.h */
#define LEAST ((uint32_t)65 << 22) /* a little above 2^28: y is below 2^31, also if it is off by 2^-13 */
#define MOST ((uint32_t)15 << 28)

uint32_t words_high_apart(uint32_t a, uint32_t b)
{
    return (uint32_t)(tia_mul_u32(a, b) >> 32);
}

static NOINLINE int32_t high_signed_apart(int32_t a, int32_t b)
{
    return tia_high_s32(a, b);
}

static inline int32_t high_signed(int32_t a, int32_t b)
{
    return TIA_HALF_PRODUCTS ? high_signed_apart(a, b) : tia_high_s32(a, b);
}

/* ---- points ---- */

/* Along a row t is convex: largest at an end. It is off by less than 2^-8 of itself, or not used. */
void words_points(const struct primary_rays *primary, const struct span_sphere *sphere, int x, int y, const num_u *t,
                  int count, struct word_points *points)
{
    struct row_square square = primary_square(primary, x, y);
    uint64_t v = (uint64_t)square.start, step = (uint64_t)square.step, twice = (uint64_t)square.twice;
    uint32_t most = (uint32_t)t[0] > (uint32_t)t[count - 1] ? (uint32_t)t[0] : (uint32_t)t[count - 1];

    points->up = (int)tia_clz32(most + (most >> 8) + 1) - 1;
    points->exponent = 2 * (sphere->t_exponent + points->up) + 2 * primary->exponent + primary->square_shift - 94;
    points->middle = count / 2;
    points->spread = 32 - (int)tia_clz32((uint32_t)points->middle | 1);
    const int32_t next = (int32_t)1 << (31 - points->spread);
    for (int i = 0; i < count; i++) {
        struct word_point *point = &points->point[i];
        uint32_t word = (uint32_t)t[i] << points->up;
        point->t = (int32_t)word;
        if (!TIA_HALF_PRODUCTS)
            point->across = (int32_t)(tia_mul_s32(point->t, (i - points->middle) * next) >> 31);
        point->reach = (int32_t)words_high(words_high(word << 1, word << 1), (uint32_t)(v >> 32));
        v += step;
        step += twice;
    }
}

/* ---- forms ---- */

/* A linear form of v, times 2^32. Where products of words are quick, one with t and one with `across` take the place of
 * an accumulator. */
struct word_form {
    int64_t now;  /* at the next pixel, or in the middle of the row */
    int64_t step; /* from one pixel to the next, or from the middle over 2^spread pixels */
};

/* Returns the form with an accumulator's start and step, times 2^shift. */
static struct word_form form_of(const struct word_points *points, num_wide start, num_wide step, int shift)
{
    num_wide middle = TIA_HALF_PRODUCTS ? start : start + (num_wide)points->middle * step;
    int over = TIA_HALF_PRODUCTS ? 0 : points->spread;
    struct word_form form = {(int64_t)span_shift(middle, shift), (int64_t)span_shift(step, shift + over)};

    return form;
}

/* Adds the form times t to a word; `rest` as tia_add_high_s32() has it. */
static INLINED_IN_WORDS void add_form(int32_t *sum, uint32_t *rest, const struct word_form *form,
                                      const struct word_point *point)
{
    if (TIA_HALF_PRODUCTS) {
        *sum += high_signed(point->t, (int32_t)(form->now >> 32));
    } else {
        tia_add_high_s32(sum, rest, point->t, (int32_t)(form->now >> 32));
        tia_add_high_s32(sum, rest, point->across, (int32_t)(form->step >> 32));
    }
}

static INLINED_IN_WORDS void form_next(struct word_form *form)
{
    if (TIA_HALF_PRODUCTS)
        form->now += form->step;
}

/* ---- a run of pixels of a light ---- */

/* A light on a ball. q is |w|^2, from LEAST to MOST, with an even exponent e; y is 2^45/sqrt(q), and so from 2^29 to
 * 2^31. With R, r with its highest bit at 2^28, f has such an exponent that the upper word of f y is R times the
 * cosine. So f is below 2^32. */
struct words {
    const struct word_points *points;
    int32_t facing;        /* constant of f, as a word */
    uint32_t doubt;        /* bound of the error of f's word */
    uint32_t distance;     /* constant of |w|^2, as a word */
    int exponent;          /* that of |w|^2's word */
    int reach_down;        /* from |P|^2's word to it */
    int32_t reach_factor;  /* the same as a factor of 2^32, 2^(32 - reach_down) */
    uint32_t square_doubt; /* bound of the error of |w|^2's word */
    int moved;             /* logarithm of the error of P, in 256ths */
    int facing_scale;      /* e/2 plus this is `up` */
    int up, square_up;     /* from f's word to f, and from |w|^2's to q */
    uint32_t inverse;      /* 1/R */
    uint32_t worst;        /* largest bound of the cosines so far */
    uint32_t y;            /* that of the next pixel, about */
    struct word_form g, q; /* G.v and -2 Q.v for the words of t */
    uint32_t least, reach; /* the smallest word of |w|^2 in the run, and the largest one, minus the smallest one */
    int at, count;         /* the next pixel */
    num_u *lambert;
};

/* Returns f as a word. */
static INLINED_IN_WORDS int32_t facing_at(const struct words *w, uint32_t *rest, const struct word_form *g,
                                          const struct word_point *point)
{
    int32_t facing = w->facing;

    add_form(&facing, rest, g, point);
    return facing;
}

/* Returns |w|^2 as a word, less `below`. */
static INLINED_IN_WORDS uint32_t square_at(const struct words *w, uint32_t below, uint32_t *rest,
                                           const struct word_form *q, const struct word_point *point)
{
    int32_t square = (int32_t)(w->distance - below);

    add_form(&square, rest, q, point);
    if (TIA_HALF_PRODUCTS)
        square += point->reach >> w->reach_down;
    else
        tia_add_high_s32(&square, rest, point->reach, w->reach_factor);
    return (uint32_t)square;
}

/* Returns about 2^45/sqrt(q), by a table. */
static NOINLINE uint32_t rough(uint32_t q)
{
    unsigned low = q >> 30 == 0;

    return tia_rsqrt_seed(q << 2 * low) >> (2 - low);
}

/* Bounds the error of the run's cosines: that of f by up to y/2^32, a half, that of q, of q, by a half, and a 32nd of
 * both for their product. */
static bool bound_run(struct words *w)
{
    uint64_t of_f = (uint64_t)w->doubt << w->up, of_q = (uint64_t)w->square_doubt << w->square_up;
    uint64_t moved = (uint64_t)num_bound_of_log(w->moved + (w->exponent + w->square_up) / 2 * 256);

    if (of_f >> 18 || of_q >> 18 || moved >> 18)
        return false;
    uint32_t both = (uint32_t)(of_f + of_q + 2 * moved), bound = both / 2 + both / 32 + 1 + WORDS_BOUND(WORDS_COSINE);
    w->worst = bound > w->worst ? bound : w->worst;
    return true;
}

/* Begins a run at the next pixel, which faces the light; false if it would not be accurate. */
static NOINLINE bool begin(struct words *w)
{
    uint32_t rest = 0, q = square_at(w, 0, &rest, &w->q, &w->points->point[w->at]);
    int zeros = (int)tia_clz32(q | 1);

    w->square_up = zeros - 1 - ((w->exponent + zeros - 1) & 1);
    if (w->square_up < 0 || w->square_up > 20)
        return false;
    w->least = LEAST >> w->square_up;
    w->reach = (MOST >> w->square_up) - w->least;
    w->up = w->facing_scale + (w->exponent + w->square_up) / 2;
    if (w->up < 0 || w->up > 15 || !bound_run(w))
        return false;
    w->y = rough(q << w->square_up);
    return true;
}

/* Computes pixels up to the first one that does not face the light or needs another run. */
static void draw_run(struct words *w)
{
    const struct words own = *w; /* which no pixel changes */
    const struct word_point *point = own.points->point + own.at, *end = own.points->point + own.count;
    struct word_form g = own.g, q = own.q;
    num_u *lambert = own.lambert + own.at;
    uint32_t y = own.y, step = 0, rest = 0;

    for (; point < end; point++) {
        int32_t facing = facing_at(&own, &rest, &g, point);
        uint32_t above = square_at(&own, own.least, &rest, &q, point);
        if (facing <= 0 || above > own.reach)
            break;
        uint32_t square = LEAST + (above << own.square_up), guess = y + step, off;
        for (;; guess = rough(square)) {
            off = ONE - words_high(square, words_high(guess, guess)); /* 1 - q y^2 */
            TIA_OPAQUE(off);
            if (off + NEAR <= 2 * NEAR)
                break;
        }
        int32_t next = (int32_t)guess;
        if (TIA_HALF_PRODUCTS)
            next += high_signed((int32_t)guess, (int32_t)(off << 5));
        else
            tia_add_high_s32(&next, &rest, (int32_t)guess, (int32_t)(off << 5));
        step = (uint32_t)next - y;
        y = (uint32_t)next;
        *lambert++ = (num_u)(words_high(words_high((uint32_t)facing << own.up, y), own.inverse) << 2);
        form_next(&g);
        form_next(&q);
    }
    w->g = g;
    w->q = q;
    w->at = (int)(point - own.points->point);
}

static void pass(struct words *w)
{
    w->lambert[w->at++] = 0;
    form_next(&w->g);
    form_next(&w->q);
}

/* Computes all pixels; false if some would not be accurate. */
static bool draw(struct words *w, struct word_light *light)
{
    while (w->at < w->count) {
        uint32_t rest = 0;
        int32_t facing = facing_at(w, &rest, &w->g, &w->points->point[w->at]);
        if (facing <= 0) {
            if (facing > -(int32_t)w->doubt)
                light->open |= PIXEL_BIT(w->at);
            pass(w);
            continue;
        }
        light->first = light->first > w->at ? w->at : light->first;
        int before = w->at;
        if (!begin(w))
            return false;
        draw_run(w);
        if (w->at == before)
            return false;
        light->last = w->at - 1;
    }
    return true;
}

bool words_light(const struct word_points *points, const struct light_source *source, const struct light_line *line,
                 const struct span_error *error, struct word_light *light)
{
    const int by_constant = 60 - span_bits(line->distance);
    const int by_points = points->exponent - (source->exponent - 32);
    int up = points->up < by_constant ? points->up : by_constant;
    struct words w;

    up = up < by_points - 3 ? up : by_points - 3;
    light->open = 0;
    light->first = line->count;
    light->last = -1;
    if (error->t > ACCURATE || line->facing_doubt >= num_bound(46) || up < 0 || by_points - up > 31)
        return false;
    w.points = points;
    w.facing = (int32_t)((int64_t)line->facing >> 32);
    w.doubt = (uint32_t)((int64_t)line->facing_doubt >> 32) + 1 + WORDS_BOUND(WORDS_FACING);
    w.distance = (uint32_t)num_top_u(span_shift(line->distance, up));
    w.exponent = source->exponent - 32 + up;
    w.reach_down = by_points - up;
    w.reach_factor = (int32_t)1 << (32 - w.reach_down);
    w.square_doubt = WORDS_BOUND(WORDS_SQUARE) + (WORDS_BOUND(WORDS_REACH) >> w.reach_down) + 1;
    w.moved = error->point + error->t + SPAN_LOG(SPAN_ERROR_WORDS);
    w.facing_scale = 64 - source->sphere->radius_bits - light_facing_exponent(source, line);
    w.inverse = (uint32_t)source->sphere->inverse;
    w.worst = 0;
    w.g = form_of(points, line->g, line->g_step, -points->up);
    w.q = form_of(points, -line->q, -line->q_step, up - points->up + 1);
    w.at = 0;
    w.count = line->count;
    w.lambert = light->lambert;
    if (!draw(&w, light))
        return false;
    light->doubt = (num_u)(4 * w.worst);
    return true;
}
