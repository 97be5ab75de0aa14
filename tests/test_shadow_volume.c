/* Shadow volumes against exact rays: what a pixel sees, and whether a face lies between that and the light, tried with
 * every face in integers of 128 bits. Corners are small enough for those, and many lie on pixel centres, in one plane,
 * in the plane of the light or the eye. Rays that meet an edge are moved to the right by less than anything, then down.
 */
#include <stdlib.h>

#include "check.h"
#include "random.h"
#include "shadow/volume.h"

__extension__ typedef __int128 big;

#define SIZE 24 /* of the image */
#define FACES 64
#define POINTS (3 * FACES)

static int32_t below(int32_t n)
{
    return (int32_t)(random_bits() % (uint64_t)n);
}

/* ---- the oracle ---- */

struct big3 {
    big x, y, z;
};

/* What a linear function of the direction is there, and how it grows to the right and then down. */
struct at_pixel {
    big value, right, down;
};

static struct big3 vector(const struct tia_raster_vertex *v)
{
    return (struct big3){v->x, v->y, v->w};
}

static struct big3 cross(struct big3 a, struct big3 b)
{
    return (struct big3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static big dot(struct big3 a, struct big3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static int sign(big a)
{
    return (a > 0) - (a < 0);
}

static int sign_at(struct at_pixel a)
{
    return a.value ? sign(a.value) : a.right ? sign(a.right) : sign(a.down);
}

/* Pixel (i, j) of a square image looks along (2 i + 1 - SIZE, SIZE - 1 - 2 j, SIZE). */
static struct at_pixel along(struct big3 n, int i, int j)
{
    return (struct at_pixel){dot(n, (struct big3){2 * i + 1 - SIZE, SIZE - 1 - 2 * j, SIZE}), 2 * n.x, -2 * n.y};
}

/* The plane n.(x, y, w) = d h. A pixel D sees it at (D, s) with the nearness s = n.D/d, whatever the projection. */
struct plane {
    struct big3 n;
    big d;
};

static struct plane through(const struct tia_raster_vertex *a, const struct tia_raster_vertex *b,
                            const struct tia_raster_vertex *c)
{
    struct big3 p = vector(a), q = vector(b), r = vector(c), u = cross(q, r), v = cross(r, p), w = cross(p, q);

    return (struct plane){{a->h * u.x + b->h * v.x + c->h * w.x, a->h * u.y + b->h * v.y + c->h * w.y,
                           a->h * u.z + b->h * v.z + c->h * w.z},
                          dot(u, p)};
}

static int side(struct plane p, const struct tia_raster_vertex *v)
{
    return sign(dot(p.n, vector(v)) - p.d * v->h);
}

/* The side on which a plane has what is seen of another: n.D - d s with s = seen.n.D/seen.d. */
static int side_of_seen(struct plane p, struct plane seen, int i, int j)
{
    struct at_pixel a = along(p.n, i, j), b = along(seen.n, i, j);
    struct at_pixel difference = {a.value * seen.d - p.d * b.value, a.right * seen.d - p.d * b.right,
                                  a.down * seen.d - p.d * b.down};

    return sign_at(difference) * sign(seen.d);
}

struct world {
    struct tia_flat_scene flat;
    tia_flat_light light;
};

static unsigned sides_of(const struct world *w, uint32_t f)
{
    return tia_face_sides(&w->flat.faces[f]);
}

static const struct tia_raster_vertex *corner(const struct world *w, uint32_t f, unsigned k)
{
    return &w->flat.points[w->flat.faces[f].corner[k % sides_of(w, f)]];
}

static struct plane plane_of(const struct world *w, uint32_t f)
{
    return through(corner(w, f, 0), corner(w, f, 1), corner(w, f, 2));
}

static bool covers(const struct world *w, uint32_t f, int i, int j)
{
    int turn = sign(plane_of(w, f).d);

    if (w->flat.eye.projection == TIA_ORTHOGRAPHIC && along(plane_of(w, f).n, i, j).value * turn > 0)
        return false; /* it is behind the window */
    for (unsigned k = 0; turn && k < sides_of(w, f); k++)
        if (sign_at(along(cross(vector(corner(w, f, k)), vector(corner(w, f, k + 1))), i, j)) != turn)
            return false;
    return turn != 0;
}

/* Whether f is nearer than g where both are met. The lower number of two in one plane. */
static bool is_nearer(const struct world *w, uint32_t f, uint32_t g, int i, int j)
{
    int order = side_of_seen(plane_of(w, f), plane_of(w, g), i, j) * sign(plane_of(w, f).d);

    return order ? order > 0 : f < g;
}

static uint32_t find_seen(const struct world *w, int i, int j)
{
    uint32_t seen = TIA_NO_FACE;

    for (uint32_t f = 0; f < w->flat.face_count; f++)
        if (covers(w, f, i, j) && (seen == TIA_NO_FACE || is_nearer(w, f, seen, i, j)))
            seen = f;
    return seen;
}

/* Whether face f is between what is seen and the light. */
static bool hides(const struct world *w, uint32_t f, struct plane seen, int i, int j)
{
    struct plane cap = plane_of(w, f);
    int toward = side(cap, &w->light), first = 0;

    if (!toward || side_of_seen(cap, seen, i, j) != -toward)
        return false;
    for (unsigned k = 0; k < sides_of(w, f); k++) {
        int at = side_of_seen(through(corner(w, f, k), corner(w, f, k + 1), &w->light), seen, i, j);
        if (at == 0 || (k > 0 && at != first))
            return false;
        first = at;
    }
    return true;
}

static bool is_lit(const struct world *w, uint32_t face, int i, int j)
{
    static const struct tia_raster_vertex eye = {0, 0, 0, 1};
    struct plane seen = plane_of(w, face);

    if (!seen.d || side(seen, &w->light) != side(seen, &eye))
        return false;
    for (uint32_t f = 0; f < w->flat.face_count; f++)
        if (f != face && hides(w, f, seen, i, j))
            return false;
    return true;
}

/* ---- scenes ---- */

static struct tia_flat_face faces[FACES];
static struct tia_flat_object objects[FACES];
static struct tia_raster_vertex points[POINTS];
static uint32_t across[TIA_SIDES * FACES];

/* Points and directions as they are in perspective; in orthographic views h is what w was. */
static struct tia_raster_vertex vertex(const struct world *w, int64_t x, int64_t y, int64_t z, bool point)
{
    if (w->flat.eye.projection == TIA_ORTHOGRAPHIC)
        return (struct tia_raster_vertex){x, y, point ? INT64_C(1) << w->flat.lattice.fraction : 0, z};
    return (struct tia_raster_vertex){x, y, z, point};
}

static void begin(struct world *w, enum tia_projection projection)
{
    *w = (struct world){.flat = {.objects = objects, .faces = faces, .across = across, .points = points}};
    w->flat.eye.projection = projection;
    CHECK(!tia_lattice_init(&w->flat.lattice, projection, SIZE, SIZE, 1, 0, projection == TIA_ORTHOGRAPHIC ? 20 : 5));
}

/* Whole multiples of step, of a scene that reaches `range` to all sides and from a bit behind the eye. */
static void any_place(const struct world *w, int32_t range, int32_t step, int64_t at[3])
{
    for (int k = 0; k < 3; k++)
        at[k] = (int64_t)(below(2 * range + 1) - (k == 2 ? range / 3 : range)) * step;
    if (w->flat.eye.projection == TIA_ORTHOGRAPHIC)
        at[2] = -at[2];
}

static void add_point(struct world *w, int64_t x, int64_t y, int64_t z, bool point)
{
    points[w->flat.point_count++] = vertex(w, x, y, z, point);
}

/* The points were added just before. */
static void add_object(struct world *w, const uint8_t (*corners)[4], uint32_t count, uint32_t point_count)
{
    struct tia_flat_scene *f = &w->flat;
    struct tia_flat_object *o = &objects[f->object_count++];
    uint32_t first = f->point_count - point_count;

    *o = (struct tia_flat_object){.first_face = f->face_count, .face_count = count};
    for (uint32_t i = 0; i < count; i++)
        for (int k = 0; k < TIA_SIDES; k++)
            faces[f->face_count + i].corner[k] =
                k == 3 && !corners[i][3] ? TIA_NO_CORNER : first + corners[i][k]; /* the last is never point 0 */
    f->face_count += count;
    for (int k = 0; k < 3; k++) {
        o->low[k] = INT64_MAX;
        o->high[k] = INT64_MIN;
    }
    for (uint32_t i = first; i < f->point_count; i++) {
        int64_t p[3];
        tia_flat_affine(f, &points[i], p);
        for (int k = 0; k < 3; k++) {
            o->low[k] = p[k] < o->low[k] ? p[k] : o->low[k];
            o->high[k] = p[k] > o->high[k] ? p[k] : o->high[k];
        }
    }
}

static void end(struct world *w, int32_t range, int32_t step)
{
    void *room = malloc(tia_edges_room(w->flat.face_count));
    int64_t at[3];

    (void)tia_edges_join(across, faces, w->flat.face_count, room);
    free(room);
    for (uint32_t i = 0; i < w->flat.object_count; i++) {
        struct tia_flat_object *o = &objects[i];
        o->closed = true;
        for (uint32_t e = TIA_SIDES * o->first_face; e < TIA_SIDES * (o->first_face + o->face_count); e++)
            o->closed = o->closed && (e % TIA_SIDES == 3 || across[e] != TIA_NO_EDGE);
    }
    any_place(w, range, step, at);
    bool point = below(4) != 0;
    w->light = vertex(w, at[0], at[1], at[2] + (!point && !at[0] && !at[1] && !at[2]), point);
}

static void make_soup(struct world *w, uint32_t count, int32_t range, int32_t step)
{
    static const uint8_t triangle[1][4] = {{0, 1, 2}};

    for (uint32_t i = 0; i < count; i++) {
        for (int k = 0; k < 3; k++) {
            int64_t at[3];
            any_place(w, range, step, at);
            add_point(w, at[0], at[1], at[2], true);
        }
        add_object(w, triangle, 1, 3);
    }
}

/* Boxes, or what becomes of them when all corners move. */
static void make_solids(struct world *w, uint32_t count, int32_t range, int32_t step, int32_t jitter)
{
    static const uint8_t box[12][4] = {{0, 6, 4}, {0, 2, 6}, {1, 5, 7}, {1, 7, 3}, {0, 5, 1}, {0, 4, 5},
                                       {2, 7, 6}, {2, 3, 7}, {0, 1, 3}, {0, 3, 2}, {4, 7, 5}, {4, 6, 7}};

    for (uint32_t i = 0; i < count; i++) {
        int64_t low[3], size[3];
        any_place(w, range, step, low);
        any_place(w, range, step, size);
        for (int k = 0; k < 8; k++) {
            int64_t at[3];
            for (int c = 0; c < 3; c++)
                at[c] = low[c] + (k >> c & 1 ? llabs(size[c]) + step : 0) + below(jitter + 1);
            add_point(w, at[0], at[1], at[2], true);
        }
        add_object(w, box, 12, 8);
    }
}

/* A plane in two halves, all of it; it goes through a point between the others. */
static void make_plane(struct world *w, int32_t range, int32_t step)
{
    static const uint8_t halves[2][4] = {{0, 1, 2, 3}, {0, 3, 4, 1}};
    int64_t at[3], a[3], b[3];

    any_place(w, range, step, at);
    any_place(w, range, step, a);
    any_place(w, range, step, b);
    add_point(w, at[0], at[1], at[2], true);
    add_point(w, a[0], a[1], a[2], false);
    add_point(w, b[0], b[1], b[2], false);
    add_point(w, -a[0], -a[1], -a[2], false);
    add_point(w, -b[0], -b[1], -b[2], false);
    add_object(w, halves, 2, 5);
}

/* ---- what is compared ---- */

struct tally {
    uint32_t worlds, pixels, seen, dark, faces_wrong, wrong[2], unsure[2];
};

/* A technique: z-fail or z-pass, and how many volumes hold where rays end or start. */
struct technique {
    struct tia_raster_target target;
    void *memory;
    uint32_t count;
    bool sure;
};

static bool is_lit_by(const struct technique *t, size_t at)
{
    return (uint8_t)(t->target.stencil[at] + t->count) == 0;
}

static void compare_pixel(const struct world *w, const struct technique how[2], int i, int j, struct tally *t)
{
    size_t at = (size_t)j * SIZE + (size_t)i;
    uint32_t face = find_seen(w, i, j);

    t->pixels++;
    t->faces_wrong += how[0].target.face[at] != face;
    if (face == TIA_NO_FACE)
        return;
    const struct tia_flat_face *f = &w->flat.faces[face];
    bool turned = tia_flat_side(&w->flat, f, &w->light) == tia_flat_side_of_eye(&w->flat, f);
    bool lit = is_lit(w, face, i, j);
    t->seen++;
    t->dark += !lit;
    for (int k = 0; k < 2; k++)
        t->wrong[k] += how[k].sure && (turned && is_lit_by(&how[k], at)) != lit;
}

static void prepare(struct technique *how, const struct world *w)
{
    struct tia_tile all = {0, 0, SIZE, SIZE};
    unsigned buffers = TIA_BUFFER_DEPTH | TIA_BUFFER_STENCIL;
    size_t size = tia_raster_size(all, buffers, w->flat.face_count);

    how->memory = malloc(size);
    CHECK(!tia_raster_init(&how->target, how->memory, size, &w->flat.lattice, all, buffers, w->flat.face_count));
    CHECK(!tia_shadow_faces(&how->target, &w->flat));
}

static void compare(const struct world *w, struct tally *t)
{
    struct technique how[2];

    for (int k = 0; k < 2; k++)
        prepare(&how[k], w);
    CHECK(!tia_shadow_zfail(&how[0].target, &w->flat, &w->light));
    CHECK(!tia_shadow_zpass(&how[1].target, &w->flat, &w->light));
    how[0].sure = tia_shadow_count_far(&w->flat, &w->light, &how[0].count);
    how[1].sure = tia_shadow_count_eye(&w->flat, &w->light, &how[1].count);
    t->worlds++;
    for (int j = 0; j < SIZE; j++)
        for (int i = 0; i < SIZE; i++)
            compare_pixel(w, how, i, j, t);
    for (int k = 0; k < 2; k++) {
        t->unsure[k] += !how[k].sure;
        free(how[k].memory);
    }
}

static void check_tally(const struct tally *t, bool ties, bool flat)
{
    CHECK_EQ(t->faces_wrong, 0);
    CHECK_EQ(t->wrong[0], 0);
    CHECK_EQ(t->wrong[1], 0);
    CHECK_MSG(t->seen > t->pixels / 20 && t->dark > t->seen / 8 && t->dark < t->seen - t->seen / 20,
              "%u of %u see a face, %u are dark", t->seen, t->pixels, t->dark);
    for (int k = 0; k < 2; k++)
        CHECK_MSG(ties && (k || flat) ? t->unsure[k] > 4 && t->unsure[k] < t->worlds / 2 : !t->unsure[k],
                  "%u of %u unsure", t->unsure[k], t->worlds);
}

enum contents { SOUP, SOLIDS, CROOKED, MIXED };

static void make(struct world *w, enum contents contents, int32_t range, int32_t step)
{
    if (contents == SOUP || contents == MIXED)
        make_soup(w, 1 + (uint32_t)below(contents == MIXED ? 5 : 13), range, step);
    if (contents != SOUP)
        make_solids(w, 2 + (uint32_t)below(3), range * 2 / 3, step, contents == CROOKED ? range / 5 : 0);
    if (contents == MIXED)
        make_plane(w, range, step);
}

static void check_worlds(enum tia_projection projection, enum contents contents, bool lattice)
{
    int32_t step = lattice ? projection == TIA_ORTHOGRAPHIC ? 128 : 96 : 1, range = lattice ? 4 : 500;
    struct tally t = {0};
    struct world w;

    for (int round = 0; round < 200; round++) {
        begin(&w, projection);
        make(&w, contents, range, step);
        end(&w, range, step);
        compare(&w, &t);
    }
    check_tally(&t, lattice, projection == TIA_ORTHOGRAPHIC);
}

TEST(soups)
{
    check_worlds(TIA_PERSPECTIVE, SOUP, false);
    check_worlds(TIA_ORTHOGRAPHIC, SOUP, false);
}

TEST(soups_with_ties)
{
    check_worlds(TIA_PERSPECTIVE, SOUP, true);
    check_worlds(TIA_ORTHOGRAPHIC, SOUP, true);
}

TEST(solids)
{
    check_worlds(TIA_PERSPECTIVE, SOLIDS, false);
    check_worlds(TIA_ORTHOGRAPHIC, SOLIDS, false);
    check_worlds(TIA_PERSPECTIVE, CROOKED, false);
    check_worlds(TIA_ORTHOGRAPHIC, CROOKED, false);
}

TEST(solids_with_ties)
{
    check_worlds(TIA_PERSPECTIVE, SOLIDS, true);
    check_worlds(TIA_ORTHOGRAPHIC, SOLIDS, true);
}

TEST(planes_and_all)
{
    check_worlds(TIA_PERSPECTIVE, MIXED, false);
    check_worlds(TIA_ORTHOGRAPHIC, MIXED, false);
    check_worlds(TIA_PERSPECTIVE, MIXED, true);
    check_worlds(TIA_ORTHOGRAPHIC, MIXED, true);
}

int main(void)
{
    RUN(soups);
    RUN(soups_with_ties);
    RUN(solids);
    RUN(solids_with_ties);
    RUN(planes_and_all);
    return check_status();
}
