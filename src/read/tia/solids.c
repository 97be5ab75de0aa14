/* solids.c - meshes and grids: blocks of lines, see blocks.c. */
#include "parse_state.h"
#include "read/text/nearest.h"

/* ---- meshes ---- */

/* A mesh that is being read: the indices of its first elements in the arrays. */
struct mesh_block {
    struct tia_parse *job;
    uint32_t vertices, normals, uvs, faces, groups;
    bool grouped;   /* the mesh has a group line */
    uint32_t group; /* of the next face */
};

static int read_vertex(struct mesh_block *block)
{
    struct tia_vec3 vertex;
    int status = tia_text_place(&block->job->text, &vertex);

    if (status && block->job->mistakes) /* later faces may use it */
        (void)tia_parse_add(block->job, TIA_OF_VERTICES, &(struct tia_vec3){0, 0, 0});
    if (!status && block->job->pass == TIA_COUNTING)
        tia_reach_vertex(&block->job->reach, vertex);
    if (!status)
        (void)tia_parse_add(block->job, TIA_OF_VERTICES, &vertex);
    return status;
}

static int read_normal(struct mesh_block *block)
{
    struct tia_dir3 normal;
    int status = tia_text_dir3(&block->job->text, &normal);

    if (status)
        normal = (struct tia_dir3){0, 0, 0};
    if (!status || block->job->mistakes)
        (void)tia_parse_add(block->job, TIA_OF_NORMALS, &normal);
    return status;
}

static int read_uv(struct mesh_block *block)
{
    struct tia_uv uv;
    int status = tia_text_q16(&block->job->text, &uv.u);

    status = status ? status : tia_text_q16(&block->job->text, &uv.v);
    if (status)
        uv = (struct tia_uv){0, 0};
    if (!status || block->job->mistakes)
        (void)tia_parse_add(block->job, TIA_OF_UVS, &uv);
    return status;
}

/* Removes a number from 1 to `count` from the front of `rest`, and sets *index to the number minus 1. */
static int take_index(struct tia_text *t, struct tia_word *rest, uint32_t count, const char *thing, uint32_t *index)
{
    struct tia_word number = *rest;
    uint64_t n = 0;

    for (number.length = 0; number.length < rest->length; number.length++) {
        char c = rest->at[number.length];
        if (c < '0' || c > '9')
            break;
        n = n <= UINT32_MAX ? n * 10 + (uint64_t)(c - '0') : n;
    }
    if (n < 1 || n > count) {
        (void)tia_text_error(t, rest, "does not exist", "the number of a ");
        tia_say(t->error, thing);
        tia_say(t->error, " of the mesh, from 1 to ");
        tia_say_number(t->error, count);
        return TIA_ERR_RANGE;
    }
    *index = (uint32_t)n - 1;
    rest->at += number.length;
    rest->length -= number.length;
    rest->column += number.length;
    return TIA_OK;
}

static bool take_slash(struct tia_word *rest)
{
    if (!rest->length || *rest->at != '/')
        return false;
    rest->at++;
    rest->length--;
    rest->column++;
    return true;
}

/* Reads a corner: vertex, vertex/uv, vertex//normal or vertex/uv/normal. */
static int take_corner(const struct mesh_block *block, struct tia_corner *corner)
{
    struct tia_parse *job = block->job;
    struct tia_text *t = &job->text;
    struct tia_word rest;
    int status;

    corner->uv = corner->normal = TIA_NO_INDEX;
    (void)tia_text_word(t, &rest);
    status = take_index(t, &rest, tia_parse_count(job, TIA_OF_VERTICES) - block->vertices, "vertex", &corner->vertex);
    if (!status && take_slash(&rest)) {
        if (!rest.length || *rest.at != '/')
            status = take_index(t, &rest, tia_parse_count(job, TIA_OF_UVS) - block->uvs, "uv", &corner->uv);
        if (!status && take_slash(&rest))
            status =
                take_index(t, &rest, tia_parse_count(job, TIA_OF_NORMALS) - block->normals, "normal", &corner->normal);
    }
    if (!status && rest.length)
        return tia_text_error(t, &rest, "is too much", "vertex, vertex/uv, vertex//normal or vertex/uv/normal");
    return status;
}

static bool are_alike(const struct tia_corner *a, const struct tia_corner *b)
{
    return (a->uv == TIA_NO_INDEX) == (b->uv == TIA_NO_INDEX) &&
           (a->normal == TIA_NO_INDEX) == (b->normal == TIA_NO_INDEX);
}

