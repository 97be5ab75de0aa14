/* test_memory.c - the memory display with all strides, and its refusals. */
#include <stdlib.h>

#include "check.h"
#include "conform.h"
#include "memory/memory.h"

static tia_rgb565 memory_pixel(void *arg, unsigned x, unsigned y)
{
    const struct tia_surface *s = arg;

    return *(tia_rgb565 *)(void *)((char *)s->pixels + (ptrdiff_t)y * s->pitch + (ptrdiff_t)x * s->step);
}

static struct port_memory memory_of(unsigned width, unsigned height, ptrdiff_t step, ptrdiff_t pitch)
{
    return (struct port_memory){.surface = {NULL, step, pitch}, .width = (uint16_t)width, .height = (uint16_t)height};
}

/* Runs the suite in a block of memory that holds the whole surface; negative strides begin at its end. No byte around
 * the pixels may change. */
static void conform_in(struct port_memory *memory)
{
    struct tia_surface *s = &memory->surface;
    size_t row = (size_t)(memory->width - 1) * (size_t)llabs(s->step);
    size_t column = (size_t)(memory->height - 1) * (size_t)llabs(s->pitch);
    size_t bytes = row + column + sizeof(tia_rgb565), guard = 64;
    char *block = malloc(bytes + 2 * guard), *first = block + guard;

    memset(block, 0x5a, bytes + 2 * guard);
    first += (s->step < 0 ? row : 0) + (s->pitch < 0 ? column : 0);
    s->pixels = (tia_rgb565 *)(void *)first;
    subject = (struct subject){&port_memory_display, memory, "", memory_pixel, NULL, s, 0, 0};
    conform();
    for (size_t i = 0; i < guard; i++)
        CHECK(block[i] == 0x5a && block[guard + bytes + i] == 0x5a);
    free(block);
}

TEST(memory)
{
    struct port_memory memory = memory_of(100, 75, 2, 200);

    memory.concurrent = true;
    conform_in(&memory);
    CHECK_EQ(memory.frames, 2 * 6);
}

TEST(memory_with_tile_limits)
{
    struct port_memory memory = memory_of(101, 77, 2, 256);

    memory.tile_width = 16;
    memory.tile_height = 5;
    conform_in(&memory);
}

/* The memory is upside down, or rotated by a quarter: a step to the right is then a row of the memory. */
TEST(memory_turned)
{
    struct port_memory flipped = memory_of(33, 9, -2, -80), turned = memory_of(33, 9, 64, -2);

    flipped.concurrent = true;
    conform_in(&flipped);
    conform_in(&turned);
}

TEST(memory_records_the_order_of_calls)
{
    tia_rgb565 pixels[4 * 3];
    struct memory_call calls[16];
    struct port_memory memory = memory_of(4, 3, 2, 8);
    static const enum memory_call_kind want[] = {MEMORY_OPEN,   MEMORY_MODE,    MEMORY_ACQUIRE,
                                                 MEMORY_SUBMIT, MEMORY_PRESENT, MEMORY_CLOSE};

    memory.surface.pixels = pixels;
    memory.calls = calls;
    memory.call_capacity = 16;
    subject = (struct subject){&port_memory_display, &memory, "", memory_pixel, NULL, &memory.surface, 0, 0};
    if (open_subject())
        one_thread(0);
    port_memory_display.close(&memory);
    CHECK_EQ(memory.call_count, 6);
    for (size_t i = 0; i < 6; i++)
        CHECK(calls[i].kind == want[i] && !calls[i].result);
    CHECK(calls[2].tile.width == 4 && calls[2].tile.height == 3);
}

TEST(memory_refuses_what_the_contract_forbids)
{
    tia_rgb565 pixels[4 * 3] = {0};
    struct port_memory memory = memory_of(4, 3, 2, 8);
    const struct tia_display *d = &port_memory_display;
    struct tia_tile tile = {0, 0, 2, 2};
    struct tia_surface surface;

    memory.surface.pixels = pixels;
    CHECK_EQ(d->mode(&memory, &mode), TIA_ERR_ARGUMENT);
    CHECK_EQ(d->acquire(&memory, tile, &surface), TIA_ERR_ARGUMENT);
    CHECK_EQ(d->present(&memory), TIA_ERR_ARGUMENT);
    CHECK_EQ(d->open(&memory, &mode), TIA_OK);
    CHECK_EQ(d->open(&memory, &mode), TIA_ERR_ARGUMENT);
    CHECK_EQ(d->submit(&memory, tile), TIA_ERR_ARGUMENT);
    CHECK_EQ(d->acquire(&memory, tile, &surface), TIA_OK);
    CHECK_EQ(d->acquire(&memory, tile, &surface), TIA_ERR_ARGUMENT); /* the display is not concurrent */
    CHECK_EQ(d->present(&memory), TIA_ERR_ARGUMENT);
    CHECK_EQ(d->submit(&memory, tile), TIA_OK);
    memory.hidden = true;
    CHECK_EQ(d->mode(&memory, &mode), TIA_HIDDEN);
    CHECK_EQ(d->acquire(&memory, tile, &surface), TIA_ERR_ARGUMENT);
    d->close(&memory);
    memory.fail_open = TIA_ERR_DEVICE;
    CHECK_EQ(d->open(&memory, &mode), TIA_ERR_DEVICE);
    CHECK_EQ(d->acquire(&memory, tile, &surface), TIA_ERR_ARGUMENT);
    d->close(&memory);
}

int main(void)
{
    RUN(memory);
    RUN(memory_with_tile_limits);
    RUN(memory_turned);
    RUN(memory_records_the_order_of_calls);
    RUN(memory_refuses_what_the_contract_forbids);
    return check_status();
}
