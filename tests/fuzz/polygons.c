/* polygons.c - the rasteriser on any polygons: corners in front of the eye, behind it and at infinity, within the
 * limits and beyond, in 64 and in 128 bits. Both formats draw the same as the oracle, pixel by pixel; two triangles on
 * either side of an edge have no pixel in common; no pixel outside the drawn part changes; and a polygon out of range
 * is refused before a pixel is drawn. */
#include <stdio.h>
#include <string.h>

#include "../../src/raster/target.h"
#include "../oracle/raster.h"
#include "bytes.h"

#define POLYGONS 6
#define SIDE 10 /* largest side of the drawn part, which has a border of one pixel */
#define PIXELS ((SIDE + 2) * (SIDE + 2))
#define BUFFERS (TIA_BUFFER_DEPTH | TIA_BUFFER_STENCIL | TIA_BUFFER_COLOUR)

/* A target and its part that is drawn. Each polygon is drawn in two of these: in the format that fits, and in 128 bits.
 */
struct drawn {
    struct tia_raster_grid grid;
    struct tia_raster_target whole, part;
    void *memory;
};

struct shape {
    struct tia_raster_vertex v[TIA_RASTER_CORNERS];
    unsigned count;
};

static uint32_t face[PIXELS];
static uint8_t stencil[PIXELS];
static uint16_t colour[3 * PIXELS];
static struct oracle_raster oracle = {.face = face, .stencil = stencil, .colour = colour};

/* ---- images ---- */

static struct tia_tile whole_of(struct tia_tile tile)
{
    const struct oracle_image *m = &oracle.image;
    struct tia_tile whole = {(uint16_t)(tile.x ? tile.x - 1 : 0), (uint16_t)(tile.y ? tile.y - 1 : 0), 0, 0};
    int right = tile.x + tile.width + 1, bottom = tile.y + tile.height + 1;

    whole.width = (uint16_t)((right < m->width ? right : m->width) - whole.x);
    whole.height = (uint16_t)((bottom < m->height ? bottom : m->height) - whole.y);
    return whole;
}

static struct tia_tile take_area(struct bytes *b)
{
    static const uint16_t sizes[] = {1, 2, 16, 31, 640, TIA_SIZE_MAX};
    uint8_t size = take_byte(b), x = take_byte(b), y = take_byte(b), kind = take_byte(b);
    struct oracle_image *m = &oracle.image;

    m->projection = kind & 1 ? TIA_ORTHOGRAPHIC : TIA_PERSPECTIVE;
    m->samples = kind & 2 ? 1 : kind & 4 ? 4 : 16;
    m->sample = (kind >> 4) % m->samples;
    m->width = sizes[size % 6];
    m->height = sizes[size / 6 % 6];
    struct tia_tile tile = {(uint16_t)((m->width - 1) * x / 255), (uint16_t)((m->height - 1) * y / 255), 0, 0};
    tile.width = (uint16_t)(m->width - tile.x < SIDE ? m->width - tile.x : SIDE);
    tile.height = (uint16_t)(m->height - tile.y < SIDE ? m->height - tile.y : SIDE);
    return tile;
}

static void open_target(struct drawn *d, struct tia_tile area, unsigned buffers, unsigned range, bool any)
{
    const struct oracle_image *m = &oracle.image;
    struct tia_tile whole = whole_of(area);
    size_t size = tia_raster_size(whole, buffers, POLYGONS);

    MUST(!tia_raster_grid_init(&d->grid, m->projection, (unsigned)m->width, (unsigned)m->height, (uint32_t)m->samples,
                               (uint32_t)m->sample, range));
    if (!any)
        d->grid.narrow = -1;
    d->memory = malloc(size);
    MUST(d->memory && !tia_raster_init(&d->whole, d->memory, size, &d->grid, whole, buffers, POLYGONS));
    MUST(!tia_raster_part(&d->part, &d->whole, area));
}

/* ---- polygons ---- */

static int64_t limit_of(const struct tia_raster_grid *l)
{
    return INT64_C(1) << (l->projection == TIA_ORTHOGRAPHIC ? 29 : 40);
}

