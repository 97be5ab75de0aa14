/* technique_map_exact.c - the alias-free map (Aila and Laine 2004; Johnson, Lee, Burns and Mark 2005): its samples are
 * the visible points of a tile's pixels. Points are filed by their cell in the light's view; faces are drawn into that
 * view, enlarged by a cell, and each face is tested exactly (occluder.h) against all points in the cells that it
 * covers. So the result is that of exact rays, and the number of cells affects only the speed. */

/* Derivation that no face is missed. Let a face hide the light from a visible point P. The segment from P to the light
 * meets the face. So as seen from the light, P lies in the face's image, or on its border if the tie rule moved the
 * pixel. P is filed by a rounded position; the centre of its cell is less than a column and a row from P, by
 * tests/proofs/shadow_map_exact.g with the numbers of shadow_ranges.h. (In larger cells, rounding is a smaller part of
 * a cell.) A face is drawn with each edge moved outwards by a column and a row: if e(x, y) >= 0 at P, then e is at
 * least
 * -(|e.x| + |e.y|) at the cell's centre. So the cell is covered, and the face is tested against P.
 *
 * In the view of a point light, a face's image is exact. A point P too near to the light is tested against all faces.
 * For a directional light, corners are rounded. The point where the segment meets the face is a mean of the corners, so
 * its image moves no farther than theirs. Thin faces are drawn as boxes. A point P beyond all corners can be hidden
 * only by planes.
 *
 * No point is hidden wrongly either: the test uses the integers of exact rays. */
#include "math/wide.h"
#include "occluder.h"
#include "places.h"
#include "raster/polygon_rows.h"
#include "raster/target.h"
#include "shadow_ranges.h"
#include "technique.h"

#define VIEWS 6 /* number of views of a point light; a directional one has one view */
#define NONE UINT32_MAX
#define ASIDE (UINT32_MAX - 1) /* not a cell: the point needs none, or is already tested */

/* Links at a pixel's index: `head` is the first pixel in the cell with this index, `next` the pixel that follows this
 * one in its own cell. */
struct filed {
    uint32_t head, next;
};

/* The cells of one view that contain the tile's points. */
struct cells {
    uint32_t count, base, x0, y0, x1, y1; /* number of points; index of the first cell; x0 <= x < x1, y0 <= y < y1 */
    unsigned shift;                       /* a cell's side is 2^shift 2^-CELL_BITS of the view's */
};

struct exact {
    const struct tia_shadow_view *view;
    struct tia_shadow_tile *tile;
    const tia_flat_light *light;
    struct cancel *cancel;
    struct filed *filed;
    uint64_t bit;
    struct tia_places places;
    struct tia_seen_face of; /* face of the last pixel tested */
    bool turned;
    struct cells cells[VIEWS];
    const struct cells *now; /* the cells being drawn into */
    struct tia_occluder occluder;
    uint32_t face;
    bool ready, casts; /* ready: the face's occluder was prepared; casts: the face can hide points */
};

/* ---- filing ---- */

static int x_of(const struct tia_raster_target *t, uint32_t number)
{
    return (int)t->area.x + (int)(number % t->area.width);
}

static int y_of(const struct tia_raster_target *t, uint32_t number)
{
    return (int)t->area.y + (int)(number / t->area.width);
}

static size_t at_of(const struct exact *e, uint32_t number)
{
    const struct tia_raster_target *t = &e->tile->target;

    return target_index(t, x_of(t, number), y_of(t, number));
}

static bool is_hidden(struct exact *e, struct tia_occluder *o, uint32_t number)
{
    const struct tia_raster_target *t = &e->tile->target;
    uint32_t face = t->face[at_of(e, number)];
    struct tia_seen seen;

    if (face == o->face || face == o->flush)
        return false;
    if (face != e->of.face)
        tia_seen_face_init(&e->of, &e->view->flat, face);
    tia_seen_init(&seen, &e->of, x_of(t, number), y_of(t, number));
    return tia_occluder_hides(o, &seen);
}

