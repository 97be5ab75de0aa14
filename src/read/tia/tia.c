/* tia.c - scenes in tia's own format, tia-scene(5): the passes over the text. */
#include "parse_state.h"
#include "read/alter.h"
#include "read/readers.h"

/* True if the statement just read is the sought one. */
static bool is_sought(const struct tia_parse *job, const struct tia_word *word)
{
    if (job->sought_statement)
        return tia_word_is(word, job->sought_statement);
    return job->sought < TIA_ARRAYS && job->arrays[job->sought].count > job->sought_index;
}

static void begin_pass(struct tia_parse *job, enum tia_pass pass)
{
    struct tia_reader *reader = job->reader;

    job->pass = pass;
    job->once = 0;
    job->constants.count = 0;
    job->includes.depth = job->includes.count = 0;
    job->includes.next.next = NULL;
    job->group_count = job->repeat_count = job->solid_groups = 0;
    job->repeated_lines = 0;
    for (unsigned i = 0; i < TIA_MODEL_HASHES; i++)
        job->models[i].parts = job->models[i].instances = 0;
    tia_events_begin(job);
    for (unsigned i = 0; i < TIA_ARRAYS; i++)
        if (pass != TIA_FILLING || (i != TIA_OF_NAMES && i != TIA_OF_ANIMATED && i != TIA_OF_MODELS))
            tia_array_restart(&job->arrays[i]);
    for (unsigned i = 0; reader->warnings && pass == TIA_FILLING && i < TIA_WARNINGS; i++)
        reader->warnings[i].count = 0; /* this pass may be repeated */
    job->reach.lengths.filling = pass == TIA_FILLING;
    if (pass == TIA_FILLING)
        job->reach.lengths.scale_bits = job->bits;
    *job->scene = (struct tia_scene){.camera = {.fov = TIA_Q16(25)}, .scale_bits = job->reach.lengths.scale_bits};
    job->text = tia_text_begin(reader->text, reader->length, "", &reader->error);
    job->text.constants = &job->constants;
    job->text.lengths = &job->reach.lengths;
    if (job->mistakes)
        job->mistakes->scans = 0;
    job->text.tolerance = job->mistakes ? &job->mistakes->tolerance : NULL;
}

/* Goes to the next line of this file or, at its end, of the file that includes it. Returns false at the end of the
 * scene. */
static bool next_line(struct tia_parse *job, int *status)
{
    while (!tia_text_line(&job->text)) {
        bool inner = job->includes.depth > 0;
        *status = tia_include_end(job);
        if (*status || !inner)
            return false;
    }
    return true;
}

static int read_pass(struct tia_parse *job, enum tia_pass pass)
{
    int status = TIA_OK;

    begin_pass(job, pass);
    while (next_line(job, &status)) {
        (void)tia_text_word(&job->text, &job->first);
        status = tia_statement_read(job);
        if (status && job->mistakes)
            status = tia_mistake_recover(job);
        if (status)
            return status;
        if (job->seeking && pass == job->seeking_in && is_sought(job, &job->first)) {
            (void)tia_text_error_at(&job->text, &job->first);
            return TIA_OK;
        }
        if (job->includes.next.next)
            tia_include_begin(job);
    }
    if (!status)
        tia_events_end(job);
    return status;
}

/* Refuses a name that is defined twice. Reads the text again up to the second definition, so that the error names its
 * file. */
static int refuse_twice(struct tia_parse *job, const struct tia_name *twice)
{
    struct tia_word word = twice->word;

    job->seeking = true;
    job->seeking_in = TIA_NAMING;
    job->sought = TIA_OF_NAMES;
    job->sought_index = twice->order;
    (void)read_pass(job, TIA_NAMING);
    return tia_text_error(&job->text, &word, "is already defined", "another name");
}

static int sort_names(struct tia_parse *job)
{
    struct tia_array *names = &job->arrays[TIA_OF_NAMES], *animated = &job->arrays[TIA_OF_ANIMATED];
    struct tia_name *first = (struct tia_name *)(void *)names->items;
    const struct tia_name *twice;

    tia_names_sort((struct tia_name *)(void *)animated->items, animated->count);
    tia_names_sort(first, names->count);
    twice = tia_names_twice(first, names->count);
    return twice && !job->mistakes ? refuse_twice(job, twice) : TIA_OK;
}

/* Sets the reference point of a camera without one: the first value of its track. */
static void look_at(struct tia_camera *camera, struct tia_vec3 reference)
{
    if (camera->up.x || camera->up.y || camera->up.z)
        return;
    camera->up.y = TIA_Q16_ONE;
    camera->reference = reference;
}

