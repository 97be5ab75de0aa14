/* keys.c - what a key press does to the lights. */
#include <tia/viewer.h>

struct move {
    uint16_t key;
    int8_t x, y, z;
};

static const struct move moves[] = {
    {TIA_KEY_LEFT, -1, 0, 0}, {TIA_KEY_RIGHT, 1, 0, 0},   {TIA_KEY_UP, 0, 0, -1},
    {TIA_KEY_DOWN, 0, 0, 1},  {TIA_KEY_PAGE_UP, 0, 1, 0}, {TIA_KEY_PAGE_DOWN, 0, -1, 0},
};

/* False where a coordinate would leave Q16.16. */
static bool add(tia_q16 *coordinate, int step)
{
    int64_t sum = (int64_t)*coordinate + (int64_t)step * TIA_Q16_ONE;

    if (sum < INT32_MIN || sum > INT32_MAX)
        return false;
    *coordinate = (tia_q16)sum;
    return true;
}

static int move_light(const struct tia_scene *scene, struct tia_light *light, const struct move *move)
{
    struct tia_light moved = *light;
    struct tia_scene alone = {.camera = scene->camera, .lights = &moved, .light_count = 1};

    if (!add(&moved.centre.x, move->x) || !add(&moved.centre.y, move->y) || !add(&moved.centre.z, move->z) ||
        tia_scene_check(&alone, NULL) != TIA_OK)
        return 0;
    *light = moved;
    return 1;
}

static int put_light(const struct tia_binding *binding, struct tia_light *lights, uint32_t *count, uint32_t capacity)
{
    uint32_t n = binding->light < *count ? binding->light : *count;

    if (n >= capacity)
        return 0;
    lights[n] = binding->state;
    *count += n == *count;
    return 1;
}

int tia_press(const struct tia_scene *scene, struct tia_light *lights, uint32_t *count, uint32_t capacity, uint16_t key)
{
    for (uint32_t i = 0; i < scene->binding_count; i++)
        if (scene->bindings[i].key == key)
            return put_light(&scene->bindings[i], lights, count, capacity);
    for (size_t i = 0; i < sizeof moves / sizeof *moves; i++)
        if (moves[i].key == key)
            return *count ? move_light(scene, &lights[0], &moves[i]) : 0;
    return TIA_ERR_ARGUMENT;
}
