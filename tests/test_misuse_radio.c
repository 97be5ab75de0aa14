/* Misuse of the paths of radio waves. */
#include <limits.h>
#include <tia/radio.h>

#include "misuse_scene.h"
#include "radio/search.h"

static struct tia_radio *radio;
static struct tia_radio_room *room;
static uint64_t radio_memory[2000];

static bool found(void *ctx, const struct tia_radio_path *path)
{
    (void)ctx;
    (void)path;
    return true;
}

static bool received(void *ctx, const struct tia_radio_ray *ray)
{
    (void)ctx;
    (void)ray;
    return true;
}

static const struct tia_radio_link between = {
    .from = TIA_VEC3(5, 1, 0), .to = TIA_VEC3(-5, 1, 0), .order = 2, .found = found};

static void prepare(void)
{
    misuse_read();
    CHECK_EQ(tia_radio_init(&radio, radio_memory, sizeof radio_memory, &misuse_scene, NULL), TIA_OK);
    CHECK(tia_radio_room_size() <= sizeof misuse_memory);
    room = (void *)misuse_memory;
}

TEST(misuse_of_radio_init)
{
    struct tia_radio *made = NULL;

    prepare();
    size_t need = tia_radio_size(&misuse_scene), size = sizeof misuse_memory;
    GIVES(SIZE_MAX, (intmax_t)tia_radio_size(NULL));
    REFUSES(tia_radio_init(NULL, misuse_memory, size, &misuse_scene, NULL));
    REFUSES(tia_radio_init(&made, NULL, size, &misuse_scene, NULL));
    REFUSES(tia_radio_init(&made, NULL, 0, &misuse_scene, NULL));
    REFUSES(tia_radio_init(&made, MISALIGNED(misuse_memory), size - 8, &misuse_scene, NULL));
    REFUSES(tia_radio_init(&made, misuse_memory, size, NULL, NULL));
    GIVES(TIA_ERR_MEMORY, tia_radio_init(&made, misuse_memory, need - 1, &misuse_scene, NULL));
    GIVES(0, tia_radio_count(NULL).faces);
    GIVES(TIA_RADIO_NO_OBJECT, tia_radio_face(NULL, 0).object);
    GIVES(TIA_RADIO_NO_OBJECT, tia_radio_face(radio, tia_radio_count(radio).faces).object);
    GIVES(TIA_RADIO_NO_OBJECT, tia_radio_face(radio, UINT32_MAX).object);
    GIVES(1, tia_radio_face(radio, 0).object);
    GIVES(TIA_RADIO_NO_OBJECT, tia_radio_inside(NULL, between.to));
    GIVES(TIA_RADIO_NO_OBJECT, tia_radio_inside(radio, (struct tia_vec3){INT32_MIN, INT32_MAX, INT32_MIN}));
    GIVES(0, tia_radio_sequences(NULL, 3));
    GIVES(1, tia_radio_sequences(radio, UINT32_MAX) == UINT64_MAX);
    misuse_end();
}

static int images(struct tia_radio_link changed)
{
    return tia_radio_images(radio, room, &changed);
}

static struct tia_radio_link linked(struct tia_vec3 from, struct tia_vec3 to, uint32_t order, uint32_t walls,
                                    bool (*call)(void *ctx, const struct tia_radio_path *path))
{
    return (struct tia_radio_link){.from = from, .to = to, .order = order, .walls = walls, .found = call};
}

TEST(misuse_of_images)
{
    const struct tia_vec3 a = between.from, b = between.to, far = {INT32_MAX, INT32_MAX, INT32_MAX},
                          farther = {INT32_MIN, INT32_MIN, INT32_MIN}, within = TIA_VEC3(-1.5, 0, 0);

    prepare();
    REFUSES(tia_radio_images(NULL, room, &between));
    REFUSES(tia_radio_images(radio, NULL, &between));
    REFUSES(tia_radio_images(radio, MISALIGNED(room), &between));
    REFUSES(tia_radio_images(radio, room, NULL));
    REFUSES(images(linked(a, b, TIA_RADIO_ORDER_MAX + 1, 0, found)));
    REFUSES(images(linked(a, b, UINT32_MAX, 0, found)));
    REFUSES(images(linked(a, b, 1, TIA_RADIO_WALLS_MAX + 1, found)));
    REFUSES(images(linked(a, b, 1, 0, NULL)));
    REFUSES(images(linked(a, a, 1, 0, found)));
    GIVES(TIA_OK, images(linked(far, farther, 1, 0, found)));
    GIVES(TIA_OK, images(linked(a, within, 1, TIA_RADIO_WALLS_MAX, found)));
    GIVES(TIA_OK, images(between));
    misuse_end();
}