/* Tests a pixel against all faces, or only against those of planes, which are infinite. */
static void test_all(struct exact *e, uint32_t number, bool endless)
{
    const struct tia_flat_scene *flat = &e->view->flat;
    struct tia_occluder o;

    for (uint32_t i = 0; i < flat->object_count; i++) {
        const struct tia_flat_object *object = &flat->objects[i];
        if (!object->face_count ||
            (endless && !tia_flat_is_direction(flat, &flat->points[flat->faces[object->first_face].corner[1]])))
            continue;
        for (uint32_t f = object->first_face; f < object->first_face + object->face_count; f++)
            if (!cancelled(e->cancel, 1) && tia_occluder_init(&o, flat, e->light, f) && is_hidden(e, &o, number)) {
                e->tile->lit[at_of(e, number)] &= ~e->bit;
                return;
            }
    }
}

static uint32_t cell(int64_t a)
{
    int64_t i = (a + (INT64_C(1) << 28)) >> (29 - CELL_BITS), last = (1 << CELL_BITS) - 1;

    return (uint32_t)(i < 0 ? 0 : i < last ? i : last);
}

/* Returns the view and the smallest cell of a point; ASIDE for a point beyond all corners or too near to the light,
 * which is tested at once. */
static uint32_t find(struct exact *e, uint32_t number, int64_t at[3])
{
    const int64_t limit = (INT64_C(1) << ACROSS_BITS) + (INT64_C(1) << 20);
    int64_t place[2];
    uint32_t view = 0;

    if (e->places.parallel) {
        tia_place_across(&e->places, at, place);
        if (place_size(place[0]) > limit || place_size(place[1]) > limit) {
            test_all(e, number, true);
            return ASIDE;
        }
    } else {
        for (int k = 0; k < 3; k++)
            at[k] -= e->places.origin[k];
        int k = place_largest(at);
        if (place_size(at[k]) >> CELL_NEAR == 0) {
            test_all(e, number, false);
            return ASIDE;
        }
        view = 2 * (uint32_t)k + (at[k] < 0);
        for (int i = 0; i < 2; i++)
            place[i] = wide_quotient(at[(k + 1 + i) % 3], place_size(at[k]), 28);
    }
    return view << 2 * CELL_BITS | cell(-place[1]) << CELL_BITS | cell(place[0]);
}

static void include(struct cells *c, uint32_t x, uint32_t y)
{
    c->x0 = c->count && c->x0 < x ? c->x0 : x;
    c->y0 = c->count && c->y0 < y ? c->y0 : y;
    c->x1 = c->count && c->x1 > x ? c->x1 : x + 1;
    c->y1 = c->count && c->y1 > y ? c->y1 : y + 1;
    c->count++;
}

#define X_OF(spot) ((spot) & ((1u << CELL_BITS) - 1))
#define Y_OF(spot) ((spot) >> CELL_BITS & ((1u << CELL_BITS) - 1))
#define VIEW_OF(spot) ((spot) >> 2 * CELL_BITS)

/* Marks a pixel as lit if its face is turned to the light, and finds the smallest cell of its point. */
static void locate(struct exact *e, uint32_t number)
{
    const struct tia_raster_target *t = &e->tile->target;
    size_t at = at_of(e, number);
    uint32_t face = t->face[at], *spot = &e->filed[at].next;
    int64_t place[3];

    *spot = ASIDE;
    e->filed[at].head = NONE;
    if (face == TIA_NO_FACE)
        return;
    if (face != e->of.face) {
        tia_seen_face_init(&e->of, &e->view->flat, face);
        e->turned = tia_flat_is_turned(&e->view->flat, face, e->light);
    }
    if (!e->turned)
        return;
    e->tile->lit[at] |= e->bit;
    if (!tia_place_seen(&e->places, x_of(t, number), y_of(t, number), face, place))
        test_all(e, number, false);
    else
        *spot = find(e, number, place);
    if (*spot < ASIDE)
        include(&e->cells[VIEW_OF(*spot)], X_OF(*spot), Y_OF(*spot));
}

/* Chooses the sizes of cells so that no view has more cells than points. */
static void choose_sizes(struct exact *e)
{
    uint32_t base = 0;

    for (int i = 0; i < VIEWS; i++) {
        struct cells *c = &e->cells[i];
        c->base = base;
        for (c->shift = 0; c->count; c->shift++) {
            uint32_t columns = ((c->x1 - 1) >> c->shift) - (c->x0 >> c->shift) + 1;
            uint32_t rows = ((c->y1 - 1) >> c->shift) - (c->y0 >> c->shift) + 1;
            if (columns * rows <= c->count)
                break;
        }
        c->x1 = ((c->x1 - 1) >> c->shift) + 1;
        c->y1 = ((c->y1 - 1) >> c->shift) + 1;
        c->x0 >>= c->shift;
        c->y0 >>= c->shift;
        base += c->count;
    }
}

