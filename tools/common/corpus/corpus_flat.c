#include "corpus_flat.h"

#include <tia/bvh.h>

#include "corpus_rays.h"

#define SAMPLES 9

static struct tia_shape box_around(const struct tia_scene *scene, uint32_t object, uint32_t material)
{
    struct tia_bounds bounds = tia_object_bounds(scene, object);

    return (struct tia_shape){.kind = TIA_BOX, .material = material, .box = {bounds.min, bounds.max}};
}

static bool is_flat(enum tia_shape_kind kind)
{
    return kind == TIA_PLANE || kind == TIA_BOX || kind == TIA_TRIANGLE || kind == TIA_MESH;
}

/* Replaces shapes that are not flat by boxes and removes the spheres; if no shape is left, adds a box in place of the
 * first sphere. */
static void flatten_shapes(struct corpus_rays *out)
{
    struct tia_scene *s = &out->scene;

    for (uint32_t i = 0; i < s->shape_count; i++)
        if (!is_flat(out->shapes[i].kind))
            out->shapes[i] = box_around(s, s->sphere_count + i, out->shapes[i].material);
    if (s->sphere_count && !s->shape_count)
        out->shapes[s->shape_count++] = box_around(s, 0, 0);
    s->sphere_count = 0;
}

static void flatten_light(struct tia_light *light)
{
    static const struct tia_vec3 sides[2] = {TIA_VEC3(0.5, 0, 0), TIA_VEC3(0, 0.2, 0.5)};

    if (!tia_light_has(light->kind, TIA_LIGHT_AREA))
        return;
    if (!tia_light_has(light->kind, TIA_LIGHT_SIDES)) {
        light->radius = 0;
        light->side[0] = sides[0];
        light->side[1] = sides[1];
    }
    light->kind = TIA_RECTANGLE_LIGHT;
    if (!light->samples || light->samples > SAMPLES)
        light->samples = SAMPLES;
}

/* Makes all materials opaque, and makes each light use the same sample points in all pixels. */
static void simplify(struct corpus_rays *out)
{
    out->scene.camera.samples = 1;
    for (uint32_t i = 0; i < out->scene.material_count; i++) {
        out->materials[i].transmission = (struct tia_rgb){0, 0, 0};
        out->materials[i].opacity = 0;
    }
    for (uint32_t i = 0; i < out->scene.light_count; i++)
        flatten_light(&out->lights[i]);
}

void corpus_random_opaque(struct corpus_rays *out, uint64_t seed, unsigned index)
{
    corpus_random_rays(out, seed, index);
    simplify(out);
}

void corpus_random_flat(struct corpus_rays *out, uint64_t seed, unsigned index)
{
    corpus_random_rays(out, seed, index);
    flatten_shapes(out);
    simplify(out);
}
