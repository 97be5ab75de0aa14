/* src/simd/rays, rays and points chosen for one bound each, moved by all that it allows: shapes that random rays hardly
 * ever hit at the end of a bound, and coordinates of textures, against the fixed-point code; the brightest rays, and
 * the hits that are still shaded. */
#include "ray_edges.h"

#include "float_modes.h"
#include "ray_steps.h"
#include "render/trace/texture.h"

#define WITHIN .9999L /* used part of a bound */

/* ---- rays: certain results are true of the fixed-point ray ---- */

#define CELL "grid g size 1 1 1 corner 0 0 0 cell 0.1\nrow 1\nend\n"
#define FLOOR "mesh g\nvertex -9 0 -9\nvertex 0 0 9\nvertex 9 0 -9\nface 1 2 3\nend\n"

/* The fixed-point ray, whose d may have any length; the certified one starts eo beside it in the direction `off` and is
 * turned by ed there. An object far away enlarges the scene, so that its boxes allow this. */
static const struct end {
    const char *name, *shape;
    double o[3], d[3], off[3], eo, ed;
    const char *behind; /* other objects of the scene */
} ends[] = {
    {"past a small sphere", "sphere centre 0 0 0 radius 0.00006", {0, 0, 2}, {0, 0, -1}, {1, 0, 0}, 0.01, 0},
    {"turned past a small sphere", "sphere centre 0 0 0 radius 0.00006", {0, 0, 2}, {0, 0, -1}, {1, 0, 0}, 0, 0.002},
    {"out of a needle",
     "cylinder base 0 0 0 top 0 0 1 radius 0.001 capped",
     {0, 0, 0.999},
     {0, 0, 1},
     {0, 0, 1},
     0.02,
     0},
    {"out of a cone",
     "cone base 0 0 0 top 0 0 1 radii 0.01 0.001 capped",
     {0, 0, 0.999},
     {0, 0, 1},
     {0, 0, 1},
     0.02,
     0},
    {"out of a cone's base",
     "cone base 0 0 0 top 0 0 1 radii 0.01 0.001 capped",
     {0, 0, 0.001},
     {0, 0, -1},
     {0, 0, -1},
     0.02,
     0},
    {"to a cylinder's side close by",
     "cylinder base 0 0 -1 top 0 0 1 radius 1",
     {1.000000015, 0, 0},
     {-0.002, 1, 0},
     {-1, 0, 0},
     0,
     0.001},
    {"to a cone's top",
     "cone base 0 0 0 top 0 0.1 0 radii 4 3.9 capped",
     {0, 0.01, 0},
     {2, 0.09, 0},
     {0, -1, 0},
     0,
     0.001},
    {"to a cone's side",
     "cone base 0 0 0 top 0 2 0 radii 0.3 0.2 capped",
     {0, 0.01, 0},
     {0.3, 1, 0},
     {-1, 0.3, 0},
     0,
     0.001},
    {"out of a cylinder's top, just before a plane",
     "cylinder base 0 0 0 top 0 0 1 radius 1 capped",
     {0, 0, 0.995},
     {1, 0, 0.01},
     {0, 0, -1},
     0.01,
     0,
     "plane point 0.8 0 0 normal 1 0 0 material plain\n"},
    {"under a grid", CELL, {-0.1, -0.0001, 0.05}, {1, 0, 0}, {0, 1, 0}, 0.01, 0},
    {"turned under a grid", CELL, {-4, -0.00001, 0.05}, {1, 0, 0}, {0, 1, 0}, 0, 0.00125},
    {"falling onto a grid", CELL, {-4, 0.103, 0.05}, {1, -0.00125, 0}, {0, 1, 0}, 0, 0.00125},
    {"out of a grid, just before a plane",
     CELL,
     {0.03, 0.095, 0.05},
     {1, 0.1, 0.1},
     {0, -1, 0},
     0.0004,
     0,
     "plane point 0.0805 0.10005 0.05505 normal 1 0.1 0.1 material plain\n"},
    {"to a plane close by", "plane point 0 0 0 normal 0 1 0", {0, 0.001, 0}, {1, -1, 0}, {0, -1, 0}, 0.01, 0},
    {"down to a plane", "plane point 0 0 0 normal 0 1 0", {0, 0.1, 0}, {1, -0.0001, 0}, {0, 1, 0}, 0, 0.0003},
    {"to a level mesh close by", FLOOR, {0, 0.005, 0}, {1, -1, 0}, {0, -1, 0}, 0.01, 0},
    {"from under a level mesh", FLOOR, {0, -0.005, 0}, {1, 1, 0}, {0, 1, 0}, 0.01, 0},
    {"down to a level mesh", FLOOR, {0, 0.0001, 0}, {1, -0.0001, 0}, {0, 1, 0}, 0, 0.0003},
    {"up to a level mesh", FLOOR, {0, -0.0001, 0}, {1, 0.0001, 0}, {0, -1, 0}, 0, 0.0003},
    {"past a triangle", "triangle a 0 0.5 0 b -1 0 0 c 1 0 0", {0, -0.001, 2}, {0, 0, -1}, {0, 1, 0}, 0.01, 0},
    {"turned past a triangle", "triangle a 0 0.5 0 b -1 0 0 c 1 0 0", {0, -0.001, 9}, {0, 0, -1}, {0, 1, 0}, 0, 0.002},
};

