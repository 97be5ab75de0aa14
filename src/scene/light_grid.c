#include "light_grid.h"

#include "axes.h"
#include "math/integer.h"
#include "math/wide.h"

/* ---- the observer line ---- */

struct tia_vec3 tia_light_offset(const int64_t u[3], tia_q16 place)
{
    return (struct tia_vec3){(tia_q16)wide_round(wide_product(place, u[0]), 62),
                             (tia_q16)wide_round(wide_product(place, u[1]), 62),
                             (tia_q16)wide_round(wide_product(place, u[2]), 62)};
}

static void axis_of(const struct tia_camera *c, int64_t u[3])
{
    const int64_t back[3] = {(int64_t)c->eye.x - c->reference.x, (int64_t)c->eye.y - c->reference.y,
                             (int64_t)c->eye.z - c->reference.z};
    int64_t axes[3][3];

    tia_camera_axes(axes, c, back);
    for (int i = 0; i < 3; i++)
        u[i] = axes[0][i];
}

tia_q16 tia_light_field_place(const struct tia_camera *camera, uint32_t view, uint32_t views)
{
    if (!camera || camera->line < 0 || view >= views || views < 2)
        return 0;
    uint64_t last = views - 1, steps = (uint64_t)camera->line * 2 * view;

    return (tia_q16)((int64_t)((2 * steps + last) / (2 * last)) - camera->line);
}

/* Moves a point; false, and the point stays, if a coordinate would leave its range. */
static bool move(struct tia_vec3 *point, struct tia_vec3 by)
{
    int64_t x = (int64_t)point->x + by.x, y = (int64_t)point->y + by.y, z = (int64_t)point->z + by.z;

    if (tia_saturate_s32(x) != x || tia_saturate_s32(y) != y || tia_saturate_s32(z) != z)
        return false;
    *point = (struct tia_vec3){(tia_q16)x, (tia_q16)y, (tia_q16)z};
    return true;
}

int tia_light_field_camera(struct tia_camera *out, const struct tia_camera *camera, tia_q16 place)
{
    int64_t u[3];

    if (!out || !camera)
        return TIA_ERR_ARGUMENT;
    if (place > camera->line || -(int64_t)place > camera->line ||
        tia_scene_check(&(struct tia_scene){.camera = *camera}, NULL))
        return TIA_ERR_RANGE;
    axis_of(camera, u);
    struct tia_vec3 offset = tia_light_offset(u, place);
    struct tia_camera view = *camera;
    if (!move(&view.eye, offset) || !move(&view.reference, offset))
        return TIA_ERR_RANGE;
    view.window.left -= place;
    view.window.right -= place;
    view.line = 0;
    *out = view;
    return TIA_OK;
}

/* ---- the kinds ---- */

/* Returns a/n modulo 1, in units of 2^-64; a is in units of 2^-40, n below 2^16. */
static uint64_t part(int64_t a, int n)
{
    uint64_t size = a < 0 ? 0 - (uint64_t)a : (uint64_t)a, by = (uint64_t)n;
    uint64_t quotient = (size / by << 24) + (size % by << 24) / by;

    return a < 0 ? 0 - quotient : quotient;
}

static void set_phases(struct light_grid *grid, const struct tia_lenticular *lens)
{
    grid->right = part(lens->pitch, 3 * grid->width);
    grid->up = part(lens->rise, grid->width);
    grid->first = part(lens->pitch, 2 * grid->width) + part(lens->rise, 2 * grid->width) - part(lens->centre, 1);
    if (!lens->inverted)
        return;
    grid->right = 0 - grid->right;
    grid->up = 0 - grid->up;
    grid->first = ~grid->first;
}

void tia_light_grid_init(struct light_grid *grid, const struct tia_scene *scene, int width, int height)
{
    const struct tia_light_field *field = scene->field;
    bool quilt = field->kind == TIA_QUILT;

    grid->field = field;
    grid->camera = &scene->camera;
    axis_of(grid->camera, grid->u);
    grid->width = width;
    grid->height = height;
    set_phases(grid, &field->lens);
    grid->channels = field->kind == TIA_LENTICULAR && field->lens.subpixels != TIA_SUBPIXELS_NONE ? 3 : 1;
    grid->ordinary_width = quilt ? width / (int)field->quilt.columns : width * grid->channels;
    grid->ordinary_height = quilt ? height / (int)field->quilt.rows : height;
}

