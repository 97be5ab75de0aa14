#include "scene_load.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>
#ifdef __wasi__
#define madvise(from, size, advice) ((void)(from), (void)(size)) /* all pages stay */
#else
#include <sys/mman.h>
#endif

#include "common/checksum.h"
#include "common/scene/model/model.h"
#include "common/thread_pool.h"
#include "scene_part.h"
#include "scene_report.h"
#include "whole_file.h"

/* Size of the memory for the first attempt, in bytes; after it, tia_read returns the size that it needs. */
#define MEMORY_FIRST ((size_t)1 << 16)
/* Largest size of the memory, in bytes. The memory takes at most some tens of bytes per byte of the file. */
#define MEMORY_MOST ((size_t)1 << (sizeof(size_t) > 4 ? 34 : 30))

static const char *const names[TIA_FORMATS] = {
    [TIA_FORMAT_TIA] = "tia", [TIA_FORMAT_NFF] = "nff", [TIA_FORMAT_OBJ] = "obj", [TIA_FORMAT_STL] = "stl",
    [TIA_FORMAT_PLY] = "ply", [TIA_FORMAT_OFF] = "off", [TIA_FORMAT_PGM] = "pgm"};

static int format_called(const char *name)
{
    for (int format = TIA_FORMAT_TIA; format < TIA_FORMATS; format++)
        if (strcasecmp(name, names[format]) == 0)
            return format;
    return SCENE_UNKNOWN;
}

int scene_format_of(const char *path)
{
    const char *dot = strrchr(path, '.');
    int format = dot ? format_called(dot + 1) : SCENE_UNKNOWN;
    return dot && format == SCENE_UNKNOWN && model_is_extension(dot + 1) ? SCENE_MODEL : format;
}

static const char *shown(const struct scene_file *file)
{
    return strcmp(file->path, "-") == 0 ? "standard input" : file->path;
}

static int exhausted(struct scene_file *file)
{
    (void)snprintf(file->why, SCENE_WHY, "memory: exhausted");
    return TIA_ERR_MEMORY;
}

static int read_text(struct scene_file *file, struct whole *text)
{
    const char *why;
    if (!scene_opens(file, file->path)) {
        (void)snprintf(file->why, SCENE_WHY, "%.300s: " SCENE_REFUSED, shown(file));
        return TIA_ERR_DEVICE;
    }
    int status = strcmp(file->path, "-") == 0 ? whole_read_from(text, STDIN_FILENO, SCENE_TEXT_MOST, &why)
                                              : whole_read(text, file->path, SCENE_TEXT_MOST, &why);
    if (status == TIA_ERR_MEMORY)
        return exhausted(file);
    if (status == TIA_ERR_RANGE)
        (void)snprintf(file->why, SCENE_WHY, "%.300s: larger than %zu MiB", shown(file), SCENE_TEXT_MOST >> 20);
    else if (status)
        (void)snprintf(file->why, SCENE_WHY, "%.300s: %s", shown(file), why);
    return status;
}

/* Writes "FILE:LINE:COLUMN: ", with FILE as a path from the working directory; returns its length. */
static size_t format_place(const struct scene_file *file, const struct tia_read_error *error, bool column,
                           char line[SCENE_WHY])
{
    char *named = error->file[0] != '\0' ? part_path(file, error->file) : NULL;
    int used = snprintf(line, SCENE_WHY, "%.300s:", named ? named : shown(file));
    if (error->line != 0)
        used += snprintf(line + used, SCENE_WHY - (size_t)used, "%u:", error->line);
    if (error->line != 0 && column)
        used += snprintf(line + used, SCENE_WHY - (size_t)used, "%u:", error->column);
    free(named);
    return (size_t)used;
}

static void format_error(const struct scene_file *file, const struct tia_read_error *error, char line[SCENE_WHY])
{
    size_t used = format_place(file, error, true, line);
    (void)snprintf(line + used, SCENE_WHY - used, " %s", error->text);
}

