/* mesh_file.c - meshes from files:  mesh NAME file PATH
 *
 * The model's reader runs on its file in each pass. The first two passes only count; the last one reads the model into
 * words of the scene's memory, and copies its materials, textures and meshes to the scene's arrays.
 *
 * A model of several materials has several parts, a mesh for each, and each instance of it has as many shapes. Without
 * a material of its own, the instance has those of the model. The number of parts is an upper bound, since only the
 * last pass finds out which materials have faces: the remaining meshes are empty. Nor does the first pass know which
 * model an instance names. It counts the instances and the parts of all names with the same hash, whose product is
 * enough.
 */
#include "math/integer.h"
#include "parse_state.h"
#include "read/model/model.h"
#include "read/readers.h"

/* The reader of the model, and the context of the functions that load its files. */
struct mesh_file {
    struct tia_parse *job;
    char path[TIA_NAME_MAX + 1];
    struct tia_reader reader;
    struct tia_scene scene;
    struct tia_model_use use;
};

/* ---- the model's own files, relative to its folder ---- */

/* Writes the path of a file of the model. */
static int path_of(const struct mesh_file *m, const char *name, char path[TIA_NAME_MAX + 1], const char **why)
{
    struct tia_word word = {name, 0, 0, 0};

    while (name[word.length])
        word.length++;
    for (unsigned i = 0; i <= TIA_NAME_MAX; i++)
        path[i] = m->path[i];
    *why = "its path is too long";
    return word.length && tia_path_follow(path, &word) ? TIA_OK : TIA_ERR_ARGUMENT;
}

static int load_library(void *ctx, const char *name, const char **text, size_t *length, const char **why)
{
    const struct mesh_file *m = ctx;
    const struct tia_reader *outer = m->job->reader;
    char path[TIA_NAME_MAX + 1];
    int status = path_of(m, name, path, why);

    return status ? status : outer->library(outer->ctx, path, text, length, why);
}

static int load_image(void *ctx, const char *name, struct tia_texture *texture, const char **why)
{
    const struct mesh_file *m = ctx;
    const struct tia_reader *outer = m->job->reader;
    char path[TIA_NAME_MAX + 1];
    int status = path_of(m, name, path, why);

    return status ? status : outer->image(outer->ctx, path, texture, why);
}

static int load_opacity(void *ctx, const char *name, enum tia_channel channel, struct tia_texture *texture,
                        const char **why)
{
    const struct mesh_file *m = ctx;
    const struct tia_reader *outer = m->job->reader;
    char path[TIA_NAME_MAX + 1];
    int status = path_of(m, name, path, why);

    return status ? status : outer->opacity(outer->ctx, path, channel, texture, why);
}

/* ---- opening ---- */

static bool ends_with(const struct tia_word *name, const char *extension)
{
    const char *at = name->at + name->length;
    uint32_t length = 0;

    while (extension[length])
        length++;
    for (uint32_t i = length; length < name->length && i > 0; i--) {
        char c = *--at;
        if ((c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c) != extension[i - 1])
            return false;
    }
    return length < name->length;
}

static int choose_format(struct tia_parse *job, const struct tia_word *name, enum tia_format *format)
{
    static const struct {
        const char *extension;
        enum tia_format format;
    } formats[] = {{".obj", TIA_FORMAT_OBJ},
                   {".stl", TIA_FORMAT_STL},
                   {".ply", TIA_FORMAT_PLY},
                   {".off", TIA_FORMAT_OFF},
                   {".pgm", TIA_FORMAT_PGM}};

    for (size_t i = 0; i < TIA_COUNT_OF(formats); i++)
        if (ends_with(name, formats[i].extension)) {
            *format = formats[i].format;
            return TIA_OK;
        }
    return tia_text_error(&job->text, name, "is not a format of models", "a file in .obj, .stl, .ply, .off or .pgm");
}