/* In the tracks of shapes and lights, replaces the index of the name by that of the transform or light. Sets the
 * camera's reference point if only a track defines it. */
static void resolve_tracks(struct tia_parse *job)
{
    struct tia_track *tracks = (struct tia_track *)(void *)job->arrays[TIA_OF_TRACKS].items;
    const struct tia_name *names = (const struct tia_name *)(const void *)job->arrays[TIA_OF_NAMES].items;

    for (uint32_t i = 0; i < job->arrays[TIA_OF_TRACKS].count; i++)
        if (tracks[i].target == TIA_MOVES_REFERENCE)
            look_at(&job->scene->camera, tracks[i].keys->value);
        else if (tracks[i].target >= TIA_MOVES_LIGHT && tracks[i].target <= TIA_SCALES_TRANSFORM)
            tracks[i].index = names[tracks[i].index].index / 2;
}

static void set_arrays(struct tia_parse *job)
{
    struct tia_scene *s = job->scene;

    s->materials = tia_parse_at(job, TIA_OF_MATERIALS, 0);
    s->material_count = tia_parse_count(job, TIA_OF_MATERIALS);
    s->textures = tia_parse_at(job, TIA_OF_TEXTURES, 0);
    s->texture_count = tia_parse_count(job, TIA_OF_TEXTURES);
    s->spheres = tia_parse_at(job, TIA_OF_SPHERES, 0);
    s->sphere_count = tia_parse_count(job, TIA_OF_SPHERES);
    s->shapes = tia_parse_at(job, TIA_OF_SHAPES, 0);
    s->shape_count = tia_parse_count(job, TIA_OF_SHAPES);
    s->transforms = tia_parse_at(job, TIA_OF_TRANSFORMS, 0);
    s->transform_count = tia_parse_count(job, TIA_OF_TRANSFORMS);
    s->meshes = tia_parse_at(job, TIA_OF_MESHES, 0);
    s->mesh_count = tia_parse_count(job, TIA_OF_MESHES);
    s->grids = tia_parse_at(job, TIA_OF_GRIDS, 0);
    s->grid_count = tia_parse_count(job, TIA_OF_GRIDS);
    s->solids = tia_parse_at(job, TIA_OF_SOLIDS, 0);
    s->solid_count = tia_parse_count(job, TIA_OF_SOLIDS);
    s->lights = tia_parse_at(job, TIA_OF_LIGHTS, 0);
    s->light_count = tia_parse_count(job, TIA_OF_LIGHTS);
    s->bindings = tia_parse_at(job, TIA_OF_BINDINGS, 0);
    s->binding_count = tia_parse_count(job, TIA_OF_BINDINGS);
    s->tracks = tia_parse_at(job, TIA_OF_TRACKS, 0);
    s->track_count = tia_parse_count(job, TIA_OF_TRACKS);
    if (tia_parse_count(job, TIA_OF_FALLING))
        s->falling = tia_parse_at(job, TIA_OF_FALLING, 0);
    if (tia_parse_count(job, TIA_OF_FOGS))
        s->fog = tia_parse_at(job, TIA_OF_FOGS, 0);
    if (tia_parse_count(job, TIA_OF_LENSES))
        s->lens = tia_parse_at(job, TIA_OF_LENSES, 0);
}

static void size_arrays(struct tia_parse *job)
{
    static const size_t sizes[TIA_ARRAYS] = {
        [TIA_OF_MATERIALS] = sizeof(struct tia_material),
        [TIA_OF_TEXTURES] = sizeof(struct tia_texture),
        [TIA_OF_SPHERES] = sizeof(struct tia_sphere),
        [TIA_OF_SHAPES] = sizeof(struct tia_shape),
        [TIA_OF_TRANSFORMS] = sizeof(struct tia_transform),
        [TIA_OF_MESHES] = sizeof(struct tia_mesh),
        [TIA_OF_VERTICES] = sizeof(struct tia_vec3),
        [TIA_OF_NORMALS] = sizeof(struct tia_dir3),
        [TIA_OF_UVS] = sizeof(struct tia_uv),
        [TIA_OF_FACES] = sizeof(struct tia_face),
        [TIA_OF_FACE_GROUPS] = sizeof(uint32_t),
        [TIA_OF_GRIDS] = sizeof(struct tia_grid),
        [TIA_OF_CELLS] = sizeof(uint8_t),
        [TIA_OF_MODELS] = sizeof(struct tia_parse_model),
        [TIA_OF_MODEL_WORDS] = sizeof(uint64_t),
        [TIA_OF_PARTS] = sizeof(struct tia_parse_part),
        [TIA_OF_SOLIDS] = sizeof(struct tia_solid),
        [TIA_OF_MEMBERS] = sizeof(struct tia_shape),
        [TIA_OF_STEPS] = sizeof(uint8_t),
        [TIA_OF_LIGHTS] = sizeof(struct tia_light),
        [TIA_OF_BINDINGS] = sizeof(struct tia_binding),
        [TIA_OF_TRACKS] = sizeof(struct tia_track),
        [TIA_OF_KEYS] = sizeof(struct tia_keyframe),
        [TIA_OF_FALLS] = sizeof(struct tia_fall),
        [TIA_OF_FALLING] = sizeof(struct tia_falling),
        [TIA_OF_FOGS] = sizeof(struct tia_fog),
        [TIA_OF_LENSES] = sizeof(struct tia_lens),
        [TIA_OF_NAMES] = sizeof(struct tia_name),
        [TIA_OF_ANIMATED] = sizeof(struct tia_name),
    };

    for (unsigned i = 0; i < TIA_ARRAYS; i++)
        job->arrays[i] = (struct tia_array){.item = sizes[i]};
}

