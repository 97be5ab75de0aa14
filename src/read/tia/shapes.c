/* shapes.c - the shapes, one statement each. */
#include "parse_state.h"

#include "scene/shapes/description.h"

struct shape_line {
    struct tia_word material, name;
    struct tia_transform transform;
    tia_q16 appears, vanishes;
    struct tia_shape shape;
    uint32_t parts; /* number of shapes, of consecutive meshes: more than 1 only for a model of several materials */
    bool may_own;   /* the material may be left out: the model has its own */
};

/* Indices of the common fields, which come first. Infinite shapes have only those before the name. */
enum { MATERIAL_FIELD, APPEARS_FIELD, VANISHES_FIELD, NAME_FIELD, AT_FIELD, ROTATE_FIELD, SCALE_FIELD, COMMON_FIELDS };
#define OFFSET(member) .offset = offsetof(struct shape_line, member)
static const struct tia_field common_fields[COMMON_FIELDS] = {
    {.word = "material", .kind = TIA_NAME_FIELD, OFFSET(material), .needed = true},
    {.word = "appears", .kind = TIA_NUMBERS, .count = 1, OFFSET(appears)},
    {.word = "vanishes", .kind = TIA_NUMBERS, .count = 1, OFFSET(vanishes)},
    {.word = "name", .kind = TIA_NAME_FIELD, OFFSET(name)},
    {.word = "at", .kind = TIA_LENGTHS, .count = 3, OFFSET(transform.position)},
    {.word = "rotate", .kind = TIA_NUMBERS, .count = 3, OFFSET(transform.rotation)},
    {.word = "scale", .kind = TIA_SPREAD, .count = 3, OFFSET(transform.scale)},
};
#define PLACED (1u << AT_FIELD | 1u << ROTATE_FIELD | 1u << SCALE_FIELD)
#define NAMED (1u << NAME_FIELD)
#define SHOWN (1u << APPEARS_FIELD | 1u << VANISHES_FIELD)
#define OF_MATERIAL (1u << MATERIAL_FIELD)

static struct tia_field field_of(const struct tia_shape_field *f)
{
    struct tia_field field = {
        .word = f->word, .offset = (uint16_t)(offsetof(struct shape_line, shape) + f->offset), .needed = f->needed};

    switch ((enum tia_shape_value)f->value) {
    case TIA_SHAPE_Q16:
        field.kind = TIA_LENGTHS;
        field.count = 1;
        break;
    case TIA_SHAPE_VEC3:
        field.kind = TIA_LENGTHS;
        field.count = 3;
        break;
    case TIA_SHAPE_DIR3:
        field.kind = TIA_DIRECTION;
        break;
    case TIA_SHAPE_FLAG:
        field.kind = TIA_FLAG;
        break;
    }
    return field;
}

/* Collects all fields of a shape's statement; returns their number. */
static unsigned fields_of(const struct shape_description *description,
                          struct tia_field fields[COMMON_FIELDS + SHAPE_FIELDS_MAX])
{
    unsigned count = 0;

    while (count < (description->add_bounds ? COMMON_FIELDS : NAME_FIELD)) {
        fields[count] = common_fields[count];
        count++;
    }
    for (const struct tia_shape_field *f = description->fields; f->member; f++) {
        struct tia_field field = field_of(f);
        if (f->word)
            fields[count++] = field;
        else
            fields[count - 1].count = (uint8_t)(fields[count - 1].count + field.count);
    }
    return count;
}

/* Adds the shape's transform if it needs one. A named shape needs a transform if it is animated; before the last pass
 * this is unknown, and every named shape gets one. */
static void add_transform(struct tia_parse *job, struct shape_line *line, uint32_t given)
{
    bool filling = job->pass == TIA_FILLING, moves = tia_parse_moves(job, &line->name);

    if (!(given & PLACED) && !moves && (filling || !(given & NAMED)))
        return;
    uint32_t index = tia_parse_add(job, TIA_OF_TRANSFORMS, &line->transform);
    line->shape.transform = index + 1;
    if (moves && (given & NAMED)) {
        struct tia_name *name = tia_parse_mover(job, &line->name);
        if (name)
            name->index = 2 * index;
    }
}

