#include "raster.h"

#include <string.h>

__extension__ typedef __int128 integer;

/* Signed integers of 320 bits, modulo 2^320, the lowest digit first. */
#define DIGITS 10
struct big {
    uint32_t digit[DIGITS];
};

static struct big big_of(integer n)
{
    struct big b;

    for (int i = 0; i < DIGITS; i++)
        b.digit[i] = i < 4 ? (uint32_t)(n >> (32 * i)) : n < 0 ? UINT32_MAX : 0;
    return b;
}

static struct big big_times(struct big a, struct big b)
{
    struct big c = {{0}};

    for (int i = 0; i < DIGITS; i++) {
        uint64_t carry = 0;
        for (int k = 0; i + k < DIGITS; k++) {
            carry += (uint64_t)a.digit[i] * b.digit[k] + c.digit[i + k];
            c.digit[i + k] = (uint32_t)carry;
            carry >>= 32;
        }
    }
    return c;
}

static struct big big_plus(struct big a, struct big b)
{
    uint64_t carry = 0;

    for (int i = 0; i < DIGITS; i++) {
        carry += (uint64_t)a.digit[i] + b.digit[i];
        a.digit[i] = (uint32_t)carry;
        carry >>= 32;
    }
    return a;
}

static int big_sign(struct big a)
{
    if (a.digit[DIGITS - 1] >> 31)
        return -1;
    for (int i = 0; i < DIGITS; i++)
        if (a.digit[i])
            return 1;
    return 0;
}

struct ray {
    int64_t x, y, w;
};

static const struct ray rightwards = {1, 0, 0}, downwards = {0, -1, 0};

/* Returns the direction of a sample, see camera.h, scaled so that its components are integers. */
static struct ray ray_of(const struct oracle_image *m, int x, int y)
{
    int n = m->samples == 16 ? 4 : m->samples == 4 ? 2 : 1, i = m->sample % n, j = m->sample / n;
    int64_t column = 2 * n * n * (int64_t)x + 2 * n * i + 2 * j + 1, row = 2 * n * n * (int64_t)y + 2 * n * j;

    row += 2 * n - 2 * i - 1;
    return (struct ray){(column - n * n * m->width) * m->height, (n * n * m->height - row) * m->width,
                        (int64_t)n * n * m->width * m->height};
}

static struct ray corner(const struct tia_raster_vertex *v)
{
    return (struct ray){v->x, v->y, v->w};
}

static integer determinant(struct ray a, struct ray b, struct ray c)
{
    return ((integer)b.y * c.w - (integer)b.w * c.y) * a.x + ((integer)b.w * c.x - (integer)b.x * c.w) * a.y +
           ((integer)b.x * c.y - (integer)b.y * c.x) * a.w;
}

static int sign_of(integer n)
{
    return (n > 0) - (n < 0);
}

static int orientation(const struct tia_raster_vertex *v)
{
    return sign_of(determinant(corner(&v[0]), corner(&v[1]), corner(&v[2])));
}

bool oracle_covers(const struct oracle_image *image, const struct tia_raster_vertex *v, int count, int x, int y)
{
    struct ray d = ray_of(image, x, y);
    int wanted = orientation(v);

    for (int i = 0; i < count; i++) {
        struct ray a = corner(&v[i]), b = corner(&v[(i + 1) % count]);
        int sign = sign_of(determinant(a, b, d));
        if (sign == 0)
            sign = sign_of(determinant(a, b, rightwards));
        if (sign == 0)
            sign = sign_of(determinant(a, b, downwards));
        if (sign == 0 || sign != wanted)
            return false;
    }
    return wanted != 0;
}

/* Returns 1/t of the plane's point along d, times det, by Cramer's rule. */
static struct big height(const struct tia_raster_vertex *v, struct ray d)
{
    struct big sum = big_of(0);

    for (int i = 0; i < 3; i++) {
        struct ray b = corner(&v[(i + 1) % 3]), c = corner(&v[(i + 2) % 3]);
        sum = big_plus(sum, big_times(big_of(determinant(d, b, c)), big_of(v[i].h)));
    }
    return sum;
}

static int order_along(const struct tia_raster_vertex *a, const struct tia_raster_vertex *b, struct ray d)
{
    struct big det_a = big_of(determinant(corner(&a[0]), corner(&a[1]), corner(&a[2])));
    struct big det_b = big_of(determinant(corner(&b[0]), corner(&b[1]), corner(&b[2])));
    struct big left = big_times(height(a, d), det_b), right = big_times(height(b, d), det_a);

    return big_sign(big_plus(left, big_times(right, big_of(-1)))) * orientation(a) * orientation(b);
}

int oracle_order(const struct oracle_image *image, const struct tia_raster_vertex *a, const struct tia_raster_vertex *b,
                 int x, int y)
{
    int order = order_along(a, b, ray_of(image, x, y));

    if (order == 0)
        order = order_along(a, b, rightwards);
    return order ? order : order_along(a, b, downwards);
}

/* Converts an integer to long double, with a relative error below 2^-63. */
static long double big_value(struct big a)
{
    long double value = 0;

    if (big_sign(a) < 0)
        return -big_value(big_times(a, big_of(-1)));
    for (int i = DIGITS - 1; i >= 0; i--)
        value = value * 4294967296.0L + a.digit[i];
    return value;
}