static void open_text(const char *name, const char *text)
{
    const struct world world = {name, text};

    open_world(&world);
}

static struct real3 real3_of(const double v[3], long double by)
{
    return (struct real3){{v[0] * by, v[1] * by, v[2] * by}};
}

/* Gives the certified ray: the fixed-point ray, whose origin is moved by `part` of eo and which is turned by `part` of
 * ed. */
static void move(const struct end *end, const struct ray *ray, double part, struct packet *p)
{
    double at[3], to[3], length = 0, eo = end->eo * part * (double)unit, ed = end->ed * part;

    *p = (struct packet){.eo = eo + P2M(44), .ed = ed * 1.0001 + P2M(50), .from = {-1, 0, 0}};
    sure_point(at, ray->origin);
    sure_dir(to, ray->direction);
    for (int i = 0; i < 3; i++) {
        at[i] += eo * (double)WITHIN * end->off[i];
        to[i] += ed * (double)WITHIN * end->off[i];
        length += to[i] * to[i];
    }
    p->o = v3_set(at);
    p->d = v3_scale(v3_set(to), 1 / sqrt(length));
}

static void check_end(const struct end *end, struct used *distances)
{
    const char *far = "sphere centre -30 -30 -30 radius 8 material plain";
    bool made = !strncmp(end->shape, "grid", 4) || !strncmp(end->shape, "mesh", 4);
    char text[500];
    struct hit hit;

    (void)snprintf(text, sizeof text, "%s%s material plain\n%s%s\n", made ? end->shape : "",
                   made ? "instance g" : end->shape, end->behind ? end->behind : "", far);
    open_text(end->name, text);
    struct ray ray = {place(real3_of(end->o, unit)), towards(real3_of(end->d, 1))};
    meet(&ray, &hit);
    for (int i = 0; i <= 1024; i++) {
        struct packet p;
        struct query q;
        move(end, &ray, i / 1024.0, &p);
        find_nearest(scene, &lights.room, &q, &p, 1);
        bool sky = q.t >= INFINITE && q.low >= INFINITE, met = hit.object != TIA_NO_OBJECT;
        if (!sky && !(q.t + q.e < q.low)) {
            distances->open++;
            continue;
        }
        CHECK_MSG(sky != met, "%s: %d/1024 of the bound: surely %s", end->name, i, sky ? "nothing" : "something");
        use(distances, met ? sure_length(hit.t) - q.t : 0, q.e + P2M(46));
    }
    close_world();
}

TEST(rays)
{
    struct used distances = {.name = "distance"};

    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++)
        check_end(&ends[i], &distances);
    check_used(&distances);
}

/* ---- textures ---- */

/* Textured shapes, and the points to test: within `size` of `centre` in the axes of the shape, times its unit. They lie
 * around shapes whose texture coordinates are those of the direction, and in faces, of which `element` is any. */