/* Takes a coordinate: a small number times a power of two, one near a limit, or any. */
static int64_t take_coordinate(struct bytes *b, const struct tia_raster_grid *l)
{
    uint8_t kind = take_byte(b);
    int8_t small = (int8_t)take_byte(b);

    switch (kind & 3) {
    case 0:
        return (int64_t)small * (INT64_C(1) << (kind >> 2) % 34);
    case 1:
        return (kind & 4 ? -1 : 1) * (kind & 8 && l->narrow > 0 ? l->narrow : limit_of(l) - 1) +
               (kind & 16 ? small : 0);
    case 2:
        return small;
    default:
        return (int64_t)small * (INT64_C(1) << 33) + (int64_t)(take_word(b) << (kind >> 2) % 8);
    }
}

/* Takes a point at the centre of a pixel, or almost there. */
static struct tia_raster_vertex take_centre(struct bytes *b, const struct drawn *d)
{
    const struct tia_raster_grid *l = &d->grid;
    uint8_t i = take_byte(b), j = take_byte(b), times = take_byte(b), off = take_byte(b);
    int64_t x = d->part.area.x + i % SIDE, y = d->part.area.y + j % SIDE, k = 1 + times % 16;

    return (struct tia_raster_vertex){(l->x + x * l->right) * k + (off & 1), (l->y - y * l->down) * k + (off >> 1 & 1),
                                      l->w * k + (off >> 2 & 1), 1};
}

static struct tia_raster_vertex take_vertex(struct bytes *b, const struct drawn *d)
{
    const struct tia_raster_grid *l = &d->grid;
    uint8_t kind = take_byte(b);
    bool flat = l->projection == TIA_ORTHOGRAPHIC;

    if (!flat && kind % 4 == 0)
        return take_centre(b, d);
    struct tia_raster_vertex v = {.x = take_coordinate(b, l), .y = take_coordinate(b, l)};
    v.w = flat ? (kind % 8 == 7 ? 0 : INT64_C(1) << l->fraction) : take_coordinate(b, l);
    v.h = flat ? take_coordinate(b, l) : kind % 8 != 7;
    return v;
}

/* Takes a polygon; its first two corners may be those of the polygon before, in reverse order. */
static void take_polygon(struct bytes *b, const struct drawn *d, const struct shape *before, struct shape *p)
{
    uint8_t kind = take_byte(b);
    unsigned from = 0;

    p->count = 3 + (kind & 1 ? (kind >> 4) % 6 : 0);
    if (kind & 2 && before->count) {
        p->v[0] = before->v[1];
        p->v[1] = before->v[0];
        from = 2;
    }
    for (unsigned i = from; i < p->count; i++)
        p->v[i] = take_vertex(b, d);
    if (p->count == 4 && kind & 4) /* the side of a shadow volume; p->v[2] is the light */
        for (unsigned i = 3; i >= 2; i--) {
            const struct tia_raster_vertex *a = &p->v[3 - i], light = p->v[2];
            p->v[i] = (struct tia_raster_vertex){a->x - light.x, a->y - light.y, a->w - light.w, a->h - light.h};
        }
}

static bool is_within(const struct tia_raster_grid *l, const struct tia_raster_vertex *v)
{
    bool flat = l->projection == TIA_ORTHOGRAPHIC;
    int64_t limit = limit_of(l) << (flat ? v->w == 0 : v->h == 0), far = 2 * limit_of(l);

    return llabs(v->x) < limit && llabs(v->y) < limit && llabs(v->w) < limit &&
           (flat ? llabs(v->h) <= far : v->h == 0 || v->h == 1);
}

static bool is_accepted(const struct tia_raster_grid *l, const struct shape *p)
{
    for (unsigned i = 0; i < p->count; i++)
        if (!is_within(l, &p->v[i]))
            return false;
    return true;
}

__extension__ typedef __int128 integer;

/* Returns the sign of the determinant of three corners' directions. */
static int turn_of(const struct tia_raster_vertex *a, const struct tia_raster_vertex *b,
                   const struct tia_raster_vertex *c)
{
    integer d = ((integer)b->y * c->w - (integer)b->w * c->y) * a->x +
                ((integer)b->w * c->x - (integer)b->x * c->w) * a->y +
                ((integer)b->x * c->y - (integer)b->y * c->x) * a->w;

    return (d > 0) - (d < 0);
}

