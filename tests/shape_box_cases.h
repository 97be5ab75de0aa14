/* shape_box_cases.h - boxes and grids, see shape_check.h. */
#include "shape_check.h"

struct box {
    real min[3], max[3];
};

static real part(struct vec p, int i)
{
    return i == 0 ? p.x : i == 1 ? p.y : p.z;
}

static struct vec axis_of(uint32_t face)
{
    real one = face & 1 ? 1 : -1;

    return (struct vec){face / 2 == 0 ? one : 0, face / 2 == 1 ? one : 0, face / 2 == 2 ? one : 0};
}

static real face_margin(const struct box *box, struct vec p, uint32_t face)
{
    real margin = 1e9L;

    for (int i = 0; i < 3; i++)
        if (i != (int)(face / 2))
            margin = least(margin, least(part(p, i) - box->min[i], box->max[i] - part(p, i)));
    return margin;
}

static bool face_candidate(const struct box *box, uint32_t face, struct vec o, struct vec d, struct candidate *found)
{
    int i = (int)(face / 2);
    real t = ((face & 1 ? box->max[i] : box->min[i]) - part(o, i)) / part(d, i);

    if (size(part(d, i)) < (real)0x1p-41)
        return false;
    *found = (struct candidate){t, face_margin(box, add(o, t, d), face), 1, face, axis_of(face)};
    return true;
}

static real face_distance(const struct box *box, struct vec p, uint32_t face)
{
    real off = part(p, (int)(face / 2)) - (face & 1 ? box->max : box->min)[face / 2];

    return most(size(off), -face_margin(box, p, face));
}

static void face_coordinates(const struct box *box, struct vec p, uint32_t face, real uv[2])
{
    /* The axes U and V of each face: at -x z and y, at +x -z and y, at -y x and z, at +y x and -z, at -z -x and y, at
     * +z x and y. */
    static const int axes[6][2] = {{2, 1}, {2, 1}, {0, 2}, {0, 2}, {0, 1}, {0, 1}};
    static const bool back[6][2] = {{false, false}, {true, false}, {false, false},
                                    {false, true},  {true, false}, {false, false}};

    for (int i = 0; i < 2; i++) {
        int axis = axes[face][i];
        real along = back[face][i] ? box->max[axis] - part(p, axis) : part(p, axis) - box->min[axis];
        uv[i] = along / (box->max[axis] - box->min[axis]);
    }
}

static int box_candidates(const struct subject *s, struct vec o, struct vec d, struct candidate found[])
{
    int count = 0;

    for (uint32_t face = 0; face < 6; face++)
        count += face_candidate(s->what, face, o, d, &found[count]);
    return count;
}

static real box_distance(const struct subject *s, struct vec p, uint32_t element)
{
    return element > 5 ? 1e9L : face_distance(s->what, p, element);
}

static struct vec box_normal(const struct subject *s, struct vec p, uint32_t element)
{
    (void)s;
    (void)p;
    return axis_of(element);
}

static void box_coordinates(const struct subject *s, struct vec p, uint32_t element, real uv[2])
{
    face_coordinates(s->what, p, element, uv);
}

static real box_curvature(const struct subject *s, struct vec p, uint32_t element)
{
    const struct box *box = s->what;
    real smallest = box->max[0] - box->min[0];

    (void)p;
    (void)element;
    for (int i = 1; i < 3; i++)
        smallest = least(smallest, box->max[i] - box->min[i]);
    return 1 / smallest;
}

/* Returns a random point of a face; with `near`, one near a corner. */
static struct vec any_of_face(const struct box *box, uint32_t face, bool near)
{
    real p[3];

    for (int i = 0; i < 3; i++) {
        double edge = near ? (chance() < 0 ? 0 : 1) + chance() * exp2(between(-40, -3)) : between(0, 1);
        p[i] = box->min[i] + edge * (box->max[i] - box->min[i]);
    }
    p[face / 2] = (face & 1 ? box->max : box->min)[face / 2];
    return (struct vec){p[0], p[1], p[2]};
}

