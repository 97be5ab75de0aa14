/* nff.c - Eric Haines's Neutral File Format, version 3.1, of the Standard Procedural Databases.
 *
 * Haines's words in quotes, and this reader's interpretation:
 *
 *     v from at up angle      the angle is the whole field of view, "from the center of top pixel row to bottom
 *                             pixel row"; this reader, like others, measures it between the edges of the picture
 *     hither resolution       for hidden surface algorithms and displays: read and ignored
 *     b r g b                 background; "if no background color is set, assume RGB = {0,0,0}"
 *     l x y z [r g b]         a point light without attenuation; its default colour is 1/sqrt(number of lights)
 *     f r g b Kd Ks Shine T index
 *                             diffuse Kd (r, g, b); "Ks the specular": both highlight and mirror, Ks in each
 *                             channel; "Shine is the Phong cosine power for highlights": 0 means no highlight,
 *                             otherwise clamped to 1..TIA_EXPONENT_MAX (the databases use 100000, with Ks = 0);
 *                             "T is transmittance (fraction of contribution of the transmitting ray)": both
 *                             refraction and transmission, in each channel; index 0 means 1. The default
 *                             material, before the first f, is white: f 1 1 1 1 0 0 0 1
 *     s c                     a sphere; a cylinder or, with different radii, a cone, "without endcaps"; a
 *                             negative radius would show the inside only, but here both sides are visible
 *     p pp                    polygons and patches with normals, convex or not; all those after one f make one
 *                             mesh; with T > 0 each is a group, so that it filters shadow rays by itself
 *
 * "Normally, objects have one side": here they always have two, as objects with T > 0 have in the databases.
 */
#include "nff.h"
#include "math/integer.h"
#include "read/alter.h"
#include "read/surface.h"

/* ---- view, background, lights ---- */

static int read_v(struct nff *n)
{
    n->view |= VIEW_V;
    return TIA_OK;
}

static int read_from(struct nff *n)
{
    n->view |= VIEW_FROM;
    int status = tia_text_fine_place(&n->text, &n->scene->camera.eye, &n->fine.eye);
    return status;
}

static int read_at(struct nff *n)
{
    n->view |= VIEW_AT;
    int status = tia_text_fine_place(&n->text, &n->scene->camera.reference, &n->fine.reference);
    return status;
}

static int read_up(struct nff *n)
{
    struct tia_vec3 *up = &n->scene->camera.up;
    struct tia_word first;

    n->view |= VIEW_UP;
    (void)tia_text_peek(&n->text, &first);
    int status = tia_text_vector(&n->text, up);
    if (!status && !up->x && !up->y && !up->z)
        return tia_text_error(&n->text, &first, "begins an up vector of no length", "three numbers that are not all 0");
    return status;
}

static int read_angle(struct nff *n)
{
    n->view |= VIEW_ANGLE;
    return tia_text_q16(&n->text, &n->scene->camera.fov);
}

static int read_hither(struct nff *n)
{
    int64_t distance;
    return tia_text_q32(&n->text, &distance);
}

static int read_resolution(struct nff *n)
{
    int64_t size;
    int status = tia_text_integer(&n->text, &size, 0, UINT32_MAX);

    return status ? status : tia_text_integer(&n->text, &size, 0, UINT32_MAX);
}

static int read_b(struct nff *n)
{
    n->backgrounds++;
    return tia_text_rgb(&n->text, &n->scene->background, false);
}

/* Returns 1/sqrt(count) as Q2.30, rounded to nearest: the square root of 2^62/count has one more fractional bit. */
static tia_q30 intensity(uint32_t count)
{
    return (tia_q30)((tia_sqrt64((UINT64_C(1) << 62) / count) + 1) >> 1);
}

static int read_l(struct nff *n)
{
    struct tia_light light = {.kind = TIA_POINT_LIGHT};
    int status = tia_text_place(&n->text, &light.centre);

    tia_lengths_cover(&n->lengths, light.centre, 0);
    if (!status && tia_text_has_number(&n->text))
        status = tia_text_rgb(&n->text, &light.emission, true);
    else if (n->lights.capacity)
        light.emission = tia_grey(intensity(n->lights.capacity));
    tia_array_add(&n->lights, &light);
    return status;
}

/* ---- materials ---- */

static int read_f(struct nff *n)
{
    struct tia_text *t = &n->text;
    struct tia_material m = {.index = TIA_Q16_ONE};
    tia_q30 kd = 0, ks = 0, transmittance = 0;
    tia_q16 exponent = 0;
    int status = tia_text_rgb(t, &m.colour, true); /* only the product with Kd must be at most 1 */

    status = status ? status : tia_text_bright(t, &kd);
    status = status ? status : tia_text_unit(t, &ks);
    status = status ? status : tia_text_exponent(t, &exponent);
    status = status ? status : tia_text_unit(t, &transmittance);
    status = status ? status : tia_text_q16(t, &m.index);
    m.colour = tia_rgb_product(m.colour, kd);
    m.mirror = tia_grey(ks);
    tia_set_highlight(&m, tia_grey(ks), exponent);
    m.refraction = m.transmission = tia_grey(transmittance);
    m.index = transmittance && m.index ? m.index : TIA_Q16_ONE;
    tia_nff_close_mesh(n);
    n->transmits = transmittance > 0;
    tia_array_add(&n->materials, &m);
    return status;
}

