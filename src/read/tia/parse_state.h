/* parse_state.h - the state of the .tia reader, shared by its statements.
 *
 * The reader makes three passes over the text. The first one only counts. It counts a named sphere both as a sphere and
 * as a shape, since a later animate statement may make it a shape. The second pass collects names, so that they can be
 * used before the lines that define them. The last pass fills the arrays.
 */
#ifndef TIA_READ_TIA_PARSE_STATE_H
#define TIA_READ_TIA_PARSE_STATE_H

#include "read/text/constants.h"
#include "read/text/fields.h"
#include "read/text/name_table.h"
#include "scene_reach.h"

/* Kinds of names, and the index that is stored with a name. */
enum tia_kind_of_name {
    TIA_NAMED_MATERIAL, /* the material's index */
    TIA_NAMED_TEXTURE,  /* the texture's index */
    TIA_NAMED_SOLID,    /* 2 i for mesh i, 2 i + 1 for grid i */
    TIA_NAMED_MOVER,    /* 2 i for transform i, 2 i + 1 for light i */
    TIA_NAMED_FAULTY    /* nothing: the name's line has a mistake; while mistakes are told */
};

enum tia_parse_array {
    TIA_OF_MATERIALS,
    TIA_OF_TEXTURES,
    TIA_OF_SPHERES,
    TIA_OF_SHAPES,
    TIA_OF_TRANSFORMS,
    TIA_OF_MESHES,
    TIA_OF_VERTICES,
    TIA_OF_NORMALS,
    TIA_OF_UVS,
    TIA_OF_FACES,
    TIA_OF_FACE_GROUPS, /* of the faces of meshes with groups */
    TIA_OF_GRIDS,
    TIA_OF_CELLS,
    TIA_OF_MODELS,      /* meshes from files; filled in the second pass */
    TIA_OF_MODEL_WORDS, /* their memory */
    TIA_OF_PARTS,       /* one item for each mesh of the scene */
    TIA_OF_SOLIDS,
    TIA_OF_MEMBERS,
    TIA_OF_STEPS,
    TIA_OF_LIGHTS,
    TIA_OF_BINDINGS,
    TIA_OF_TRACKS,
    TIA_OF_KEYS,
    TIA_OF_FALLS,
    TIA_OF_FALLING,
    TIA_OF_FOGS,
    TIA_OF_LENSES,
    TIA_OF_NAMES,    /* all defined names */
    TIA_OF_ANIMATED, /* the names in animate and fall statements */
    TIA_ARRAYS
};

enum tia_pass { TIA_COUNTING, TIA_NAMING, TIA_FILLING };

#define TIA_INCLUDE_DEPTH 8 /* largest depth of nested files */
#define TIA_INCLUDES_MAX 64 /* largest number of includes: 8 nested files, each including the next twice, make 256 */
#define TIA_GROUP_DEPTH 8
#define TIA_REPEATS_MAX 65536 /* most copies of a repeat block */

/* Most lines of a scene in repeat blocks, each counted for each copy. */
#define TIA_REPEATED_LINES (UINT32_C(1) << 24)

/* The stack of included files. */
struct tia_includes {
    struct {
        struct tia_text text;
        unsigned groups; /* number of open groups at the include statement */
    } outer[TIA_INCLUDE_DEPTH];
    struct tia_word names[TIA_INCLUDE_DEPTH]; /* names of the included files, as written; the innermost last */
    unsigned depth, count;
    struct tia_text next;        /* file of an include statement just read; next.next is NULL if there is none */
    char file[TIA_NAME_MAX + 1]; /* path of the innermost file, relative to the scene's folder */
};

/* A transform of higher precision than tia_transform: see groups.c. */
struct tia_place {
    int64_t axes[3][3];            /* in the format of tia_rotation_axes */
    int64_t scale[3], position[3]; /* Q31.32 */
    struct tia_vec3 rotation;      /* the angles as written, if `as_written` */
    bool as_written;
};

/* A mesh from a file: its parts are consecutive meshes. */
struct tia_parse_model {
    uint32_t mesh, parts;
};
#define TIA_MODEL_HASHES 64
#define TIA_MODELS_MAX 256 /* most models in a scene: a file is read for each time it is named */