static bool quilted(const struct light_grid *grid, int x, int y, struct light_pixel *pixel)
{
    const struct tia_quilt *quilt = &grid->field->quilt;
    int width = grid->ordinary_width, height = grid->ordinary_height;
    int from_below = grid->height - 1 - y;

    if (!width || !height || x / width >= (int)quilt->columns || from_below / height >= (int)quilt->rows)
        return false;
    pixel->x = x % width;
    pixel->y = height - 1 - from_below % height;
    uint32_t view = (uint32_t)(from_below / height) * quilt->columns + (uint32_t)(x / width);
    pixel->place = tia_light_field_place(grid->camera, view, (uint32_t)quilt->columns * quilt->rows);
    return true;
}

static void lensed(const struct light_grid *grid, int x, int y, int channel, struct light_pixel *pixel)
{
    const struct tia_lenticular *lens = &grid->field->lens;
    int from_left = lens->subpixels == TIA_SUBPIXELS_BGR ? 2 - channel : channel;
    int j = grid->channels * x + (grid->channels == 3 ? from_left : 0);

    j = lens->flipped ? grid->ordinary_width - 1 - j : j;
    pixel->x = j;
    pixel->y = y;
    uint64_t third = (uint64_t)j * (grid->channels == 3 ? 1 : 3), row = (uint64_t)(grid->height - 1 - y);
    uint64_t phase = grid->first + third * grid->right + row * grid->up;
    uint64_t line = (uint64_t)grid->camera->line;
    pixel->place = (tia_q16)((int64_t)(((phase >> 32) * 2 * line + (UINT64_C(1) << 31)) >> 32) - (int64_t)line);
}

/* Returns a b/c, with an error of up to half a unit plus 2^-59 of the result; |a| < 2^62, b and c above 0. */
static int64_t scaled(int64_t a, tia_q16 b, tia_q16 c)
{
    wide product = wide_product(a < 0 ? -a : a, b);
    int more = wide_bits(product) - 62;
    int64_t quotient = more > 0 ? wide_quotient(wide_down(product, (unsigned)more), c, more)
                                : wide_quotient((int64_t)wide_low(product), c, 0);

    return a < 0 ? -quotient : quotient;
}

/* Writes the pixel of a projector. The projector's ray through the pixel, at q on the screen, meets the observer line
 * at s. Both are positions along u, Q31.32, relative to the middle of the line. */
static bool projected(const struct light_grid *grid, int x, int y, struct light_pixel *pixel)
{
    const struct tia_projector *projector = &grid->field->projector;
    const struct tia_window *w = &grid->camera->window;
    int64_t across = (int64_t)w->right - w->left, middle = ((int64_t)w->left + w->right) * (INT32_C(1) << 15);
    int64_t q = (int64_t)w->left * (INT32_C(1) << 16) +
                (across * (2 * (int64_t)x + 1) * (INT32_C(1) << 15) + grid->width / 2) / grid->width;
    int64_t s = q + scaled(q - middle - (int64_t)projector->place * (INT32_C(1) << 16), w->near, projector->distance);

    s = tia_round_shift(s, 16);
    pixel->x = x;
    pixel->y = y;
    pixel->place = (tia_q16)s;
    return s >= -(int64_t)grid->camera->line && s <= grid->camera->line;
}

bool tia_light_grid_pixel(const struct light_grid *grid, int x, int y, int channel, struct light_pixel *pixel)
{
    switch (grid->field->kind) {
    case TIA_QUILT:
        return quilted(grid, x, y, pixel);
    case TIA_PROJECTOR:
        return projected(grid, x, y, pixel);
    case TIA_LENTICULAR:
    default:
        lensed(grid, x, y, channel, pixel);
        return true;
    }
}
