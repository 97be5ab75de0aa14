#include "ray_scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "checked.h"
#include "common/thread_pool.h"
#include "milliseconds.h"

#define BUILDS 3 /* number of builds; the fastest counts */

void *ray_scene_memory(size_t size)
{
    return checked(malloc(size + 1));
}

static void must(bool fine, const char *what)
{
    if (!fine) {
        (void)fprintf(stderr, "bench: %s\n", what);
        exit(1);
    }
}

static void build(struct ray_scene *s)
{
    size_t size = tia_bvh_size(&s->scene);

    s->memory[0] = ray_scene_memory(size);
    s->memory_bytes = size;
    for (int round = 0; round < BUILDS; round++)
        for (unsigned threads = 1; threads <= 2; threads++) {
            struct threads *pool = threads_create(threads);
            double start = milliseconds();
            must(pool && !tia_bvh_build(&s->scene.bvh, s->memory[0], size, NULL, &s->scene,
                                        &(struct tia_job){.workers = threads_workers(pool)}),
                 "no hierarchy");
            keep_least(&s->built[threads - 1], milliseconds() - start);
            threads_destroy(pool);
        }
}

struct ball {
    struct point at, away; /* `away`: the direction away from the ball that carries this one */
    double radius;
};

/* Returns the direction from a ball to the i-th of the nine balls that it carries, in a frame whose z axis is the
 * ball's `away`. */
static struct point place(int i)
{
    static const double angle[3] = {45, 15, 75};
    double turn = (angle[i % 3] + 120 * (i / 3)) * 3.14159265358979324 / 180, height = i % 3 ? 0 : 2 / sqrt(6);
    double wide = sqrt(1 - height * height);

    return (struct point){wide * cos(turn), wide * sin(turn), height};
}

/* Returns v after the rotation that turns the z axis into w. */
static struct point turned(struct point v, struct point w)
{
    if (w.z < -0.999999)
        return (struct point){-v.x, v.y, -v.z};
    double along = v.z - (w.x * v.x + w.y * v.y) / (1 + w.z);

    return (struct point){v.x + along * w.x, v.y + along * w.y, w.z * v.z - w.x * v.x - w.y * v.y};
}

static size_t write_balls(char *text, struct ball b, int depth)
{
    size_t length = (size_t)sprintf(text, "s %.9g %.9g %.9g %.9g\n", b.at.x, b.at.y, b.at.z, b.radius);

    for (int i = 0; depth > 0 && i < 9; i++) {
        struct ball next = {b.at, turned(place(i), b.away), b.radius / 3};
        next.at.x += next.away.x * (b.radius + next.radius);
        next.at.y += next.away.y * (b.radius + next.radius);
        next.at.z += next.away.z * (b.radius + next.radius);
        length += write_balls(text + length, next, depth - 1);
    }
    return length;
}

#define LINE 80 /* largest length of a ball's line, in bytes */

void ray_scene_balls(struct ray_scene *s, int depth)
{
    char head[4096];
    FILE *file = fopen("scenes/nff/balls_1.nff", "r");
    size_t length = file ? fread(head, 1, sizeof head - 1, file) : 0, need = 0;

    head[length] = '\0';
    char *balls = strstr(head, "\ns ");
    must(balls, "scenes/nff/balls_1.nff: not there, or without balls");
    (void)fclose(file);
    *s = (struct ray_scene){.memory_bytes = 0};
    length = (size_t)(balls + 1 - head);
    char *text = s->memory[1] = ray_scene_memory(length + (size_t)(LINE * pow(9, depth + 1) / 8) + LINE);
    memcpy(text, head, length);
    length += write_balls(text + length, (struct ball){{0, 0, 0}, {0, 0, 1}, 0.5}, depth);
    struct tia_reader reader = {.format = TIA_FORMAT_NFF, .text = text, .length = length};
    (void)tia_read(&reader, &s->scene, NULL, 0, &need);
    s->memory[2] = ray_scene_memory(need);
    must(!tia_read(&reader, &s->scene, s->memory[2], need, &need), "the flake is no scene");
    build(s);
}

#define Q(x) ((tia_q16)lrint((x)*65536))
#define ONE (INT32_C(1) << 30)

static void set_mesh(struct ray_scene *s, const struct mesh *m, struct tia_mesh *to)
{
    uint32_t first = m->first[0], count = m->count - first;
    struct tia_vec3 *points = s->memory[2] = ray_scene_memory(3 * (size_t)count * sizeof *points);
    struct tia_face *faces = s->memory[3] = ray_scene_memory(count * sizeof *faces);

    for (uint32_t i = 0; i < 3 * count; i++) {
        const struct point *p = &m->corner[first + i / 3][i % 3];
        points[i] = (struct tia_vec3){Q(p->x), Q(p->y), Q(p->z)};
        faces[i / 3].corner[i % 3] = (struct tia_corner){i, TIA_NO_INDEX, TIA_NO_INDEX};
    }
    *to = (struct tia_mesh){.vertices = points, .faces = faces, .vertex_count = 3 * count, .face_count = count};
}

void ray_scene_mesh(struct ray_scene *s, int depth)
{
    static const struct tia_material grey = {.colour = {ONE / 2, ONE / 2, ONE / 2},
                                             .mirror = {ONE / 4, ONE / 4, ONE / 4}};
    static const struct tia_light lamp = {.centre = {TIA_Q16(3), TIA_Q16(7), TIA_Q16(4)}, .emission = {ONE, ONE, ONE}};
    static const struct tia_shape shapes[2] = {{TIA_MESH, .mesh = 0}, {TIA_PLANE, .plane = {.normal = {0, ONE, 0}}}};
    struct mesh mesh;

    *s = (struct ray_scene){.memory_bytes = 0};
    mesh.corner = s->memory[1] = ray_scene_memory(((size_t)84 << 2 * depth) * sizeof *mesh.corner + 4096);
    bench_mesh(&mesh, depth);
    struct tia_mesh *solids = s->memory[4] = ray_scene_memory(sizeof *solids);
    set_mesh(s, &mesh, solids);
    s->scene = (struct tia_scene){.camera = {.eye = {Q(0.5), Q(4.2), Q(9)},
                                             .reference = {Q(0.2), Q(0.9), Q(0.3)},
                                             .up = {0, Q(1), 0},
                                             .fov = Q(45)},
                                  .materials = &grey,
                                  .material_count = 1,
                                  .lights = &lamp,
                                  .light_count = 1,
                                  .shapes = shapes,
                                  .shape_count = 2,
                                  .meshes = solids,
                                  .mesh_count = 1};
    must(!tia_scene_check(&s->scene, NULL), "the mesh is no scene");
    build(s);
}

void ray_scene_free(struct ray_scene *s)
{
    for (size_t i = 0; i < sizeof s->memory / sizeof *s->memory; i++)
        free(s->memory[i]);
}
