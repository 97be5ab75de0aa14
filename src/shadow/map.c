#include "map.h"

#include "kernels.h"
#include "math/wide.h"
#include "raster/halves.h"
#include "raster/runs.h"
#include "raster/target.h"

#define BAND_TEXELS (UINT32_C(1) << 20)   /* largest number of texels in memory while a map is drawn, band by band */
#define CACHED_TEXELS (UINT32_C(1) << 17) /* of a band that stays in a cache, where there are */
#define FEW_FACES 512                     /* so few faces that each may be prepared for many bands */
#define ASKED_TEXELS 4096                 /* number of texels that count as one item of work, see cancel.h */

unsigned tia_map_corners(const struct tia_map *map, const struct tia_map_view *view, const struct tia_flat_scene *flat,
                         uint32_t face, struct tia_raster_vertex corners[TIA_SIDES])
{
    unsigned sides = tia_flat_corners(flat, face, corners);
    int fraction = view->grid.fraction;

    for (unsigned k = 0; k < sides; k++) {
        bool direction = tia_flat_is_direction(flat, &corners[k]);
        int64_t at[3];
        tia_flat_affine(flat, &corners[k], at);
        for (int i = 0; i < 3; i++)
            at[i] *= direction ? INT64_C(1) << 20 : 256;
        if (direction)
            tia_eye_direction(&view->eye, at, map->bits, &corners[k]);
        else
            tia_eye_point(&view->eye, at, fraction, &corners[k]);
    }
    return sides;
}

/* Returns the upper 62 bits of a > 0; *exponent receives the exponent of the lowest of these bits. */
static int64_t mantissa(wide a, int *exponent)
{
    int bits = wide_bits(a);

    *exponent = bits - 62;
    return bits > 62 ? wide_down(a, (unsigned)(bits - 62)) : (int64_t)(wide_low(a) << (62 - bits));
}

static int most_bits(wide a, int more, int most)
{
    int bits = wide_bits(wide_size(a)) + more;

    return bits > most ? bits : most;
}

static int64_t cut_by(wide a, int cut)
{
    return cut > 0 ? wide_down(a, (unsigned)cut) : (int64_t)wide_low(a);
}

/* At the middle of a texel the plane's point is t D, with t = det/f and D.w = size: its distance is det size/f, in
 * units of the vertices. For parallel rays the distance is -f/(det size). */
void tia_map_plane_init(struct tia_map_plane *plane, const struct tia_map *map, const struct tia_map_view *view,
                        const struct tia_raster_plane *given)
{
    wide x = halves_get(given->x), y = halves_get(given->y), c = halves_get(given->c), det = halves_get(given->det);
    int side = 31 - (int)tia_clz32(map->size), units = TIA_WORLD_BITS + map->unit - map->coarse, exponent;
    int bits = most_bits(x, side, most_bits(y, side, most_bits(c, 0, 0))) + 2, cut = bits > 62 ? bits - 62 : 0;

    *plane = (struct tia_map_plane){.factor = 0};
    if (wide_sign(det) <= 0)
        return;
    plane->x = cut_by(x, cut);
    plane->y = cut_by(y, cut);
    plane->c = cut_by(c, cut);
    int64_t m = mantissa(det, &exponent);
    if (map->parallel) {
        plane->factor = wide_quotient(INT64_C(1) << 61, m, 61);
        plane->places = 122 + exponent + side - cut - units;
    } else {
        plane->factor = m;
        plane->places = cut + view->grid.fraction - exponent - side - units;
    }
}

static inline uint32_t clamped(uint64_t distance)
{
    return distance < TIA_MAP_FAR ? (uint32_t)distance : TIA_MAP_FAR;
}

static inline uint32_t parallel_distance(const struct tia_map_plane *plane, int64_t f)
{
    wide product = wide_product(-f, plane->factor);

    if (f >= 0 || plane->places > 126)
        return 0;
    if (plane->places < 1 || wide_bits(product) - plane->places > 32)
        return TIA_MAP_FAR;
    return clamped((uint64_t)wide_round(product, (unsigned)plane->places));
}

/* The upper 32 bits of f give 31 correct bits of the quotient. */
static inline uint32_t central_distance(const struct tia_map_plane *plane, int64_t f)
{
    if (f <= 0)
        return 0;
    int zeros = (int)tia_clz64((uint64_t)f), down = plane->places + 33 - zeros;
    uint64_t quotient = ((uint64_t)plane->factor << 1) / ((uint64_t)f << zeros >> 32);
    if (down <= 0)
        return down < -2 || quotient << -down >= TIA_MAP_FAR ? TIA_MAP_FAR : (uint32_t)(quotient << -down);
    return down > 40 ? 0 : clamped((quotient + (UINT64_C(1) << (down - 1))) >> down);
}

static int64_t form_at(const struct tia_map_plane *plane, int i, int j)
{
    return plane->c + plane->x * i + plane->y * j;
}

