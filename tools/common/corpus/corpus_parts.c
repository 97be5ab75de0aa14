#include "corpus_parts.h"

#include <stdlib.h>

#include "dice.h"

/* An octahedron's corners and edge midpoints, moved out to the unit sphere: sqrt(1/2) = 0.70711. */
#define EDGE 0.70711
#define BALL_VERTICES 18
#define BALL_FACES 32

static const struct tia_vec3 ball_vertices[BALL_VERTICES] = {
    TIA_VEC3(1, 0, 0),        TIA_VEC3(-1, 0, 0),        TIA_VEC3(0, 1, 0),       TIA_VEC3(0, -1, 0),
    TIA_VEC3(0, 0, 1),        TIA_VEC3(0, 0, -1),        TIA_VEC3(EDGE, EDGE, 0), TIA_VEC3(-EDGE, EDGE, 0),
    TIA_VEC3(EDGE, -EDGE, 0), TIA_VEC3(-EDGE, -EDGE, 0), TIA_VEC3(EDGE, 0, EDGE), TIA_VEC3(-EDGE, 0, EDGE),
    TIA_VEC3(EDGE, 0, -EDGE), TIA_VEC3(-EDGE, 0, -EDGE), TIA_VEC3(0, EDGE, EDGE), TIA_VEC3(0, -EDGE, EDGE),
    TIA_VEC3(0, EDGE, -EDGE), TIA_VEC3(0, -EDGE, -EDGE)};

/* The directions of the octahedron's points, not normalised. */
#define DIR3(x, y, z)                                                                                                  \
    {                                                                                                                  \
        TIA_Q30(x), TIA_Q30(y), TIA_Q30(z)                                                                             \
    }
static const struct tia_dir3 ball_normals[BALL_VERTICES] = {
    DIR3(1, 0, 0),      DIR3(-1, 0, 0),     DIR3(0, 1, 0),      DIR3(0, -1, 0),      DIR3(0, 0, 1),
    DIR3(0, 0, -1),     DIR3(0.5, 0.5, 0),  DIR3(-0.5, 0.5, 0), DIR3(0.5, -0.5, 0),  DIR3(-0.5, -0.5, 0),
    DIR3(0.5, 0, 0.5),  DIR3(-0.5, 0, 0.5), DIR3(0.5, 0, -0.5), DIR3(-0.5, 0, -0.5), DIR3(0, 0.5, 0.5),
    DIR3(0, -0.5, 0.5), DIR3(0, 0.5, -0.5), DIR3(0, -0.5, -0.5)};

/* A corner with vertex n and normal n, without texture coordinates; the corners of a face are in counter-clockwise
 * order, seen from outside. */
#define CORNER(n)                                                                                                      \
    {                                                                                                                  \
        n, n, TIA_NO_INDEX                                                                                             \
    }
#define FACE(a, b, c)                                                                                                  \
    {                                                                                                                  \
        {                                                                                                              \
            CORNER(a), CORNER(b), CORNER(c)                                                                            \
        }                                                                                                              \
    }
/* An octant: the corners on the axes x, y, z, and the midpoints of the edges xy, yz, zx. */
#define OCTANT(x, y, z, xy, yz, zx) FACE(x, xy, zx), FACE(xy, y, yz), FACE(zx, yz, z), FACE(xy, yz, zx)
static const struct tia_face ball_faces[BALL_FACES] = {
    OCTANT(0, 2, 4, 6, 14, 10), OCTANT(4, 2, 1, 14, 7, 11), OCTANT(1, 2, 5, 7, 16, 13), OCTANT(5, 2, 0, 16, 6, 12),
    OCTANT(4, 3, 0, 15, 8, 10), OCTANT(1, 3, 4, 9, 15, 11), OCTANT(5, 3, 1, 17, 9, 13), OCTANT(0, 3, 5, 8, 17, 12)};

struct tia_vec3 parts_moved(struct tia_vec3 p, struct tia_vec3 v, int32_t sign)
{
    return (struct tia_vec3){p.x + sign * v.x, p.y + sign * v.y, p.z + sign * v.z};
}

/* Returns v divided by about |x| + |y| + |z|. */
static struct tia_dir3 direction_of(struct tia_vec3 v)
{
    int64_t sum = (int64_t)abs(v.x) + abs(v.y) + abs(v.z) + 1;
    struct tia_dir3 d = {(tia_q30)(v.x * (int64_t)TIA_Q30_ONE / sum), (tia_q30)(v.y * (int64_t)TIA_Q30_ONE / sum),
                         (tia_q30)(v.z * (int64_t)TIA_Q30_ONE / sum)};

    return d;
}

