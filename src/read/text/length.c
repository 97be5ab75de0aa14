#include "length.h"

#include "math/integer.h"

void tia_span_begin(struct tia_span *span)
{
    for (int i = 0; i < 3; i++) {
        span->min[i] = INT32_MAX;
        span->max[i] = INT32_MIN;
    }
}

void tia_span_join(struct tia_span *span, const struct tia_span *more)
{
    for (int i = 0; i < 3; i++) {
        span->min[i] = more->min[i] < span->min[i] ? more->min[i] : span->min[i];
        span->max[i] = more->max[i] > span->max[i] ? more->max[i] : span->max[i];
    }
}

void tia_span_cover(struct tia_span *span, struct tia_vec3 centre, int64_t radius)
{
    const struct tia_span ball = {{centre.x - radius, centre.y - radius, centre.z - radius},
                                  {centre.x + radius, centre.y + radius, centre.z + radius}};

    tia_span_join(span, &ball);
}

void tia_lengths_begin(struct tia_lengths *l, int scale_bits, tia_q16 reach)
{
    *l = (struct tia_lengths){
        .scale_bits = scale_bits, .finest = reach > 0, .longest = reach > 0 ? tia_length_times(reach, scale_bits) : 0};
    tia_span_begin(&l->all);
    tia_span_begin(&l->eyes);
}

bool tia_lengths_widen(const struct tia_lengths *l, int *scale_bits)
{
    int bits = l->scale_bits;

    while (bits > -TIA_SCALE_BITS_MAX && tia_length_times(l->longest, bits - l->scale_bits) > INT32_MAX)
        bits--;
    *scale_bits = bits;
    return bits < l->scale_bits;
}

int64_t tia_length_times(int64_t x, int bits)
{
    if (bits >= 0)
        return x > INT64_MAX >> bits ? INT64_MAX : x * (INT64_C(1) << bits);
    return (x >> -bits) + ((x & ((INT64_C(1) << -bits) - 1)) != 0);
}

void tia_lengths_cover(struct tia_lengths *l, struct tia_vec3 centre, int64_t radius)
{
    tia_span_cover(&l->all, centre, radius);
}

void tia_lengths_cover_eye(struct tia_lengths *l, struct tia_vec3 eye)
{
    tia_span_cover(&l->all, eye, 0);
    tia_span_cover(&l->eyes, eye, 0);
}

/* Returns the distance from an eye or, if the finest unit is wanted, from any point to the farthest corner, rounded
 * up. */
static int64_t farthest(const struct tia_lengths *l)
{
    uint64_t far[3], most = 0, square = 0;
    unsigned coarse = 0;

    for (int i = 0; i < 3; i++) {
        const struct tia_span *from = l->finest ? &l->all : &l->eyes;
        int64_t over = l->all.max[i] - from->min[i], under = from->max[i] - l->all.min[i];
        far[i] = (uint64_t)(over > under ? over : under);
        most = far[i] > most ? far[i] : most;
    }
    while (((most >> coarse) + 1) >> 31)
        coarse++;
    for (int i = 0; i < 3; i++) {
        uint64_t part = (far[i] >> coarse) + (coarse > 0);
        square += part * part;
    }
    return (int64_t)(tia_sqrt64(square) + 1) << coarse;
}

/* Bound on the distance's error, in units of the last bit. Q16.16 rounds each number by up to half of that, once in the
 * unit of the first pass and once in that of the scene. */
#define ROUNDED 5

int tia_lengths_room(const struct tia_lengths *l)
{
    int64_t far = farthest(l) + ROUNDED, longest = l->longest + 1, most = far > longest ? far : longest;
    int bits = TIA_SCALE_BITS_MAX;

    while (bits > -TIA_SCALE_BITS_MAX &&
           tia_length_times(most, bits - l->scale_bits) + (bits < l->scale_bits ? ROUNDED : 0) > INT32_MAX)
        bits--;
    return bits;
}

/* Reads and measures a length. In the first passes a number that does not fit is clamped: a later pass reads it in a
 * larger unit. */
static int measure(struct tia_text *t, tia_q16 *out)
{
    struct tia_lengths *l = t->lengths;
    struct tia_text before = *t;
    int64_t length = 0, exact;
    int status = tia_text_long(t, &length, (unsigned)(16 + l->scale_bits));
    int64_t size = length < 0 ? -(length + 1) : length; /* INT32_MAX at both ends of the range of Q16.16 */

    l->longest = size > l->longest ? size : l->longest;
    *out = tia_saturate_s32(length);
    if (!status && !l->rounded && !tia_text_q32(&before, &exact))
        l->rounded = exact != length * 65536;
    return status;
}

/* Where mistakes are told, the unit does not matter: only what no unit holds is out of range. */
int tia_text_length(struct tia_text *t, tia_q16 *out)
{
    return t->lengths->filling && !t->tolerance ? tia_text_scaled(t, out, t->lengths->scale_bits) : measure(t, out);
}

int tia_text_place(struct tia_text *t, struct tia_vec3 *out)
{
    int status = tia_text_length(t, &out->x);

    status = status ? status : tia_text_length(t, &out->y);
    return status ? status : tia_text_length(t, &out->z);
}

struct tia_vec3 tia_vector_of(const int64_t v[3])
{
    tia_q16 to[3];
    uint64_t all = 0;
    bool exact = true;

    for (int i = 0; i < 3; i++) {
        all |= (uint64_t)(v[i] < 0 ? -v[i] : v[i]);
        exact = exact && !(v[i] & 0xffff) && v[i] >> 16 == (tia_q16)(v[i] >> 16);
    }
    /* the largest component has 64 - clz bits, of which 30 are kept: rounding up then does not overflow */
    int shift = exact ? 16 : all ? 34 - (int)tia_clz64(all) : 0;
    for (int i = 0; i < 3; i++)
        to[i] = (tia_q16)(shift > 0 ? tia_round_shift(v[i], (unsigned)shift) : v[i] * (INT64_C(1) << -shift));
    return (struct tia_vec3){to[0], to[1], to[2]};
}

int tia_text_vector(struct tia_text *t, struct tia_vec3 *out)
{
    struct tia_text before = *t;
    int status = tia_text_vec3(t, out);
    int64_t v[3] = {0, 0, 0};

    for (int i = 0; !status && i < 3; i++)
        status = tia_text_q32(&before, &v[i]);
    if (!status && ((v[0] | v[1] | v[2]) & 0xffff))
        *out = tia_vector_of(v);
    return status;
}

int tia_text_fine_length(struct tia_text *t, tia_q16 *out, int16_t *digits)
{
    int64_t fine = 0;

    *digits = 0;
    if (!t->lengths->filling)
        return tia_text_length(t, out);
    int status = tia_text_fine(t, &fine, t->lengths->scale_bits);
    *out = (tia_q16)((fine + 0x8000) >> 16);
    *digits = (int16_t)(fine - *out * INT64_C(65536));
    return status;
}

int tia_text_fine_place(struct tia_text *t, struct tia_vec3 *out, struct tia_fine_place *digits)
{
    int status = tia_text_fine_length(t, &out->x, &digits->x);

    status = status ? status : tia_text_fine_length(t, &out->y, &digits->y);
    return status ? status : tia_text_fine_length(t, &out->z, &digits->z);
}
