#include "options_check.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>

#include "benchmark.h"
#include "common/image/series.h"
#include "eye_setup.h"
#include "fail.h"
#include "gaze_options.h"
#include "lightfield_setup.h"
#include "ports.h"
#include "thumbnail_check.h"

enum { PACE_MAX = 1000 };

static bool is_one_of(const char *name, const char *const *names)
{
    while (*names && strcmp(name, *names) != 0)
        names++;
    return *names;
}

/* Checks the names of displays and inputs. A name that is valid only in other builds of tia is no usage error; opening
 * it fails later, with its own message. */
static int check_names(const struct options *options)
{
    static const char *const displays[] = {"auto", "drm", "fbdev", "terminal", "none", NULL};
    static const char *const inputs[] = {"auto", "evdev", "tty", "none", NULL};
    bool display = is_one_of(options->display.name, displays), input = is_one_of(options->input.name, inputs);
    for (const struct port_display *port = port_displays; port->name; port++)
        display = display || strcmp(port->name, options->display.name) == 0;
    for (const struct port_input *port = port_inputs; port->name; port++)
        input = input || strcmp(port->name, options->input.name) == 0;
    if (!display)
        return wrong("--display", options->display.name, "no such display (auto, drm, fbdev, terminal or none)");
    if (!input)
        return wrong("--input", options->input.name, "no such input (auto, evdev, tty or none)");
    if (options->display.device && strcmp(options->display.name, "auto") == 0)
        return wrong("--display", options->display.device, "auto takes no device (name the display)");
    if (options->input.device && strcmp(options->input.name, "auto") == 0)
        return wrong("--input", options->input.device, "auto takes no device (name the input)");
    return EXIT_FINE;
}

/* Chooses the file's format and checks the options for files. */
static int check_output(struct options *options)
{
    if (!options->output)
        return options->format == IMAGE_UNKNOWN ? EXIT_FINE : fail(EXIT_USAGE, "--format: needs --output FILE");
    if (strcmp(options->display.name, "auto") != 0 || strcmp(options->input.name, "auto") != 0 || options->connector ||
        options->mode)
        return fail(EXIT_USAGE, "--output: goes to a file, without --display, --input, --connector or --mode");
    bool is_standard = strcmp(options->output, "-") == 0;
    if (is_standard && options->checksum)
        return fail(EXIT_USAGE, "--checksum: standard output already gets the picture (-o FILE)");
    if (options->format == IMAGE_UNKNOWN && !is_standard)
        options->format = image_format_of(options->output);
    if (options->format == IMAGE_UNKNOWN) {
        return fail(
            EXIT_USAGE,
            "%.200s: unknown picture format (name it .png, .ppm, .bmp, .565, .pfm, .exr or .y4m, or use --format)",
            is_standard ? "standard output" : options->output);
    }
    if (!image_format_built(options->format)) {
        return fail(EXIT_USAGE, "%.200s: this build writes no .%s (use .ppm)", options->output,
                    image_format_name(options->format));
    }
    if (options->action == ACTION_SHOW)
        options->action = ACTION_DRAW;
    return EXIT_FINE;
}

/* Checks --fps, which is the target frame rate on a display if --frames is not given. */
static int check_pace(const struct options *options)
{
    bool paces = options->rate_given && !options->output && options->frames == 0;

    if (paces && options->rate[0] / options->rate[1] > PACE_MAX)
        return fail(EXIT_USAGE, "--fps %u: no display shows more than %u frames a second", options->rate[0],
                    (unsigned)PACE_MAX);
    return EXIT_FINE;
}

/* Checks the options for parts of films and pictures, which can only be files, and others that need a file or a
 * display. */
static int check_parts(const struct options *options)
{
    const char *output = options->output;
    bool films = output && (image_format_films(options->format) || series_is_pattern(output));
    if (options->frame_range && !films)
        return fail(EXIT_USAGE, "--frame-range: needs a film (-o FILE.y4m, FILE.tiapart or FILE%%04d.png)");
    if (options->tile_rows && (!output || options->format != IMAGE_PART))
        return fail(EXIT_USAGE, "--tile-rows: needs a part file (-o FILE.tiapart)");
    unsigned width = options->width ? options->width : 640, height = options->height ? options->height : 480;
    if (options->views.draws_rays && (output || options->width) &&
        (options->views.x >= width || options->views.y >= height))
        return fail(EXIT_USAGE, "--draw-rays %u,%u: outside the picture, %ux%u", options->views.x, options->views.y,
                    width, height);
    if (options->stats_overlay && output)
        return fail(EXIT_USAGE, "--stats-overlay: needs a display (a file has --stats)");
    if (options->notify && !output && !options->benchmark && !options->write && !options->frames && !options->in_line)
        return fail(EXIT_USAGE, "--notify: needs work that ends (--output, --frames, --write or --benchmark)");
    if (options->rate_given && output && !films)
        return fail(EXIT_USAGE, "--fps: needs a film (-o FILE.y4m, FILE.tiapart or FILE%%04d.png)");
    return check_pace(options);
}

/* Checks --inline, which prints one picture on the terminal unless --frames says how many. */
static int check_inline(struct options *options)
{
    if (!options->in_line)
        return EXIT_FINE;
    if (options->output || options->watches)
        return fail(EXIT_USAGE, "--inline: not with --%s", options->output ? "output" : "watch");
    if (strcmp(options->display.name, "auto") == 0)
        options->display.name = "terminal";
    if (strcmp(options->display.name, "terminal") != 0)
        return fail(EXIT_USAGE, "--inline: only the terminal display has it (-d terminal)");
    options->frames = options->frames ? options->frames : 1;
    return EXIT_FINE;
}

