/* view.c - the statements camera, samples, background, depth and shadows. */
#include "job.h"

#define EYE                                                                                                            \
    {.word = "eye", .kind = TIA_LENGTHS, .count = 3, .offset = offsetof(struct tia_camera, eye)},                      \
        {.word = "look", .kind = TIA_LENGTHS, .count = 3, .offset = offsetof(struct tia_camera, reference)},           \
    {                                                                                                                  \
        .word = "up", .kind = TIA_VECTOR, .offset = offsetof(struct tia_camera, up)                                    \
    }
#define LOOK_GIVEN 2u
#define UP_GIVEN 4u
/* left, right, bottom, top */
#define WINDOW                                                                                                         \
    {                                                                                                                  \
        .word = "window", .kind = TIA_LENGTHS, .count = 4, .offset = offsetof(struct tia_camera, window),              \
        .needed = true                                                                                                 \
    }
_Static_assert(offsetof(struct tia_window, top) == 3 * sizeof(tia_q16), "a window is four numbers");

static const struct tia_field perspective[] = {
    EYE,
    {.word = "fov", .kind = TIA_NUMBERS, .count = 1, .offset = offsetof(struct tia_camera, fov)},
};

static const struct tia_field frustum[] = {
    EYE,
    WINDOW,
    {.word = "near",
     .kind = TIA_LENGTHS,
     .count = 1,
     .offset = offsetof(struct tia_camera, window.near),
     .needed = true},
};

static const struct tia_field orthographic[] = {EYE, WINDOW};

static const struct tia_form projections[] = {
    {"perspective", "a camera", TIA_PERSPECTIVE, perspective, TIA_COUNT_OF(perspective)},
    {"frustum", "a frustum camera", TIA_FRUSTUM, frustum, TIA_COUNT_OF(frustum)},
    {"orthographic", "an orthographic camera", TIA_ORTHOGRAPHIC, orthographic, TIA_COUNT_OF(orthographic)},
};

int tia_line_camera(struct tia_job *job)
{
    struct tia_camera *camera = &job->scene->camera;
    const struct tia_form *form = tia_form(&job->text, projections, TIA_COUNT_OF(projections));
    uint32_t given = 0;
    struct tia_word end;

    camera->projection = (enum tia_projection)form->kind;
    int status = tia_fields(&job->text, form->what, form->fields, form->count, camera, &given);
    if (status)
        return status;
    (void)tia_text_peek(&job->text, &end);
    if ((given & UP_GIVEN) && !(given & LOOK_GIVEN))
        return tia_text_error(&job->text, &end, "", "look, as there is up");
    if ((given & LOOK_GIVEN) && !(given & UP_GIVEN))
        camera->up.y = TIA_Q16_ONE;
    return TIA_OK;
}

int tia_line_samples(struct tia_job *job)
{
    struct tia_word word;

    (void)tia_text_word(&job->text, &word);
    for (uint32_t n = 1; n <= TIA_SAMPLES_MAX; n *= 4)
        if (tia_word_is(&word, n == 1 ? "1" : n == 4 ? "4" : "16")) {
            job->scene->camera.samples = n;
            return TIA_OK;
        }
    return tia_text_error(&job->text, &word, "is no number of samples", "1, 4 or 16");
}

int tia_line_background(struct tia_job *job)
{
    return tia_colour(&job->text, &job->scene->background, false);
}

int tia_line_depth(struct tia_job *job)
{
    int64_t depth = 0;
    int status = tia_text_integer(&job->text, &depth, 1, TIA_DEPTH_MAX);

    job->scene->depth = (uint32_t)depth;
    return status;
}

int tia_line_shadows(struct tia_job *job)
{
    struct tia_word word;
    const char *name;

    (void)tia_text_word(&job->text, &word);
    for (unsigned i = 0; (name = tia_shadows_name(i)) != NULL; i++)
        if (tia_word_is(&word, name)) {
            job->scene->shadows = (enum tia_shadows)i;
            return TIA_OK;
        }
    return tia_text_error(&job->text, &word, "is no technique", "traced, rays, zpass or zfail");
}