/* ---- the whole file ---- */

static const struct {
    const char *name;
    int (*read)(struct nff *);
} statements[] = {
    {"v", read_v},
    {"from", read_from},
    {"at", read_at},
    {"up", read_up},
    {"angle", read_angle},
    {"hither", read_hither},
    {"resolution", read_resolution},
    {"b", read_b},
    {"l", read_l},
    {"f", read_f},
    {"s", tia_nff_s},
    {"c", tia_nff_c},
    {"p", tia_nff_p},
    {"pp", tia_nff_pp},
};

static int read_statement(struct nff *n, const struct tia_word *word)
{
    for (size_t i = 0; i < sizeof statements / sizeof *statements; i++)
        if (tia_word_is(word, statements[i].name)) {
            n->statement = statements[i].name;
            n->rest = n->text;
            int status = statements[i].read(n);
            return status ? status : tia_text_end(&n->text);
        }
    return tia_text_error(&n->text, word, "is not a statement", "v, b, l, f, c, s, p, pp or a # comment");
}

static bool is_same(const char *a, const char *b)
{
    while (*a && *a == *b)
        a++, b++;
    return *a == *b;
}

/* True if the statement just read created the object with the fault. */
static bool is_found(const struct nff *n)
{
    const struct {
        const char *thing;
        uint32_t made;
    } kinds[] = {{"material", n->materials.count},
                 {"light", n->lights.count},
                 {"sphere", n->spheres.count},
                 {"shape", n->shapes.count},
                 {"mesh", n->meshes.count + (n->mesh.vertex_count > 0)},
                 {"camera", n->view & VIEW_V},
                 {"scene", n->backgrounds}};

    if (n->line)
        return is_same(n->line, n->statement);
    for (size_t i = 0; n->fault && i < sizeof kinds / sizeof *kinds; i++)
        if (is_same(n->fault->thing, kinds[i].thing))
            return kinds[i].made > n->fault->index;
    return false;
}

static void alter_camera(struct nff *n, const struct tia_reader *reader)
{
    struct tia_camera *camera = &n->scene->camera;

    if (reader->camera && reader->camera->has_eye)
        n->fine.eye = (struct tia_fine_place){0, 0, 0};
    if (reader->camera && reader->camera->has_reference)
        n->fine.reference = (struct tia_fine_place){0, 0, 0};
    tia_alter_measured(reader, camera, &n->lengths);
    tia_lengths_cover_eye(&n->lengths, camera->eye);
    tia_lengths_cover(&n->lengths, camera->reference, 0);
}

/* Reads the file once. When searching for a fault, stops at the statement that created the object, and sets the error's
 * place to it. */
static int read_all(struct nff *n, const struct tia_reader *reader, struct tia_read_error *error)
{
    struct tia_word word;

    n->text = tia_text_begin(reader->text, reader->length, "", error);
    n->text.lengths = &n->lengths;
    while (tia_text_line(&n->text)) {
        (void)tia_text_word(&n->text, &word);
        int status = read_statement(n, &word);
        if (status)
            return status;
        if (is_found(n)) {
            tia_text_error_place(&n->text, &word);
            return TIA_OK;
        }
    }
    tia_nff_close_mesh(n);
    alter_camera(n, reader);
    return TIA_OK;
}

static struct nff begin(struct tia_scene *scene)
{
    struct nff n = {.scene = scene,
                    .materials = {.item = sizeof(struct tia_material)},
                    .lights = {.item = sizeof(struct tia_light)},
                    .spheres = {.item = sizeof(struct tia_sphere)},
                    .shapes = {.item = sizeof(struct tia_shape)},
                    .meshes = {.item = sizeof(struct tia_mesh)},
                    .vertices = {.item = sizeof(struct tia_vec3)},
                    .normals = {.item = sizeof(struct tia_dir3)},
                    .faces = {.item = sizeof(struct tia_face)},
                    .groups = {.item = sizeof(uint32_t)},
                    .fine_spheres = {.item = sizeof(struct tia_fine_sphere)},
                    .fine_shapes = {.item = sizeof(struct tia_fine_ends)}};

    tia_lengths_begin(&n.lengths, 0, 0);
    return n;
}