/* Receives a mistake from tia_read. */
static void add_mistake(void *ctx, const struct tia_read_error *error)
{
    struct scene_file *file = ctx;
    char line[SCENE_WHY];

    format_error(file, error, line);
    scene_report_add(file, line, error);
}

static int set_error(struct scene_file *file, const struct tia_reader *reader)
{
    format_error(file, &reader->error, file->why);
    if (reader->mistakes > TIA_MISTAKES_MAX)
        scene_report_more(file);
    return TIA_ERR_RANGE;
}

static void format_warning(const struct scene_file *file, const struct tia_read_warning *warning, char line[SCENE_WHY])
{
    size_t used = format_place(file, &warning->at, false, line);
    used += (size_t)snprintf(line + used, SCENE_WHY - used, " %s", warning->at.text);
    if (warning->count > 1)
        (void)snprintf(line + used, SCENE_WHY - used, " (%u more)", warning->count - 1);
}

bool scene_warning(const struct scene_file *file, unsigned *at, char line[SCENE_WHY])
{
    while (*at < TIA_WARNINGS) {
        const struct tia_read_warning *warning = &file->warnings[(*at)++];
        if (warning->count > 0) {
            format_warning(file, warning, line);
            return true;
        }
    }
    /* a key may add a light; integrators other than Whitted's have other sources of light */
    if ((*at)++ > TIA_WARNINGS || file->scene.light_count > 0 || file->scene.binding_count > 0 ||
        file->scene.integration.integrator != TIA_WHITTED)
        return false;
    (void)snprintf(line, SCENE_WHY, "%.300s: no light: only what shines by itself is seen", shown(file));
    return true;
}

static void name_material(void *ctx, uint32_t index, const char *name)
{
    const struct scene_wish *wish = ((const struct scene_file *)ctx)->wish;

    if (wish->material)
        wish->material(wish->ctx, index, name);
}

/* Removes the tracks that would move what `change` sets. They are in the file's own memory. */
static void drop_tracks(struct scene_file *file, const struct tia_camera_change *change)
{
    struct tia_scene *scene = &file->scene;
    size_t at = scene->track_count ? (size_t)((const char *)scene->tracks - (const char *)file->memory) : 0;
    struct tia_track *tracks = (struct tia_track *)(void *)((char *)file->memory + at);
    uint32_t kept = 0;

    for (uint32_t i = 0; i < scene->track_count; i++) {
        bool set = (tracks[i].target == TIA_MOVES_EYE && change->has_eye) ||
                   (tracks[i].target == TIA_MOVES_REFERENCE && change->has_reference);
        if (!set)
            tracks[kept++] = tracks[i];
    }
    scene->track_count = kept;
}

/* Reads the scene. If memory is too small, tia_read returns the size that it needs for the next attempt. The first size
 * is three times the text's, which suffices for most large models; what is not used takes only addresses. */
static int read_scene(struct scene_file *file, const struct whole *text, int format, bool strict, struct threads *pool)
{
    struct tia_reader reader = {.format = (enum tia_format)format,
                                .text = text->bytes,
                                .length = text->length,
                                .library = part_library,
                                .image = part_image,
                                .opacity = part_opacity,
                                .material = name_material,
                                .ctx = file,
                                .reach = file->wish->reach,
                                .camera = file->wish->camera,
                                .workers = threads_workers(pool),
                                .strict = strict,
                                .warnings = file->warnings,
                                .mistake = add_mistake};
    size_t size = 3 * text->length > MEMORY_FIRST ? 3 * text->length : MEMORY_FIRST, need = 0;
    int status = TIA_ERR_MEMORY;
    bool more = true; /* memory is needed: for the scene, or for the rest of its mistakes */
    for (unsigned tries = 0; tries < 4 && more && size <= MEMORY_MOST; tries++) {
        free(file->memory);
        scene_report_free(file);
        file->memory = malloc(size);
        if (!file->memory)
            return exhausted(file);
        status = tia_read(&reader, &file->scene, file->memory, size, &need);
        more = status == TIA_ERR_MEMORY || (status == TIA_ERR_RANGE && need > size);
        size = need > size ? need : size * 2;
    }
    file->placement = reader.placement;
    if (!status && file->wish->camera)
        drop_tracks(file, file->wish->camera);
    return status == TIA_ERR_MEMORY ? exhausted(file) : status ? set_error(file, &reader) : TIA_OK;
}

