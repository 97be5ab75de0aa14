/* technique_map.c - a shadow map for each sample of a light. */
#include "kernels.h"
#include "map_light.h"
#include "math/align.h"
#include "math/wide.h"
#include "raster/distance.h"
#include "raster/runs.h"
#include "raster/target.h"
#include "scene/axes.h"

/* The technique's data. The struct is followed by the maps, the working memory for drawing one map, and the
 * distances. */
struct maps {
    struct tia_map_look look;
    struct tia_world world;
    struct tia_map *map; /* a map for each sample */
    int64_t radius[TIA_SHADOW_SAMPLES_MAX];
    void *room;
    uint32_t *distance;
};

/* ---- memory ---- */

static bool is_whole(const struct tia_scene *scene)
{
    return scene->shadow_map.filter == TIA_FILTER_PCSS;
}

#define ROOT INT64_C(0x48375d410a6db400) /* 2/sqrt(pi), Q1.62 */

struct demand {
    uint64_t samples, texels;
};

static void add_light(struct demand *demand, const struct tia_scene *scene, const struct tia_light *light)
{
    struct tia_map_look look;
    unsigned samples =
        is_whole(scene) ? !tia_light_has(light->kind, TIA_LIGHT_EVERYWHERE) : tia_flat_light_samples(light);

    tia_map_look_init(&look, scene);
    demand->samples += samples;
    demand->texels += (uint64_t)samples * tia_map_views(light) * look.size * look.size;
}

/* Returns the numbers of samples and texels needed for all lights, whichever keys are pressed. */
static struct demand demand_of(const struct tia_scene *scene)
{
    struct demand demand = {0, 0};

    for (uint32_t i = 0; i < scene->light_count; i++)
        add_light(&demand, scene, &scene->lights[i]);
    for (uint32_t i = 0; i < scene->binding_count; i++)
        add_light(&demand, scene, &scene->bindings[i].state);
    return demand;
}

static bool has_room(const struct tia_scene *scene, const struct tia_light *lights, uint32_t count)
{
    struct demand room = demand_of(scene), demand = {0, 0};

    for (uint32_t i = 0; i < count; i++)
        add_light(&demand, scene, &lights[i]);
    return demand.samples <= room.samples && demand.texels <= room.texels;
}

static uint64_t room_size(const struct tia_scene *scene)
{
    struct tia_map_look look;

    tia_map_look_init(&look, scene);
    return tia_map_room(look.size, (uint32_t)tia_flat_face_count(scene));
}

static uint64_t own_size(const struct tia_scene *scene)
{
    struct demand demand = demand_of(scene);

    return ALIGN(sizeof(struct maps)) + ALIGN(demand.samples * sizeof(struct tia_map)) + ALIGN(room_size(scene)) +
           ALIGN(demand.texels * sizeof(uint32_t));
}

static unsigned shares(const struct tia_scene *scene)
{
    return scene->shadow_map.filter == TIA_FILTER_NONE ? 0 : (unsigned)demand_of(scene).samples;
}

/* ---- maps ---- */

#define NARROWED_FACES 2048 /* with more faces, narrowing a map would take longer than drawing it */

static int prepare(struct tia_shadow_view *view, struct cancel *cancel)
{
    struct maps *maps = view->own;
    struct demand demand = demand_of(view->scene);
    char *next = (char *)view->own + ALIGN(sizeof *maps);

    (void)cancel;
    tia_map_look_init(&maps->look, view->scene);
    tia_world_init(&maps->world, &view->flat);
    maps->map = (struct tia_map *)(void *)next;
    maps->room = next + ALIGN(demand.samples * sizeof(struct tia_map));
    maps->distance = (uint32_t *)(void *)((char *)maps->room + ALIGN(room_size(view->scene)));
    return TIA_OK;
}

