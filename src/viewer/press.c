/* press.c - the effect of a key press on the lights. */
#include "loop.h"

#include "math/integer.h"

struct move {
    uint16_t key;
    int8_t x, y, z;
};

static const struct move moves[] = {
    {TIA_KEY_LEFT, -1, 0, 0}, {TIA_KEY_RIGHT, 1, 0, 0},   {TIA_KEY_UP, 0, 0, -1},
    {TIA_KEY_DOWN, 0, 0, 1},  {TIA_KEY_PAGE_UP, 0, 1, 0}, {TIA_KEY_PAGE_DOWN, 0, -1, 0},
};

static const struct move *find_move(uint16_t key)
{
    for (size_t i = 0; i < sizeof moves / sizeof *moves; i++)
        if (moves[i].key == key)
            return &moves[i];
    return NULL;
}

static const struct tia_binding *find_binding(const struct tia_scene *scene, uint16_t key)
{
    for (uint32_t i = 0; i < scene->binding_count; i++)
        if (scene->bindings[i].key == key)
            return &scene->bindings[i];
    return NULL;
}

/* Adds a step to a coordinate; false when the sum would leave Q16.16. */
static bool add(tia_q16 *coordinate, int step, int32_t unit)
{
    int64_t sum = (int64_t)*coordinate + (int64_t)step * unit;

    if (sum < INT32_MIN || sum > INT32_MAX)
        return false;
    *coordinate = (tia_q16)sum;
    return true;
}

/* Moves a centre by a unit of the scene's file. False: the unit or the sum does not fit Q16.16. */
static bool move_centre(struct tia_vec3 *centre, const struct move *move, int scale_bits)
{
    if (scale_bits > 14)
        return false;
    int32_t unit = TIA_Q30_ONE >> (14 - scale_bits);
    return add(&centre->x, move->x, unit) && add(&centre->y, move->y, unit) && add(&centre->z, move->z, unit);
}

/* Rotates a light by about 3.6 degrees: moves the point -direction, from which the light shines at the distance 1, by
 * 1/16. The sum's length stays below 1.1, so its components fit Q2.30. False when the direction does not change. */
static bool rotate(struct tia_dir3 *direction, const struct move *move)
{
    const int32_t step = TIA_Q30_ONE / 16;
    struct tia_dir3 from = tia_normalise(direction->x, direction->y, direction->z);
    struct tia_dir3 to = tia_normalise(from.x - move->x * step, from.y - move->y * step, from.z - move->z * step);

    *direction = to;
    return to.x != from.x || to.y != from.y || to.z != from.z;
}

static int move_light(scene_check *check, const struct tia_scene *scene, struct tia_light *light,
                      const struct move *move)
{
    struct tia_light moved = *light;
    struct tia_scene alone = {.camera = scene->camera, .lights = &moved, .light_count = 1};
    struct cancel never = {0};

    if (check(&alone, NULL, &never))
        return 0;
    if (tia_light_has(light->kind, TIA_LIGHT_FAR) ? !rotate(&moved.direction, move)
                                                  : !move_centre(&moved.centre, move, scene->scale_bits))
        return 0;
    if (check(&alone, NULL, &never))
        return 0;
    *light = moved;
    return 1;
}

static int put_light(const struct tia_binding *binding, struct tia_light *lights, uint32_t *count, uint32_t n,
                     uint32_t capacity)
{
    if (n >= capacity)
        return 0;
    lights[n] = binding->state;
    *count += n == *count;
    return 1;
}

bool tia_viewer_is_switch(const struct loop *loop, uint16_t key)
{
    return loop->more && loop->viewer->variant && key == TIA_KEY_SHADOWS && !find_binding(loop->scene, key);
}

bool tia_viewer_moves(const struct loop *loop, uint16_t key)
{
    return !find_binding(loop->scene, key) && find_move(key);
}

/* True for keys that set or move lights. If the viewer has a control, keys that move lights do not do so with Shift. */
bool tia_viewer_lights(const struct loop *loop, const struct tia_event *event)
{
    return find_binding(loop->scene, event->key) ||
           (find_move(event->key) && !(event->shift && loop->viewer->hooks.control));
}

uint32_t tia_viewer_key_light(const struct tia_scene *scene, const struct tia_light *lights, uint32_t count,
                              uint16_t key)
{
    if (!scene || (count && !lights))
        return TIA_NO_LIGHT;
    const struct tia_binding *binding = find_binding(scene, key);
    uint32_t first = 0;

    if (binding)
        return binding->light < count ? binding->light : count;
    if (!find_move(key))
        return TIA_NO_LIGHT;
    while (first < count && tia_light_has(lights[first].kind, TIA_LIGHT_EVERYWHERE))
        first++;
    return first < count ? first : TIA_NO_LIGHT;
}

int tia_viewer_press_lights(scene_check *check, const struct tia_scene *scene, struct tia_light *lights,
                            uint32_t *count, uint32_t capacity, uint16_t key)
{
    if (!scene || !count || *count > capacity || (capacity && !lights))
        return TIA_ERR_ARGUMENT;
    const struct tia_binding *binding = find_binding(scene, key);
    const struct move *move = find_move(key);
    uint32_t light = tia_viewer_key_light(scene, lights, *count, key);

    if (binding)
        return put_light(binding, lights, count, light, capacity);
    if (!move)
        return TIA_ERR_ARGUMENT;
    return light != TIA_NO_LIGHT ? move_light(check, scene, &lights[light], move) : 0;
}