/* Adds a sphere that does not move and is always visible to the scene's spheres. */
static void add_sphere(struct tia_parse *job, const struct tia_shape *shape)
{
    struct tia_sphere sphere = {shape->sphere.centre, shape->sphere.radius, shape->material};
    (void)tia_parse_add(job, TIA_OF_SPHERES, &sphere);
}

/* Extends the scene's bounds by the shape. */
static void note_reach(struct tia_parse *job, const struct shape_line *line, uint32_t given)
{
    if (job->pass == TIA_COUNTING)
        tia_reach_shape(&job->reach, &line->shape, &line->transform, given & PLACED, given & NAMED);
    if (job->pass == TIA_NAMING && line->shape.kind == TIA_PLANE)
        tia_reach_plane(&job->reach, &line->shape.plane);
}

/* Adds the shape to the open solid. */
static int add_member(struct tia_parse *job, struct shape_line *line, uint32_t given)
{
    if (given & (NAMED | SHOWN))
        return tia_text_error(&job->text, &job->first, "is a member, which has no name, no appears and no vanishes",
                              "them in the first line of the solid");
    if (job->pass == TIA_FILLING && line->shape.material == TIA_OWN_MATERIAL)
        return tia_text_error(&job->text, &job->first, "is a member with the materials of its file", "one material");
    if (line->parts > 1)
        return tia_text_error(&job->text, &job->first, "is a member with several materials", "a mesh of one");
    if (job->pass == TIA_COUNTING)
        tia_reach_member(&job->reach, &line->shape, &line->transform);
    if (given & PLACED)
        line->shape.transform = tia_parse_add(job, TIA_OF_TRANSFORMS, &line->transform) + 1;
    return tia_operation_add(job, &line->shape);
}

static int add_shape(struct tia_parse *job, struct shape_line *line, uint32_t given)
{
    bool sphere = line->shape.kind == TIA_SPHERE;

    note_reach(job, line, given);
    if (given & NAMED)
        tia_parse_name(job, TIA_NAMED_MOVER, &line->name, 0);
    add_transform(job, line, given);
    if (sphere && !(given & (PLACED | SHOWN)) && (job->pass != TIA_FILLING || !line->shape.transform))
        add_sphere(job, &line->shape);
    for (uint32_t i = 0; i < line->parts && (!sphere || line->shape.transform || given & SHOWN); i++) {
        (void)tia_parse_add(job, TIA_OF_SHAPES, &line->shape);
        line->shape.mesh += line->parts > 1;
    }
    return tia_parse_show(job, TIA_SHOWS_SHAPE, tia_parse_count(job, TIA_OF_SHAPES) - 1,
                          given & 1u << APPEARS_FIELD ? &line->appears : NULL,
                          given & 1u << VANISHES_FIELD ? &line->vanishes : NULL);
}

static int check_name(struct tia_parse *job, const struct tia_word *name)
{
    return tia_word_is(name, "camera") ? tia_text_error(&job->text, name, "is the camera's name", "another") : TIA_OK;
}

/* True if the shape is moved by a group, or by an operation of the open solid. */
static bool is_moved(const struct tia_parse *job)
{
    return job->group_count && !(job->solid_groups && tia_group_is_still(job));
}

/* Moves the shape with its groups, and adds it. */
static int place_shape(struct tia_parse *job, struct shape_line *line, uint32_t given)
{
    int status = TIA_OK;

    if (is_moved(job)) {
        status = tia_group_place(job, &line->transform, given & NAMED ? &line->name : NULL);
        given |= PLACED;
    }
    if (status)
        return status;
    return job->solid_groups ? add_member(job, line, given) : add_shape(job, line, given);
}