/* True if the polygon is convex, that is, if no two triples of corners, in their order, turn in opposite directions,
 * and if all sides have an outside. Another polygon has no inside, and the sides' signs in the oracle mean nothing. A
 * side whose ends lie in one direction from the eye has no outside, and the polygon covers nothing in the oracle. */
static bool is_convex(const struct shape *p)
{
    bool turns[3] = {false};

    for (unsigned i = 0; i < p->count; i++) {
        const struct tia_raster_vertex *a = &p->v[i], *b = &p->v[(i + 1) % p->count];
        if ((integer)a->x * b->y == (integer)a->y * b->x && (integer)a->y * b->w == (integer)a->w * b->y &&
            (integer)a->w * b->x == (integer)a->x * b->w)
            return false;
        for (unsigned j = i + 1; j < p->count; j++)
            for (unsigned k = j + 1; k < p->count; k++)
                turns[1 + turn_of(a, &p->v[j], &p->v[k])] = true;
    }
    return !turns[0] || !turns[2];
}

static struct tia_stencil take_stencil(struct bytes *b)
{
    uint8_t kind = take_byte(b);
    struct tia_stencil s = {TIA_COMPARE_ALWAYS, take_byte(b),    255, 255, TIA_STENCIL_KEEP,
                            TIA_STENCIL_KEEP,   TIA_STENCIL_KEEP};

    if (kind < 64) /* operations as for shadow volumes */
        *(kind & 1 ? &s.zfail : &s.zpass) = kind & 2 ? TIA_STENCIL_INCR_WRAP : TIA_STENCIL_DECR_WRAP;
    else
        s = (struct tia_stencil){kind & 7,         s.reference,      take_byte(b),    take_byte(b),
                                 take_byte(b) & 7, take_byte(b) & 7, take_byte(b) & 7};
    return s;
}

static struct tia_raster_state take_state(struct bytes *b)
{
    uint8_t kind = take_byte(b), more = take_byte(b);
    struct tia_raster_state s = {.depth = kind & 8 ? TIA_COMPARE_LESS : kind & 7, .depth_write = kind & 16};

    s.ties_by_face = kind & 32;
    s.skip_front = more % 16 == 1;
    s.skip_back = more % 16 == 2;
    s.front = take_stencil(b);
    s.back = take_stencil(b);
    for (int c = 0; c < 3; c++) {
        s.colour_write[c] = more >> (4 + c) & 1;
        s.colour[c] = (uint16_t)(more * 257 + c);
    }
    return s;
}

/* ---- checks ---- */

static void must_be_the_oracles(const struct drawn *d)
{
    struct tia_tile a = d->whole.area;

    for (size_t i = 0; i < (size_t)a.width * a.height; i++) {
        MUST(d->whole.face[i] == face[i]);
        MUST(d->whole.stencil[i] == stencil[i]);
        MUST(!memcmp(&d->whole.colour[3 * i], &colour[3 * i], 6));
    }
}

/* Checks that nearness in the two formats is about the same: each is within 2^15 of the exact one. */
static void must_be_alike(const struct drawn *a, const struct drawn *b)
{
    for (size_t i = 0; i < (size_t)a->whole.area.width * a->whole.area.height; i++) {
        int64_t difference = (int64_t)(a->whole.nearness[i] - b->whole.nearness[i]);
        MUST(difference <= 65536 && difference >= -65536);
        MUST(a->whole.nearness[i] <= UINT64_C(1) << 62);
        MUST(a->whole.face[i] == b->whole.face[i] && a->whole.stencil[i] == b->whole.stencil[i]);
    }
    MUST(!memcmp(a->whole.planes, b->whole.planes, POLYGONS * sizeof *a->whole.planes));
}

/* Draws the oracle's picture in the drawn part only, so that a change outside is detected. */
static void draw_oracles(const struct tia_raster_state *s, const struct shape *p, uint32_t id, const struct drawn *d)
{
    struct tia_tile part = d->part.area, whole = d->whole.area;
    struct oracle_raster row = oracle;

    for (int y = 0; y < part.height; y++) {
        size_t at = (size_t)(part.y - whole.y + y) * whole.width + part.x - whole.x;
        row.area = (struct tia_tile){part.x, (uint16_t)(part.y + y), part.width, 1};
        row.face = face + at;
        row.stencil = stencil + at;
        row.colour = colour + 3 * at;
        oracle_draw(&row, s, p->v, (int)p->count, id);
    }
    memcpy(oracle.planes[id], row.planes[id], sizeof row.planes[id]);
}

