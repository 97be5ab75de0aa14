/* shadow_map_world.h - boxes in front of a camera, a light and its shadow map; and the same world in double
 * precision. */
#ifndef TESTS_SHADOW_MAP_WORLD_H
#define TESTS_SHADOW_MAP_WORLD_H

#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "random.h"
#include "shadow/map_look.h"

#define BOXES 5
#define SIZE 64

static const double unit = 1.0 / (1 << TIA_WORLD_BITS);

static double any(double low, double high)
{
    return low + (high - low) * (double)(random_bits() % 1000003) / 1000003;
}

static tia_q16 q16(double x)
{
    return (tia_q16)lrint(x * 65536);
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* ---- a world: boxes, and a camera that looks at them ---- */

static struct {
    struct tia_shape shapes[BOXES];
    struct tia_scene scene;
    struct tia_light light;
    struct tia_flat_scene flat;
    struct tia_world world;
    struct tia_map map;
    struct tia_map_look look;
    double eye[3], zero[3]; /* positions are relative to `zero`: the eye, or the middle of the window */
    double axes[3][3];      /* the camera's axes: right, up, back */
    tia_flat_light at;
    void *memory, *room;
    uint32_t *texels;
} w;

/* Computes the axes of the camera, which looks at the world's origin. */
static void find_axes(void)
{
    const struct tia_window *window = &w.scene.camera.window;
    double length = sqrt(dot(w.eye, w.eye)), side = hypot(w.eye[0], w.eye[2]);
    double middle = w.scene.camera.projection == TIA_ORTHOGRAPHIC ? (window->bottom + window->top) / 131072. : 0;

    for (int k = 0; k < 3; k++)
        w.axes[2][k] = w.eye[k] / length;
    w.axes[0][0] = w.eye[2] / side;
    w.axes[0][1] = 0;
    w.axes[0][2] = -w.eye[0] / side;
    for (int k = 0; k < 3; k++) {
        int a = (k + 1) % 3, b = (k + 2) % 3;
        w.axes[1][k] = w.axes[2][a] * w.axes[0][b] - w.axes[2][b] * w.axes[0][a];
        w.zero[k] = w.eye[k] + middle * w.axes[1][k];
    }
}

static void make_scene(enum tia_projection projection)
{
    for (int i = 0; i < BOXES; i++) {
        double low[3], high[3];
        for (int k = 0; k < 3; k++) {
            low[k] = any(-3, 2);
            high[k] = low[k] + any(0.3, 2);
        }
        w.shapes[i] = (struct tia_shape){.kind = TIA_BOX};
        w.shapes[i].box.min = (struct tia_vec3){q16(low[0]), q16(low[1]), q16(low[2])};
        w.shapes[i].box.max = (struct tia_vec3){q16(high[0]), q16(high[1]), q16(high[2])};
    }
    w.scene = (struct tia_scene){.shapes = w.shapes, .shape_count = BOXES};
    w.scene.camera = (struct tia_camera){.projection = projection,
                                         .fov = TIA_Q16(50),
                                         .eye = {q16(any(-4, 4)), q16(any(-4, 4)), q16(any(8, 12))},
                                         .up = {0, TIA_Q16_ONE, 0},
                                         .window = {.bottom = q16(-3), .top = q16(3.5)}};
    w.eye[0] = w.scene.camera.eye.x / 65536.;
    w.eye[1] = w.scene.camera.eye.y / 65536.;
    w.eye[2] = w.scene.camera.eye.z / 65536.;
    find_axes();
}

static void make_light(enum tia_light_kind kind, double outer)
{
    const double d[3] = {any(-1, 1), any(-1, 1), any(-1, 1)}, length = sqrt(dot(d, d));

    w.light = (struct tia_light){.kind = kind, .outer = q16(outer)};
    w.light.centre = (struct tia_vec3){q16(-d[0] / length * 8), q16(-d[1] / length * 8), q16(-d[2] / length * 8)};
    w.light.direction =
        (struct tia_dir3){(tia_q30)lrint(d[0] / length * 0x1p30), (tia_q30)lrint(d[1] / length * 0x1p30),
                          (tia_q30)lrint(d[2] / length * 0x1p30)};
}

static void make_map(unsigned border)
{
    struct cancel never = {0};

    w.memory = malloc(tia_flat_size(&w.scene));
    CHECK(!tia_flat_init(&w.flat, w.memory, tia_flat_size(&w.scene), &w.scene, 80, 60, &never));
    tia_world_init(&w.world, &w.flat);
    tia_flat_light_at(&w.flat, &w.light, 0, &w.at);
    CHECK(!tia_map_init(&w.map, &w.world, &(struct tia_map_light){&w.light, w.at}, SIZE, border));
    w.texels = malloc(sizeof *w.texels * SIZE * SIZE * TIA_CUBE_VIEWS);
    w.room = malloc((size_t)tia_map_room(SIZE, w.flat.face_count));
    for (unsigned i = 0; i < w.map.view_count; i++)
        w.map.view[i].distance = w.texels + (size_t)i * SIZE * SIZE;
    CHECK(!tia_map_draw(&w.map, &w.flat, w.room, NULL, &never));
}

static void unmake(void)
{
    free(w.memory);
    free(w.room);
    free(w.texels);
}

static void axes_of(const struct tia_map_view *view, double axes[3][3])
{
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            axes[i][k] = (double)view->axes[i][k] * 0x1p-62;
}

static void origin_of(double out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = (double)w.map.origin[k] * unit;
}

/* Returns the number of texels per unit of length; for a point light, at a distance of 1. */
static double density(void)
{
    return (double)w.map.density * 0x1p-40;
}

/* ---- points of faces, and their positions in the map ---- */

struct point {
    double place[3], normal[3];
    uint32_t face;
};

/* Finds a point on a side of a box that faces the light. Faces 2 n and 2 n + 1 of a box are its side n, the low or the
 * high one along an axis. */
static inline bool any_point(struct point *p)
{
    static const int axis_of[6] = {0, 0, 1, 1, 2, 2};
    double corners[3][3], a = any(0, 1), b = any(0, 1 - a), way[3], origin[3], axes[3][3];

    p->face = (uint32_t)(random_bits() % w.flat.face_count);
    int side = (int)(p->face % 12) / 2, box = (int)p->face / 12;
    struct tia_raster_vertex v[TIA_SIDES];
    (void)tia_flat_corners(&w.flat, p->face, v);
    for (int i = 0; i < 3; i++) {
        int64_t place[3];
        tia_world_place(&w.world, &v[i], place);
        for (int k = 0; k < 3; k++)
            corners[i][k] = (double)place[k] * unit;
    }
    for (int k = 0; k < 3; k++) {
        p->place[k] = corners[0][k] + a * (corners[1][k] - corners[0][k]) + b * (corners[2][k] - corners[0][k]);
        p->normal[k] = 0;
    }
    const struct tia_box *at = &w.shapes[box].box;
    const double low[3] = {at->min.x / 65536., at->min.y / 65536., at->min.z / 65536.};
    int k = axis_of[side];
    p->normal[k] = fabs(p->place[k] + w.zero[k] - low[k]) < 1e-3 ? -1 : 1;
    origin_of(origin);
    axes_of(&w.map.view[0], axes);
    for (int i = 0; i < 3; i++)
        way[i] = w.map.parallel ? -axes[2][i] : origin[i] - p->place[i];
    return dot(way, p->normal) > 0.02;
}

struct found {
    const struct tia_map_view *view;
    double u, v, distance, texel;
};

static inline struct found find(const double place[3])
{
    struct found f = {&w.map.view[0], 0, 0, 0, 0};
    double origin[3], d[3], axes[3][3];
    int most = 0;

    origin_of(origin);
    for (int k = 0; k < 3; k++) {
        d[k] = place[k] - origin[k];
        most = fabs(d[k]) > fabs(d[most]) ? k : most;
    }
    if (w.map.view_count > 1)
        f.view = &w.map.view[2 * most + (d[most] < 0)];
    axes_of(f.view, axes);
    f.distance = dot(axes[2], d);
    double scale = density() / (w.map.parallel ? 1 : f.distance);
    f.u = SIZE / 2 + dot(axes[0], d) * scale;
    f.v = SIZE / 2 - dot(axes[1], d) * scale;
    f.texel = 1 / scale;
    return f;
}

/* Returns the depth in the map, at the centre of texel (i, j), of the plane through p with p's normal. */
static inline double plane_at(const struct point *p, const struct found *f, int i, int j)
{
    double axes[3][3], origin[3], d[3], to[3], u = (i + 0.5 - SIZE / 2) / density(),
                                               v = (SIZE / 2 - j - 0.5) / density();

    axes_of(f->view, axes);
    origin_of(origin);
    for (int k = 0; k < 3; k++) {
        double across = u * axes[0][k] + v * axes[1][k];
        d[k] = axes[2][k] + (w.map.parallel ? 0 : across);
        to[k] = p->place[k] - origin[k] - (w.map.parallel ? across : 0);
    }
    return dot(p->normal, to) / dot(p->normal, d);
}

#endif
