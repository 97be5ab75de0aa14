/* lightfield.c - the statement `camera lightfield`: a display's screen and observer line become a frustum, whose eye is
 * the middle of the line.
 *
 * With the screen's axes n = normal, u = up x n and v = n x u, the eye is centre + distance n + above v + (from + to)/2
 * u.
 */
#include "math/integer.h"
#include "parse_state.h"

struct display {
    struct tia_vec3 centre, up;
    struct tia_dir3 normal;
    tia_q16 width, height, distance, above, from, to;
};

static const struct tia_field fields[] = {
    {.word = "centre", .kind = TIA_LENGTHS, .count = 3, .offset = offsetof(struct display, centre)},
    {.word = "up", .kind = TIA_VECTOR, .offset = offsetof(struct display, up)},
    {.word = "normal", .kind = TIA_DIRECTION, .offset = offsetof(struct display, normal)},
    {.word = "width", .kind = TIA_LENGTHS, .count = 1, .offset = offsetof(struct display, width), .needed = true},
    {.word = "height", .kind = TIA_LENGTHS, .count = 1, .offset = offsetof(struct display, height), .needed = true},
    {.word = "distance", .kind = TIA_LENGTHS, .count = 1, .offset = offsetof(struct display, distance), .needed = true},
    {.word = "above", .kind = TIA_LENGTHS, .count = 1, .offset = offsetof(struct display, above)},
    {.word = "from", .kind = TIA_LENGTHS, .count = 1, .offset = offsetof(struct display, from), .needed = true},
    {.word = "to", .kind = TIA_LENGTHS, .count = 1, .offset = offsetof(struct display, to), .needed = true},
};
#define UP_GIVEN 2u
#define NORMAL_GIVEN 4u

/* Returns the fault of the display's numbers, or NULL. Sets *expected to the remedy. */
static const char *refused(const struct display *d, const char **expected)
{
    *expected = d->width <= 0 || d->height <= 0 ? "a width and a height above 0"
                : d->distance <= 0              ? "a distance above 0"
                                                : "from to the left of to";
    if (d->width > 0 && d->height > 0 && d->distance > 0 && d->from < d->to)
        return NULL;
    return d->from >= d->to ? "is not an observer line" : "is not a display";
}

static int64_t dot(struct tia_dir3 a, struct tia_dir3 b)
{
    return ((int64_t)a.x * b.x >> 30) + ((int64_t)a.y * b.y >> 30) + ((int64_t)a.z * b.z >> 30);
}

/* Returns a x b, normalised. */
static struct tia_dir3 across(struct tia_dir3 a, struct tia_dir3 b)
{
    return tia_normalise((int32_t)(((int64_t)a.y * b.z - (int64_t)a.z * b.y) >> 30),
                         (int32_t)(((int64_t)a.z * b.x - (int64_t)a.x * b.z) >> 30),
                         (int32_t)(((int64_t)a.x * b.y - (int64_t)a.y * b.x) >> 30));
}

/* Returns d l, in the unit of l. */
static struct tia_vec3 along(struct tia_dir3 d, int64_t l)
{
    return (struct tia_vec3){tia_saturate_s32(tia_round_shift(d.x * l, 30)),
                             tia_saturate_s32(tia_round_shift(d.y * l, 30)),
                             tia_saturate_s32(tia_round_shift(d.z * l, 30))};
}

static struct tia_vec3 added(struct tia_vec3 a, struct tia_vec3 b)
{
    return (struct tia_vec3){tia_saturate_s32((int64_t)a.x + b.x), tia_saturate_s32((int64_t)a.y + b.y),
                             tia_saturate_s32((int64_t)a.z + b.z)};
}

/* Sets the camera. A screen that is not `turned` is upright and faces along z; the camera then has no up vector, so
 * that its axes are exact. */
static void place(struct tia_camera *camera, const struct display *d, bool turned)
{
    struct tia_dir3 n = d->normal, u = {TIA_Q30_ONE, 0, 0}, v = {0, TIA_Q30_ONE, 0};
    tia_q16 middle = tia_saturate_s32(((int64_t)d->from + d->to) >> 1);

    if (turned) {
        u = across(tia_normalise(d->up.x, d->up.y, d->up.z), n);
        v = across(n, u);
    }
    struct tia_vec3 on_screen = added(added(d->centre, along(v, d->above)), along(u, middle));
    camera->eye = added(on_screen, along(n, d->distance));
    camera->reference = turned ? on_screen : (struct tia_vec3){0, 0, 0};
    camera->up = turned ? d->up : (struct tia_vec3){0, 0, 0};
    camera->line = tia_saturate_s32((int64_t)d->to - middle);
    camera->window.left = tia_saturate_s32(-(int64_t)(d->width / 2) - middle);
    camera->window.right = tia_saturate_s32((int64_t)camera->window.left + d->width);
    camera->window.bottom = tia_saturate_s32(-(int64_t)(d->height / 2) - d->above);
    camera->window.top = tia_saturate_s32((int64_t)camera->window.bottom + d->height);
    camera->window.near = d->distance;
}

int tia_light_field_line(struct tia_parse *job)
{
    struct display d = {.up = {0, TIA_Q16_ONE, 0}, .normal = {0, 0, TIA_Q30_ONE}};
    struct tia_word word;
    uint32_t given = 0;
    const char *expected, *wrong;

    (void)tia_text_word(&job->text, &word);
    int status = tia_fields(&job->text, "a lightfield camera", fields, TIA_COUNT_OF(fields), &d, &given);
    if (status)
        return status;
    wrong = refused(&d, &expected);
    if (wrong)
        return tia_text_error(&job->text, &word, wrong, expected);
    struct tia_dir3 up = tia_normalise(d.up.x, d.up.y, d.up.z);
    int64_t slope = dot(up, d.normal);
    if (slope > TIA_Q30_ONE - 1024 || slope < 1024 - TIA_Q30_ONE)
        return tia_text_error(&job->text, &word, "has its up along its normal", "another direction");
    job->scene->camera.projection = TIA_FRUSTUM;
    place(&job->scene->camera, &d, (given & (UP_GIVEN | NORMAL_GIVEN)) != 0);
    return TIA_OK;
}