/* Reads a polygon, and adds it as a fan of triangles around its first corner. */
static int read_face(struct mesh_block *block)
{
    struct tia_text *t = &block->job->text;
    struct tia_face face;
    struct tia_word word;

    for (unsigned n = 0; n < 3 || tia_text_peek(t, &word); n++) {
        struct tia_corner corner;
        (void)tia_text_peek(t, &word);
        int status = take_corner(block, &corner);
        if (status)
            return status;
        if (n > 0 && !are_alike(&corner, &face.corner[0]))
            return tia_text_error(t, &word, "is not like the first corner", "uv and normal in all corners or in none");
        if (n > 2)
            face.corner[1] = face.corner[2];
        face.corner[n < 2 ? n : 2] = corner;
        if (n >= 2)
            (void)tia_parse_add(block->job, TIA_OF_FACES, &face);
        if (n >= 2 && block->grouped)
            (void)tia_parse_add(block->job, TIA_OF_FACE_GROUPS, &block->group);
    }
    return TIA_OK;
}

/* Reads the group of the following faces. Faces before the first such line have the group 0. */
static int read_group(struct mesh_block *block)
{
    int64_t group = 0;
    int status = tia_text_integer(&block->job->text, &group, 0, UINT32_MAX);

    for (uint32_t i = tia_parse_count(block->job, TIA_OF_FACES) - block->faces; i > 0 && !block->grouped; i--)
        (void)tia_parse_add(block->job, TIA_OF_FACE_GROUPS, &block->group);
    block->grouped = true;
    block->group = (uint32_t)group;
    return status;
}

#define MESH_EXPECTED "vertex, normal, uv, face, group or end"

static const struct mesh_line {
    const char *word;
    int (*read)(struct mesh_block *block);
} mesh_lines[] = {
    {"vertex", read_vertex}, {"face", read_face}, {"normal", read_normal}, {"uv", read_uv}, {"group", read_group}};

static const struct mesh_line *find_mesh_line(const struct tia_word *word)
{
    for (unsigned i = 0; i < TIA_COUNT_OF(mesh_lines); i++)
        if (tia_word_is(word, mesh_lines[i].word))
            return &mesh_lines[i];
    return NULL;
}

/* Reads a line; sets *end if it is probably the end of the mesh. */
static int read_mesh_line(struct mesh_block *block, const struct tia_word *word, bool *end)
{
    struct tia_text *t = &block->job->text;
    const struct mesh_line *line = find_mesh_line(word);
    struct tia_word meant;

    if (line)
        return line->read(block);
    (void)tia_text_error_of(t, word, "is not a line of a mesh", MESH_EXPECTED, &meant);
    if (!meant.length || !tia_text_goes_on(t))
        return TIA_ERR_RANGE;
    line = find_mesh_line(&meant);
    *end = !line;
    return line ? line->read(block) : TIA_OK;
}

static int read_mesh(struct mesh_block *block)
{
    struct tia_parse *job = block->job;
    struct tia_word word;
    bool end = false;

    while (!end) {
        enum tia_block_line line = tia_block_take(job, &word);
        if (line != TIA_BLOCK_LINE)
            return line == TIA_BLOCK_END ? TIA_OK : tia_block_refuse(job);
        int status = read_mesh_line(block, &word, &end);
        status = status ? status : tia_text_end(&job->text);
        if (status && tia_block_go_on(job))
            return status;
    }
    return TIA_OK;
}

static void add_mesh(const struct mesh_block *block)
{
    struct tia_parse *job = block->job;
    struct tia_mesh mesh = {
        .vertices = tia_parse_at(job, TIA_OF_VERTICES, block->vertices),
        .normals = tia_parse_at(job, TIA_OF_NORMALS, block->normals),
        .uvs = tia_parse_at(job, TIA_OF_UVS, block->uvs),
        .faces = tia_parse_at(job, TIA_OF_FACES, block->faces),
        .vertex_count = tia_parse_count(job, TIA_OF_VERTICES) - block->vertices,
        .normal_count = tia_parse_count(job, TIA_OF_NORMALS) - block->normals,
        .uv_count = tia_parse_count(job, TIA_OF_UVS) - block->uvs,
        .face_count = tia_parse_count(job, TIA_OF_FACES) - block->faces,
    };

    const struct tia_parse_part part = {0};

    mesh.groups = NULL;
    if (block->grouped)
        mesh.groups = tia_parse_at(job, TIA_OF_FACE_GROUPS, block->groups);
    (void)tia_parse_add(job, TIA_OF_MESHES, &mesh);
    (void)tia_parse_add(job, TIA_OF_PARTS, &part);
}