/* Size in bytes from which a hierarchy is built by several threads: building it takes as long as starting the
 * threads. */
#define BOXES_FOR_THREADS ((size_t)1 << 20)
/* Size in bytes of a text that is read by several threads, likewise. */
#define TEXT_FOR_THREADS ((size_t)1 << 18)

/* Returns whole pages behind the first `used` bytes to the system. They stay allocated. */
static void drop_pages(void *memory, size_t used, size_t size)
{
    uintptr_t page = (uintptr_t)sysconf(_SC_PAGESIZE), start = (uintptr_t)memory;
    uintptr_t from = (start + used + page - 1) / page * page, to = (start + size) / page * page;
    if (to > from)
        (void)madvise((void *)from, to - from, MADV_DONTNEED);
}

/* Builds the hierarchy. */
static int build_boxes(struct scene_file *file, struct threads *pool)
{
    struct tia_scene *scene = &file->scene;
    size_t size = tia_bvh_size(scene), used = 0;
    file->boxes = size <= MEMORY_MOST ? malloc(size > 0 ? size : 1) : NULL;
    int status = !file->boxes ? TIA_ERR_MEMORY
                              : tia_bvh_build(&scene->bvh, file->boxes, size, &used, scene,
                                              &(struct tia_job){.workers = threads_workers(pool)});
    if (!status)
        drop_pages(file->boxes, used, size);
    return status == TIA_ERR_MEMORY ? exhausted(file) : TIA_OK;
}

/* Creates a pool for large work. Returns NULL, one thread, also if there is no memory. */
static struct threads *create_pool(unsigned threads, bool large)
{
    return threads > 1 && large ? threads_create(threads) : NULL;
}

int scene_open(struct scene_file *file, const char *path, int format, bool strict)
{
    return scene_open_for(file, path, format, strict, &(struct scene_wish){.reach = 0});
}

/* Reads a scene in a format of the core. *pool receives the threads that were created for it. */
static int open_text(struct scene_file *file, int format, bool strict, struct threads **pool)
{
    struct whole text;
    int status = read_text(file, &text);
    if (status)
        return status;
    file->crc = file->wish->hashed ? checksum_bytes(0, text.bytes, text.length) : 0;
    *pool = create_pool(file->wish->threads, text.length >= TEXT_FOR_THREADS);
    status = read_scene(file, &text, format, strict, *pool);
    free(text.bytes);
    return status;
}

int scene_open_for(struct scene_file *file, const char *path, int format, bool strict, const struct scene_wish *wish)
{
    struct threads *pool = NULL;
    *file = (struct scene_file){.path = path, .wish = wish};
    int status = format == SCENE_MODEL ? model_open(file, strict) : open_text(file, format, strict, &pool);
    if (!pool)
        pool = create_pool(wish->threads, !status && tia_bvh_size(&file->scene) >= BOXES_FOR_THREADS);
    if (!status)
        status = build_boxes(file, pool);
    threads_destroy(pool);
    if (status) {
        char *report = file->report;
        file->report = NULL;
        scene_close(file);
        file->report = report;
    }
    return status;
}

void scene_close(struct scene_file *file)
{
    free(file->memory);
    free(file->boxes);
    file->memory = file->boxes = NULL;
    scene_report_free(file);
    part_free_all(file);
    model_close(file);
}