static void place(struct nff *n, struct tia_arena *arena)
{
    struct tia_scene *scene = n->scene;

    scene->material_count = n->materials.count;
    scene->light_count = n->lights.count;
    scene->sphere_count = n->spheres.count;
    scene->shape_count = n->shapes.count;
    scene->mesh_count = n->meshes.count;
    scene->materials = tia_array_place(arena, &n->materials);
    scene->lights = tia_array_place(arena, &n->lights);
    scene->spheres = tia_array_place(arena, &n->spheres);
    scene->shapes = tia_array_place(arena, &n->shapes);
    scene->meshes = tia_array_place(arena, &n->meshes);
    (void)tia_array_place(arena, &n->vertices);
    (void)tia_array_place(arena, &n->normals);
    (void)tia_array_place(arena, &n->faces);
    (void)tia_array_place(arena, &n->groups);
    n->fine.spheres = tia_array_place(arena, &n->fine_spheres);
    n->fine.shapes = tia_array_place(arena, &n->fine_shapes);
    n->corners = tia_arena_take(arena, n->most_corners, sizeof *n->corners);
}

/* Reports the first missing line of the view. */
static int check_view(struct nff *n)
{
    static const char *const names[] = {"v", "from", "at", "up", "angle"};
    struct tia_word end;

    for (unsigned i = 0; i < sizeof names / sizeof *names; i++)
        if (!(n->view >> i & 1)) {
            (void)tia_text_word(&n->text, &end);
            (void)tia_text_error_at(&n->text, &end);
            tia_say(n->text.error, "the view has no '");
            tia_say(n->text.error, names[i]);
            tia_say(n->text.error, "', expected v, from, at, up and angle");
            return TIA_ERR_RANGE;
        }
    return TIA_OK;
}

/* Reads the text again, with lengths times 2^bits, and stores the objects. */
static int fill(struct nff *n, struct tia_reader *reader, int bits)
{
    struct tia_array *const arrays[] = {&n->materials, &n->lights,       &n->spheres,    &n->shapes,
                                        &n->meshes,    &n->vertices,     &n->normals,    &n->faces,
                                        &n->groups,    &n->fine_spheres, &n->fine_shapes};

    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++)
        tia_array_restart(arrays[i]);
    n->transmits = false;
    n->lengths.filling = true;
    n->lengths.scale_bits = n->scene->scale_bits = bits;
    reader->error = (struct tia_read_error){.line = 0};
    return read_all(n, reader, &reader->error);
}

int tia_read_nff(struct tia_reader *reader, struct tia_scene *scene, struct tia_arena *arena)
{
    struct nff n = begin(scene);
    int bits = 0, status;

    do {
        n = begin(scene);
        tia_lengths_begin(&n.lengths, bits, reader->reach);
        status = read_all(&n, reader, &reader->error);
    } while (!status && !reader->unscaled && tia_lengths_widen(&n.lengths, &bits));
    status = status ? status : check_view(&n);
    if (status)
        return status;
    place(&n, arena);
    struct tia_fine *fine = tia_arena_take(arena, 1, sizeof *fine);
    if (!tia_arena_fits(arena))
        return TIA_OK;
    int room = reader->unscaled ? 0 : tia_lengths_room(&n.lengths);
    status = fill(&n, reader, bits == 0 && room < 0 ? 0 : room);
    *fine = n.fine;
    scene->fine = fine;
    if (room < scene->scale_bits && (status || tia_scene_check(scene, NULL))) {
        status = fill(&n, reader, room);
        *fine = n.fine;
    }
    return status;
}

/* The file's name for a field of the scene, "" for the whole line, and the index of the field's word in the line. */
static const struct nff_field {
    const char *thing, *field, *name;
    unsigned word;
} fields[] = {
    {"camera", "eye", "from", 0},
    {"camera", "reference", "at", 0},
    {"camera", "up", "up", 0},
    {"camera", "fov", "angle", 0},
    {"material", "colour", "Kd", 3},
    {"material", "index", "index", 7},
    {"sphere", "centre", "", 0},
    {"sphere", "radius", "radius", 3},
    {"light", "centre", "", 0},
    {"shape", "base_radius", "radius", 3},
    {"shape", "top_radius", "radius", 7},
    {"shape", "radius", "radius", 3},
    {"shape", "top", "", 4},
    {"shape", "place", "", UINT16_MAX},
};

void tia_locate_nff(struct tia_reader *reader, struct tia_fault *fault)
{
    struct tia_scene scene = {.bvh = NULL};
    struct nff n = begin(&scene);
    const struct nff_field *field = fields;

    while (field < fields + sizeof fields / sizeof *fields &&
           !(is_same(field->thing, fault->thing) && is_same(field->field, fault->field)))
        field++;
    bool known = field < fields + sizeof fields / sizeof *fields;
    n.fault = fault;
    n.line = known && is_same(fault->thing, "camera") ? field->name : NULL;
    (void)read_all(&n, reader, &reader->error);
    if (!reader->error.line)
        return;
    fault->thing = n.line ? "v" : n.statement;
    fault->field = known ? field->name : fault->field;
    if (known)
        (void)tia_text_locate(n.rest, field->word, NULL, &reader->error);
}
