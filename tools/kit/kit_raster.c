/* kit_raster.c - triangles given in pixels, drawn by the exact rasteriser. */
#include <stdlib.h>
#include <tia/raster.h>

#include "kit.h"

enum { SIZE_MOST = 1024, FACES_MOST = 1 << 20, BUFFERS = TIA_BUFFER_DEPTH | TIA_BUFFER_STENCIL };

struct kit_raster {
    struct tia_raster_grid grid;
    struct tia_raster_target target;
    void *memory;
};

static bool begin(struct kit_raster *raster, struct tia_tile area, uint32_t faces)
{
    size_t size = tia_raster_size(area, BUFFERS, faces);

    /* The range affects the format of vertices alone, and these are integers of any format. */
    raster->memory = size < SIZE_MAX ? malloc(size) : NULL;
    return raster->memory && !tia_raster_grid_init(&raster->grid, TIA_PERSPECTIVE, area.width, area.height, 1, 0, 0) &&
           !tia_raster_init(&raster->target, raster->memory, size, &raster->grid, area, BUFFERS, faces);
}

struct kit_raster *kit_raster_create(uint32_t width, uint32_t height, uint32_t faces)
{
    if (width - 1 >= SIZE_MOST || height - 1 >= SIZE_MOST || faces - 1 >= FACES_MOST) {
        kit_refuse("a target has 1..%d x 1..%d pixels and 1..%d faces", SIZE_MOST, SIZE_MOST, FACES_MOST);
        return NULL;
    }
    struct kit_raster *raster = calloc(1, sizeof *raster);
    if (raster && begin(raster, (struct tia_tile){0, 0, (uint16_t)width, (uint16_t)height}, faces))
        return raster;
    kit_raster_free(raster);
    kit_refuse("memory: exhausted");
    return NULL;
}

void kit_raster_free(struct kit_raster *raster)
{
    if (raster)
        free(raster->memory);
    free(raster);
}

void kit_raster_clear(struct kit_raster *raster, uint32_t stencil)
{
    (void)tia_raster_clear_depth(&raster->target);
    (void)tia_raster_clear_stencil(&raster->target, (uint8_t)stencil, 255);
}

/* Sets one side's stencil. Returns false for a number that is not in its range. */
static bool set_side(struct tia_stencil *side, const int32_t *s)
{
    static const int32_t most[KIT_SIDE] = {
        TIA_COMPARE_ALWAYS, 255, 255, 255, TIA_STENCIL_DECR_WRAP, TIA_STENCIL_DECR_WRAP, TIA_STENCIL_DECR_WRAP};

    for (int i = 0; i < KIT_SIDE; i++)
        if (s[i] < 0 || s[i] > most[i])
            return false;
    *side = (struct tia_stencil){.test = (enum tia_compare)s[0],
                                 .reference = (uint8_t)s[1],
                                 .mask = (uint8_t)s[2],
                                 .write = (uint8_t)s[3],
                                 .fail = (enum tia_stencil_op)s[4],
                                 .zfail = (enum tia_stencil_op)s[5],
                                 .zpass = (enum tia_stencil_op)s[6]};
    return true;
}

/* Returns the corner in clip coordinates: x/w and y/w are -1..1 in the image, and w is a multiple of 256 width height,
 * so that all are integers. */
static struct tia_raster_vertex place(const struct tia_raster_grid *grid, const int32_t *corner)
{
    int64_t width = grid->width, height = grid->height, w = corner[2];

    return (struct tia_raster_vertex){.x = (2 * (int64_t)corner[0] - 256 * width) * height * w,
                                      .y = (256 * height - 2 * (int64_t)corner[1]) * width * w,
                                      .w = 256 * width * height * w,
                                      .h = 1};
}

int kit_raster_triangle(struct kit_raster *raster, const int32_t *state, const int32_t *corners, uint32_t face)
{
    struct tia_raster_state s = {.depth = (enum tia_compare)state[KIT_DEPTH],
                                 .depth_write = state[KIT_DEPTH_WRITE] != 0,
                                 .ties_by_face = state[KIT_TIES_BY_FACE] != 0,
                                 .skip_front = state[KIT_SKIP_FRONT] != 0,
                                 .skip_back = state[KIT_SKIP_BACK] != 0};
    struct tia_raster_vertex vertices[3];
    int status = state[KIT_DEPTH] < 0 || state[KIT_DEPTH] > TIA_COMPARE_ALWAYS ||
                         !set_side(&s.front, state + KIT_FRONT) || !set_side(&s.back, state + KIT_FRONT + KIT_SIDE)
                     ? TIA_ERR_ARGUMENT
                     : TIA_OK;

    for (int i = 0; i < 3 && !status; i++) {
        int64_t most = (INT64_C(1) << 40) / (256 * (int64_t)raster->grid.width * raster->grid.height);
        const int32_t *c = corners + 3 * i;
        bool far = c[2] < 1 || c[2] >= most || abs(c[0]) >= 1 << 24 || abs(c[1]) >= 1 << 24;
        status = far ? TIA_ERR_RANGE : TIA_OK;
        if (!far)
            vertices[i] = place(&raster->grid, c);
    }
    if (!status)
        status = tia_raster_draw(&raster->target, &s, vertices, 3, face);
    if (status)
        kit_refuse("%s", status == TIA_ERR_RANGE ? "a corner is too far away" : "no such state or face");
    return status;
}

const uint32_t *kit_raster_faces(const struct kit_raster *raster)
{
    return raster->target.face;
}

const uint8_t *kit_raster_stencil(const struct kit_raster *raster)
{
    return raster->target.stencil;
}