/* Chooses the unit of length. If all lengths fit in the file's unit, that unit is tried first, even if the estimated
 * bounds are too large for it. */
static void choose_unit(struct tia_parse *job)
{
    bool fits = job->reach.lengths.scale_bits == 0;

    job->room = tia_reach_room(&job->reach);
    job->most = fits && job->room < 0 ? 0 : job->room;
    job->bits = tia_reach_bits(&job->reach, job->most);
}

int tia_parse_read(struct tia_parse *job, struct tia_arena *arena)
{
    int bits = 0, status;

    size_arrays(job);
    do {
        tia_reach_begin(&job->reach, bits, job->reader->reach);
        do
            status = read_pass(job, TIA_COUNTING);
        while (!status && tia_mistake_blocks(job));
        if (status)
            return status;
        tia_alter_measured(job->reader, &job->scene->camera, &job->reach.lengths);
    } while (!job->reader->unscaled && tia_lengths_widen(&job->reach.lengths, &bits));
    tia_reach_camera(&job->reach, &job->scene->camera);
    tia_models_count(job);
    for (unsigned i = 0; i < TIA_ARRAYS; i++)
        (void)tia_array_place(arena, &job->arrays[i]);
    if (!tia_arena_fits(arena))
        return job->mistakes ? tia_mistake_pass(job), read_pass(job, TIA_COUNTING) : TIA_OK;
    status = read_pass(job, TIA_NAMING);
    status = status ? status : sort_names(job);
    if (!job->reader->unscaled)
        choose_unit(job);
    if (job->mistakes)
        tia_mistake_pass(job);
    return status ? status : read_pass(job, TIA_FILLING);
}

static void finish(struct tia_parse *job)
{
    resolve_tracks(job);
    tia_alter_measured(job->reader, &job->scene->camera, &job->reach.lengths);
    tia_events_resolve(job);
    tia_models_resolve(job);
    set_arrays(job);
}

/* Chooses the next unit to try after a scene was refused. If the unit is large because of the horizon, see
 * tia_reach_bits, a length may be too small in it: a smaller unit is next. Otherwise the scene may not fit: the unit in
 * which it certainly fits is next. Returns false if no unit is left. */
static bool next_unit(struct tia_parse *job)
{
    if (job->bits < job->most) {
        job->bits++;
        return true;
    }
    if (job->bits <= job->room)
        return false;
    job->bits = job->most = job->room;
    return true;
}

int tia_read_tia(struct tia_reader *reader, struct tia_scene *scene, struct tia_arena *arena)
{
    struct tia_parse job = {.reader = reader, .scene = scene};
    int status = tia_parse_read(&job, arena);

    if (!tia_arena_fits(arena) || job.pass != TIA_FILLING)
        return status;
    if (!status)
        finish(&job);
    while ((status || tia_scene_check(scene, NULL)) && next_unit(&job)) {
        reader->error = (struct tia_read_error){.line = 0};
        status = read_pass(&job, TIA_FILLING);
        if (!status)
            finish(&job);
    }
    return status;
}

void tia_tell_tia(struct tia_reader *reader, struct tia_scene *scene, struct tia_arena *arena)
{
    struct tia_mistakes mistakes = {.tolerance = {.tell = tia_mistake_tell}, .first = reader->error};
    struct tia_parse job = {.reader = reader, .scene = scene, .mistakes = &mistakes};

    mistakes.tolerance.ctx = &job;
    arena->used = 0;
    (void)tia_parse_read(&job, arena);
    reader->error = mistakes.first;
}