/* What belongs to a mesh: the material of a model's own. */
struct tia_parse_part {
    uint32_t material;
};

#define TIA_OWN_MATERIAL UINT32_MAX /* of a shape, until the end of the last pass: that of its mesh */

/* A group, a copy of a repeat block, or an operation of a solid. */
struct tia_group {
    struct tia_place place; /* composed with the groups around it, up to the solid */

    /* Of an operation of a solid: see enum tia_solid_step, else 0; and the number of its operands so far. */
    uint8_t operation;
    uint32_t operands;

    /* Of a repeat block: what follows the copy. */
    bool repeats;
    uint32_t left;             /* number of copies */
    struct tia_transform step; /* places each copy in the one before it */
    struct tia_text body;      /* the block, from the end of its first line on */
    struct tia_word first;     /* the statement's name; of any group */
};

/* All mistakes of a text, see mistakes.c. */
struct tia_mistakes {
    struct tia_tolerance tolerance;
    bool tells;      /* the last pass: mistakes are told; the passes before it only count and collect names */
    bool follows;    /* the error was caused by a mistake that is told elsewhere */
    bool lost;       /* a file was not read: it may define any name */
    uint32_t deep;   /* number of open groups that are too deep */
    uint32_t scans;  /* number of times that the rest of the text was scanned in the pass */
    unsigned groups; /* number of open groups at the beginning of the line */
    struct tia_read_error first;
    const char *places[TIA_MISTAKES_MAX];   /* of mistakes, to tell each of them once */
    const char *unclosed[TIA_GROUP_DEPTH];  /* first words of groups without an end */
    uint32_t unclosed_count, unclosed_seen; /* their number, and what it was before the pass */
    struct tia_word suspect; /* first word of a group whose end has the indentation of a group around it; or empty */
};

struct tia_parse {
    struct tia_text text;
    struct tia_word first; /* first word of the line */
    struct tia_constants constants;
    struct tia_includes includes;
    struct tia_group groups[TIA_GROUP_DEPTH];
    unsigned group_count, repeat_count; /* numbers of open groups, repeat blocks included, and of these blocks */
    uint32_t repeated_lines;            /* see TIA_REPEATED_LINES */
    unsigned solid_groups;              /* number of open groups with the first operation of the open solid; 0: none */
    struct tia_reach reach;
    struct tia_reader *reader;
    struct tia_scene *scene;
    enum tia_pass pass;
    struct tia_array arrays[TIA_ARRAYS];
    struct tia_falling falling; /* gravity, and the time of its end */
    struct {
        uint32_t parts, instances; /* the most parts of a model, and the number of instances */
    } models[TIA_MODEL_HASHES];    /* by the hash of the mesh's name: see mesh_file.c */
    bool hides;                    /* a shape may be hidden: the scene needs a mesh without faces */
    int bits, most, room;          /* scale_bits of the last pass, and two limits: see next_unit */
    bool footprints;               /* textures are filtered; known after the first pass */
    uint32_t images;               /* number of textures whose images have been loaded */
    uint32_t once;                 /* bit n: statement n, which may occur only once, has occurred */

    const char *statement; /* the statement read last */
    struct tia_text rest;  /* the rest of its line */
    bool opens, names;     /* it opens a group, it defines the name that follows it */
    bool (*is_statement)(const struct tia_word *word);

    struct tia_mistakes *mistakes; /* NULL: the first mistake ends the reading */

    /* Set when the text is read again to find a line: that of a statement, or of the item sought_index of an array. */
    bool seeking;
    enum tia_pass seeking_in;
    unsigned sought; /* enum tia_parse_array; TIA_ARRAYS: none */
    uint32_t sought_index;
    const char *sought_statement; /* NULL: none */
};

/* Reads the statement whose first word is job->first. Defined in statement.c. */
int tia_statement_read(struct tia_parse *job);

/* ---- blocks.c: blocks of lines, from their statement to the line "end" ---- */

/* What the next line of a block is. */
enum tia_block_line {
    TIA_BLOCK_LINE,    /* a line of the block, or one that is not allowed there: its first word is read */
    TIA_BLOCK_END,     /* "end" */
    TIA_BLOCK_UNCLOSED /* the block has no end: nothing is read */
};

