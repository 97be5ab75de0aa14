/* cone_row_span against brute force: the cone's inequality at every pixel, in 128 bits. */
#include "check.h"
#include "random.h"
#include "render/span/cone_row.h"

#ifdef __SIZEOF_INT128__

__extension__ typedef __int128 wide128;

/* Returns an integer in -most..most, of any magnitude. */
static int64_t any(int64_t most)
{
    uint64_t size = random_bits() % (uint64_t)(most + 1) >> random_bits() % 40;

    return random_bits() & 1 ? (int64_t)size : -(int64_t)size;
}

/* True if c < 0, or L.v >= 0 and (L.v)^2 >= c v.v at pixel i, where |L.v| < 2^63 and c v.v < 2^126. */
static bool is_inside(const struct cone_row *s, int i)
{
    wide128 x = (wide128)(2 * i + 1 - s->count) * ((wide128)1 << s->exponent);
    wide128 b = s->slope * x + s->base, square = x * x + s->square;

    return s->c < 0 || (b >= 0 && b * b >= s->c * square);
}

static int widths, empties, partials; /* kinds of the cases */

static int estimates, near_estimates; /* spans that end within the row; those estimated to within a pixel */

static void check_estimate(const struct cone_row *s, struct span want)
{
    struct span span = cone_row_estimate(s);
    int first = span.first - want.first, end = span.end - want.end;

    CHECK(span.first >= 0 && span.first <= s->count && span.end >= 0 && span.end <= s->count);
    if (s->c < 0 || want.first == 0 || want.end == s->count || want.end - want.first < 2)
        return;
    estimates++;
    near_estimates += first >= -1 && first <= 1 && end >= -1 && end <= 1;
}

static void check_slice(const struct cone_row *s)
{
    struct span want = {0, 0}, span;
    int pixels = 0;

    for (int i = 0; i < s->count; i++)
        if (is_inside(s, i)) {
            want.first = pixels++ ? want.first : i;
            want.end = i + 1;
        }
    CHECK_EQ(want.end - want.first, pixels); /* a cone is convex */
    widths += pixels == s->count;
    empties += !pixels;
    partials += pixels && pixels < s->count;
    check_estimate(s, want);
    for (int k = 0; k < 12; k++) {
        int near = (int)(random_bits() % 5) - 2, first = (int)(random_bits() % (unsigned)s->count);
        struct span guess = {0, 0}; /* guesses: none; good; nearly good; bad; the whole row */
        if (k > 0)
            guess = k < 3   ? want
                    : k < 6 ? (struct span){want.first + near, want.end + near}
                            : (struct span){first, first + 1};
        if (k > 8)
            guess = k == 9 ? (struct span){0, s->count} : (struct span){first, s->count};
        guess = span_within(guess, 0, s->count);
        span = cone_row_span(s, guess);
        CHECK_MSG(span.end - span.first == pixels && (!pixels || span.first == want.first),
                  "%d..%d, not %d..%d of %d pixels, guess %d..%d", span.first, span.end, want.first, want.end, s->count,
                  guess.first, guess.end);
    }
}

/* Checks a sphere at L with radius r, seen along the row Y of a picture of `count` pixels that is `depth` away; |v| <
 * 2^30 as in the renderer. */
static void tia_check_sphere(int count, int64_t lx, int64_t ly, int64_t lz, int64_t r, int64_t row, int64_t depth)
{
    int bits = 64 - __builtin_clzll((uint64_t)(count * (int64_t)count + row * row + depth * depth));
    struct cone_row s = {.count = count, .exponent = 30 - (bits + 1) / 2, .doubt = -1};
    int64_t unit = INT64_C(1) << s.exponent, y = row * unit, z = depth * unit;

    s.slope = lx;
    s.base = ly * y - lz * z;
    s.square = y * y + z * z;
    s.c = lx * lx + ly * ly + lz * lz - r * r;
    check_slice(&s);
}

#define FAR ((int64_t)18000 << 16) /* limit of each coordinate: |L| < 2^31 */

static void check_random(int count, int cases)
{
    for (int i = 0; i < cases; i++) {
        int64_t lx = any(FAR), ly = any(FAR), lz = -any(FAR),
                r = 64 + (int64_t)(random_bits() % FAR >> random_bits() % 24);
        int64_t row = (int64_t)(random_bits() % 8192) - 4096,
                depth = 1 + (int64_t)(random_bits() % 60000 >> random_bits() % 16);
        tia_check_sphere(count, lx, ly, lz, r, row, depth);
    }
}

/* Checks spheres of some pixels, aimed at: the centre is near pixel (at, row). */
static void check_aimed(int count, int cases)
{
    for (int i = 0; i < cases; i++) {
        int64_t depth = 1 + (int64_t)(random_bits() % 9000), row = (int64_t)(random_bits() % 400) - 200;
        int64_t at = (int64_t)(random_bits() % (2 * (unsigned)count)) - count;
        int64_t lz = 10 + (int64_t)(random_bits() % (FAR / 8)), r = 64 + (int64_t)((uint64_t)lz >> random_bits() % 14);
        int64_t lx = lz * at / depth, ly = lz * row / depth + any(r);
        if (lx < FAR && lx > -FAR && ly < FAR && ly > -FAR)
            tia_check_sphere(count, lx, ly, -lz, r, row, depth);
    }
}

