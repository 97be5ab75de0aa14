/* shapes.c - the shapes, one statement each. */
#include "read/job.h"

struct shape_line {
    struct tia_word material, name;
    struct tia_transform transform;
    struct tia_shape shape;
};

#define MATERIAL                                                                                                       \
    {                                                                                                                  \
        .word = "material", .kind = TIA_NAME_FIELD, .offset = offsetof(struct shape_line, material), .needed = true    \
    }
#define NUMBERS(field, n, part, need)                                                                                  \
    {                                                                                                                  \
        .word = field, .kind = TIA_NUMBERS, .count = n, .offset = offsetof(struct shape_line, part), .needed = need    \
    }
#define NORMAL(part)                                                                                                   \
    {                                                                                                                  \
        .word = "normal", .kind = TIA_DIRECTION, .offset = offsetof(struct shape_line, part), .needed = true           \
    }

/* What every shape that can be moved begins with. */
enum { MATERIAL_FIELD, NAME_FIELD, AT_FIELD, ROTATE_FIELD, SCALE_FIELD };
#define INSTANCE                                                                                                       \
    MATERIAL, {.word = "name", .kind = TIA_NAME_FIELD, .offset = offsetof(struct shape_line, name)},                   \
        NUMBERS("at", 3, transform.position, false), NUMBERS("rotate", 3, transform.rotation, false),                  \
    {                                                                                                                  \
        .word = "scale", .kind = TIA_SPREAD, .count = 3, .offset = offsetof(struct shape_line, transform.scale)        \
    }
#define PLACED (1u << AT_FIELD | 1u << ROTATE_FIELD | 1u << SCALE_FIELD)
#define NAMED (1u << NAME_FIELD)

static const struct tia_field sphere_fields[] = {INSTANCE, NUMBERS("centre", 3, shape.sphere.centre, false),
                                                 NUMBERS("radius", 1, shape.sphere.radius, true)};
static const struct tia_field plane_fields[] = {MATERIAL, NUMBERS("point", 3, shape.plane.point, false),
                                                NORMAL(shape.plane.normal)};
static const struct tia_field disc_fields[] = {INSTANCE, NUMBERS("centre", 3, shape.disc.centre, false),
                                               NORMAL(shape.disc.normal),
                                               NUMBERS("radius", 1, shape.disc.radius, true)};
static const struct tia_field cylinder_fields[] = {
    INSTANCE,
    NUMBERS("base", 3, shape.cylinder.base, true),
    NUMBERS("top", 3, shape.cylinder.top, true),
    NUMBERS("radius", 1, shape.cylinder.radius, true),
    {.word = "capped", .kind = TIA_FLAG, .offset = offsetof(struct shape_line, shape.cylinder.capped)}};
static const struct tia_field cone_fields[] = {
    INSTANCE,
    NUMBERS("base", 3, shape.cone.base, true),
    NUMBERS("top", 3, shape.cone.top, true),
    NUMBERS("radii", 2, shape.cone.base_radius, true), /* and top_radius */
    {.word = "capped", .kind = TIA_FLAG, .offset = offsetof(struct shape_line, shape.cone.capped)}};
static const struct tia_field box_fields[] = {INSTANCE, NUMBERS("min", 3, shape.box.min, true),
                                              NUMBERS("max", 3, shape.box.max, true)};
static const struct tia_field triangle_fields[] = {INSTANCE, NUMBERS("a", 3, shape.triangle.corner[0], true),
                                                   NUMBERS("b", 3, shape.triangle.corner[1], true),
                                                   NUMBERS("c", 3, shape.triangle.corner[2], true)};
static const struct tia_field instance_fields[] = {INSTANCE};
_Static_assert(offsetof(struct tia_cone, top_radius) == offsetof(struct tia_cone, base_radius) + sizeof(tia_q16),
               "a cone's radii are two numbers");

/* The transform of a shape that has one. A shape with a name has one when it moves, and until that is
 * known. */