uint32_t tia_map_distance(const struct tia_map *map, const struct tia_map_plane *plane, int i, int j)
{
    int64_t f = form_at(plane, i, j);

    return map->parallel ? parallel_distance(plane, f) : central_distance(plane, f);
}

static struct tia_tile band_of(struct tia_tile drawn, unsigned y, uint32_t texels)
{
    uint32_t rows = texels / drawn.width, left = drawn.y + (unsigned)drawn.height - y;

    return (struct tia_tile){drawn.x, (uint16_t)y, drawn.width, (uint16_t)(rows < left ? rows : left)};
}

uint64_t tia_map_room(unsigned size, uint32_t faces)
{
    const struct tia_tile all = {0, 0, (uint16_t)size, (uint16_t)size};

    return tia_raster_size(band_of(all, 0, BAND_TEXELS), TIA_BUFFER_DEPTH, faces);
}

static int draw_faces(const struct tia_map *map, const struct tia_map_view *view, struct tia_raster_target *target,
                      const struct tia_flat_scene *flat, struct cancel *cancel)
{
    static const struct tia_raster_state state = {.depth = TIA_COMPARE_LESS, .depth_write = true, .ties_by_face = true};
    uint32_t work = (uint32_t)target->area.width * target->area.height / ASKED_TEXELS + 1;
    int status = TIA_OK;

    for (uint32_t f = 0; !status && f < flat->face_count && !cancelled(cancel, work); f++) {
        struct tia_raster_vertex corners[TIA_SIDES];
        unsigned sides = tia_map_corners(map, view, flat, f, corners);
        status = tia_raster_draw(target, &state, corners, sides, f);
    }
    return status;
}

/* Stores the distances of a plane at texels (i, j), (i + 1, j) ... as tia_map_distance() gives them. */
static void keep_run(const struct tia_map *map, const struct tia_map_plane *plane, int i, int j, int count,
                     uint32_t *to)
{
    const struct tia_map_plane own = *plane;
    int64_t f = form_at(plane, i, j);

    for (int k = 0; k < count && map->parallel; k++)
        to[k] = parallel_distance(&own, f + k * own.x);
    for (int k = 0; k < count && !map->parallel; k++)
        to[k] = central_distance(&own, f + k * own.x);
}

static void keep_distances(const struct tia_map *map, const struct tia_map_view *view,
                           const struct tia_raster_target *target, struct cancel *cancel)
{
    const struct tia_tile *area = &target->area;
    uint32_t *to = view->distance + (size_t)area->y * map->size + area->x, last = TIA_NO_FACE;
    const uint32_t *face = target->face;
    int width = (int)area->width;
    struct tia_map_plane plane = {.factor = 0};

    if (target->runs && target->runs->shadows && target->runs->shadows->keep(map, view, target, cancel))
        return;
    for (int y = (int)area->y; y < target_bottom(target) && !cancelled(cancel, area->width); y++, to += map->size)
        for (int x = 0, count; x < width; x += count, face += count) {
            uint32_t here = *face;
            for (count = 1; x + count < width && face[count] == here; count++)
                continue;
            if (here != last && here != TIA_NO_FACE)
                tia_map_plane_init(&plane, map, view, &target->planes[here]);
            last = here == TIA_NO_FACE ? last : here;
            for (int k = 0; k < count && here == TIA_NO_FACE; k++)
                to[x + k] = TIA_MAP_NOTHING;
            if (here != TIA_NO_FACE)
                keep_run(map, &plane, (int)area->x + x, y, count, to + x);
        }
}

static int draw_band(const struct tia_map *map, const struct tia_map_view *view, const struct tia_flat_scene *flat,
                     struct tia_raster_target *target, struct cancel *cancel)
{
    int status = draw_faces(map, view, target, flat, cancel);

    if (!status && !cancel->stopped)
        keep_distances(map, view, target, cancel);
    return cancel->stopped ? TIA_STOPPED : status;
}

int tia_map_draw(const struct tia_map *map, const struct tia_flat_scene *flat, void *room,
                 const struct tia_raster_runs *runs, struct cancel *cancel)
{
    size_t size = (size_t)tia_map_room(map->size, flat->face_count);
    uint32_t texels = flat->face_count <= FEW_FACES ? CACHED_TEXELS : BAND_TEXELS;
    int status = TIA_OK;

    for (unsigned i = 0; i < map->view_count; i++) {
        const struct tia_map_view *view = &map->view[i];
        unsigned y = view->drawn.y, bottom = y + view->drawn.height;
        while (!status && y < bottom && view->drawn.width) {
            struct tia_tile band = band_of(view->drawn, y, texels);
            struct tia_raster_target target;
            y += band.height;
            status = tia_raster_init(&target, room, size, &view->grid, band, TIA_BUFFER_DEPTH, flat->face_count);
            target.runs = runs;
            status = status ? status : draw_band(map, view, flat, &target, cancel);
        }
    }
    return status;
}