static const struct textured {
    const char *name, *shape;
    uint32_t element;
    double centre[3], size[3];
} surfaces[] = {
    {"plane", "plane point 0 -0.5 0 normal 0.1 1 0", 0, {0, 0, 0}, {1, 1, 1}},
    {"disc", "disc centre 0.2 0.3 0 normal 0.5 0.1 1 radius 0.8", 0, {0.2, 0.3, 0}, {0.5, 0.5, 0.5}},
    {"long box", "box min -0.4 -0.3 -0.01 max 0.5 0.4 0.01", 0, {0, 0, 0}, {0.3, 0.3, 0.01}},
    {"flat box", "box min -0.4 -0.03 -0.4 max 0.5 0.04 0.2", 3, {0, 0, 0}, {0.3, 0.03, 0.1}},
    {"sphere", "sphere centre 0.3 0 0 radius 0.9", 0, {0.3, 0, 0}, {0.5, 0.5, 0.5}},
    {"sphere's pole", "sphere centre 0 0 0 radius 1", 0, {0, 0, 0}, {0.1, 1, 0.1}},
    {"sphere's seam", "sphere centre 0 0 0 radius 1", 0, {-1, 0, 0}, {0.5, 0.5, 0.001}},
    {"cylinder",
     "cylinder base -0.4 -0.1 0 top 0.5 0.5 0.2 radius 0.3 capped",
     ROUND_SIDE,
     {0, 0.2, 0},
     {0.4, 0.4, 0.4}},
    {"short cylinder", "cylinder base 0 0 0 top 0 0.01 0 radius 0.8 capped", ROUND_SIDE, {0, 0, 0}, {0.8, 0.1, 0.8}},
    {"needle's cap", "cylinder base 0 0 0 top 0.3 1 0 radius 0.01 capped", ROUND_BASE, {0, 0, 0}, {0.01, 0.01, 0.01}},
    {"cone's top", "cone base 0 0 0 top 0 1 0 radii 0.5 0.2 capped", ROUND_TOP, {0, 1, 0}, {0.2, 0.1, 0.2}},
    {"triangle", "triangle a 0 0 0 b 1 0.1 0 c 0 1 0", 0, {0.3, 0.3, 0}, {0.29, 0.29, 0}},
    {"large triangle", "triangle a 0 0 0 b 3000 300 0 c 0 3000 0", 0, {900, 900, 0}, {870, 870, 0}},
    {"triangle's edge", "triangle a 0 0 0 b 1 0.1 0 c 0 1 0", 0, {0.3, 0.5, 0}, {0.3, 0.5, 0}},
    {"face",
     "instance f material squares\nmesh f\nvertex 0 0 0\nvertex 1 0 0.1\nvertex 0 1 0\nuv 0 0\nuv 3 0\nuv 0 0\n"
     "face 1/1 2/2 3/3\nend",
     0,
     {0.3, 0.3, 0.03},
     {0.29, 0.29, 0}},
};

/* True if the point is inside the face, as that of a certain hit is. */
static bool is_in_face(const struct sure_object *o, const double at[3])
{
    long double part[3], least = 1;

    if (o->kind != SURE_MESH && o->kind != SURE_TRIANGLE)
        return true;
    const struct sure_face whole = o->kind == SURE_MESH ? sure_face_of(o->mesh, 0) : *o->face, *f = &whole;
    for (int i = 0; i < 3; i++) {
        const double *a = f->at[(i + 1) % 3], *b = f->at[(i + 2) % 3];
        part[i] = (a[0] - at[0]) * (long double)(b[1] - at[1]) - (a[1] - at[1]) * (long double)(b[0] - at[0]);
        least = fminl(least, part[i]);
    }
    return least >= 0;
}

static void try_coordinates(const struct textured *surface, struct used *u)
{
    const struct hit hit = {.object = 0, .light = TIA_NO_OBJECT, .element = surface->element};
    struct texture_point p = {&scene->object[0], surface->element, {0, 0, 0}, (double)unit * some_size(6, 30)};
    struct real off = real_random();
    struct coordinates c;
    struct real3 theirs;
    num_length uv[2];

    if (random_bits() % 2)
        off = (struct real){{random_bits() % 3 == 0, random_bits() % 2, 0}};
    if (real_dot(off, off) == 0)
        off.v[2] = 1;
    for (int i = 0; i < 3; i++) {
        p.at[i] = (double)unit * (surface->centre[i] + surface->size[i] * random_double());
        theirs.v[i] = (p.at[i] + p.e * WITHIN / sqrtl(real_dot(off, off)) * off.v[i] * (long double)some_sign());
    }
    p.e += 2 * SURE_UNIT; /* the fixed-point point is rounded */
    if (!is_in_face(p.object, p.at))
        return;
    if (!coordinates_of(&p, &c)) {
        u->open++;
        return;
    }
    ray_uv(view, &hit, place(theirs), uv);
    for (int i = 0; i < 2; i++)
        use(u, sure_length(uv[i]) - c.uv[i], c.e);
}

TEST(coordinates)
{
    for (size_t i = 0; i < sizeof surfaces / sizeof *surfaces; i++) {
        const struct textured *s = &surfaces[i];
        struct used u = {.name = s->name};
        char text[500];
        (void)snprintf(text, sizeof text, "%s%s\n", s->shape,
                       strncmp(s->shape, "instance", 8) ? " material squares" : "");
        open_text(s->name, text);
        for (int k = 0; k < 10000; k++)
            try_coordinates(s, &u);
        close_world();
        check_used(&u);
    }
}