static struct filed *cell_at(const struct exact *e, const struct cells *c, uint32_t x, uint32_t y)
{
    return &e->filed[at_of(e, c->base + (y - c->y0) * (c->x1 - c->x0) + x - c->x0)];
}

static void file(struct exact *e, uint32_t number)
{
    uint32_t *spot = &e->filed[at_of(e, number)].next;

    if (*spot >= ASIDE)
        return;
    const struct cells *c = &e->cells[VIEW_OF(*spot)];
    struct filed *home = cell_at(e, c, X_OF(*spot) >> c->shift, Y_OF(*spot) >> c->shift);
    *spot = home->head;
    home->head = number;
}

/* ---- drawing ---- */

/* Tests the present face against all points filed in a run of cells; removes the hidden points from the cells. */
static void test_run(void *ctx, int y, int x0, int x1)
{
    struct exact *e = ctx;

    for (int x = x0; x < x1; x++)
        for (uint32_t *link = &cell_at(e, e->now, (uint32_t)x, (uint32_t)y)->head; *link != NONE;) {
            size_t at = at_of(e, *link);
            if (!e->ready)
                e->casts = tia_occluder_init(&e->occluder, &e->view->flat, e->light, e->face);
            e->ready = true;
            if (!e->casts || cancelled(e->cancel, 1))
                return;
            if (is_hidden(e, &e->occluder, *link)) {
                e->tile->lit[at] &= ~e->bit;
                *link = e->filed[at].next;
            } else
                link = &e->filed[at].next;
        }
}

static struct tia_tile area_of(const struct cells *c)
{
    return (struct tia_tile){(uint16_t)c->x0, (uint16_t)c->y0, (uint16_t)(c->x1 - c->x0), (uint16_t)(c->y1 - c->y0)};
}

static void test_box(struct exact *e, uint32_t x0, uint32_t y0, uint32_t x1, uint32_t y1)
{
    const struct cells *c = e->now;

    x0 = x0 > c->x0 ? x0 : c->x0;
    x1 = x1 < c->x1 ? x1 : c->x1;
    for (uint32_t y = y0 > c->y0 ? y0 : c->y0; y < y1 && y < c->y1 && x0 < x1; y++)
        test_run(e, (int)y, (int)x0, (int)x1);
}

/* Tests the present face against the points in the box around three corners, enlarged by a cell. */
static void test_around(struct exact *e, const struct tia_raster_vertex *v)
{
    uint32_t x0 = NONE, y0 = NONE, x1 = 0, y1 = 0;

    for (int i = 0; i < 3; i++) {
        uint32_t x = cell(v[i].x) >> e->now->shift, y = cell(-v[i].y) >> e->now->shift;
        x0 = x < x0 ? x : x0;
        y0 = y < y0 ? y : y0;
        x1 = x > x1 ? x : x1;
        y1 = y > y1 ? y : y1;
    }
    test_box(e, x0 ? x0 - 1 : 0, y0 ? y0 - 1 : 0, x1 + 2, y1 + 2);
}

/* Converts a corner to a view of a point light, exactly. */
static void seen_from_point(const struct exact *e, unsigned view, struct tia_raster_vertex *v)
{
    const struct tia_flat_scene *flat = &e->view->flat;
    bool direction = tia_flat_is_direction(flat, v);
    int k = (int)view / 2;
    int64_t d[3], from[3];

    tia_flat_affine(flat, v, d);
    tia_flat_affine(flat, e->light, from);
    for (int i = 0; i < 3 && !direction; i++)
        d[i] -= from[i];
    *v = (struct tia_raster_vertex){d[(k + 1) % 3], d[(k + 2) % 3], view % 2 ? -d[k] : d[k], 0};
}

/* Converts corners to the view of a directional light, rounded. False: the face belongs to a plane, whose image is
 * unbounded. */
