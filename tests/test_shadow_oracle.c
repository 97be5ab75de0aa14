/* Exact shadow rays against rays in double precision, which start from the scene in the world, without rounding of
 * vertices. Vertices have 18 bits or more, so a few pixels may show another face. */
#include <stdlib.h>

#include "check.h"
#include "common/corpus/corpus_flat.h"
#include "oracle/face_shadows.h"
#include "oracle/rays.h"
#include "shadow/technique.h"

#define WIDTH 64
#define HEIGHT 48
#define PIXELS (WIDTH * HEIGHT)
#define SCENES 120

static struct cancel never;

struct picture {
    struct tia_shadow_view view;
    struct tia_shadow_tile tile;
    uint64_t lit[PIXELS];
    void *flat, *own, *target;
};

static void set_lights(struct picture *p)
{
    const struct tia_scene *s = p->view.scene;

    for (uint32_t n = 0; n < s->light_count; n++)
        for (unsigned i = 0; i < tia_flat_light_samples(&s->lights[n]); i++)
            tia_flat_light_at(&p->view.flat, &s->lights[n], i, &p->view.samples[p->view.sample_count++]);
}

static void open_picture(struct picture *p, const struct tia_scene *scene)
{
    const struct tia_shadow_technique *technique = tia_shadow_technique(scene->shadows);
    const struct tia_tile all = {0, 0, WIDTH, HEIGHT};
    size_t size = tia_flat_size(scene);

    *p = (struct picture){.view.scene = scene, .tile.lit = p->lit};
    p->flat = malloc(size);
    CHECK(!tia_flat_init(&p->view.flat, p->flat, size, scene, WIDTH, HEIGHT, &never));
    p->view.own_size = technique->own_size(scene);
    p->view.own = p->own = malloc((size_t)p->view.own_size);
    set_lights(p);
    size = tia_raster_size(all, TIA_BUFFER_DEPTH | TIA_BUFFER_COUNT, p->view.flat.face_count);
    p->target = malloc(size);
    CHECK(!tia_raster_init(&p->tile.target, p->target, size, &p->view.flat.grid, all,
                           TIA_BUFFER_DEPTH | TIA_BUFFER_COUNT, p->view.flat.face_count));
    CHECK(!tia_shadow_faces(&p->tile.target, &p->view.flat, &never));
    CHECK(!technique->prepare(&p->view, &never) && !technique->set_lights(&p->view, &never));
    for (unsigned i = 0; i < p->view.sample_count; i++)
        technique->light(&p->view, &p->tile, i, &never);
}

static void close_picture(struct picture *p)
{
    free(p->flat);
    free(p->own);
    free(p->target);
}

struct tally {
    unsigned pixels, other_object, answers, dark, other_light, techniques;
};

static void compare_pixel(const struct picture *p, const struct oracle_face *faces, uint32_t count, int at,
                          struct tally *t)
{
    const struct tia_scene *s = p->view.scene;
    struct ray eye = oracle_camera(&s->camera, s->fine, WIDTH, HEIGHT, at % WIDTH + 0.5, at / WIDTH + 0.5);
    double distance;
    uint32_t seen = oracle_face_seen(faces, count, eye, &distance), face = p->tile.target.face[at];
    unsigned sample = 0;

    t->pixels++;
    if ((seen == ORACLE_NO_FACE) != (face == TIA_NO_FACE) ||
        (face != TIA_NO_FACE && tia_flat_object_of(&p->view.flat, face)->object != faces[seen].object)) {
        t->other_object++;
        return;
    }
    for (uint32_t n = 0; seen != ORACLE_NO_FACE && n < s->light_count; n++)
        for (unsigned i = 0; i < tia_flat_light_samples(&s->lights[n]); i++) {
            bool lit = oracle_face_lit(faces, count, seen, eye, distance, &s->lights[n], i);
            t->answers++;
            t->dark += !lit;
            t->other_light += lit != (p->lit[at] >> sample++ & 1);
        }
}

static void compare(const struct tia_scene *scene, struct tally *t)
{
    uint32_t count = oracle_faces(scene, NULL);
    struct oracle_face *faces = malloc((count + 1) * sizeof *faces);
    static struct picture p, other;
    struct tia_scene volumes = *scene;

    CHECK_EQ(oracle_faces(scene, faces), count);
    open_picture(&p, scene);
    for (int at = 0; at < PIXELS; at++)
        compare_pixel(&p, faces, count, at, t);
    for (volumes.shadows = TIA_SHADOWS_ZPASS; volumes.shadows <= TIA_SHADOWS_ZFAIL; volumes.shadows++) {
        open_picture(&other, &volumes);
        t->techniques += memcmp(other.lit, p.lit, sizeof p.lit) != 0;
        close_picture(&other);
    }
    close_picture(&p);
    free(faces);
}

/* At present no pixel differs, of 368640 pixels and 1186686 shadow rays. */
TEST(corpus)
{
    static struct corpus_rays scene;
    struct tally t = {0};

    for (unsigned i = 0; i < check_count(SCENES); i++) {
        corpus_random_flat(&scene, 21, i);
        scene.scene.shadows = TIA_SHADOWS_RAYS;
        CHECK_EQ(tia_scene_check(&scene.scene, NULL), TIA_OK);
        compare(&scene.scene, &t);
    }
    printf("# %u of %u pixels see another object; %u of %u answers differ, %u are dark\n", t.other_object, t.pixels,
           t.other_light, t.answers, t.dark);
    CHECK_EQ(t.techniques, 0);
    CHECK(t.other_object <= t.pixels / 100000 && t.other_light <= t.answers / 100000);
    CHECK(t.dark > t.answers / 10 && t.dark < t.answers * 9 / 10);
}

int main(void)
{
    RUN(corpus);
    return check_status();
}
