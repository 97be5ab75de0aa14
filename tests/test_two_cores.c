/* test_two_cores.c - the example for two cores by two threads, which draw rows of one view at once: the picture is that
 * of one thread. tests/slow/threads runs this under ThreadSanitizer. */
#include <pthread.h>

#include <tia/damage.h>
#include <tia/tia.h>

#include "check.h"

int prepare(const struct tia_light *light);
int draw_half(unsigned number, void (*send_row)(unsigned y, const tia_rgb565 *pixels));

#include "boards/two_cores.c"

enum { W = 320, H = 240, FRAMES = 8 };

static tia_rgb565 sent[W * H], whole[W * H], shown[W * H];
static struct tia_damage damage;
static pthread_barrier_t both;

/* Rows are sent to places of their own, so that no lock is needed; and each is compared with what was shown. Neither
 * core sends a row before the other has drawn one. */
static void send_row(unsigned y, const tia_rgb565 *pixels)
{
    const struct tia_tile row = {.y = (uint16_t)y, .width = W, .height = 1};
    tia_rgb565 copy[W];
    const struct tia_surface surface = {.pixels = copy, .step = sizeof *copy, .pitch = sizeof copy};
    struct tia_tile changed;

    (void)pthread_barrier_wait(&both);
    memcpy(copy, pixels, sizeof copy);
    if (tia_damage_update(&damage, row, &surface, &changed))
        memcpy(sent + y * W + changed.x, copy + changed.x, changed.width * sizeof *copy);
}

static void *second_core(void *status)
{
    *(int *)status = draw_half(1, send_row);
    return NULL;
}

static void draw_at_once(void)
{
    static uint64_t own_hits[W * H + 64];
    const struct tia_tile frame = {.width = W, .height = H};
    const struct tia_surface surface = {.pixels = whole, .step = 2, .pitch = 2 * W};
    struct tia_hits *hits;

    CHECK_EQ(tia_hits_init(&hits, own_hits, sizeof own_hits, view, frame), TIA_OK);
    CHECK_EQ(tia_view_draw(view, hits, frame, &surface, NULL), TIA_OK);
}

/* Blocks of 1 and of 32 pixels: the latter have bits, of which those of two rows are never in one byte. */
static void draw_frames(unsigned block)
{
    CHECK_EQ(tia_damage_init(&damage, shown, tia_damage_size(W, H, block), W, H), TIA_OK);
    CHECK_EQ(pthread_barrier_init(&both, NULL, 2), 0);
    memset(sent, 0, sizeof sent);
    for (int frame = 0; frame < FRAMES; frame++) {
        struct tia_light light = tia_thesis_scene.bindings[frame / 2].state;
        pthread_t second;
        int status = -1;
        light.centre.x += frame % 2 * TIA_Q16(1);
        CHECK_EQ(prepare(&light), TIA_OK);
        CHECK_EQ(pthread_create(&second, NULL, second_core, &status), 0);
        CHECK_EQ(draw_half(0, send_row), TIA_OK);
        CHECK_EQ(pthread_join(second, NULL), 0);
        CHECK_EQ(status, TIA_OK);
        tia_damage_complete(&damage);
        draw_at_once();
        CHECK_MSG(!memcmp(sent, whole, sizeof sent), "frame %d, blocks of %u", frame, block);
    }
    CHECK_EQ(pthread_barrier_destroy(&both), 0);
}

TEST(rows_by_turns)
{
    draw_frames(1);
    draw_frames(32);
}

int main(void)
{
    RUN(rows_by_turns);
    return check_status();
}
