/* vector.c - vectors, colours and directions: three numbers. */
#include "math/integer.h"
#include "text_lines.h"

int tia_text_vec3(struct tia_text *t, struct tia_vec3 *out)
{
    int status = tia_text_q16(t, &out->x);

    status = status ? status : tia_text_q16(t, &out->y);
    return status ? status : tia_text_q16(t, &out->z);
}

static int read_channel(struct tia_text *t, tia_q30 *out, bool bright)
{
    return bright ? tia_text_bright(t, out) : tia_text_unit(t, out);
}

int tia_text_rgb(struct tia_text *t, struct tia_rgb *out, bool bright)
{
    int status = read_channel(t, &out->r, bright);

    status = status ? status : read_channel(t, &out->g, bright);
    return status ? status : read_channel(t, &out->b, bright);
}

/* Returns floor(sqrt(x)), bit by bit. */
static uint64_t root(uint64_t x)
{
    uint64_t r = 0;

    for (uint64_t bit = UINT64_C(1) << 62; bit; bit >>= 2) {
        bool set = x >= r + bit;
        x -= set ? r + bit : 0;
        r = (r >> 1) + (set ? bit : 0);
    }
    return r;
}

static uint64_t magnitude(int64_t x)
{
    return x < 0 ? 0 - (uint64_t)x : (uint64_t)x;
}

/* Normalises a vector. Its components are shifted so that the largest is in 2^30..2^31. The sum of squares is then
 * below 2^64, and its root at least 2^30. So the truncation of the components and of the root changes each by less than
 * 2^-30 of the root. */
/* True if v, Q31.32, is a unit vector of Q2.30 within 2 ulp: it stays as it is, so that a direction that was written
 * as it is stored is read as it was. The length is within 2^-29 of 1 if its square is within 2^-28, all in 60 bits. */
static bool is_unit(const int64_t v[3])
{
    const uint64_t one = UINT64_C(1) << 60, most = UINT64_C(1) << 32;
    uint64_t square = 0;

    if ((v[0] | v[1] | v[2]) & 3 || magnitude(v[0]) >> 33 || magnitude(v[1]) >> 33 || magnitude(v[2]) >> 33)
        return false;
    for (int i = 0; i < 3; i++)
        square += (magnitude(v[i]) >> 2) * (magnitude(v[i]) >> 2);
    return square >= one - most && square <= one + most;
}

bool tia_dir3_of(struct tia_dir3 *out, const int64_t v[3])
{
    tia_q30 unit[3];
    uint64_t all = magnitude(v[0]) | magnitude(v[1]) | magnitude(v[2]), part[3], square = 0;

    if (!all)
        return false;
    if (is_unit(v)) {
        *out = (struct tia_dir3){(tia_q30)(v[0] / 4), (tia_q30)(v[1] / 4), (tia_q30)(v[2] / 4)};
        return true;
    }
    unsigned zeros = tia_clz64(all);
    for (int i = 0; i < 3; i++) {
        part[i] = zeros < 33 ? magnitude(v[i]) >> (33 - zeros) : magnitude(v[i]) << (zeros - 33);
        square += part[i] * part[i];
    }
    uint64_t length = root(square);
    for (int i = 0; i < 3; i++) {
        tia_q30 size = (tia_q30)(((part[i] << 30) + length / 2) / length);
        unit[i] = v[i] < 0 ? -size : size;
    }
    *out = (struct tia_dir3){unit[0], unit[1], unit[2]};
    return true;
}

int tia_text_dir3(struct tia_text *t, struct tia_dir3 *out)
{
    struct tia_word first;
    int64_t v[3];

    (void)tia_text_peek(t, &first);
    for (int i = 0; i < 3; i++) {
        int status = tia_text_q32(t, &v[i]);
        if (status)
            return status;
    }
    if (!tia_dir3_of(out, v))
        return tia_text_error(t, &first, "begins a direction of no length", "three numbers that are not all 0");
    return TIA_OK;
}
