/* radio.c - measures a link between houses: the image method by numbers of faces and reflections, shooting and bouncing
 * by the number of rays. */
#include "radio.h"

#include <stdio.h>
#include <stdlib.h>
#include <tia/radio.h>

#include "common/corpus/dice.h"
#include "milliseconds.h"

enum { HOUSES_MOST = 144, TRIES = 3 };

struct city {
    struct tia_scene scene;
    struct tia_material material;
    struct tia_transform turn;
    struct tia_shape shapes[HOUSES_MOST + 1];
    void *memory;
    struct tia_radio *radio;
    struct tia_radio_room *room;
};

/* Builds side x side houses of 8 to 14 m, 20 m apart, on a ground; with `turned`, all rotated by 20 degrees. */
static bool build(struct city *c, int side, bool turned)
{
    uint64_t dice = 7;

    *c = (struct city){.turn = {.rotation = TIA_VEC3(0, 20, 0), .scale = TIA_VEC3(1, 1, 1)}};
    c->scene = (struct tia_scene){.materials = &c->material,
                                  .material_count = 1,
                                  .shapes = c->shapes,
                                  .transforms = &c->turn,
                                  .transform_count = 1};
    c->shapes[c->scene.shape_count++] =
        (struct tia_shape){.kind = TIA_PLANE, .plane = {TIA_VEC3(0, 0, 0), {0, TIA_Q30_ONE, 0}}};
    for (int i = 0; i < side * side; i++) {
        int32_t x = (i % side * 20 - side * 10 + 4) * TIA_Q16_ONE, z = (i / side * 20 - side * 10 + 4) * TIA_Q16_ONE;
        struct tia_vec3 min = {x, 0, z}, max = {x + dice_between(&dice, 8 * TIA_Q16_ONE, 14 * TIA_Q16_ONE),
                                                dice_between(&dice, 6 * TIA_Q16_ONE, 30 * TIA_Q16_ONE),
                                                z + dice_between(&dice, 8 * TIA_Q16_ONE, 14 * TIA_Q16_ONE)};
        c->shapes[c->scene.shape_count++] = (struct tia_shape){.kind = TIA_BOX, .transform = turned, .box = {min, max}};
    }
    size_t size = tia_radio_size(&c->scene);
    c->memory = malloc(size);
    c->room = malloc(tia_radio_room_size());
    return c->memory && c->room && !tia_radio_init(&c->radio, c->memory, size, &c->scene, NULL);
}

static void end(struct city *c)
{
    free(c->memory);
    free(c->room);
}

static bool count_path(void *ctx, const struct tia_radio_path *path)
{
    (void)path;
    ++*(unsigned *)ctx;
    return true;
}

static bool count_ray(void *ctx, const struct tia_radio_ray *ray)
{
    (void)ray;
    ++*(unsigned *)ctx;
    return true;
}

/* Returns a link of about 12 m along the street through the middle, with up to `order` reflections. Its paths are
 * counted in *count. */
static struct tia_radio_link link_of(uint32_t order, unsigned *count)
{
    return (struct tia_radio_link){TIA_VEC3(1, 9, 1.5), TIA_VEC3(1.5, 1.5, 13), order, 0, count_path, count};
}

static void measure_images(const struct city *c, const char *name, uint32_t order)
{
    double least = 0;
    unsigned count = 0;

    for (int i = 0; i < TRIES; i++) {
        struct tia_radio_link link = link_of(order, &count);
        count = 0;
        double start = cpu_milliseconds();
        (void)tia_radio_images(c->radio, c->room, &link);
        keep_least(&least, cpu_milliseconds() - start);
    }
    double sequences = (double)tia_radio_sequences(c->radio, order);
    (void)printf("%-14s %6u %11.0f %6u %10.2f %12.1f\n", name, order, sequences, count, least, least * 1e6 / sequences);
}

static void measure_rays(const struct city *c, uint32_t density, uint32_t order)
{
    double least = 0;
    unsigned count = 0;
    uint32_t rays = tia_radio_directions(density);

    for (int i = 0; i < TRIES; i++) {
        struct tia_radio_link link = link_of(order, &count);
        count = 0;
        double start = cpu_milliseconds();
        for (uint32_t k = 0; k < rays; k++)
            (void)tia_radio_shoot(c->radio, c->room, &link, density, k, false, count_ray, &count);
        keep_least(&least, cpu_milliseconds() - start);
    }
    (void)printf("%7u %6u %9u %10.2f %10.2f\n", c->scene.shape_count * 6 - 5, order, rays, least,
                 least * 1e3 / (double)rays);
}

void bench_radio(void)
{
    static const int sides[] = {2, 4, 6, 12};
    struct city c;

    (void)printf("\nradio, images   order   sequences  paths         ms ns a sequence\n");
    for (int turned = 0; turned < 2; turned++)
        for (int i = 0; i < 4 && build(&c, sides[i], turned); i++) {
            char name[32];
            (void)snprintf(name, sizeof name, "%u planes%s", tia_radio_count(c.radio).planes, turned ? "*" : "");
            for (uint32_t order = 1; order <= (i < 2 ? 3 : 2); order++)
                measure_images(&c, name, order);
            end(&c);
        }
    (void)printf(
        "* turned by 20 degrees: normals of many digits\n\nradio, faces  order      rays         ms   us a ray\n");
    for (int i = 0; i < 4 && build(&c, sides[i], false); i++) {
        measure_rays(&c, 16, 3);
        end(&c);
    }
    for (uint32_t density = 32; density <= 64 && build(&c, 4, false); density *= 2) {
        measure_rays(&c, density, 3);
        end(&c);
    }
    for (uint32_t order = 1; order <= 8 && build(&c, 4, false); order += order < 2 ? 1 : 3) {
        measure_rays(&c, 16, order);
        end(&c);
    }
}