/* Returns the radius of a disc with the light's area, TIA_WORLD_BITS fraction bits; 0 for a light without area. */
static int64_t radius_of(const struct tia_light *light)
{
    const int64_t a[3] = {light->side[0].x, light->side[0].y, light->side[0].z};
    const int64_t b[3] = {light->side[1].x, light->side[1].y, light->side[1].z};
    int64_t unit[2][3], normal[3];

    if (tia_light_has(light->kind, TIA_LIGHT_AREA) && tia_light_has(light->kind, TIA_LIGHT_RADIUS))
        return (int64_t)light->radius << (TIA_WORLD_BITS - 16);
    if (!tia_light_has(light->kind, TIA_LIGHT_SIDES) || !wide_normalise(a, unit[0]) || !wide_normalise(b, unit[1]))
        return 0;
    tia_axes_cross(unit[0], unit[1], normal);
    int64_t sine = wide_sqrt(wide_dot(normal, normal)); /* Q1.62 */
    /* the geometric mean of the half sides' lengths, Q.16 */
    int64_t lengths = wide_sqrt(wide_product(wide_sqrt(wide_dot(a, a)), wide_sqrt(wide_dot(b, b))));
    int64_t root = wide_sqrt(wide_product(sine, INT64_C(1) << 62));
    return wide_round(wide_product(wide_round(wide_product(lengths, root), 62 - 12), ROOT), 62);
}

static int make_map(struct maps *maps, const struct tia_shadow_view *view, unsigned sample, uint64_t *used,
                    struct cancel *cancel)
{
    struct tia_map *map = &maps->map[sample];
    struct tia_map_light light = {view->lights[sample], view->samples[sample]};
    uint64_t texels = (uint64_t)maps->look.size * maps->look.size;
    int status = tia_map_init(map, &maps->world, &light, maps->look.size, tia_map_border(maps->look.filter));

    if (status)
        return status;
    for (unsigned i = 0; i < map->view_count; i++, *used += texels)
        map->view[i].distance = maps->distance + *used;
    maps->radius[sample] = radius_of(light.light);
    bool fixed = maps->look.bias != TIA_BIAS_NORMAL && maps->look.filter != TIA_FILTER_PCSS;
    if (fixed && view->flat.face_count <= NARROWED_FACES && view->runs && view->runs->shadows)
        (void)view->runs->shadows->narrow(map, &maps->world, &view->samples[sample]);
    return tia_map_draw(map, &view->flat, maps->room, view->runs, cancel);
}

static int set_lights(struct tia_shadow_view *view, struct cancel *cancel)
{
    struct maps *maps = view->own;
    uint64_t used = 0;
    int status = TIA_OK;

    for (unsigned i = 0; !status && i < view->sample_count; i++)
        status = make_map(maps, view, i, &used, cancel);
    return status;
}

/* ---- light ---- */

void tia_map_light_pixel(struct tia_map_lighting *l, int x, int y)
{
    const struct tia_flat_scene *flat = &l->view->flat;
    size_t at = target_index(&l->tile->target, x, y);
    uint32_t face = l->tile->target.face[at];
    int64_t place[3];

    if (face == TIA_NO_FACE)
        return;
    if (face != l->point.face) {
        l->turned = tia_flat_is_turned(flat, face, &l->view->samples[l->sample]);
        tia_map_face(&l->point, &l->view->samples[l->sample], face);
    }
    if (!l->turned)
        return;
    tia_world_seen(&l->world, x, y, tia_plane_distance(&flat->planes[face], &flat->grid, x, y), place);
    tia_map_place(&l->point, l->look, place);
    tia_map_put_share(l, at, tia_map_share(&l->point, l->look->filter, l->radius, (unsigned)(x + 3 * y)));
}

static void light(const struct tia_shadow_view *view, struct tia_shadow_tile *tile, unsigned sample,
                  struct cancel *cancel)
{
    const struct maps *maps = view->own;
    const struct tia_raster_target *t = &tile->target;
    struct tia_map_lighting l = {.view = view,
                                 .look = &maps->look,
                                 .tile = tile,
                                 .cancel = cancel,
                                 .sample = sample,
                                 .shares = shares(view->scene),
                                 .radius = maps->radius[sample]};

    l.point.map = &maps->map[sample];
    tia_world_init(&l.world, &view->flat);
    l.point.world = &l.world;
    l.point.face = TIA_NO_FACE;
    if (t->runs && t->runs->shadows && t->runs->shadows->light(&l))
        return;
    for (int y = (int)t->area.y; y < target_bottom(t); y++)
        for (int x = (int)t->area.x; x < target_right(t) && !cancelled(cancel, TIA_MAP_PIXEL_WORK); x++)
            tia_map_light_pixel(&l, x, y);
}

const struct tia_shadow_technique tia_shadow_maps = {own_size, prepare,  set_lights, light,
                                                     shares,   is_whole, has_room,   0};