static int open_file(struct mesh_file *m, const struct tia_word *name)
{
    struct tia_parse *job = m->job;
    const struct tia_reader *outer = job->reader;
    const char *why = "cannot be read";

    m->reader = (struct tia_reader){.library = outer->library ? load_library : NULL,
                                    .image = outer->image ? load_image : NULL,
                                    .opacity = outer->opacity ? load_opacity : NULL,
                                    .ctx = m,
                                    .strict = outer->strict,
                                    .warnings = job->pass == TIA_FILLING ? outer->warnings : NULL};
    int status = choose_format(job, name, &m->reader.format);
    status = status ? status : tia_include_path(job, name, m->path);
    if (status)
        return status;
    if (!outer->library)
        return tia_text_error(&job->text, name, "cannot be fetched here", "a scene of one file");
    if (tia_parse_count(job, TIA_OF_MODELS) == TIA_MODELS_MAX && job->pass != TIA_FILLING)
        return tia_text_error(&job->text, name, "is one file too many", "at most 256 models");
    if (outer->library(outer->ctx, m->path, &m->reader.text, &m->reader.length, &why))
        return tia_parse_missing(job, name, why, "a model's file");
    if (tia_text_is_too_long(m->reader.length))
        return tia_text_error(&job->text, name, "is too long", "less than 4 GiB");
    if (!m->reader.text)
        m->reader.text = "";
    return TIA_OK;
}

/* ---- the passes ---- */

/* Reads the model, or only counts if the arena has no memory. */
static int read_model(struct mesh_file *m, struct tia_arena *arena)
{
    m->scene = (struct tia_scene){.bvh = NULL};
    m->use = (struct tia_model_use){.file = m->path, .scale_bits = m->job->reach.lengths.scale_bits};
    m->reader.error = (struct tia_read_error){.line = 0};
    int status = tia_read_model(&m->reader, &m->scene, arena, &m->use);
    if (status)
        m->job->reader->error = m->reader.error;
    return status;
}

/* Returns the largest coordinate, rounded up, in the unit of the pass. */
static int64_t size_of(const struct mesh_file *m)
{
    int64_t size = 0;

    for (int i = 0; i < 3 && m->use.min[0] <= m->use.max[0]; i++) {
        size = m->use.max[i] > size ? m->use.max[i] : size;
        size = -m->use.min[i] > size ? -m->use.min[i] : size;
    }
    size = (size >> (TIA_MODEL_BITS - 16)) + ((size & ((1 << (TIA_MODEL_BITS - 16)) - 1)) != 0);
    return tia_length_times(size, m->use.scale_bits);
}

static void measure(const struct mesh_file *m)
{
    struct tia_reach *reach = &m->job->reach;
    int64_t size = size_of(m);
    tia_q16 at = tia_saturate_s32(size);

    reach->lengths.longest = size > reach->lengths.longest ? size : reach->lengths.longest;
    reach->lengths.rounded = reach->lengths.rounded || m->use.rounded;
    tia_reach_vertex(reach, (struct tia_vec3){at, at, at});
}

/* Adds `count` to an array's items. */
static void add_items(struct tia_parse *job, enum tia_parse_array array, uint64_t count)
{
    uint32_t *now = &job->arrays[array].count;

    *now = count < UINT32_MAX - *now ? *now + (uint32_t)count : UINT32_MAX;
}

static unsigned hash(const struct tia_word *name)
{
    uint32_t h = 0;

    for (uint32_t i = 0; i < name->length; i++)
        h = h * 31 + (unsigned char)name->at[i];
    return (unsigned)(h % TIA_MODEL_HASHES);
}

static void count(struct mesh_file *m, const struct tia_word *mesh, size_t bytes)
{
    struct tia_parse *job = m->job;
    uint32_t parts = m->use.mesh_most, *most = &job->models[hash(mesh)].parts;
    const struct tia_parse_model model = {.mesh = tia_parse_count(job, TIA_OF_MESHES), .parts = parts};

    if (job->pass == TIA_COUNTING)
        measure(m);
    *most = parts > *most ? parts : *most;
    (void)tia_parse_add(job, TIA_OF_MODELS, &model);
    add_items(job, TIA_OF_MODEL_WORDS, bytes / sizeof(uint64_t));
    add_items(job, TIA_OF_MESHES, parts);
    add_items(job, TIA_OF_PARTS, parts);
    add_items(job, TIA_OF_MATERIALS, m->scene.material_count);
    add_items(job, TIA_OF_TEXTURES, m->scene.texture_count);
}

/* Adds a mesh, and the material that its faces have in the model. */
static void add_mesh(struct tia_parse *job, const struct tia_mesh *mesh, uint32_t material)
{
    const struct tia_parse_part part = {material};

    (void)tia_parse_add(job, TIA_OF_MESHES, mesh);
    (void)tia_parse_add(job, TIA_OF_PARTS, &part);
}

