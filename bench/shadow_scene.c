#include "shadow_scene.h"

#include "milliseconds.h"
#include "raster/target.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <tia/debug.h>
#include <tia/raster.h>
#include <tia/simd.h>

#define Q(x) ((tia_q16)lrint((x)*65536))

void shadow_must(bool fine)
{
    if (!fine) {
        (void)fprintf(stderr, "bench: the scene with shadows failed\n");
        exit(1);
    }
}

void shadow_scene_init(struct shadow_scene *s)
{
    *s = (struct shadow_scene){.mesh.corner = malloc(sizeof *s->mesh.corner * MESH_FACES_MAX),
                               .points = malloc(sizeof *s->points * 3 * MESH_FACES_MAX),
                               .faces = malloc(sizeof *s->faces * MESH_FACES_MAX)};
    shadow_must(s->mesh.corner && s->points && s->faces);
}

void shadow_scene_free(struct shadow_scene *s)
{
    free(s->mesh.corner);
    free(s->points);
    free(s->faces);
}

#define WHITE (INT32_C(1) << 30)
static const struct tia_material white = {.colour = {WHITE, WHITE, WHITE}};
#define LAMP(x, y, z)                                                                                                  \
    {                                                                                                                  \
        .centre = {TIA_Q16(x), TIA_Q16(y), TIA_Q16(z)}, .emission = { WHITE, WHITE, WHITE }                            \
    }
static const struct tia_light lamps[SHADOW_LAMPS] = {LAMP(3, 7, 4), LAMP(-5, 6, 3), LAMP(1, 8, -4), LAMP(-3, 5, 7)};

static void make_solid(struct shadow_scene *s, int i)
{
    uint32_t first = s->mesh.first[i], count = s->mesh.first[i + 1] - first;

    s->solids[i] = (struct tia_mesh){
        .vertices = &s->points[3 * first], .faces = &s->faces[first], .vertex_count = 3 * count, .face_count = count};
    for (uint32_t f = 0; f < count; f++)
        for (uint32_t k = 0; k < 3; k++)
            s->faces[first + f].corner[k] = (struct tia_corner){3 * f + k, TIA_NO_INDEX, TIA_NO_INDEX};
    s->shapes[i] = (struct tia_shape){TIA_MESH, .mesh = (uint32_t)i};
}

void shadow_scene_make(struct shadow_scene *s, int level)
{
    bench_mesh(&s->mesh, level);
    for (uint32_t i = 0; i < 3 * s->mesh.count; i++) {
        const struct point *p = &s->mesh.corner[i / 3][i % 3];
        s->points[i] = (struct tia_vec3){Q(p->x), Q(p->y), Q(p->z)};
    }
    s->shapes[MESH_SOLIDS] = (struct tia_shape){TIA_PLANE, .plane = {.normal = {0, INT32_C(1) << 30, 0}}};
    for (int i = 0; i < MESH_SOLIDS; i++)
        make_solid(s, i);
    s->scene = (struct tia_scene){.camera = {.eye = {Q(0.5), Q(4.2), Q(9)},
                                             .reference = {Q(0.2), Q(0.9), Q(0.3)},
                                             .up = {0, Q(1), 0},
                                             .fov = Q(45)},
                                  .materials = &white,
                                  .material_count = 1,
                                  .lights = lamps,
                                  .light_count = 1,
                                  .shapes = s->shapes,
                                  .shape_count = MESH_SOLIDS + 1,
                                  .meshes = s->solids,
                                  .mesh_count = MESH_SOLIDS,
                                  .shadows = TIA_SHADOWS_ZFAIL};
    shadow_must(tia_scene_check(&s->scene, NULL) == TIA_OK);
}

void shadow_passes_init(struct shadow_passes *p, const struct shadow_scene *s, struct tia_tile image, unsigned rows)
{
    const unsigned buffers = TIA_BUFFER_DEPTH | TIA_BUFFER_COUNT;
    struct cancel never = {NULL, NULL, 0, false};
    size_t size = tia_flat_size(&s->scene);

    p->rows = rows;
    p->memory[0] = malloc(size);
    shadow_must(p->memory[0] &&
                !tia_flat_init(&p->flat, p->memory[0], size, &s->scene, image.width, image.height, &never));
    tia_flat_light_at(&p->flat, lamps, 0, &p->light);
    size = tia_raster_size(image, buffers, p->flat.face_count);
    p->memory[1] = malloc(size);
    p->roles = malloc(p->flat.face_count);
    shadow_must(p->memory[1] && p->roles &&
                !tia_raster_init(&p->target, p->memory[1], size, &p->flat.grid, image, buffers, p->flat.face_count));
    p->target.planes = p->flat.planes;
    p->target.planes_known = true;
    p->target.runs = tia_simd_raster(tia_simd_best());
}

static void draw_pass(struct tia_raster_target *target, const struct shadow_passes *p, enum shadow_pass pass)
{
    struct cancel never = {NULL, NULL, 0, false};

    if (pass == SHADOW_DEPTH) {
        target->count = NULL;
        tia_raster_clear_depth(target);
        shadow_must(!tia_shadow_faces(target, &p->flat, &never));
        return;
    }
    tia_raster_clear_count(target, 0);
    const struct tia_shadow_light light = {&p->light, p->roles};
    shadow_must(!(pass == SHADOW_ZFAIL ? tia_shadow_zfail : tia_shadow_zpass)(target, &p->flat, light, &never));
}

void shadow_passes_draw(struct shadow_passes *p, enum shadow_pass pass, unsigned y, double *ms)
{
    const struct tia_tile image = p->target.area;
    struct tia_tile strip = {0, (uint16_t)y, image.width, 0};
    struct tia_raster_target target;
    double start = cpu_milliseconds();

    strip.height = (uint16_t)(image.height - y < p->rows ? image.height - y : p->rows);
    shadow_must(!tia_raster_part(&target, &p->target, strip));
    if (pass != SHADOW_DEPTH && y == 0) { /* once for all strips */
        struct cancel never = {NULL, NULL, 0, false};
        shadow_must(!tia_shadow_keep_roles(p->roles, &p->flat, &p->light, &never));
    }
    draw_pass(&target, p, pass);
    *ms += cpu_milliseconds() - start;
}

void shadow_passes_free(struct shadow_passes *p)
{
    free(p->memory[0]);
    free(p->memory[1]);
    free(p->roles);
}