struct tia_dir3 parts_random_direction(uint64_t *state)
{
    static const struct tia_vec3 range[2] = {TIA_VEC3(-10, -10, -10), TIA_VEC3(10, 10, 10)};
    struct tia_vec3 v = dice_vec3(state, range[0], range[1]);

    v.y += v.y < 0 ? -TIA_Q16_ONE : TIA_Q16_ONE;
    return direction_of(v);
}

static void random_glass(uint64_t *state, struct tia_material *m)
{
    m->refraction = dice_rgb(state, 50, 100);
    m->transmission = dice_rgb(state, 30, 100);
    m->index = dice_between(state, TIA_Q16(1.1), TIA_Q16(2.4));
    m->fresnel = dice_one_in(state, 2);
    if (dice_one_in(state, 8))
        m->index = dice_between(state, TIA_Q16(0.6), TIA_Q16(0.95));
}

void parts_random_material(uint64_t *state, struct tia_material *m)
{
    m->colour = dice_rgb(state, 10, 100);
    m->exponent = TIA_Q16_ONE;
    if (dice_one_in(state, 3)) {
        m->specular = dice_rgb(state, 10, 90);
        m->exponent = dice_one_in(state, 3) ? dice_between(state, TIA_Q16(1), TIA_Q16(8))
                                            : dice_between(state, TIA_Q16(8), TIA_Q16(200));
    }
    if (dice_one_in(state, 4))
        m->mirror = dice_rgb(state, 15, 90);
    if (dice_one_in(state, 4))
        random_glass(state, m);
    if (dice_one_in(state, 3))
        m->texture = 1 + (uint32_t)(dice_next(state) % 3);
    if (dice_one_in(state, 8))
        m->emission = dice_rgb(state, 0, 30);
    if (dice_one_in(state, 6))
        m->facing = dice_rgb(state, 10, 60);
    if (dice_one_in(state, 12))
        m->colour = (struct tia_rgb)TIA_RGB(0, 0, 0);
}

static void random_area(uint64_t *state, struct tia_light *light)
{
    static const uint16_t samples[] = {0, 1, 4, 4, 5, 9};
    tia_q16 a = dice_between(state, TIA_Q16(0.4), TIA_Q16(2)), b = dice_between(state, TIA_Q16(-1), TIA_Q16(1));

    light->samples = samples[dice_next(state) % (sizeof samples / sizeof samples[0])];
    if (tia_light_has(light->kind, TIA_LIGHT_SIDES)) {
        light->side[0] = (struct tia_vec3){a, 0, b};
        light->side[1] = (struct tia_vec3){-b, dice_between(state, TIA_Q16(-1), TIA_Q16(1)), a};
    } else {
        light->radius = a;
    }
}

void parts_random_light(uint64_t *state, struct tia_light *light)
{
    static const struct tia_vec3 range[2] = {TIA_VEC3(-10, 4, -10), TIA_VEC3(10, 14, 10)};

    light->kind = (enum tia_light_kind)(dice_next(state) % TIA_LIGHT_KINDS);
    light->centre = dice_vec3(state, range[0], range[1]);
    light->emission =
        tia_light_has(light->kind, TIA_LIGHT_EVERYWHERE) ? dice_rgb(state, 5, 30) : dice_rgb(state, 20, 100);
    light->direction = direction_of(parts_moved((struct tia_vec3){0, 0, 0}, light->centre, -1));
    light->inner = dice_between(state, TIA_Q16(5), TIA_Q16(20));
    light->outer = light->inner + dice_between(state, 0, TIA_Q16(25));
    light->outer = light->outer < TIA_Q16_ONE ? TIA_Q16_ONE : light->outer;
    if (tia_light_has(light->kind, TIA_LIGHT_BALL) && !tia_light_has(light->kind, TIA_LIGHT_AREA) &&
        dice_one_in(state, 2))
        light->radius = dice_between(state, TIA_Q16(0.25), TIA_Q16(1));
    if (tia_light_has(light->kind, TIA_LIGHT_AREA))
        random_area(state, light);
    if (dice_one_in(state, 3)) {
        light->constant = dice_between(state, 0, TIA_Q16(0.5));
        light->linear = dice_between(state, 0, TIA_Q16(0.05));
        light->quadratic = dice_between(state, TIA_Q16(0.001), TIA_Q16(0.01));
    }
}