TEST(misuse_of_a_sequence)
{
    uint32_t planes[TIA_RADIO_ORDER_MAX + 1] = {0}, none[2] = {0, UINT32_MAX}, next[1];

    prepare();
    next[0] = tia_radio_count(radio).planes;
    REFUSES(tia_radio_try(NULL, room, &between, planes, 1));
    REFUSES(tia_radio_try(radio, NULL, &between, planes, 1));
    REFUSES(tia_radio_try(radio, room, NULL, planes, 1));
    REFUSES(tia_radio_try(radio, room, &between, NULL, 1));
    REFUSES(tia_radio_try(radio, room, &between, planes, TIA_RADIO_ORDER_MAX + 1));
    REFUSES(tia_radio_try(radio, room, &between, planes, UINT32_MAX));
    REFUSES(tia_radio_try(radio, room, &between, none, 2));
    REFUSES(tia_radio_try(radio, room, &between, next, 1));
    GIVES(TIA_OK, tia_radio_try(radio, room, &between, NULL, 0));
    GIVES(TIA_OK, tia_radio_try(radio, room, &between, planes, 1));
    misuse_end();
}

static int direction(uint32_t density, uint32_t i)
{
    int64_t d[3];

    return tia_radio_direction(density, i, d);
}

static int shoot(struct tia_radio_link changed, uint32_t density, uint32_t i)
{
    return tia_radio_shoot(radio, room, &changed, density, i, false, received, NULL);
}

TEST(misuse_of_rays)
{
    const struct tia_radio_link nowhere = {.from = between.from, .to = between.from, .order = 1};

    prepare();
    GIVES(0, tia_radio_directions(0));
    GIVES(0, tia_radio_directions(TIA_RADIO_DENSITY_MAX + 1));
    GIVES(0, tia_radio_directions(UINT32_MAX));
    GIVES(12, tia_radio_directions(1));
    REFUSES(direction(0, 0));
    REFUSES(direction(TIA_RADIO_DENSITY_MAX + 1, 0));
    REFUSES(direction(64, tia_radio_directions(64)));
    REFUSES(direction(64, UINT32_MAX));
    REFUSES(tia_radio_direction(1, 0, NULL));
    GIVES(TIA_OK, direction(TIA_RADIO_DENSITY_MAX, tia_radio_directions(TIA_RADIO_DENSITY_MAX) - 1));
    REFUSES(tia_radio_shoot(NULL, room, &between, 64, 0, false, received, NULL));
    REFUSES(tia_radio_shoot(radio, NULL, &between, 64, 0, false, received, NULL));
    REFUSES(tia_radio_shoot(radio, room, NULL, 64, 0, false, received, NULL));
    REFUSES(tia_radio_shoot(radio, room, &between, 64, 0, false, NULL, NULL));
    REFUSES(shoot(between, 0, 0));
    REFUSES(shoot(between, TIA_RADIO_DENSITY_MAX + 1, 0));
    REFUSES(shoot(between, 64, UINT32_MAX));
    REFUSES(shoot(linked(between.from, between.to, TIA_RADIO_ORDER_MAX + 1, 0, NULL), 64, 0));
    REFUSES(shoot(linked(between.from, between.to, 1, UINT32_MAX, NULL), 64, 0));
    REFUSES(shoot(linked(between.from, between.from, 1, 1, NULL), 64, 3));
    GIVES(TIA_OK, tia_radio_shoot(radio, room, &nowhere, 64, 3, true, received, NULL)); /* the receiver is ignored */
    GIVES(TIA_OK, shoot(linked(between.from, between.to, 1, 1, NULL), 64, 3));
    misuse_end();
}

int main(void)
{
    RUN(misuse_of_radio_init);
    RUN(misuse_of_images);
    RUN(misuse_of_a_sequence);
    RUN(misuse_of_rays);
    return check_status();
}