static bool is_help(const char *value)
{
    return value && strcmp(value, "help") == 0;
}

/* Checks --connector and --mode: only DRM has connectors and modes. */
static int check_drm(struct options *options)
{
    if (!options->connector && !options->mode)
        return EXIT_FINE;
    if (is_help(options->connector) || is_help(options->mode))
        options->action = ACTION_MODES;
    if (strcmp(options->display.name, "auto") == 0)
        options->display.name = "drm";
    if (strcmp(options->display.name, "drm") != 0) {
        return fail(EXIT_USAGE, "--%s: only the drm display has it (-d drm)",
                    options->connector ? "connector" : "mode");
    }
    return EXIT_FINE;
}

/* Refuses a file without the extension of a format; the reason may be that there is no such file. */
static int refuse_format(const char *path)
{
    struct stat status;

    if (stat(path, &status) != 0)
        return fail(EXIT_USAGE, "%.200s: %s", path, strerror(errno));
    if (S_ISDIR(status.st_mode))
        return fail(EXIT_USAGE, "%.200s: %s", path, strerror(EISDIR));
    return fail(
        EXIT_USAGE,
        "%.200s: unknown scene format (name it .tia, .nff, .obj, .stl, .ply, .off or .pgm, or use --scene-format)",
        path);
}

/* Chooses the scene's format by the file's name unless it is given. */
int check_scene(struct options *options)
{
    const char *path = options->scene_path;
    if (!path)
        return options->scene_format == SCENE_UNKNOWN ? EXIT_FINE : fail(EXIT_USAGE, "--scene-format: needs a SCENE");
    if (strcmp(path, "-") == 0 && options->scene_format == SCENE_UNKNOWN && options->checks)
        options->scene_format = TIA_FORMAT_TIA;
    if (strcmp(path, "-") == 0 && options->scene_format == SCENE_UNKNOWN)
        return fail(EXIT_USAGE, "standard input: unknown scene format (use --scene-format)");
    if (options->scene_format == SCENE_UNKNOWN)
        options->scene_format = scene_format_of(path);
    return options->scene_format == SCENE_UNKNOWN ? refuse_format(path) : EXIT_FINE;
}

/* Checks several scenes: they need a display, where a key selects the next one. */
static int check_scenes(struct options *options)
{
    int result = check_scene(options);

    for (uint32_t i = 1; i < options->scene_count && result == EXIT_FINE; i++) {
        struct options other = *options;
        other.scene_path = options->scene_paths[i];
        other.scene_format = options->format_of_scenes;
        if (options->output)
            return fail(EXIT_USAGE, "%.200s: one scene at a time (several are for a display)", other.scene_path);
        if (strcmp(other.scene_path, "-") == 0 || strcmp(options->scene_path, "-") == 0)
            return fail(EXIT_USAGE, "standard input: not one of several scenes, since it is read once");
        result = check_scene(&other);
    }
    return result;
}

static int check_write(struct options *options)
{
    if (!options->write)
        return EXIT_FINE;
    if (options->output || options->watches)
        return fail(EXIT_USAGE, "--write: not with --%s", options->output ? "output" : "watch");
    if (!options->scene_path || options->scene_count > 1)
        return fail(EXIT_USAGE, "--write: needs one SCENE, a model");
    options->action = ACTION_WRITE;
    return EXIT_FINE;
}

static int check_checks(const struct options *options)
{
    const char *other = options->output ? "output" : options->write ? "write" : options->watches ? "watch" : NULL;

    if (!options->checks)
        return EXIT_FINE;
    if (other)
        return fail(EXIT_USAGE, "--check: not with --%s: it draws nothing", other);
    return options->scene_path ? EXIT_FINE : fail(EXIT_USAGE, "--check: needs a SCENE");
}

static int check_watch(const struct options *options)
{
    if (!options->watches)
        return EXIT_FINE;
    if (options->output)
        return fail(EXIT_USAGE, "--watch: needs a display, not --output");
    if (!options->scene_path || strcmp(options->scene_path, "-") == 0)
        return fail(EXIT_USAGE, "--watch: needs a SCENE that is a file");
    return EXIT_FINE;
}

int check(struct options *options)
{
    int result = check_names(options);
    if (result == EXIT_FINE)
        result = check_output(options);
    if (result == EXIT_FINE)
        result = check_inline(options);
    if (result == EXIT_FINE)
        result = check_parts(options);
    if (result == EXIT_FINE)
        result = check_drm(options);
    if (result == EXIT_FINE)
        result = gaze_check(options);
    if (result == EXIT_FINE)
        result = eye_check(options);
    if (result == EXIT_FINE)
        result = check_checks(options);
    if (result == EXIT_FINE)
        result = check_watch(options);
    if (result == EXIT_FINE)
        result = check_write(options);
    if (result == EXIT_FINE)
        result = light_check(options);
    if (result == EXIT_FINE)
        result = check_scenes(options);
    if (result == EXIT_FINE)
        result = benchmark_options(options);
    return result == EXIT_FINE ? thumbnail_check(options) : result;
}
