/* made.h - the arrays of a scene with all features, and numbers for it from a fuzzer's bytes: of any size, but seldom
 * beyond their ranges. */
#ifndef TESTS_FUZZ_MADE_H
#define TESTS_FUZZ_MADE_H

#include <math.h>
#include <string.h>

#include "bytes.h"

#include <tia/mip.h>

#define MADE_SPHERES 2
#define MADE_SHAPES 5
#define MADE_LIGHTS 3
#define MADE_MATERIALS 5
#define MADE_FACES 4
#define MADE_MEMBERS 3
#define MADE_VERTICES 6
#define MADE_CELLS 4096

struct made {
    struct tia_scene scene;
    struct tia_vec3 origin; /* origin of positions: 0 or the eye */
    struct tia_sphere spheres[MADE_SPHERES];
    struct tia_shape shapes[MADE_SHAPES];
    struct tia_light lights[MADE_LIGHTS];
    struct tia_material materials[MADE_MATERIALS];
    struct tia_transform transforms[2];
    struct tia_texture textures[3]; /* textures, of which the last one is an opacity */
    struct tia_mesh meshes[2];
    struct tia_grid grid;
    struct tia_shape members[MADE_MEMBERS];
    uint8_t steps[2 * MADE_MEMBERS - 1];
    struct tia_solid solid;
    struct tia_vec3 vertices[MADE_VERTICES];
    struct tia_dir3 normals[3];
    struct tia_uv uvs[3];
    struct tia_face faces[MADE_FACES];
    struct tia_track track;
    struct tia_keyframe keys[2];
    uint8_t cells[MADE_CELLS], texels[3 * TIA_TEXTURE_MAX];
};

/* Takes a number of any size: of up to 7 bits with as many zeros as possible, or near a limit. */
static inline int32_t take_sized(struct bytes *b)
{
    static const int32_t limits[] = {INT32_MAX,   -INT32_MAX, 1239850262, -1239850262,    1073741824, -1073741824,
                                     TIA_Q16_ONE, 0,          65535,      TIA_RADIUS_MIN, 46340,      -TIA_Q16_ONE};
    uint8_t kind = take_byte(b);
    int32_t small = (int8_t)take_byte(b);

    if (kind < 200)
        return (small < -127 ? 127 : small) * (1 << kind % 25);
    int64_t sum = (int64_t)limits[kind % 12] + small * (1 << (kind - 200) / 12 * 3);
    return sum > INT32_MAX ? INT32_MAX : sum < -INT32_MAX ? -INT32_MAX : (int32_t)sum;
}

/* Takes one of a few numbers, or one between least and most. */
static inline int32_t take_within(struct bytes *b, int32_t least, int32_t most)
{
    uint8_t kind = take_byte(b);
    int64_t n = kind & 1   ? least + (kind >> 2)
                : kind & 2 ? most - (kind >> 2)
                           : least + (most - (int64_t)least) * take_byte(b) / 255 + (kind >> 2);
    return n > most ? most : n < least ? least : (int32_t)n;
}

static inline int32_t moved(int32_t x, int32_t by)
{
    int64_t sum = (int64_t)x + by;
    return sum > INT32_MAX ? INT32_MAX : sum < INT32_MIN ? INT32_MIN : (int32_t)sum;
}

static inline struct tia_vec3 take_size(struct bytes *b)
{
    tia_q16 x = take_sized(b), y = take_sized(b);
    return (struct tia_vec3){x, y, take_sized(b)};
}

static inline struct tia_vec3 take_place(struct bytes *b, const struct made *m)
{
    struct tia_vec3 v = take_size(b);
    return (struct tia_vec3){moved(v.x, m->origin.x), moved(v.y, m->origin.y), moved(v.z, m->origin.z)};
}

static inline tia_q16 take_radius(struct bytes *b)
{
    int32_t r = take_sized(b);
    r = r < 0 ? -r : r;
    return r < TIA_RADIUS_MIN ? TIA_RADIUS_MIN + r % 2 : r;
}

/* Takes a direction of length 1, or of the smallest or largest length allowed. */
static inline struct tia_dir3 take_direction(struct bytes *b)
{
    uint8_t kind = take_byte(b);
    double x = (int8_t)take_byte(b), y = (int8_t)take_byte(b), z = (int8_t)take_byte(b);
    double length = kind & 1 ? 1 : kind & 2 ? 0.500001 : 1.499999;

    if (kind & 4)
        x /= 1 << 24;
    if (kind & 8)
        y /= 1 << (kind >> 4);
    if (x == 0 && y == 0 && z == 0)
        y = 1;
    length *= TIA_Q30_ONE / sqrt(x * x + y * y + z * z);
    return (struct tia_dir3){(tia_q30)(x * length), (tia_q30)(y * length), (tia_q30)(z * length)};
}

static inline tia_q30 take_part(struct bytes *b, tia_q30 most)
{
    static const tia_q30 some[] = {0, TIA_Q30_ONE, TIA_Q30_ONE / 2, 1, TIA_Q30_ONE - 1, 1 << 14};
    uint8_t kind = take_byte(b);

    if (kind >= 240 && most > TIA_Q30_ONE)
        return most - (kind - 240);
    return kind < 192 ? some[kind % 6] : (kind - 192) * (most / 64);
}

static inline struct tia_rgb take_colour(struct bytes *b, tia_q30 most)
{
    tia_q30 r = take_part(b, most);
    return (struct tia_rgb){r, r, take_byte(b) % 4 ? r : take_part(b, most)};
}

#endif
