/* The random scenes for general rays: accepted, of every kind, and the same on every machine. */
#include "check.h"
#include "common/corpus/corpus_rays.h"

#define SCENES 400

TEST(every_scene_is_accepted)
{
    static struct corpus_rays c;
    struct tia_fault fault = {0};

    for (unsigned i = 0; i < SCENES; i++) {
        corpus_random_rays(&c, 1 + i % 7, i);
        CHECK_MSG(!tia_scene_check(&c.scene, &fault), "scene %u: %s %u: %s: %s", i, fault.thing, fault.index,
                  fault.field, fault.rule);
        corpus_add_opacity(&c, i);
        CHECK_MSG(!tia_scene_check(&c.scene, &fault), "scene %u: %s %u: %s: %s", i, fault.thing, fault.index,
                  fault.field, fault.rule);
    }
}

/* Counts of each kind of object. */
struct census {
    unsigned shapes[TIA_ROUNDED + 1], lights[TIA_SPHERE_LIGHT + 1], projections[TIA_ORTHOGRAPHIC + 1], samples[17];
    unsigned spheres, instances, smooth, mirrors, glass, fresnel, textures[4], filters, seen, look_at, depths;
};

static void count_materials(struct census *n, const struct tia_material *m)
{
    n->mirrors += m->mirror.r > 0;
    n->glass += m->refraction.r > 0;
    n->fresnel += m->fresnel;
    n->textures[m->texture]++;
    n->filters += m->transmission.r > 0;
}

static void count(struct census *n, const struct corpus_rays *c)
{
    const struct tia_scene *s = &c->scene;

    n->spheres += s->sphere_count;
    n->projections[s->camera.projection]++;
    n->samples[s->camera.samples]++;
    n->look_at += s->camera.up.y > 0;
    n->depths += s->depth != 0;
    for (uint32_t i = 0; i < s->shape_count; i++) {
        n->shapes[s->shapes[i].kind]++;
        n->instances += s->shapes[i].transform != 0;
        n->smooth +=
            s->shapes[i].kind == TIA_MESH && s->shapes[i].mesh == 1 && c->land[0].corner[0].normal != TIA_NO_INDEX;
        count_materials(n, &s->materials[s->shapes[i].material]);
    }
    for (uint32_t i = 0; i < s->light_count; i++) {
        n->lights[s->lights[i].kind]++;
        n->seen += s->lights[i].kind == TIA_POINT_LIGHT && s->lights[i].radius > 0;
    }
}

static void at_least(const unsigned *counts, size_t length, const char *what)
{
    for (size_t i = 0; i < length; i++)
        CHECK_MSG(counts[i] >= 10, "%s %u occurs %u times", what, (unsigned)i, counts[i]);
}

TEST(scenes_have_variety)
{
    static struct corpus_rays c;
    struct census n = {{0}};

    for (unsigned i = 0; i < 100; i++) {
        corpus_random_rays(&c, 1, i);
        count(&n, &c);
    }
    at_least(n.shapes, TIA_ROUNDED + 1, "shape");
    at_least(n.lights, TIA_SPHERE_LIGHT + 1, "light");
    at_least(n.projections, TIA_ORTHOGRAPHIC + 1, "projection");
    at_least(n.textures, 4, "texture");
    const unsigned others[] = {n.spheres, n.instances, n.smooth, n.mirrors, n.glass,     n.fresnel,
                               n.filters, n.look_at,   n.depths, n.seen,    n.samples[4]};
    at_least(others, sizeof others / sizeof others[0], "thing");
    CHECK(n.samples[16] > 0 && n.samples[0] > 0 && n.samples[1] > 0);
}

/* Continues an FNV-1a hash by a value's four bytes, the lowest first. */
static uint32_t hash(uint32_t h, int32_t value)
{
    for (int shift = 0; shift < 32; shift += 8)
        h = (h ^ ((uint32_t)value >> shift & 255)) * 16777619u;
    return h;
}

static uint32_t hash_scene(uint32_t h, const struct corpus_rays *c)
{
    h = hash(hash(hash(h, (int32_t)c->width), (int32_t)c->height), c->scene.camera.eye.x);
    h = hash(hash(h, c->scene.camera.window.top), (int32_t)c->scene.shape_count);
    for (uint32_t i = 0; i < c->scene.shape_count; i++) {
        h = hash(hash(h, c->shapes[i].kind), (int32_t)c->shapes[i].transform);
        h = hash(hash(h, c->materials[i].colour.g), c->materials[i].index);
    }
    for (uint32_t i = 0; i < c->scene.transform_count; i++)
        h = hash(hash(h, c->transforms[i].rotation.y), c->transforms[i].scale.z);
    for (uint32_t i = 0; i < c->scene.light_count; i++)
        h = hash(hash(h, c->lights[i].direction.z), c->lights[i].quadratic);
    h = hash(hash(h, c->heights[7].y), c->texels[9]);
    return hash(h, c->cells[5]);
}

/* The hash of these scenes when the accuracy tables were made. */
TEST(scenes_are_the_same_everywhere)
{
    static struct corpus_rays c;
    uint32_t h = 2166136261u;

    for (unsigned i = 0; i < 100; i++) {
        corpus_random_rays(&c, 1, i);
        h = hash_scene(h, &c);
    }
    CHECK_MSG(h == 0xd3e5f712, "0x%08x", (unsigned)h);
}

int main(void)
{
    RUN(every_scene_is_accepted);
    RUN(scenes_have_variety);
    RUN(scenes_are_the_same_everywhere);
    return check_status();
}
