/* How much spans compute between two polls of `stop`, and after it has returned true: calls of their kernels, each of
 * which takes a span of at most CHUNK pixels. */
#include <tia/render.h>

#include "check.h"
#include "random.h"
#include "render/span/span.h"
#include "render/span/span_shade.h"

enum { W = 320, H = 3, BALLS = 100, LIGHTS = 40 };

/* A light takes at most the kernels light, lambert and three times add, a caster one; then there is pack. */
enum { MOST = 5 * SPAN_WORK + 1 };

static uint64_t view_memory[40000], hits_memory[W * H * 2 + 100];
static tia_rgb565 pixels[W * H];

/* ---- kernels that are counted ---- */

static unsigned calls, most_calls, polls, until;

static bool poll_calls(void *ctx)
{
    (void)ctx;
    if (calls > most_calls)
        most_calls = calls;
    calls = 0;
    return ++polls >= until;
}

static void sphere(const struct sphere_line *line, num_u *t)
{
    calls++;
    span_kernels_plain.sphere(line, t);
}

static void sphere_inside(const struct sphere_line *line, num_u *t)
{
    calls++;
    span_kernels_plain.sphere_inside(line, t);
}

static bool light(const struct light_line *line, const num_u *t, struct lit *lit)
{
    calls++;
    return span_kernels_plain.light(line, t, lit);
}

static void shadow(const struct shadow_line *line, const num_u *t, struct lit *lit)
{
    calls++;
    span_kernels_plain.shadow(line, t, lit);
}

static void lambert(const struct lit *lit, num_u inverse, int count, num_u *cosine)
{
    calls++;
    span_kernels_plain.lambert(lit, inverse, count, cosine);
}

static void add(num_u *sum, const num_u *cosine, num_u colour, int count)
{
    calls++;
    span_kernels_plain.add(sum, cosine, colour, count);
}

static pixel_set pack(const num_u *const rgb[3], num_u doubt, const num_u *threshold, int x, int count, tia_rgb565 *out)
{
    calls++;
    return span_kernels_plain.pack(rgb, doubt, threshold, x, count, out);
}

static const struct span_kernels counting = {sphere, sphere_inside, light, shadow, lambert, add, pack};

/* ---- crowds ---- */

static struct tia_sphere balls[BALLS];
static struct tia_light lights[LIGHTS];
static struct tia_material materials[2];

static int32_t between(int32_t least, int32_t most)
{
    return least + (int32_t)(random_u32() % (uint32_t)(most - least));
}

/* Returns a scene of balls that overlap, one of three of which transmits light if `tinted` is set. */
static struct tia_scene crowd(bool tinted)
{
    random_state = 1;
    materials[0] = (struct tia_material){.colour = TIA_RGB(0.5, 0.6, 0.7)};
    materials[1] = materials[0];
    if (tinted)
        materials[1].transmission = (struct tia_rgb)TIA_RGB(0.9, 0.8, 0.9);
    for (uint32_t i = 0; i < BALLS; i++)
        balls[i] = (struct tia_sphere){
            {between(TIA_Q16(-6), TIA_Q16(6)), between(TIA_Q16(-2), TIA_Q16(2)), between(TIA_Q16(-30), TIA_Q16(-15))},
            between(TIA_Q16(.5), TIA_Q16(2)),
            i % 3 == 0};
    for (uint32_t i = 0; i < LIGHTS; i++)
        lights[i] = (struct tia_light){
            {between(TIA_Q16(-20), TIA_Q16(20)), between(TIA_Q16(-20), TIA_Q16(20)), between(TIA_Q16(-20), TIA_Q16(5))},
            0,
            TIA_RGB(0.1, 0.1, 0.1)};
    return (struct tia_scene){.camera = {.fov = TIA_Q16(25)},
                              .materials = materials,
                              .material_count = 2,
                              .spheres = balls,
                              .sphere_count = BALLS,
                              .lights = lights,
                              .light_count = LIGHTS};
}

/* Draws with counted kernels until the poll number `stop_at`. */
static int draw(const struct tia_scene *scene, unsigned stop_at)
{
    const struct tia_surface surface = {.pixels = pixels, .step = 2, .pitch = 2 * W};
    const struct tia_tile frame = {0, 0, W, H};
    struct tia_view *view;
    struct tia_hits *hits;
    int status;

    until = UINT32_MAX;
    status = tia_core_spheres.view_init(&tia_core_spheres, &view, view_memory, sizeof view_memory, scene, LIGHTS, W, H,
                                        &(struct tia_job){.stop = poll_calls});
    CHECK_EQ(status, TIA_OK);
    CHECK_EQ(tia_hits_init(&hits, hits_memory, sizeof hits_memory, view, frame), TIA_OK);
    ((struct span_view *)view->prepared)->kernels = &counting;
    calls = most_calls = polls = 0;
    until = stop_at;
    return tia_view_draw(view, hits, frame, &surface, NULL);
}

static void check_crowd(bool tinted)
{
    struct tia_scene scene = crowd(tinted);

    CHECK_EQ(draw(&scene, UINT32_MAX), TIA_OK);
    CHECK_MSG(most_calls <= MOST, "%u calls between two polls, of %d", most_calls, MOST);
    unsigned all = polls;
    for (unsigned i = 1; i < all; i += all / 50 + 1) {
        CHECK_EQ(draw(&scene, i), TIA_STOPPED);
        unsigned after = polls - i;
        CHECK_MSG(most_calls <= MOST && calls <= MOST && after <= CHUNK + 2 * LIGHTS + BALLS + 8,
                  "stopped by poll %u: %u, %u, %u polls more", i, most_calls, calls, after);
    }
}

TEST(opaque_balls)
{
    check_crowd(false);
}

TEST(balls_that_transmit_light)
{
    check_crowd(true);
}

int main(void)
{
    RUN(opaque_balls);
    RUN(balls_that_transmit_light);
    return check_status();
}