/* Goes to the next line of a block, and reads its first word. */
enum tia_block_line tia_block_take(struct tia_parse *job, struct tia_word *word);
/* Refuses a block without an end. Returns TIA_OK if the reader goes on. */
int tia_block_refuse(struct tia_parse *job);
/* Skips the rest of a line with a mistake. Returns TIA_ERR_RANGE if the reader does not go on. */
int tia_block_go_on(struct tia_parse *job);
/* After a mistake in a block's first line: skips the block if there is one, likewise. */
int tia_block_skip(struct tia_parse *job);

/* ---- mistakes.c: after a mistake, while all of them are told ---- */

/* Tells the mistake in the reader's error, in the pass for that; `ctx` is the struct tia_parse. */
void tia_mistake_tell(void *ctx);
/* Tells the mistake of the statement just read, and skips the rest of its line. Returns TIA_OK, or TIA_ERR_RANGE after
 * too many mistakes. */
int tia_mistake_recover(struct tia_parse *job);
/* Ends a counting pass. True if it has found further blocks without an end, and must be repeated without them. */
bool tia_mistake_blocks(struct tia_parse *job);
/* Begins the pass that tells the mistakes. */
void tia_mistake_pass(struct tia_parse *job);
/* True if the group that begins at job->first has no end. Sets the error then. */
bool tia_mistake_unclosed(struct tia_parse *job);
/* Notes a closed group, and whether its end has the indentation of a group around it. */
void tia_mistake_closed(struct tia_parse *job, const struct tia_word *end);
/* Closes the groups from number `base` on, which have no end. */
void tia_mistake_close(struct tia_parse *job, unsigned base);
/* Sets the error of a block without an end. */
int tia_block_has_no_end(struct tia_text *t, const struct tia_word *first);

/* Runs all passes, but only the first one if the memory is too small. Defined in tia.c. */
int tia_parse_read(struct tia_parse *job, struct tia_arena *arena);

/* Adds an item to an array; returns its index. */
uint32_t tia_parse_add(struct tia_parse *job, enum tia_parse_array array, const void *item);
uint32_t tia_parse_count(const struct tia_parse *job, enum tia_parse_array array);

/* Returns the address of item `index` of an array, filled or not; NULL in the first pass. */
const void *tia_parse_at(const struct tia_parse *job, enum tia_parse_array array, uint32_t index);

/* Defines the name that is the next word. */
int tia_parse_define(struct tia_parse *job, enum tia_kind_of_name kind, uint32_t index);
/* Defines the given name. */
void tia_parse_name(struct tia_parse *job, enum tia_kind_of_name kind, const struct tia_word *name, uint32_t index);

/* Looks up a name's index, 0 before the last pass. `expected` describes the name in an error: "the name of a
 * material". */
int tia_parse_find(struct tia_parse *job, enum tia_kind_of_name kind, const struct tia_word *name, const char *expected,
                   uint32_t *index);

/* Refuses a name that is not defined, likewise. */
int tia_parse_undefined(struct tia_parse *job, enum tia_kind_of_name kind, const struct tia_word *name,
                        const char *expected);
/* True if there is such a name; false before the last pass. */
bool tia_parse_has(const struct tia_parse *job, enum tia_kind_of_name kind, const struct tia_word *name);

/* Records that a name is animated. */
void tia_parse_animate(struct tia_parse *job, const struct tia_word *name);
/* True if a name is animated. */
bool tia_parse_moves(const struct tia_parse *job, const struct tia_word *name);
/* Finds the entry of a light's or a transform's name. Returns NULL if there is none, and before the last pass. */
struct tia_name *tia_parse_mover(const struct tia_parse *job, const struct tia_word *name);

/* Adds a track of a shape's or light's visibility. A time that was not given is NULL; if both are NULL, adds
 * nothing. */
int tia_parse_show(struct tia_parse *job, enum tia_target target, uint32_t index, const tia_q16 *appears,
                   const tia_q16 *vanishes);

/* ---- events.c ---- */