TEST(lines_of_few_pixels)
{
    check_random(1, 20000);
    check_random(2, 20000);
    check_random(3, 20000);
    check_aimed(1, 5000);
    check_aimed(2, 5000);
}

TEST(lines_of_many_pixels)
{
    check_random(65, 10000);
    check_aimed(64, 10000);
    check_aimed(641, 1500);
    CHECK(widths > 100 && empties > 100 && partials > 1000);
}

TEST(the_longest_line)
{
    widths = empties = partials = 0;
    check_random(8192, 150);
    check_aimed(8192, 250);
    CHECK(empties > 20 && partials > 100);
}

/* The estimates of the cases before; not where a cone reaches 90 degrees from the middle. */
TEST(ends_are_estimated)
{
    CHECK_MSG(estimates > 500 && near_estimates >= estimates / 100 * 97, "%d of %d", near_estimates, estimates);
}

/* Pixels where both sides of the inequality are equal are inside. L = (0, 0, -5), r = 3: c = 16, and with v = (X, 0,
 * -4) it is 20^2 >= 16 (X^2 + 16), that is X^2 <= 9: X = -3..3, of the odd numbers. */
TEST(tangents)
{
    struct cone_row s = {.slope = 0, .base = 20, .square = 16, .c = 16, .exponent = 0, .count = 10, .doubt = -1};
    struct span span = cone_row_span(&s, (struct span){0, 0});

    CHECK(span.first == 3 && span.end == 7);
    check_slice(&s);
    s.c = 17; /* 400/17 - 16 = 7.5: X = -1..1 */
    span = cone_row_span(&s, (struct span){3, 7});
    CHECK(span.first == 4 && span.end == 6);
    s.c = 400 / 16; /* the tangent in the middle lies between two pixels */
    span = cone_row_span(&s, (struct span){0, 10});
    CHECK_EQ(span.end, span.first);
    s.count = 9; /* the tangent is on a pixel here: X = 0 */
    span = cone_row_span(&s, (struct span){0, 0});
    CHECK(span.first == 4 && span.end == 5);
}

/* c < 0: from inside, a sphere is visible in all directions. */
TEST(from_inside)
{
    struct cone_row s = {.slope = 1, .base = 2, .square = 1, .c = -1, .exponent = 0, .count = 10, .doubt = -1};

    check_slice(&s);
    CHECK_EQ(cone_row_span(&s, (struct span){0, 0}).first, 0);
    CHECK_EQ(cone_row_span(&s, (struct span){0, 0}).end, 10);
    for (int i = 0; i < 20000; i++) {
        int64_t r = 64 + (int64_t)(random_bits() % FAR);
        tia_check_sphere(1 + (int)(random_bits() % 40), any(r / 2), any(r / 2), any(r / 2), r, any(100),
                         1 + (int64_t)(random_bits() % 999));
    }
}

/* Pixels in doubt count as inside, as no picture is given to decide them: the span has each pixel that is inside, and
 * begins no earlier than with b^2 - c v.v larger by the doubt. */
TEST(doubts)
{
    for (int i = 0; i < 3000; i++) {
        int64_t depth = 1 + (int64_t)(random_bits() % 9000), lz = 10 + (int64_t)(random_bits() % (FAR / 8));
        int64_t lx = lz * (int64_t)(random_bits() % 40) / depth, r = 64 + (int64_t)((uint64_t)lz >> random_bits() % 14);
        struct cone_row s = {.count = 64, .exponent = 12, .doubt = -1};
        s.slope = lx;
        s.base = lz * depth * 4096;
        s.square = depth * 4096 * (depth * 4096);
        s.c = lx * lx + lz * lz - r * r;
        if (s.c < 0)
            continue;
        struct span sure = cone_row_span(&s, (struct span){0, 0});
        s.doubt = (num_wide)(random_bits() % 1000);
        struct span span = cone_row_span(&s, (struct span){0, 0});
        if (sure.first < sure.end)
            CHECK(span.first <= sure.first && span.end >= sure.end);
        if (span.first < span.end && span.first > 0) {
            wide128 x = (wide128)(2 * (span.first - 1) + 1 - s.count) * 4096, b = s.slope * x + s.base;
            CHECK(b < 0 || b * b - s.c * (x * x + s.square) < 0);
            x += 2 * 4096;
            b = s.slope * x + s.base;
            CHECK(b * b - s.c * (x * x + s.square) >= -((wide128)(s.doubt + 2) << 64));
        }
    }
}

int main(void)
{
    RUN(lines_of_few_pixels);
    RUN(lines_of_many_pixels);
    RUN(the_longest_line);
    RUN(ends_are_estimated);
    RUN(tangents);
    RUN(from_inside);
    RUN(doubts);
    return check_status();
}

#else

int main(void)
{
    printf("skip cone_row: no 128-bit integers on this machine\n");
    return 0;
}

#endif
