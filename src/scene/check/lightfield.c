#include "math/integer.h"
#include "scene_check.h"

static int check_line(const struct check *check)
{
    const struct tia_camera *c = &check->scene->camera;
    const struct tia_window *w = &c->window;

    REQUIRE(c->line >= 0, "line", "must be at least 0");
    if (!c->line)
        return TIA_OK;
    REQUIRE(c->projection == TIA_FRUSTUM, "line", "only a frustum camera has one");
    REQUIRE((int64_t)w->left - c->line >= INT32_MIN && (int64_t)w->right + c->line <= INT32_MAX, "line",
            "the window must be within 32768 of all of it");
    return TIA_OK;
}

static int check_lens(const struct check *check, const struct tia_lenticular *lens)
{
    REQUIRE(lens->pitch > -TIA_PITCH_MAX && lens->pitch < TIA_PITCH_MAX, "lens.pitch", "must be below 2^20");
    REQUIRE(lens->rise > -TIA_PITCH_MAX && lens->rise < TIA_PITCH_MAX, "lens.rise", "must be below 2^20");
    REQUIRE(lens->subpixels <= TIA_SUBPIXELS_NONE, "lens.subpixels", "must be rgb, bgr or none");
    return TIA_OK;
}

/* Checks the light field; widths and distances must not be 0, since later steps divide by them. */
static int check_field(const struct check *check, const struct tia_light_field *field)
{
    const struct tia_window *w = &check->scene->camera.window;

    REQUIRE(check->scene->camera.line > 0, "camera", "must have an observer line");
    REQUIRE(w->left < w->right, "camera", "its window must have a width");
    REQUIRE(!check->scene->shadows, "shadows", "must be traced where a picture has many eyes");
    REQUIRE(field->kind == TIA_QUILT || field->kind == TIA_LENTICULAR || field->kind == TIA_PROJECTOR, "kind",
            "must be a kind of light field");
    if (field->kind == TIA_QUILT)
        REQUIRE(field->quilt.columns - 1u < TIA_QUILT_MAX && field->quilt.rows - 1u < TIA_QUILT_MAX, "quilt",
                "must have 1 to 256 columns and rows");
    if (field->kind == TIA_LENTICULAR)
        return check_lens(check, &field->lens);
    if (field->kind == TIA_PROJECTOR)
        REQUIRE(field->projector.distance > 0, "projector.distance", "must be above 0");
    return TIA_OK;
}

void tia_check_eyes(const struct tia_camera *camera, struct tia_bounds *eyes)
{
    int64_t line = camera->line > 0 ? camera->line : 0;

    eyes->min = (struct tia_vec3){tia_saturate_s32(eyes->min.x - line), tia_saturate_s32(eyes->min.y - line),
                                  tia_saturate_s32(eyes->min.z - line)};
    eyes->max = (struct tia_vec3){tia_saturate_s32(eyes->max.x + line), tia_saturate_s32(eyes->max.y + line),
                                  tia_saturate_s32(eyes->max.z + line)};
}

int tia_check_light_field(struct check *check)
{
    const struct tia_light_field *field = check->scene->field;

    check->index = 0;
    check->thing = "camera";
    int status = check_line(check);
    check->thing = "light field";
    return status || !field ? status : check_field(check, field);
}