static void add_meshes(struct mesh_file *m, uint32_t first_material)
{
    static const struct tia_mesh empty = {.face_count = 0};
    const struct tia_scene *scene = &m->scene;

    for (uint32_t i = 0; i < m->use.mesh_most; i++)
        if (i < scene->mesh_count)
            add_mesh(m->job, &scene->meshes[i], first_material + scene->shapes[i].material);
        else
            add_mesh(m->job, &empty, first_material);
}

static void add_materials(struct mesh_file *m)
{
    uint32_t textures = tia_parse_count(m->job, TIA_OF_TEXTURES);

    for (uint32_t i = 0; i < m->scene.texture_count; i++)
        (void)tia_parse_add(m->job, TIA_OF_TEXTURES, &m->scene.textures[i]);
    for (uint32_t i = 0; i < m->scene.material_count; i++) {
        struct tia_material material = m->scene.materials[i];
        material.texture += material.texture ? textures : 0;
        material.opacity += material.opacity ? textures : 0;
        (void)tia_parse_add(m->job, TIA_OF_MATERIALS, &material);
    }
}

static int fill(struct mesh_file *m, const struct tia_word *name)
{
    struct tia_parse *job = m->job;
    struct tia_array *words = &job->arrays[TIA_OF_MODEL_WORDS];
    struct tia_arena arena = {NULL, 0, 0};

    if (words->items && words->count < words->capacity) /* else the model has a mistake, as in the passes before */
        arena = (struct tia_arena){words->items + words->count * sizeof(uint64_t),
                                   (size_t)(words->capacity - words->count) * sizeof(uint64_t), 0};
    int status = read_model(m, &arena);

    if (status)
        return status;
    if (!tia_arena_fits(&arena))
        return tia_text_error(&job->text, name, "has changed while it was read", "the same file");
    if (size_of(m) > INT32_MAX)
        return tia_text_error(&job->text, name, "is too large for the scene", "a model nearer to 0");
    add_meshes(m, tia_parse_count(job, TIA_OF_MATERIALS));
    add_materials(m);
    add_items(job, TIA_OF_MODEL_WORDS, arena.used / sizeof(uint64_t));
    return TIA_OK;
}

int tia_mesh_file(struct tia_parse *job, const struct tia_word *mesh)
{
    struct mesh_file m = {.job = job};
    struct tia_arena none = {NULL, 0, 0};
    struct tia_word name;

    (void)tia_text_word(&job->text, &name);
    int status = tia_text_file(&job->text, &name, "a model's file");
    status = status ? status : tia_text_end(&job->text);
    status = status ? status : open_file(&m, &name);
    if (status || job->pass == TIA_FILLING)
        return status ? status : fill(&m, &name);
    status = read_model(&m, &none);
    if (!status)
        count(&m, mesh, none.used);
    return status;
}

/* ---- instances ---- */

const struct tia_parse_model *tia_model_at(const struct tia_parse *job, uint32_t mesh)
{
    const struct tia_parse_model *models = tia_parse_at(job, TIA_OF_MODELS, 0);
    uint32_t low = 0, high = models ? tia_parse_count(job, TIA_OF_MODELS) : 0;

    while (low < high) {
        uint32_t middle = low + (high - low) / 2;
        if (models[middle].mesh == mesh)
            return &models[middle];
        if (models[middle].mesh < mesh)
            low = middle + 1;
        else
            high = middle;
    }
    return NULL;
}

void tia_models_note(struct tia_parse *job, const struct tia_word *mesh)
{
    job->models[hash(mesh)].instances++;
}

void tia_models_count(struct tia_parse *job)
{
    for (unsigned i = 0; i < TIA_MODEL_HASHES; i++) {
        uint32_t parts = job->models[i].parts;
        uint64_t more = (uint64_t)job->models[i].instances * (parts > 1 ? parts - 1 : 0);
        add_items(job, TIA_OF_SHAPES, more < UINT32_MAX ? (size_t)more : UINT32_MAX);
    }
}

void tia_models_resolve(struct tia_parse *job)
{
    struct tia_shape *shapes = (struct tia_shape *)(void *)job->arrays[TIA_OF_SHAPES].items;
    const struct tia_parse_part *parts = tia_parse_at(job, TIA_OF_PARTS, 0);

    for (uint32_t i = 0; i < tia_parse_count(job, TIA_OF_SHAPES); i++)
        if (shapes[i].material == TIA_OWN_MATERIAL)
            shapes[i].material = parts[shapes[i].mesh].material;
}