static bool is_flattened(const struct exact *e, struct tia_raster_vertex *v, unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        int64_t at[3], place[2];
        if (tia_flat_is_direction(&e->view->flat, &v[i]))
            return false;
        tia_place_of_vertex(&e->places, &v[i], at);
        tia_place_across(&e->places, at, place);
        v[i] = (struct tia_raster_vertex){place[0], place[1], INT64_C(1) << 28, 0};
    }
    return true;
}

/* True if rounding may have changed the orientation of the corners. */
static bool is_thin(const struct tia_raster_vertex *v)
{
    int64_t area = (v[1].x - v[0].x) * (v[2].y - v[0].y) - (v[1].y - v[0].y) * (v[2].x - v[0].x);

    return place_size(area) < INT64_C(1) << ACROSS_THIN;
}

static void draw(struct exact *e, const struct tia_raster_grid *grid, uint32_t face)
{
    struct tia_raster_vertex v[TIA_SIDES];
    unsigned count = tia_flat_corners(&e->view->flat, face, v);
    struct polygon p;

    e->face = face;
    e->ready = false;
    if (e->places.parallel && !is_flattened(e, v, count)) {
        test_box(e, e->now->x0, e->now->y0, e->now->x1, e->now->y1);
        return;
    }
    if (e->places.parallel && is_thin(v)) {
        test_around(e, v);
        return;
    }
    for (unsigned i = 0; i < count && !e->places.parallel; i++)
        seen_from_point(e, (unsigned)(e->now - e->cells), &v[i]);
    if (!tia_polygon_init_enlarged(&p, grid, area_of(e->now), v, count) && p.count)
        tia_polygon_rows(&p, test_run, e);
}

/* Draws an object. If its silhouette suffices, only the faces turned to the light are drawn, as every blocked ray meets
 * one. */
static void draw_object(struct exact *e, const struct tia_raster_grid *grid, const struct tia_flat_object *object)
{
    const struct tia_flat_scene *flat = &e->view->flat;
    bool closed = tia_flat_has_silhouette(flat, object, e->light);

    for (uint32_t n = 0; n < object->face_count && !cancelled(e->cancel, 1); n++) {
        uint32_t face = object->first_face + n;
        if (!closed || tia_flat_side(flat, &flat->faces[face], e->light) > 0)
            draw(e, grid, face);
    }
}

static void draw_view(struct exact *e, unsigned view)
{
    const struct tia_flat_scene *flat = &e->view->flat;
    struct tia_raster_grid grid;
    unsigned side = 1u << (CELL_BITS - e->cells[view].shift);

    e->now = &e->cells[view];
    if (!e->now->count ||
        tia_raster_grid_init(&grid, e->places.parallel ? TIA_ORTHOGRAPHIC : TIA_PERSPECTIVE, side, side, 1, 0, 1))
        return;
    for (uint32_t i = 0; i < flat->object_count && !e->cancel->stopped; i++)
        if (!tia_flat_hides_nothing(flat, &flat->objects[i], e->light))
            draw_object(e, &grid, &flat->objects[i]);
}

/* ---- the technique ---- */

static uint64_t own_size(const struct tia_scene *scene)
{
    (void)scene;
    return 0;
}

static int nothing(struct tia_shadow_view *view, struct cancel *cancel)
{
    (void)view;
    (void)cancel;
    return TIA_OK;
}

static void light(const struct tia_shadow_view *view, struct tia_shadow_tile *tile, unsigned sample,
                  struct cancel *cancel)
{
    uint32_t pixels = (uint32_t)tile->target.area.width * tile->target.area.height;
    struct exact e = {.view = view,
                      .tile = tile,
                      .light = &view->samples[sample],
                      .cancel = cancel,
                      .filed = tile->more,
                      .bit = UINT64_C(1) << sample};

    e.of.face = TIA_NO_FACE;
    tia_places_init(&e.places, &view->flat, e.light);
    for (uint32_t i = 0; i < pixels && !cancelled(cancel, 1); i++)
        locate(&e, i);
    choose_sizes(&e);
    for (uint32_t i = 0; i < pixels && !cancel->stopped; i++)
        file(&e, i);
    for (unsigned i = 0; i < VIEWS && !cancel->stopped; i++)
        draw_view(&e, i);
}

const struct tia_shadow_technique tia_shadow_exact_maps = {
    .own_size = own_size, .prepare = nothing, .set_lights = nothing, .light = light, .scratch = sizeof(struct filed)};
