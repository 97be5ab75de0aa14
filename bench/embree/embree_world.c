#include "embree_world.h"

#include <stdlib.h>

const bool embree_is_there = true;

static void rgb_of(const struct tia_rgb *c, float out[3])
{
    out[0] = (float)c->r / 1073741824;
    out[1] = (float)c->g / 1073741824;
    out[2] = (float)c->b / 1073741824;
}

static bool is_black(const struct tia_rgb *c)
{
    return !(c->r | c->g | c->b);
}

static struct embree_material material_of(const struct tia_material *m)
{
    struct embree_material to = {.exponent = (float)m->exponent / 65536,
                                 .index = (float)m->index / 65536,
                                 .shines = !is_black(&m->specular),
                                 .reflects = !is_black(&m->mirror),
                                 .refracts = !is_black(&m->refraction),
                                 .passes = !is_black(&m->transmission)};

    rgb_of(&m->colour, to.colour);
    rgb_of(&m->specular, to.specular);
    rgb_of(&m->mirror, to.mirror);
    rgb_of(&m->refraction, to.refraction);
    rgb_of(&m->transmission, to.transmission);
    return to;
}

static bool is_known(const struct tia_shape *s)
{
    return !s->transform && (s->kind == TIA_MESH || (s->kind == TIA_CYLINDER && !s->cylinder.capped) ||
                             (s->kind == TIA_CONE && !s->cone.capped));
}

static bool takes(const struct tia_scene *scene)
{
    bool all = scene->camera.projection == TIA_PERSPECTIVE && scene->camera.samples < 2 && !scene->texture_count &&
               scene->depth <= EMBREE_DEPTH;

    for (uint32_t i = 0; i < scene->light_count; i++)
        all = all && scene->lights[i].kind == TIA_POINT_LIGHT && !scene->lights[i].radius && !scene->lights[i].linear &&
              !scene->lights[i].quadratic;
    for (uint32_t i = 0; i < scene->shape_count; i++)
        all = all && is_known(&scene->shapes[i]);
    return all;
}

/* Members of N rays or hits, which lie one after the other as N words each: Embree has functions for them in C++ alone.
 */
enum { RAY_ID = 10, HIT_ITEM = 5, HIT_GEOMETRY = 6 };

static uint32_t member_of(const void *packet, unsigned number, unsigned n, unsigned i)
{
    return ((const uint32_t *)packet)[number * n + i];
}

/* Filters the hits of shadow rays: a transparent object lets light pass, reduced by its transmission. */
static void let_pass(const struct RTCFilterFunctionNArguments *args)
{
    const struct embree *e = args->geometryUserPtr;
    const struct embree_context *context = (const struct embree_context *)args->context;

    for (unsigned i = 0; i < args->N; i++) {
        if (args->valid[i] != -1)
            continue;
        uint32_t geometry = member_of(args->hit, HIT_GEOMETRY, args->N, i);
        uint32_t item = member_of(args->hit, HIT_ITEM, args->N, i);
        const struct embree_material *m = &e->materials[e->material_of[geometry][item]];
        if (!m->passes)
            continue;
        float *through = context->through[member_of(args->ray, RAY_ID, args->N, i)];
        for (int c = 0; c < 3; c++)
            through[c] *= m->transmission[c];
        args->valid[i] = 0;
    }
}

static void attach(struct embree *e, RTCGeometry geometry, enum embree_geometry number)
{
    bool passes = false;

    for (uint32_t i = 0; i < e->given->material_count; i++)
        passes = passes || e->materials[i].passes;
    rtcSetGeometryUserData(geometry, e);
    if (passes)
        rtcSetGeometryOccludedFilterFunction(geometry, let_pass);
    embree_attach(&e->made, geometry, number);
}

static void set_round(const struct tia_scene *scene, float to[4], struct tia_vec3 place, tia_q16 radius)
{
    struct vec p = embree_place(scene, place);

    to[0] = p.x;
    to[1] = p.y;
    to[2] = p.z;
    to[3] = embree_length(scene, radius);
}

static void add_spheres(struct embree *e)
{
    const struct tia_scene *scene = e->given;

    if (!scene->sphere_count)
        return;
    RTCGeometry geometry = rtcNewGeometry(e->made.device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    float(*to)[4] = embree_rounds(geometry, scene->sphere_count);
    for (uint32_t i = 0; i < scene->sphere_count; i++) {
        set_round(scene, to[i], scene->spheres[i].centre, scene->spheres[i].radius);
        e->material_of[EMBREE_SPHERES][i] = scene->spheres[i].material;
    }
    e->spheres = (const float(*)[4])to;
    attach(e, geometry, EMBREE_SPHERES);
}

/* Adds cones and cylinders, both as Embree's cones. Each has its own two end points, so that none is joined to
 * another. */
static void add_cones(struct embree *e)
{
    const struct tia_scene *scene = e->given;
    uint32_t count = 0;

    for (uint32_t i = 0; i < scene->shape_count; i++)
        count += scene->shapes[i].kind != TIA_MESH;
    if (!count)
        return;
    RTCGeometry geometry = rtcNewGeometry(e->made.device, RTC_GEOMETRY_TYPE_CONE_LINEAR_CURVE);
    float(*to)[4] = embree_rounds(geometry, 2 * count);
    uint32_t *first = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT, 4, count), n = 0;
    for (uint32_t i = 0; i < scene->shape_count; i++) {
        const struct tia_shape *s = &scene->shapes[i];
        if (s->kind == TIA_MESH)
            continue;
        bool cone = s->kind == TIA_CONE;
        set_round(scene, to[2 * n], cone ? s->cone.base : s->cylinder.base,
                  cone ? s->cone.base_radius : s->cylinder.radius);
        set_round(scene, to[2 * n + 1], cone ? s->cone.top : s->cylinder.top,
                  cone ? s->cone.top_radius : s->cylinder.radius);
        e->material_of[EMBREE_CONES][n] = s->material;
        first[n] = 2 * n;
        n++;
    }
    attach(e, geometry, EMBREE_CONES);
}