void parts_random_textures(uint64_t *state, struct corpus_rays *out)
{
    for (int i = 0; i < 3; i++) {
        struct tia_texture *t = &out->textures[i];
        t->kind = i == 0 ? TIA_CHECKER : TIA_IMAGE;
        t->repeat[0] = dice_between(state, TIA_Q16(0.5), i == 0 ? TIA_Q16(8) : TIA_Q16(3));
        t->repeat[1] = dice_between(state, TIA_Q16(0.5), i == 0 ? TIA_Q16(8) : TIA_Q16(3));
        t->cells[0] = dice_rgb(state, 50, 100);
        t->cells[1] = dice_rgb(state, 0, 50);
        t->bilinear = i == 2;
        t->width = (uint16_t)dice_between(state, 1, CORPUS_RAYS_TEXELS);
        t->height = (uint16_t)dice_between(state, 1, CORPUS_RAYS_TEXELS);
        t->texels = out->texels;
    }
    for (size_t i = 0; i < sizeof out->texels; i++)
        out->texels[i] = (uint8_t)dice_between(state, 0, 255);
}

/* Makes opacities: a third of the texels are holes, a third is opaque. */
void parts_random_opacities(uint64_t *state, struct corpus_rays *out)
{
    for (int i = 3; i < 5; i++) {
        struct tia_texture *t = &out->textures[i];
        t->kind = TIA_OPACITY;
        t->repeat[0] = dice_between(state, TIA_Q16(0.5), TIA_Q16(3));
        t->repeat[1] = dice_between(state, TIA_Q16(0.5), TIA_Q16(3));
        t->offset[0] = dice_between(state, TIA_Q16(-1), TIA_Q16(1));
        t->bilinear = i == 4;
        t->width = (uint16_t)dice_between(state, 1, CORPUS_RAYS_TEXELS);
        t->height = (uint16_t)dice_between(state, 1, CORPUS_RAYS_TEXELS);
        t->texels = out->opacities;
    }
    for (size_t i = 0; i < sizeof out->opacities; i++) {
        int32_t value = dice_between(state, -255, 510);
        out->opacities[i] = (uint8_t)(value < 0 ? 0 : value > 255 ? 255 : value);
    }
    for (uint32_t i = 0; i < out->scene.material_count; i++)
        if (dice_one_in(state, 2))
            out->materials[i].opacity = 4 + (uint32_t)(dice_next(state) % 2);
    out->scene.texture_count = 5;
}

/* Makes a height field from -1 to 1, at most 0.2 high. Cells are 0.4 wide, so slopes are at most 1/2; so are x and z of
 * the normals, whose y is 1. */
static void random_land(uint64_t *state, struct corpus_rays *out)
{
    const unsigned row = CORPUS_RAYS_LAND + 1;

    for (unsigned i = 0; i < row * row; i++) {
        int32_t x = (int32_t)(i % row), z = (int32_t)(i / row);
        out->heights[i].x = 2 * TIA_Q16_ONE * x / CORPUS_RAYS_LAND - TIA_Q16_ONE;
        out->heights[i].y = dice_between(state, 0, TIA_Q16(0.2));
        out->heights[i].z = 2 * TIA_Q16_ONE * z / CORPUS_RAYS_LAND - TIA_Q16_ONE;
        out->slopes[i].x = dice_between(state, TIA_Q30(-0.4), TIA_Q30(0.4));
        out->slopes[i].y = TIA_Q30_ONE;
        out->slopes[i].z = dice_between(state, TIA_Q30(-0.4), TIA_Q30(0.4));
        out->places[i].u = x * TIA_Q16_ONE;
        out->places[i].v = z * TIA_Q16_ONE;
    }
    for (unsigned i = 0; i < 2 * CORPUS_RAYS_LAND * CORPUS_RAYS_LAND; i++) {
        uint32_t first = i / 2 / CORPUS_RAYS_LAND * row + i / 2 % CORPUS_RAYS_LAND;
        uint32_t quad[4] = {first, first + row, first + row + 1, first + 1};
        for (unsigned k = 0; k < 3; k++) {
            uint32_t n = quad[i % 2 && k ? k + 1 : k];
            out->land[i].corner[k] = (struct tia_corner){n, n, n};
        }
    }
}

void parts_random_meshes(uint64_t *state, struct corpus_rays *out)
{
    const uint32_t points = CORPUS_RAYS_LAND_POINTS, faces = 2 * CORPUS_RAYS_LAND * CORPUS_RAYS_LAND;

    random_land(state, out);
    out->meshes[0] = (struct tia_mesh){ball_vertices, ball_normals, NULL, ball_faces, BALL_VERTICES, BALL_VERTICES, 0,
                                       BALL_FACES,    NULL};
    out->meshes[1] =
        (struct tia_mesh){out->heights, out->slopes, out->places, out->land, points, points, points, faces, NULL};
    if (dice_one_in(state, 3)) /* flat shading: no normals at the vertices */
        for (uint32_t i = 0; i < faces * 3; i++)
            out->land[i / 3].corner[i % 3].normal = TIA_NO_INDEX;
}

