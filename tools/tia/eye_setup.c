#include "eye_setup.h"

#include <tia/fit.h>

#include "fail.h"
#include "write.h"

static bool changes(const struct tia_camera_change *change)
{
    return change->has_eye || change->has_reference || change->has_up || change->fov || change->height;
}

const struct tia_camera_change *eye_change(const struct options *options)
{
    return changes(&options->eye.change) ? &options->eye.change : NULL;
}

/* True if the output contains the hash of its scene, so that parts and finished rows of other scenes are refused. */
static bool names_scene(const struct options *options)
{
    return options->resume || options->format == IMAGE_PART || options->format == IMAGE_Y4M;
}

static int open_with(struct options *options, const struct tia_camera_change *change)
{
    const struct scene_wish wish = {.camera = change,
                                    .threads = options->threads,
                                    .hashed = names_scene(options),
                                    .opens = options->watch ? file_watch_add : options->opens,
                                    .opens_ctx = options->watch ? options->watch : options->opens_ctx,
                                    .material = options->write ? write_note_name : NULL,
                                    .ctx = &options->names};
    int status = scene_open_for(&options->file, options->scene_path, options->scene_format, options->strict, &wish);

    options->scene = options->file.scene;
    return status ? fail_scene(status == TIA_ERR_MEMORY ? EXIT_RUNNING : EXIT_USAGE, &options->file) : EXIT_FINE;
}

int eye_open(struct options *options)
{
    return open_with(options, eye_change(options));
}

int eye_check(const struct options *options)
{
    if (options->eye.change.fov && options->eye.change.height)
        return fail(EXIT_USAGE, "--fov: not with --orthographic, whose rays are parallel");
    return EXIT_FINE;
}

/* ---- the file's coordinates ---- */

/* Returns a length of Q47.16 in the scene's unit as one of Q31.32 in the file's, saturated. */
static int64_t file_length(int64_t a, int bits)
{
    int shift = 16 - bits;
    int64_t most = shift > 0 ? INT64_MAX >> shift : INT64_MAX;

    if (shift <= 0)
        return a / (INT64_C(1) << (-shift < 62 ? -shift : 62));
    return a > most ? INT64_MAX : a < -most ? -INT64_MAX : a * (INT64_C(1) << shift);
}

static void file_place(int64_t out[3], const int64_t at[3], const struct tia_placement *placement)
{
    for (int i = 0; i < 3; i++)
        out[i] = placement->origin[i] + file_length(at[i], placement->bits);
}

/* Returns what makes this camera of any other. */
static struct tia_camera_change place_of(const struct tia_camera *camera, const struct tia_placement *placement)
{
    const int64_t eye[3] = {camera->eye.x, camera->eye.y, camera->eye.z},
                  reference[3] = {camera->reference.x, camera->reference.y, camera->reference.z};
    struct tia_camera_change change = {.has_eye = true, .has_reference = true};

    file_place(change.eye, eye, placement);
    file_place(change.reference, reference, placement);
    return change;
}

void eye_carry(struct tia_camera *camera, const struct tia_placement *from, const struct tia_placement *to)
{
    struct tia_camera_change change = place_of(camera, from);
    struct tia_window *window = &camera->window;
    tia_q16 *const lengths[] = {&window->left, &window->right, &window->bottom, &window->top, &window->near};

    change.has_reference = camera->up.x || camera->up.y || camera->up.z;
    tia_camera_alter(camera, &change, to);
    for (unsigned i = 0; i < sizeof lengths / sizeof *lengths; i++) {
        int64_t length = *lengths[i], bits = to->bits - from->bits;
        length = bits >= 0 ? length * (INT64_C(1) << (bits < 31 ? bits : 31)) : length >> (bits > -63 ? -bits : 63);
        *lengths[i] = (tia_q16)(length > INT32_MAX ? INT32_MAX : length < INT32_MIN ? INT32_MIN : length);
    }
}

/* ---- --fit ---- */

static struct tia_camera_change change_to(const struct options *options, const struct tia_fit *fit,
                                          const struct tia_placement *placement)
{
    const struct tia_camera *camera = &options->scene.camera;
    struct tia_camera_change change = options->eye.change;

    change.has_eye = true;
    change.has_reference = camera->up.x || camera->up.y || camera->up.z;
    file_place(change.eye, fit->eye, placement);
    file_place(change.reference, fit->reference, placement);
    if (camera->projection == TIA_ORTHOGRAPHIC)
        change.height = file_length(fit->height, placement->bits);
    return change;
}

/* True if the camera cannot simply be replaced, since more depends on it: keyframes, and digits below Q16.16. */
static bool is_bound(const struct tia_scene *scene)
{
    for (uint32_t i = 0; i < scene->track_count; i++)
        if (scene->tracks[i].target == TIA_MOVES_EYE || scene->tracks[i].target == TIA_MOVES_REFERENCE)
            return true;
    return scene->fine;
}

/* Reads the file again with this camera, which can be too far away for the unit of length of the first time. */
static int read_again(struct options *options, const struct tia_camera_change *change)
{
    if (options->scene_path[0] == '-' && !options->scene_path[1])
        return fail(EXIT_USAGE, "--fit: standard input cannot be read twice, as this scene needs (use a file)");
    scene_close(&options->file);
    return open_with(options, change);
}

static int fit(struct options *options)
{
    bool known = options->width, file = options->output;
    unsigned width = known ? options->width : file ? 640 : 1, height = known ? options->height : file ? 480 : 1;
    const struct tia_placement *placement = &options->file.placement;
    struct tia_scene *scene = &options->scene;
    struct tia_camera before = scene->camera;
    struct tia_fit place;

    if (tia_camera_fit(&place, scene, width, height))
        return fail(EXIT_USAGE, "--fit: no object with bounds is near enough (planes have none)");
    struct tia_camera_change change = change_to(options, &place, placement);
    tia_camera_alter(&scene->camera, &change, placement);
    if (!(options->scene_path && is_bound(scene)) && !tia_scene_check(scene, NULL))
        return EXIT_FINE;
    scene->camera = before;
    return options->scene_path ? read_again(options, &change)
                               : fail(EXIT_USAGE, "--fit: the eye would be too far away");
}

/* ---- all ---- */

/* Changes the camera of the built-in scene, which is not read. */
static int change_built_in(struct options *options)
{
    struct tia_fault fault;

    tia_camera_alter(&options->scene.camera, eye_change(options), &options->file.placement);
    if (!tia_scene_check(&options->scene, &fault))
        return EXIT_FINE;
    return fail(EXIT_USAGE, "the eye: %s %u: %s: %s", fault.thing, (unsigned)fault.index, fault.field, fault.rule);
}

int eye_load(struct options *options)
{
    const struct eye_options *eye = &options->eye;
    const char *projects = eye->fit ? "fit" : eye->change.fov ? "fov" : eye->change.height ? "orthographic" : NULL;

    if (projects && options->scene.camera.line)
        return fail(EXIT_USAGE, "--%s: not for a camera lightfield, whose window is its screen", projects);
    int status = options->scene_path || !eye_change(options) ? EXIT_FINE : change_built_in(options);
    return status || !eye->fit ? status : fit(options);
}