long double oracle_nearness(const struct oracle_image *image, const struct tia_raster_vertex *v, int x, int y, long w)
{
    struct ray d = ray_of(image, x, y);
    integer det = determinant(corner(&v[0]), corner(&v[1]), corner(&v[2]));

    return big_value(height(v, d)) / big_value(big_of(det)) * w / d.w;
}

/* Compares as in OpenGL 4.6, tables 17.2 and 17.3, and section 17.3.5. */
static bool compare(enum tia_compare test, long new, long old)
{
    switch (test) {
    case TIA_COMPARE_NEVER:
        return false;
    case TIA_COMPARE_LESS:
        return new < old;
    case TIA_COMPARE_EQUAL:
        return new == old;
    case TIA_COMPARE_LEQUAL:
        return new <= old;
    case TIA_COMPARE_GREATER:
        return new > old;
    case TIA_COMPARE_NOTEQUAL:
        return new != old;
    case TIA_COMPARE_GEQUAL:
        return new >= old;
    case TIA_COMPARE_ALWAYS:
        break;
    }
    return true;
}

static int operated(enum tia_stencil_op op, int old, int reference)
{
    switch (op) {
    case TIA_STENCIL_KEEP:
        return old;
    case TIA_STENCIL_ZERO:
        return 0;
    case TIA_STENCIL_REPLACE:
        return reference;
    case TIA_STENCIL_INCR:
        return old + 1 > 255 ? 255 : old + 1;
    case TIA_STENCIL_DECR:
        return old - 1 < 0 ? 0 : old - 1;
    case TIA_STENCIL_INVERT:
        return 255 - old;
    case TIA_STENCIL_INCR_WRAP:
        return (old + 1) % 256;
    case TIA_STENCIL_DECR_WRAP:
        break;
    }
    return (old + 255) % 256;
}

static void write_stencil(uint8_t *pixel, const struct tia_stencil *s, enum tia_stencil_op op)
{
    int now = operated(op, *pixel, s->reference);

    for (int bit = 1; bit < 256; bit *= 2)
        if (s->write & bit)
            *pixel = (uint8_t)((*pixel & ~bit) | (now & bit));
}

/* Returns the sign of the depth of the polygon `face` minus that of the pixel's face, `there`. */
static int depth_against(const struct oracle_raster *r, const struct tia_raster_state *state,
                         const struct tia_raster_vertex *v, uint32_t face, uint32_t there, int x, int y)
{
    if (there == TIA_NO_FACE)
        return -1;
    if (there == face)
        return 0;
    int nearer = oracle_order(&r->image, v, r->planes[there], x, y);
    if (nearer == 0 && state->ties_by_face)
        nearer = face < there ? 1 : -1;
    return -nearer;
}

static void draw_pixel(struct oracle_raster *r, const struct tia_raster_state *state, const struct tia_raster_vertex *v,
                       uint32_t face, int x, int y)
{
    size_t at = (size_t)(y - r->area.y) * r->area.width + (size_t)(x - r->area.x);
    const struct tia_stencil *s = orientation(v) > 0 ? &state->front : &state->back;

    if (!compare(s->test, s->reference & s->mask, r->stencil[at] & s->mask)) {
        write_stencil(&r->stencil[at], s, s->fail);
        return;
    }
    if (!compare(state->depth, depth_against(r, state, v, face, r->face[at], x, y), 0)) {
        write_stencil(&r->stencil[at], s, s->zfail);
        return;
    }
    write_stencil(&r->stencil[at], s, s->zpass);
    if (state->depth_write)
        r->face[at] = face;
    for (size_t c = 0; c < 3; c++)
        if (state->colour_write[c])
            r->colour[3 * at + c] = state->colour[c];
}

void oracle_draw(struct oracle_raster *raster, const struct tia_raster_state *state, const struct tia_raster_vertex *v,
                 int count, uint32_t face)
{
    int side = orientation(v);

    if (side == 0 || (side > 0 ? state->skip_front : state->skip_back))
        return;
    if (state->depth_write)
        memcpy(raster->planes[face], v, sizeof raster->planes[face]);
    for (int y = raster->area.y; y < raster->area.y + raster->area.height; y++)
        for (int x = raster->area.x; x < raster->area.x + raster->area.width; x++)
            if (oracle_covers(&raster->image, v, count, x, y))
                draw_pixel(raster, state, v, face, x, y);
}

/* Finds the largest n with 2 n - 1 <= 2 value, bit by bit from the highest. */
int32_t oracle_blend(const struct oracle_image *image, const struct tia_raster_vertex v[3], int x, int y,
                     const int32_t a[3])
{
    struct ray d = ray_of(image, x, y);
    struct big over = big_of(0), under = over;
    int64_t n = INT32_MIN;

    for (int i = 0; i < 3; i++) {
        struct ray b = corner(&v[(i + 1) % 3]), c = corner(&v[(i + 2) % 3]);
        bool point = image->projection == TIA_ORTHOGRAPHIC ? v[i].w != 0 : v[i].h != 0;
        struct big weight = big_of(point ? determinant(d, b, c) : 0);
        under = big_plus(under, weight);
        over = big_plus(over, big_times(weight, big_of(2 * (integer)a[i])));
    }
    int side = big_sign(under);
    for (int64_t bit = INT64_C(1) << 31; bit; bit /= 2)
        if (n + bit <= INT32_MAX &&
            big_sign(big_plus(over, big_times(under, big_of(1 - 2 * (integer)(n + bit))))) * side >= 0)
            n += bit;
    return (int32_t)n;
}