void parts_random_grid(uint64_t *state, struct corpus_rays *out)
{
    unsigned cells = 1, fill = (unsigned)dice_between(state, 2, 6);

    out->grid.corner = (struct tia_vec3)TIA_VEC3(-1, -1, -1);
    out->grid.cell = dice_between(state, TIA_Q16(0.2), TIA_Q16(0.5));
    for (int i = 0; i < 3; i++) {
        out->grid.size[i] = (uint16_t)dice_between(state, 1, CORPUS_RAYS_CELLS);
        cells *= out->grid.size[i];
    }
    out->grid.cells = out->cells;
    for (unsigned i = 0; i < cells; i++)
        if (dice_one_in(state, fill))
            out->cells[i] = (uint8_t)dice_between(state, 1, 3);
    out->cells[0] = 1;
}

/* Makes glass. Its index of refraction is often one that other materials have as well. */
static void random_medium(uint64_t *state, struct tia_material *m)
{
    static const tia_q16 indices[] = {TIA_Q16(1), TIA_Q16(1), TIA_Q16(1.33), TIA_Q16(1.5), TIA_Q16(1.5), TIA_Q16(1.5)};

    *m = (struct tia_material){.exponent = TIA_Q16_ONE, .colour = dice_rgb(state, 0, 20)};
    random_glass(state, m);
    if (!dice_one_in(state, 4))
        m->index = indices[dice_next(state) % (sizeof indices / sizeof indices[0])];
    if (dice_one_in(state, 6))
        m->mirror = dice_rgb(state, 5, 40);
}

/* Makes a vessel about `size` large around the centre. */
static void random_vessel(uint64_t *state, struct corpus_rays *out, struct tia_shape *shape, struct tia_vec3 centre,
                          tia_q16 size)
{
    static const enum tia_shape_kind kinds[] = {TIA_SPHERE,   TIA_SPHERE, TIA_BOX, TIA_MESH,
                                                TIA_CYLINDER, TIA_DISC,   TIA_GRID};
    struct tia_transform *t = &out->transforms[out->scene.transform_count];

    shape->kind = kinds[dice_next(state) % (sizeof kinds / sizeof kinds[0])];
    if (shape->kind == TIA_SPHERE) {
        shape->sphere.centre = centre;
        shape->sphere.radius = size;
    } else if (shape->kind == TIA_BOX) {
        shape->box.min = parts_moved(centre, (struct tia_vec3){size, size, size}, -1);
        shape->box.max = parts_moved(centre, (struct tia_vec3){size, size, size}, 1);
    } else if (shape->kind == TIA_CYLINDER) {
        shape->cylinder = (struct tia_cylinder){parts_moved(centre, (struct tia_vec3){0, size, 0}, -1),
                                                parts_moved(centre, (struct tia_vec3){0, size, 0}, 1), size, true};
    } else if (shape->kind == TIA_DISC) {
        shape->disc = (struct tia_disc){centre, parts_random_direction(state), size};
    } else { /* the ball, or the grid, whose other cells have the materials with the next numbers */
        *t = (struct tia_transform){centre, {0, dice_between(state, 0, TIA_Q16(90)), 0}, {size, size, size}};
        shape->transform = ++out->scene.transform_count;
    }
}

void parts_random_nest(uint64_t *state, struct corpus_rays *out, uint32_t material)
{
    static const struct tia_vec3 range[2] = {TIA_VEC3(-1.5, 0.8, -1.5), TIA_VEC3(1.5, 2, 1.5)};
    struct tia_vec3 centre = dice_vec3(state, range[0], range[1]);
    tia_q16 size = dice_between(state, TIA_Q16(0.8), TIA_Q16(2));
    uint32_t count = (uint32_t)dice_between(state, 2, CORPUS_RAYS_NESTED);

    for (uint32_t i = 0; i < CORPUS_RAYS_NESTED; i++)
        random_medium(state, &out->materials[material + i]);
    for (uint32_t i = 0; i < count; i++) {
        struct tia_shape *shape = &out->shapes[out->scene.shape_count++];
        shape->material = material + (i < CORPUS_RAYS_NESTED - 2 ? i : 0);
        random_vessel(state, out, shape, centre, size);
        centre.x += dice_between(state, -size / 4, size / 4);
        centre.z += dice_between(state, -size / 4, size / 4);
        size = size / 16 * dice_between(state, 10, 16);
    }
    for (uint32_t i = 0; i < sizeof out->groups / sizeof out->groups[0]; i++)
        out->groups[i] = (uint32_t)dice_between(state, 0, 40);
    out->meshes[0].groups = out->meshes[1].groups = dice_one_in(state, 2) ? out->groups : NULL;
}