/* Begins a pass. */
void tia_events_begin(struct tia_parse *job);
/* Ends a pass: adds the falling balls. */
void tia_events_end(struct tia_parse *job);
/* Sets the shapes of falling balls after the last pass, when all shapes are known. */
void tia_events_resolve(struct tia_parse *job);

/* Composes a shape's transform with those of the groups around it. `name`: the shape's name, or NULL. */
int tia_group_place(struct tia_parse *job, struct tia_transform *transform, const struct tia_word *name);

/* True if the innermost group, or the solid, leaves its contents in place. */
bool tia_group_is_still(const struct tia_parse *job);

/* Begins an operation of a solid: the first one, whose place is the solid's, or one within it. */
int tia_operation_begin(struct tia_parse *job, enum tia_solid_step step);
/* Ends the innermost group, which is an operation. */
int tia_operation_end(struct tia_parse *job);
/* Adds a member to the open solid. */
int tia_operation_add(struct tia_parse *job, const struct tia_shape *member);

/* Writes the path, relative to the scene's folder, of a file that is named in the file being read. */
int tia_include_path(struct tia_parse *job, const struct tia_word *name, char path[TIA_NAME_MAX + 1]);

/* Reports that a file could not be loaded; `why` is the callback's reason. */
int tia_parse_missing(struct tia_parse *job, const struct tia_word *file, const char *why, const char *expected);

/* Switches to the file of the last include statement. */
void tia_include_begin(struct tia_parse *job);
/* Switches back at the end of a file. Fails if one of its groups is still open. */
int tia_include_end(struct tia_parse *job);

/* Replaces a file's path by the path of `name`, which is relative to the file's folder. Returns false if the new path
 * is too long. */
bool tia_path_follow(char path[TIA_NAME_MAX + 1], const struct tia_word *name);

/* ---- mesh_file.c ---- */

/* Reads the rest of a mesh statement from the word `file` on; `mesh` is its name. */
int tia_mesh_file(struct tia_parse *job, const struct tia_word *mesh);
/* Returns the model whose first part has that index; NULL if there is none. */
const struct tia_parse_model *tia_model_at(const struct tia_parse *job, uint32_t mesh);
/* Counts an instance, in the first pass. */
void tia_models_note(struct tia_parse *job, const struct tia_word *mesh);
/* Ends the first pass: counts the shapes of instances with several parts. */
void tia_models_count(struct tia_parse *job);
/* Ends the last pass: sets the materials of shapes with a model's own. */
void tia_models_resolve(struct tia_parse *job);

/* ---- statements: each function reads the rest of the line, and the block if there is one ---- */

int tia_line_camera(struct tia_parse *job);
int tia_light_field_line(struct tia_parse *job); /* the statement `camera lightfield` */
int tia_line_samples(struct tia_parse *job);
int tia_line_background(struct tia_parse *job);
int tia_line_depth(struct tia_parse *job);
int tia_line_fog(struct tia_parse *job);
int tia_line_lens(struct tia_parse *job);
int tia_line_shadows(struct tia_parse *job);
int tia_line_integrator(struct tia_parse *job);
int tia_line_spp(struct tia_parse *job);
int tia_line_filter(struct tia_parse *job);
int tia_line_tone(struct tia_parse *job);
int tia_line_exposure(struct tia_parse *job);
int tia_line_material(struct tia_parse *job);
int tia_line_texture(struct tia_parse *job);
int tia_line_shape(struct tia_parse *job, enum tia_shape_kind kind);
int tia_line_instance(struct tia_parse *job);
int tia_line_union(struct tia_parse *job);
int tia_line_intersection(struct tia_parse *job);
int tia_line_difference(struct tia_parse *job);
int tia_line_mesh(struct tia_parse *job);
int tia_line_grid(struct tia_parse *job);
int tia_line_light(struct tia_parse *job);
int tia_line_key(struct tia_parse *job);
int tia_line_animate(struct tia_parse *job);
int tia_line_gravity(struct tia_parse *job);
int tia_line_fall(struct tia_parse *job);
int tia_line_group(struct tia_parse *job);
int tia_line_repeat(struct tia_parse *job);
int tia_line_end(struct tia_parse *job);
int tia_line_include(struct tia_parse *job);
int tia_line_define(struct tia_parse *job);

#endif