static void add_face(struct embree *e, const struct tia_mesh *mesh, uint32_t face, uint32_t n, struct vec corners[3])
{
    struct embree_face *to = &e->faces[n];

    to->smooth = true;
    for (int k = 0; k < 3; k++) {
        struct tia_corner corner = mesh->faces[face].corner[k];
        corners[k] = embree_place(e->given, mesh->vertices[corner.vertex]);
        to->smooth = to->smooth && corner.normal != TIA_NO_INDEX;
        if (!to->smooth)
            continue;
        struct tia_dir3 d = mesh->normals[corner.normal];
        to->normal[k] = vec_unit((struct vec){(float)d.x, (float)d.y, (float)d.z});
    }
    to->geometric = vec_unit(vec_cross(vec_sub(corners[1], corners[0]), vec_sub(corners[2], corners[0])));
}

static uint32_t face_count(const struct tia_scene *scene)
{
    uint32_t count = 0;

    for (uint32_t i = 0; i < scene->shape_count; i++)
        count += scene->shapes[i].kind == TIA_MESH ? scene->meshes[scene->shapes[i].mesh].face_count : 0;
    return count;
}

static void add_faces(struct embree *e)
{
    const struct tia_scene *scene = e->given;
    uint32_t count = face_count(scene), n = 0;

    if (!count)
        return;
    RTCGeometry geometry = rtcNewGeometry(e->made.device, RTC_GEOMETRY_TYPE_TRIANGLE);
    struct vec(*corners)[3] = embree_triangles(geometry, count);
    for (uint32_t i = 0; i < scene->shape_count; i++) {
        const struct tia_shape *s = &scene->shapes[i];
        for (uint32_t k = 0; s->kind == TIA_MESH && k < scene->meshes[s->mesh].face_count; k++, n++) {
            add_face(e, &scene->meshes[s->mesh], k, n, corners[n]);
            e->material_of[EMBREE_FACES][n] = s->material;
        }
    }
    attach(e, geometry, EMBREE_FACES);
}

static bool allocate(struct embree *e)
{
    const struct tia_scene *scene = e->given;
    const uint32_t counts[EMBREE_GEOMETRIES] = {[EMBREE_SPHERES] = scene->sphere_count,
                                                [EMBREE_FACES] = face_count(scene),
                                                [EMBREE_CONES] = scene->shape_count};
    bool enough = true;

    e->materials = malloc((scene->material_count + 1) * sizeof *e->materials);
    e->lights = malloc((scene->light_count + 1) * sizeof *e->lights);
    e->faces = malloc((counts[EMBREE_FACES] + 1) * sizeof *e->faces);
    for (int i = 0; i < EMBREE_GEOMETRIES; i++) {
        e->material_of[i] = malloc((counts[i] + 1) * sizeof **e->material_of);
        enough = enough && e->material_of[i];
    }
    return enough && e->materials && e->lights && e->faces;
}

static void fill(struct embree *e)
{
    const struct tia_scene *scene = e->given;

    for (uint32_t i = 0; i < scene->material_count; i++)
        e->materials[i] = material_of(&scene->materials[i]);
    for (uint32_t i = 0; i < scene->light_count; i++) {
        e->lights[i].place = embree_place(scene, scene->lights[i].centre);
        rgb_of(&scene->lights[i].emission, e->lights[i].emission);
    }
    rgb_of(&scene->background, e->background);
    e->depth = scene->depth ? scene->depth : TIA_DEPTH_DEFAULT;
    add_spheres(e);
    add_faces(e);
    add_cones(e);
    rtcCommitScene(e->made.scene);
}

struct embree *embree_open(const struct tia_scene *scene)
{
    struct embree *e = takes(scene) ? calloc(1, sizeof *e) : NULL;

    if (!e)
        return NULL;
    e->given = scene;
    if (!embree_scene_begin(&e->made) || !allocate(e)) {
        embree_close(e);
        return NULL;
    }
    fill(e);
    return e;
}

void embree_close(struct embree *e)
{
    if (!e)
        return;
    embree_scene_end(&e->made);
    for (int i = 0; i < EMBREE_GEOMETRIES; i++)
        free(e->material_of[i]);
    free(e->faces);
    free(e->lights);
    free(e->materials);
    free(e);
}