/* Tests an image of four texels, blended, on a plane: the change of its value where the coordinates are off. */
static void try_blend(struct used *u)
{
    static const uint8_t texels[12] = {255, 255, 0, 0, 0, 0, 0, 255, 0, 255, 255, 255};
    const struct tia_texture t = {.kind = TIA_IMAGE,
                                  .repeat = {TIA_Q16_ONE, TIA_Q16_ONE},
                                  .bilinear = true,
                                  .width = 2,
                                  .height = 2,
                                  .texels = texels};
    const struct sure_material m = {.texture = &t, .repeat = {1, 1}};
    struct texture_point p = {&scene->object[0], 0, {0, 0, 0}, (double)unit * some_size(4, 30)};
    struct coordinates c;
    struct texture_place place = {.bits = 0};
    num_length value[3];
    double rgb[3], e;

    for (int i = 0; i < 3; i++)
        p.at[i] = (double)unit * random_double();
    (void)coordinates_of(&p, &c);
    if (!texture_colour(&m, &p, rgb, &e)) {
        u->open++;
        return;
    }
    for (int i = 0; i < 2; i++)
        place.at[i] = (num_length)((c.uv[i] + (double)WITHIN * c.e * some_sign()) / SURE_UNIT);
    (void)ray_texture(&t, &place, value);
    for (int i = 0; i < 3; i++)
        use(u, sure_length(value[i]) - rgb[i], e + P2M(44));
}

TEST(blends)
{
    struct used u = {.name = "blend of texels"};

    open_text("plane", "plane point 0 0 0 normal 0 0 1 material squares\n");
    for (int i = 0; i < 20000; i++)
        try_blend(&u);
    close_world();
    check_used(&u);
}

/* ---- the brightest rays ---- */

/* Tests two mirrors that emit light, after `depth` bounces. */
static void try_brightest(unsigned depth)
{
    char text[300];
    num_length colour[3];
    struct world world = {"mirrors", text};

    (void)snprintf(text, sizeof text,
                   "depth %u\nmaterial bright colour 0 mirror 0.8 emission 0.7\n"
                   "plane point 0 0 -1 normal 0 0 1 material bright\nplane point 0 0 20 normal 0 0 1 material bright\n",
                   depth);
    open_world(&world);
    tia_sure_sample(view, 32, 32, 0, colour);
    long double sum = 0.7L * (1 - powl(0.8L, depth + 1)) / 0.2L;
    CHECK_MSG(fabsl(sure_length(colour[1]) - sum) < 1e-4L, "%f after %u bounces", sure_length(colour[1]), depth);
    for (int c = 0; c < 3; c++)
        CHECK_MSG(sure_length(colour[c]) <= scene->brightest[0], "%f after %u bounces", sure_length(colour[c]), depth);
    for (unsigned left = 0; left <= depth; left++) {
        sum = 0.7L * (1 - powl(0.8L, left + 1)) / 0.2L;
        CHECK_MSG(sum <= scene->brightest[depth - left], "%f with %u bounces left", (double)sum, left);
    }
    close_world();
}

TEST(brightest)
{
    for (unsigned depth = 1; depth <= 8; depth++)
        try_brightest(depth);
}

/* ---- pending hits ---- */

/* Queued hits of samples that are undecided by now are not shaded, the others are. */
TEST(hits)
{
    static struct sure_block block;
    static struct work w = {.block = &block};
    struct rays r = {.ew = 0};
    struct query q = {.t = 1};

    for (uint32_t slot = 0; slot < 2 * LANES; slot++) {
        r.slot[0] = slot;
        push_hits(&w, 1, &r, &q);
    }
    for (uint32_t slot = 1; slot < 2 * LANES; slot += 2)
        mark(&w, slot);
    for (int left = 2 * LANES; left > 0; left -= LANES) {
        unsigned lanes = pop_hits(&w, &r, &q);
        for (int k = 0; k < LANES; k++)
            CHECK_EQ(lanes >> k & 1, !block.unsure[r.slot[k]]);
    }
    CHECK_EQ(w.hits.count, 0);
}

int main(void)
{
    (void)trace;
    (void)edge_ray;
    (void)moved;
    (void)random_size;
    float_mode_of_simd();
    RUN(rays);
    RUN(coordinates);
    RUN(blends);
    RUN(brightest);
    RUN(hits);
    return check_status();
}