static void check_box(double far, double smallest, double largest)
{
    struct tia_vec3 min = any_place(far), max = min;
    struct box box;
    struct subject s = {.what = &box,
                        .candidates = box_candidates,
                        .distance = box_distance,
                        .normal = box_normal,
                        .uv = box_coordinates,
                        .curvature = box_curvature};
    double scale = largest;

    for (int i = 0; i < 3; i++) {
        double edge = any_length(smallest, largest);
        *(i == 0 ? &max.x : i == 1 ? &max.y : &max.z) += (tia_q16)(edge * 65536);
        scale = edge < scale ? edge : scale;
        box.min[i] = part(position(min), i);
        box.max[i] = part(position(max), i);
    }
    s.extent = length(position(min)) + length(position(max));
    PREPARE(&s.shape, TIA_BOX, box, {min, max});
    for (uint32_t i = 0; i < 18; i++)
        check_rays_through(&s, any_of_face(&box, i % 6, i > 8), axis_of(i % 6), scale);
}

/* ---- grids ---- */
#define CELLS_MAX 4096

struct grid {
    struct tia_grid grid;
    uint8_t cells[CELLS_MAX];
};

/* Returns the contents of cell (x, y, z); 0 outside the grid. */
static unsigned filling(const struct grid *g, int x, int y, int z)
{
    const uint16_t *n = g->grid.size;

    return x < 0 || y < 0 || z < 0 || x >= n[0] || y >= n[1] || z >= n[2] ? 0 : g->cells[(z * n[1] + y) * n[0] + x];
}

static struct box cell_box(const struct grid *g, uint32_t cell)
{
    const uint16_t *n = g->grid.size;
    const unsigned at[3] = {cell % n[0], cell / n[0] % n[1], cell / n[0] / n[1]};
    struct vec corner = position(g->grid.corner);
    struct box box;

    for (int i = 0; i < 3; i++) {
        box.min[i] = part(corner, i) + (real)at[i] * g->grid.cell / 65536;
        box.max[i] = part(corner, i) + (real)(at[i] + 1) * g->grid.cell / 65536;
    }
    return box;
}

/* True if the face is a surface for a ray along d: from its front if the next cell differs, from its back if the next
 * cell is empty. */
static bool is_surface(const struct grid *g, uint32_t cell, uint32_t face, struct vec d)
{
    const uint16_t *n = g->grid.size;
    int at[3] = {(int)(cell % n[0]), (int)(cell / n[0] % n[1]), (int)(cell / n[0] / n[1])};
    unsigned here = filling(g, at[0], at[1], at[2]);

    at[face / 2] += face & 1 ? 1 : -1;
    unsigned beyond = filling(g, at[0], at[1], at[2]);
    return here && beyond != here && (dot(d, axis_of(face)) < 0 || !beyond);
}

static int grid_candidates(const struct subject *s, struct vec o, struct vec d, struct candidate found[])
{
    const struct grid *g = s->what;
    uint32_t cells = (uint32_t)g->grid.size[0] * g->grid.size[1] * g->grid.size[2];
    int count = 0;

    for (uint32_t i = 0; i < 6 * cells; i++) {
        struct box box = cell_box(g, i / 6);
        if (!is_surface(g, i / 6, i % 6, d) || !face_candidate(&box, i % 6, o, d, &found[count]) ||
            found[count].margin < 0)
            continue;
        found[count++].element = i;
    }
    return count;
}

static real grid_distance(const struct subject *s, struct vec p, uint32_t element)
{
    const struct grid *g = s->what;
    struct box box = cell_box(g, element / 6);

    return !g->cells[element / 6] ? 1e9L : face_distance(&box, p, element % 6);
}

static struct vec grid_normal(const struct subject *s, struct vec p, uint32_t element)
{
    (void)s;
    (void)p;
    return axis_of(element % 6);
}

static void grid_coordinates(const struct subject *s, struct vec p, uint32_t element, real uv[2])
{
    struct box box = cell_box(s->what, element / 6);

    face_coordinates(&box, p, element % 6, uv);
}

static real grid_curvature(const struct subject *s, struct vec p, uint32_t element)
{
    (void)p;
    (void)element;
    return 65536 / (real)((const struct grid *)s->what)->grid.cell;
}

static void prepare_grid(struct subject *s, struct grid *g, const unsigned n[3], double far, double edge)
{
    g->grid = (struct tia_grid){any_place(far), (tia_q16)(edge * 65536), {0, 0, 0}, g->cells};
    for (int i = 0; i < 3; i++)
        g->grid.size[i] = (uint16_t)n[i];
    *s = (struct subject){.what = g,
                          .candidates = grid_candidates,
                          .distance = grid_distance,
                          .normal = grid_normal,
                          .uv = grid_coordinates,
                          .curvature = grid_curvature};
    s->extent = length(position(g->grid.corner)) + (n[0] + n[1] + n[2]) * edge;
    prepare_grid_alone(&s->shape, &g->grid);
    s->shape.material = 7;
}

