/* memory.c - the reference display. */
#include "memory.h"

#include "pixels/canvas.h"

static int record(struct port_memory *memory, enum memory_call_kind kind, struct tia_tile tile, int result)
{
    size_t n = atomic_fetch_add(&memory->call_count, 1);

    if (memory->calls && n < memory->call_capacity)
        memory->calls[n] = (struct memory_call){kind, tile, result};
    return result;
}

static void tell_mode(const struct port_memory *memory, struct tia_mode *mode)
{
    *mode = (struct tia_mode){
        .width = memory->width,
        .height = memory->height,
        .tile_width = memory->tile_width,
        .tile_height = memory->tile_height,
        .concurrent = memory->concurrent,
        .format = "RGB565",
    };
}

static int memory_open(void *ctx, struct tia_mode *mode)
{
    struct port_memory *memory = ctx;
    int result = memory->is_open ? TIA_ERR_ARGUMENT : memory->fail_open;

    if (!result) {
        memory->is_open = true;
        tell_mode(memory, mode);
    }
    return record(memory, MEMORY_OPEN, (struct tia_tile){0}, result);
}

static int memory_mode(void *ctx, struct tia_mode *mode)
{
    struct port_memory *memory = ctx;
    int result = TIA_ERR_ARGUMENT;

    if (memory->is_open && atomic_load(&memory->acquired) == 0) {
        tell_mode(memory, mode);
        result = memory->hidden ? TIA_HIDDEN : TIA_OK;
    }
    return record(memory, MEMORY_MODE, (struct tia_tile){0}, result);
}

static bool tile_allowed(const struct port_memory *memory, struct tia_tile tile)
{
    return tile_inside(tile, memory->width, memory->height) &&
           (memory->tile_width == 0 || tile.width <= memory->tile_width) &&
           (memory->tile_height == 0 || tile.height <= memory->tile_height);
}

static int memory_acquire(void *ctx, struct tia_tile tile, struct tia_surface *surface)
{
    struct port_memory *memory = ctx;
    const struct tia_surface *all = &memory->surface;
    int result = TIA_ERR_ARGUMENT;

    if (memory->is_open && !memory->hidden && tile_allowed(memory, tile)) {
        char *first = (char *)all->pixels + tile.y * all->pitch + tile.x * all->step;
        if (atomic_fetch_add(&memory->acquired, 1) == 0 || memory->concurrent) {
            *surface = *all;
            surface->pixels = (tia_rgb565 *)(void *)first;
            result = TIA_OK;
        } else {
            atomic_fetch_sub(&memory->acquired, 1);
        }
    }
    return record(memory, MEMORY_ACQUIRE, tile, result);
}

static int memory_submit(void *ctx, struct tia_tile tile)
{
    struct port_memory *memory = ctx;
    int result = TIA_ERR_ARGUMENT;

    if (memory->is_open && atomic_load(&memory->acquired) > 0 && tile_allowed(memory, tile)) {
        atomic_fetch_sub(&memory->acquired, 1);
        result = TIA_OK;
    }
    return record(memory, MEMORY_SUBMIT, tile, result);
}

static int memory_present(void *ctx)
{
    struct port_memory *memory = ctx;
    int result = TIA_ERR_ARGUMENT;

    if (memory->is_open && !memory->hidden && atomic_load(&memory->acquired) == 0) {
        memory->frames++;
        result = TIA_OK;
    }
    return record(memory, MEMORY_PRESENT, (struct tia_tile){0}, result);
}

static void memory_close(void *ctx)
{
    struct port_memory *memory = ctx;

    memory->is_open = false;
    atomic_store(&memory->acquired, 0);
    record(memory, MEMORY_CLOSE, (struct tia_tile){0}, TIA_OK);
}

const struct tia_display port_memory_display = {
    .open = memory_open,
    .mode = memory_mode,
    .acquire = memory_acquire,
    .submit = memory_submit,
    .present = memory_present,
    .close = memory_close,
};