static void add_transform(struct tia_job *job, struct shape_line *line, uint32_t given)
{
    bool filling = job->pass == TIA_FILLING, moves = tia_job_moves(job, &line->name);

    if (!(given & PLACED) && !moves && (filling || !(given & NAMED)))
        return;
    uint32_t index = tia_job_add(job, TIA_OF_TRANSFORMS, &line->transform);
    line->shape.transform = index + 1;
    if (moves && (given & NAMED)) {
        struct tia_name *name = tia_job_mover(job, &line->name);
        if (name)
            name->index = 2 * index;
    }
}

/* A sphere that stays where it is belongs to the scene's spheres. */
static void add_sphere(struct tia_job *job, const struct tia_shape *shape)
{
    struct tia_sphere sphere = {shape->sphere.centre, shape->sphere.radius, shape->material};
    (void)tia_job_add(job, TIA_OF_SPHERES, &sphere);
}

static void add_shape(struct tia_job *job, struct shape_line *line, uint32_t given)
{
    bool sphere = line->shape.kind == TIA_SPHERE;

    if (given & NAMED)
        tia_job_name(job, TIA_NAMED_MOVER, &line->name, 0);
    add_transform(job, line, given);
    if (sphere && !(given & PLACED) && (job->pass != TIA_FILLING || !line->shape.transform))
        add_sphere(job, &line->shape);
    if (!sphere || line->shape.transform)
        (void)tia_job_add(job, TIA_OF_SHAPES, &line->shape);
}

/* The fields of a shape, whose kind and, of an instance, mesh or grid are set. */
static int read_shape(struct tia_job *job, const char *what, const struct tia_field *fields, unsigned count,
                      struct shape_line *line)
{
    uint32_t given = 0;
    int status = tia_fields(&job->text, what, fields, count, line, &given);

    if (line->shape.kind == TIA_PLANE)
        given &= 1u << MATERIAL_FIELD; /* its other fields are not an instance's */
    if (!status && (given & NAMED) && tia_word_is(&line->name, "camera"))
        status = tia_text_error(&job->text, &line->name, "is the camera's name", "another");
    if (!status)
        status =
            tia_job_find(job, TIA_NAMED_MATERIAL, &line->material, "the name of a material", &line->shape.material);
    if (!status)
        add_shape(job, line, given);
    return status;
}

static struct shape_line line_of(enum tia_shape_kind kind)
{
    return (struct shape_line){.shape = {.kind = kind},
                               .transform = {.scale = {TIA_Q16_ONE, TIA_Q16_ONE, TIA_Q16_ONE}}};
}

#define SHAPE(name, KIND, what)                                                                                        \
    int tia_line_##name(struct tia_job *job)                                                                           \
    {                                                                                                                  \
        struct shape_line line = line_of(KIND);                                                                        \
        return read_shape(job, what, name##_fields, TIA_COUNT_OF(name##_fields), &line);                               \
    }

SHAPE(sphere, TIA_SPHERE, "a sphere")
SHAPE(plane, TIA_PLANE, "a plane")
SHAPE(disc, TIA_DISC, "a disc")
SHAPE(cylinder, TIA_CYLINDER, "a cylinder")
SHAPE(cone, TIA_CONE, "a cone")
SHAPE(box, TIA_BOX, "a box")
SHAPE(triangle, TIA_TRIANGLE, "a triangle")

int tia_line_instance(struct tia_job *job)
{
    struct shape_line line = line_of(TIA_MESH);
    struct tia_word solid;
    uint32_t index = 0;
    const char *expected = "the name of a mesh or grid";
    int status = tia_text_name(&job->text, &solid, expected);

    status = status ? status : tia_job_find(job, TIA_NAMED_SOLID, &solid, expected, &index);
    if (status)
        return status;
    if (index % 2) {
        line.shape.kind = TIA_GRID;
        line.shape.grid = index / 2;
    } else {
        line.shape.mesh = index / 2;
    }
    return read_shape(job, "an instance", instance_fields, TIA_COUNT_OF(instance_fields), &line);
}