/* Checks a grid. A fraction `share` of its cells is filled, each with one of two materials. */
static void tia_check_grid(const unsigned n[3], double far, double edge, double share, int rays)
{
    static struct grid g;
    struct subject s;
    uint32_t cells = n[0] * n[1] * n[2];

    for (uint32_t i = 0; i < cells; i++)
        g.cells[i] = (uint8_t)(between(0, 1) > share ? 0 : chance() < 0.5 ? 1 : 2);
    prepare_grid(&s, &g, n, far, edge);
    for (int i = 0; i < rays; i++) {
        uint32_t cell = (uint32_t)between(0, cells), face = (uint32_t)i % 6;
        struct box box = cell_box(&g, cell < cells ? cell : 0);
        check_rays_through(&s, any_of_face(&box, face, i % 4 == 0), axis_of(face), edge);
        if (g.cells[cell])
            CHECK_EQ(shape_material(&s.shape, 6 * cell + face), 7 + g.cells[cell] - 1);
    }
}

/* True if the ray is in the cell at t, judged by the order in which the ray meets the planes of the cell's faces. */
static bool is_in_cell(const struct grid *g, uint32_t cell, const struct ray *ray, num_length t)
{
    const uint16_t *n = g->grid.size;
    const unsigned at[3] = {cell % n[0], cell / n[0] % n[1], cell / n[0] / n[1]};
    const num_unit d[3] = {ray->direction.x, ray->direction.y, ray->direction.z};
    const num_length o[3] = {ray->origin.x, ray->origin.y, ray->origin.z};
    const tia_q16 corner[3] = {g->grid.corner.x, g->grid.corner.y, g->grid.corner.z};

    for (unsigned k = 0; k < 6; k++) {
        unsigned i = k / 2, plane = at[i] + k % 2;
        num_length ahead = num_length_of(corner[i] + (tia_q16)plane * g->grid.cell) - o[i];
        bool enters = (d[i] < 0) == (k % 2 == 1);
        if (plane == 0 || plane == n[i] || d[i] == 0)
            continue;
        if (enters ? num_div(ahead, d[i]) > t : num_div(ahead, d[i]) < t)
            return false;
    }
    return true;
}

/* Checks a block of one material, which is a box: no ray enters or leaves it except at its surface, not even one that
 * goes exactly through the edges and corners of its cells. */
static void check_block(const unsigned n[3], double far, double edge)
{
    static struct grid g;
    struct subject s;
    struct shape box;
    struct intersection in_grid, in_box;

    memset(g.cells, 3, sizeof g.cells);
    prepare_grid(&s, &g, n, far, edge);
    struct tia_vec3 min = g.grid.corner, max = min;
    max.x += (tia_q16)n[0] * g.grid.cell;
    max.y += (tia_q16)n[1] * g.grid.cell;
    max.z += (tia_q16)n[2] * g.grid.cell;
    PREPARE(&box, TIA_BOX, box, {min, max});
    for (int i = 0; i < 3000; i++) {
        tia_q16 at[3], d[3], back = (tia_q16)between(0, 9);
        for (int k = 0; k < 3; k++) {
            at[k] = (tia_q16)between(-2, n[k] + 3) * g.grid.cell;
            d[k] = (tia_q16)between(-4, 5) * g.grid.cell;
            at[k] -= back * d[k];
        }
        struct tia_vec3 from = {min.x + at[0], min.y + at[1], min.z + at[2]};
        struct num_point heading = num_point_of((struct tia_vec3){d[0], d[1], d[2]});
        struct ray ray = {num_point_of(from), {0, 0, 0}};
        if (!num_normalise(heading, &ray.direction))
            continue;
        bool met = s.shape.kind->intersect(&s.shape, &ray, NUM_LENGTH_MAX, &in_grid);
        CHECK_EQ(met, box.kind->intersect(&box, &ray, NUM_LENGTH_MAX, &in_box));
        hits += met;
        misses += !met;
        CHECK(!met || (!(in_grid.t < in_box.t) && !(in_grid.t > in_box.t)));
        CHECK_EQ(met ? in_grid.element % 6 : 0, met ? in_box.element : 0);
        CHECK(!met || is_in_cell(&g, in_grid.element / 6, &ray, in_grid.t));
    }
}