/* Reads the fields of a shape. Its kind is set, and so is the mesh or grid of an instance. */
static int read_fields(struct tia_parse *job, struct shape_line *line)
{
    const struct shape_description *description = tia_shape_description(line->shape.kind);
    struct tia_field fields[COMMON_FIELDS + SHAPE_FIELDS_MAX];
    uint32_t given = 0;
    unsigned count = fields_of(description, fields);

    fields[MATERIAL_FIELD].needed = !line->may_own;
    int status = tia_fields(&job->text, description->what, fields, count, line, &given);
    if (!description->add_bounds)
        given &= NAMED - 1; /* the bits from NAMED on are the shape's own fields */
    if (!status && (given & NAMED))
        status = check_name(job, &line->name);
    if (!status && line->parts > 1 && given & SHOWN)
        status = tia_text_error(&job->text, &job->first, "has several materials", "one if it appears or vanishes");
    line->shape.material = TIA_OWN_MATERIAL;
    if (!status && given & OF_MATERIAL)
        status =
            tia_parse_find(job, TIA_NAMED_MATERIAL, &line->material, "the name of a material", &line->shape.material);
    if (!status && is_moved(job) && !description->add_bounds)
        status = tia_text_error(&job->text, &job->first, "is not moved by groups", "it outside of them");
    return status ? status : place_shape(job, line, given);
}

static struct shape_line line_of(enum tia_shape_kind kind)
{
    return (struct shape_line){
        .transform = {.scale = {TIA_Q16_ONE, TIA_Q16_ONE, TIA_Q16_ONE}}, .shape = {.kind = kind}, .parts = 1};
}

int tia_line_shape(struct tia_parse *job, enum tia_shape_kind kind)
{
    struct shape_line line = line_of(kind);

    return read_fields(job, &line);
}

/* Sets the mesh of an instance. Which meshes are models is known in the last pass; one whose line has a mistake may be
 * a model. */
static void set_mesh(struct tia_parse *job, struct shape_line *line, const struct tia_word *name, uint32_t mesh)
{
    const struct tia_parse_model *model = job->pass == TIA_FILLING ? tia_model_at(job, mesh) : NULL;

    line->shape.mesh = mesh;
    line->may_own = model || job->pass != TIA_FILLING || tia_parse_has(job, TIA_NAMED_FAULTY, name);
    line->parts = model ? model->parts : 1;
}

int tia_line_instance(struct tia_parse *job)
{
    struct shape_line line = line_of(TIA_MESH);
    struct tia_word solid;
    uint32_t index = 0;
    const char *expected = "the name of a mesh or grid";
    int status = tia_text_name(&job->text, &solid, expected);

    status = status ? status : tia_parse_find(job, TIA_NAMED_SOLID, &solid, expected, &index);
    if (status)
        return status;
    if (index % 2) {
        line.shape.kind = TIA_GRID;
        line.shape.grid = index / 2;
    } else {
        set_mesh(job, &line, &solid, index / 2);
    }
    if (job->pass == TIA_COUNTING)
        tia_models_note(job, &solid);
    return read_fields(job, &line);
}

/* Reads the first line of a solid. It has all common fields but the material. */
static int begin_solid(struct tia_parse *job)
{
    struct shape_line line = line_of(TIA_SOLID);
    struct tia_solid solid = {NULL, NULL, 0, 0};
    uint32_t given = 0;
    int status = tia_fields(&job->text, "a solid", common_fields + 1, COMMON_FIELDS - 1, &line, &given);

    given <<= 1;
    if (!status && (given & NAMED))
        status = check_name(job, &line.name);
    if (status)
        return status;
    solid.members = tia_parse_at(job, TIA_OF_MEMBERS, tia_parse_count(job, TIA_OF_MEMBERS));
    solid.steps = tia_parse_at(job, TIA_OF_STEPS, tia_parse_count(job, TIA_OF_STEPS));
    line.shape.solid = tia_parse_add(job, TIA_OF_SOLIDS, &solid);
    return place_shape(job, &line, given);
}

static int read_operation(struct tia_parse *job, enum tia_solid_step step)
{
    int status = job->solid_groups ? TIA_OK : begin_solid(job);

    return status ? status : tia_operation_begin(job, step);
}

int tia_line_union(struct tia_parse *job)
{
    return read_operation(job, TIA_SOLID_UNION);
}

int tia_line_intersection(struct tia_parse *job)
{
    return read_operation(job, TIA_SOLID_INTERSECTION);
}

int tia_line_difference(struct tia_parse *job)
{
    return read_operation(job, TIA_SOLID_DIFFERENCE);
}