/* True if the pixel has a value: in perspective it may show a corner at infinity, where values are undefined. */
static bool sees_value(const struct shape *p, int x, int y)
{
    return oracle_covers(&oracle.image, p->v, 3, x, y) &&
           (oracle.image.projection == TIA_ORTHOGRAPHIC || oracle_nearness(&oracle.image, p->v, x, y, 1) > 0);
}

static void must_blend(struct bytes *b, const struct drawn *d, const struct shape *p)
{
    const struct tia_tile *part = &d->part.area;
    int32_t a[3] = {take_number(b), take_number(b), take_number(b)};
    struct tia_raster_corners corners;

    if (!tia_raster_corners_init(&corners, &d->grid, p->v))
        return;
    for (int i = 0; i < part->width && i < part->height; i++)
        if (sees_value(p, part->x + i, part->y + i))
            MUST(tia_raster_corners_blend(&corners, part->x + i, part->y + i, a) ==
                 oracle_blend(&oracle.image, p->v, part->x + i, part->y + i, a));
}

/* Checks that two triangles with a common edge, which has opposite directions in them, cover no pixel twice when both
 * are seen from the same side. */
static void must_not_overlap(const struct drawn *d, const struct shape *a, const struct shape *b, unsigned range)
{
    static const struct tia_stencil once = {TIA_COMPARE_ALWAYS,   0, 255, 255, TIA_STENCIL_KEEP, TIA_STENCIL_KEEP,
                                            TIA_STENCIL_INCR_WRAP};
    const struct tia_raster_state front = {.front = once, .back = once, .skip_back = true};
    const struct tia_raster_state back = {.front = once, .back = once, .skip_front = true};
    struct drawn count;

    for (int side = 0; side < 2; side++) {
        open_target(&count, d->part.area, TIA_BUFFER_COUNT, range, true);
        MUST(!tia_raster_draw(&count.part, side ? &back : &front, a->v, a->count, 0));
        MUST(!tia_raster_draw(&count.part, side ? &back : &front, b->v, b->count, 0));
        for (size_t i = 0; i < (size_t)count.whole.area.width * count.whole.area.height; i++)
            MUST(count.whole.count[i] < 2);
        free(count.memory);
    }
}

static bool shares_an_edge(const struct shape *a, const struct shape *b)
{
    return a->count == 3 && b->count == 3 && !memcmp(&a->v[0], &b->v[1], sizeof a->v[0]) &&
           !memcmp(&a->v[1], &b->v[0], sizeof a->v[0]) && memcmp(&a->v[0], &a->v[1], sizeof a->v[0]);
}

static void clear_oracle(void)
{
    memset(face, 255, sizeof face);
    memset(stencil, 0, sizeof stencil);
    memset(colour, 0, sizeof colour);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct bytes b = {data, size};
    struct tia_tile area = take_area(&b);
    unsigned range = take_byte(&b) % 21;
    struct shape shapes[2] = {{.count = 0}, {.count = 0}};
    struct drawn any, wide;
    bool is_right = true;

    clear_oracle();
    open_target(&any, area, BUFFERS, range, true);
    open_target(&wide, area, BUFFERS, range, false);
    for (uint32_t id = 0; id < POLYGONS && b.left && is_right; id++) {
        struct shape *p = &shapes[id % 2], *before = &shapes[1 - id % 2];
        struct tia_raster_state state = take_state(&b);
        take_polygon(&b, &any, before, p);
        int status = is_accepted(&any.grid, p) ? TIA_OK : TIA_ERR_RANGE;
        MUST(tia_raster_draw(&any.part, &state, p->v, p->count, id) == status);
        MUST(tia_raster_draw(&wide.part, &state, p->v, p->count, id) == status);
        if (status) {
            p->count = 0;
            continue;
        }
        must_be_alike(&any, &wide);
        is_right = is_convex(p);
        if (!is_right)
            break;
        draw_oracles(&state, p, id, &any);
        must_be_the_oracles(&any);
        must_blend(&b, &any, p);
        if (shares_an_edge(before, p))
            must_not_overlap(&any, before, p, range);
    }
    free(any.memory);
    free(wide.memory);
    return 0;
}