int tia_line_mesh(struct tia_parse *job)
{
    struct mesh_block block = {.job = job,
                               .vertices = tia_parse_count(job, TIA_OF_VERTICES),
                               .normals = tia_parse_count(job, TIA_OF_NORMALS),
                               .uvs = tia_parse_count(job, TIA_OF_UVS),
                               .faces = tia_parse_count(job, TIA_OF_FACES),
                               .groups = tia_parse_count(job, TIA_OF_FACE_GROUPS)};
    struct tia_word word = {NULL, 0, 0, 0};
    struct tia_word name;

    (void)tia_text_peek(&job->text, &name);
    int status = tia_parse_define(job, TIA_NAMED_SOLID, 2 * tia_parse_count(job, TIA_OF_MESHES));
    if (!status && tia_text_peek(&job->text, &word) && tia_word_is(&word, "file"))
        return tia_mesh_file(job, &name);
    status = status ? status : tia_text_end(&job->text);
    if (status)
        return tia_block_skip(job);
    status = read_mesh(&block);
    if (!status)
        add_mesh(&block);
    return status;
}

/* ---- grids ---- */

static const struct tia_field grid_fields[] = {
    {.word = "size",
     .kind = TIA_WHOLE,
     .count = 3,
     .max = TIA_GRID_MAX,
     .offset = offsetof(struct tia_grid, size),
     .needed = true},
    {.word = "corner", .kind = TIA_LENGTHS, .count = 3, .offset = offsetof(struct tia_grid, corner)},
    {.word = "cell", .kind = TIA_LENGTHS, .count = 1, .offset = offsetof(struct tia_grid, cell)},
};

static int read_row(struct tia_parse *job, unsigned cells)
{
    for (unsigned i = 0; i < cells; i++) {
        int64_t value;
        int status = tia_text_integer(&job->text, &value, 0, UINT8_MAX);
        if (status)
            return status;
        uint8_t cell = (uint8_t)value;
        (void)tia_parse_add(job, TIA_OF_CELLS, &cell);
    }
    return tia_text_end(&job->text);
}

/* Reads a line of a grid, whose rows are `left` too few. */
static int read_grid_line(struct tia_parse *job, const struct tia_word *word, const struct tia_grid *grid,
                          uint32_t left)
{
    if (left && tia_word_is(word, "row"))
        return read_row(job, grid->size[0]);
    return tia_text_error_of(&job->text, word, "is not the next line of the grid", left ? "row" : "end", NULL);
}

/* Reads the rows of a grid, one for each y and z, and the line "end". */
static int read_rows(struct tia_parse *job, const struct tia_grid *grid)
{
    uint32_t left = (uint32_t)grid->size[1] * grid->size[2];
    struct tia_word word;

    for (;; left--) {
        enum tia_block_line line = tia_block_take(job, &word);
        if (line == TIA_BLOCK_UNCLOSED || (line == TIA_BLOCK_END && !left))
            return line == TIA_BLOCK_END ? TIA_OK : tia_block_refuse(job);
        int status = read_grid_line(job, &word, grid, left);
        if (status && line == TIA_BLOCK_LINE && !left)
            return tia_block_skip(job); /* rows too many */
        if (status && tia_block_go_on(job))
            return status;
        if (line == TIA_BLOCK_END)
            return TIA_OK;
    }
}

int tia_line_grid(struct tia_parse *job)
{
    struct tia_grid grid = {.cell = (tia_q16)tia_length_times(TIA_Q16_ONE, job->reach.lengths.scale_bits)};
    uint32_t cells = tia_parse_count(job, TIA_OF_CELLS);
    int status = tia_parse_define(job, TIA_NAMED_SOLID, 2 * tia_parse_count(job, TIA_OF_GRIDS) + 1);

    status = status ? status : tia_fields(&job->text, "a grid", grid_fields, TIA_COUNT_OF(grid_fields), &grid, NULL);
    if (status)
        return tia_block_skip(job);
    status = read_rows(job, &grid);
    if (status)
        return status;
    if (job->pass == TIA_COUNTING)
        tia_reach_grid(&job->reach, &grid);
    grid.cells = tia_parse_at(job, TIA_OF_CELLS, cells);
    (void)tia_parse_add(job, TIA_OF_GRIDS, &grid);
    return TIA_OK;
}
