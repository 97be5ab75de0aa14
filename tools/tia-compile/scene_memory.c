#include "scene_memory.h"

#include <ctype.h>
#include <stddef.h>
#include <stdio.h>

#include <tia/bvh.h>
#include <tia/debug.h>
#include <tia/mip.h>
#include <tia/motion.h>
#include <tia/render.h>

#include "common/text_file.h"
#include "ports.h"

#define ALIGN(size) (((size) + 7) / 8 * 8)

#define MESH_FACTS 28 /* size of what a view has for each mesh, on all kinds of machines */

/* Kinds of machines, by the sizes of pointers and enumerations. All of them align 64-bit numbers to 8 bytes. */
enum { WIDE, NARROW, SHORT, KINDS };

/* Sizes of those structures of the library that differ between kinds of machines. To convert a size of this machine,
 * these sizes are subtracted and those of the other kind are added. The list is complete: tests/slow/memory compares
 * the results with the library on machines of each kind. */
struct layout {
    unsigned view, hits, scene, bvh, block; /* block: a plane or a box that balls bounce off */
    unsigned spans;                         /* for scenes drawn by row: size of the view's part */
    unsigned rays, shape, solid;            /* for all other scenes: size of the view's part, of a shape and of the
                                               pointer to a solid's members */
    unsigned emitter;                       /* for paths: size of an emitter, of which there is one for each light and
                                               for each sphere that emits */
    unsigned raster, sample;    /* for techniques for shadows other than traced rays: size of the view, and of a pixel's
                                   sample */
    unsigned map, volumes, own; /* for these techniques: sizes of their data */
};

static const struct layout layouts[KINDS] = {{96, 40, 336, 48, 208, 136, 416, 224, 8, 88, 40, 2888, 744, 576, 40},
                                             {56, 24, 256, 28, 200, 108, 392, 216, 4, 80, 32, 2592, 728, 560, 28},
                                             {56, 24, 252, 28, 200, 108, 392, 208, 4, 80, 32, 2592, 728, 560, 28}};

/* Returns the kind of this machine; KINDS when it is none of them. */
static int kind_here(void)
{
    struct aligned {
        char before;
        uint64_t number;
    };

    if (offsetof(struct aligned, number) != 8)
        return KINDS;
    return sizeof(void *) == 8 ? WIDE : sizeof(enum tia_light_kind) == 1 ? SHORT : NARROW;
}

struct scene_memory {
    const struct tia_scene *scene;
    uint32_t lights; /* the view's capacity */
};

/* True if the scene is drawn by row: then hits store a distance for each pixel. */
static bool is_drawn_by_row(const struct tia_scene *scene)
{
    const struct tia_tile none = {0, 0, 0, 0}, few = {0, 0, 8, 8};

    return !scene->integration.integrator && !scene->shadows &&
           tia_hits_size(scene, few) - tia_hits_size(scene, none) == 512;
}

static uint64_t emitters(const struct scene_memory *m)
{
    uint64_t count = m->lights;

    for (uint32_t i = 0; i < m->scene->sphere_count; i++) {
        const struct tia_rgb *e = &m->scene->materials[m->scene->spheres[i].material].emission;
        count += e->r || e->g || e->b;
    }
    return count;
}

/* Returns the number of prepared shapes: the scene's, and the members of its solids. */
static uint64_t prepared_shapes(const struct tia_scene *scene)
{
    uint64_t count = scene->shape_count;

    for (uint32_t i = 0; i < scene->solid_count; i++)
        count += scene->solids[i].member_count;
    return count;
}

static uint64_t technique_part(const struct layout *l, const struct tia_scene *scene)
{
    uint64_t samples = scene->camera.samples ? scene->camera.samples : 1, part = ALIGN(l->raster + samples * l->sample);

    switch (scene->shadows) {
    case TIA_SHADOWS_MAP_EXACT:
        return part;
    case TIA_SHADOWS_MAP:
        return part + ALIGN(l->map);
    case TIA_SHADOWS_RAYS:
        return part + ALIGN(l->own);
    default:
        return part + ALIGN(l->volumes);
    }
}

/* Returns that part of a view's size which differs between kinds of machines. */
static uint64_t view_part(const struct layout *l, const struct scene_memory *m)
{
    enum tia_integrator integrator = m->scene->integration.integrator;
    uint64_t part = ALIGN(l->view);

    if (is_drawn_by_row(m->scene))
        return part + ALIGN(l->spans);
    part += ALIGN(l->rays) + prepared_shapes(m->scene) * l->shape;
    part += ALIGN((uint64_t)m->scene->mesh_count * MESH_FACTS + (uint64_t)m->scene->solid_count * l->solid);
    if (integrator == TIA_PATHS)
        return part + l->emitter * emitters(m);
    return integrator == TIA_OCCLUSION || !m->scene->shadows ? part : part + technique_part(l, m->scene);
}

static uint64_t view_size(const struct scene_memory *m, int kind)
{
    uint64_t rest = tia_view_size(m->scene, m->lights) - view_part(&layouts[kind_here()], m);

    return ALIGN(rest + view_part(&layouts[kind], m));
}

static uint64_t hits_size(const struct tia_scene *scene, struct tia_tile tile, int kind)
{
    return tia_hits_size(scene, tile) - ALIGN(layouts[kind_here()].hits) + ALIGN(layouts[kind].hits);
}

/* Returns that part of the size of the moving arrays' copy which differs between kinds of machines. */
static uint64_t copy_part(const struct layout *l, const struct tia_scene *scene)
{
    uint64_t part = ALIGN(l->scene);

    for (uint32_t i = 0; scene->falling && i < scene->shape_count; i++)
        if (tia_scene_bounces_off(scene, i))
            part += l->block;
    return part + (scene->bvh ? ALIGN(l->bvh) : 0);
}

/* Returns the size of the viewer's first request: a view, whole frames of hits, a canvas to refine pictures on
 * with the work of its tiles, and a copy of the moving arrays. A tile has the least number of rows that it has for a
 * display without a limit; with few threads, those of scenes with shadow techniques may have more. */
static uint64_t viewer_size(const struct scene_memory *m, struct tia_tile frame, int kind)
{
    enum { ROWS = 16, TILE_WORK = 24 };
    const struct tia_scene *scene = m->scene;
    uint64_t tiles = (frame.height + ROWS - 1u) / ROWS, size = 0;

    if (tia_scene_moves(scene)) {
        size = ALIGN(tia_scene_at_size(scene)) + ALIGN(sizeof *scene) + (scene->bvh ? tia_bvh_move_size(scene) : 0);
        size = size - copy_part(&layouts[kind_here()], scene) + copy_part(&layouts[kind], scene);
    }
    size += view_size(m, kind) + ALIGN(hits_size(scene, frame, kind)) + 2 * ALIGN(tiles);
    if (tia_draws_by_pixel(scene) || scene->shadows)
        size += ALIGN((uint64_t)frame.width * frame.height * sizeof(tia_rgb565)) + ALIGN(TILE_WORK * tiles);
    return size;
}

/* Returns the memory of tia_draw_rows for rows of `width` pixels that are drawn at once. Its view has room for no more
 * lights than it gets, and one light may take more than two, by the steps of its colour. */
static uint64_t rows_size(const struct scene_memory *m, uint16_t width, int kind)
{
    const struct tia_tile row = {0, 0, width, 1};
    const struct scene_memory one = {m->scene, 1};
    uint64_t view = view_size(m, kind), single = m->scene->light_count > 1 ? 0 : view_size(&one, kind);

    return ALIGN(single > view ? single : view) + hits_size(m->scene, row, kind) + width * sizeof(tia_rgb565);
}

/* ---- flash and stack ---- */

/* Bytes of flash for a program's code and tables on a Cortex-M3 by gcc -Os, without the code for the board: measured
 * with the example of docs/boards.md, with tia_core_spheres and with tia_core_q16. */
enum { FLASH_SPHERES = 48600, FLASH_ALL = 281000 };

/* Bytes of stack: for scenes of spheres the limit of tests/slow/freestanding, and, rounded up, what
 * tests/boards/stack.py prints for smaller chunks; for all others that test's limit on a Cortex-M0. */
enum {
    STACK_SPHERES = 6848,
    STACK_CHUNK_32 = 5376,
    STACK_CHUNK_16 = 5120,
    STACK_CHUNK_16_WORDS_8 = 3968,
    STACK_ALL = 15360
};

static uint64_t textures_size(const struct tia_scene *scene)
{
    uint64_t size = scene->texture_count * (uint64_t)sizeof *scene->textures;

    for (uint32_t i = 0; i < scene->texture_count; i++)
        size += (uint64_t)scene->textures[i].width * scene->textures[i].height *
                    (scene->textures[i].kind == TIA_OPACITY ? 1 : 3) +
                (scene->textures[i].mip_levels ? tia_mip_size(&scene->textures[i]) : 0);
    for (uint32_t i = 0; i < scene->grid_count; i++)
        size += sizeof *scene->grids +
                (uint64_t)scene->grids[i].size[0] * scene->grids[i].size[1] * scene->grids[i].size[2];
    return size;
}

static uint64_t solids_size(const struct tia_scene *scene)
{
    uint64_t size = scene->solid_count * (uint64_t)sizeof *scene->solids;

    for (uint32_t i = 0; i < scene->solid_count; i++)
        size += scene->solids[i].member_count * (uint64_t)sizeof *scene->solids->members + scene->solids[i].step_count;
    return size;
}

static uint64_t meshes_size(const struct tia_scene *scene)
{
    uint64_t size = scene->mesh_count * (uint64_t)sizeof *scene->meshes;

    for (uint32_t i = 0; i < scene->mesh_count; i++) {
        const struct tia_mesh *m = &scene->meshes[i];
        size += m->vertex_count * (uint64_t)sizeof *m->vertices + m->face_count * (uint64_t)sizeof *m->faces +
                m->normal_count * (uint64_t)sizeof *m->normals + m->uv_count * (uint64_t)sizeof *m->uvs;
    }
    return size + (scene->bvh ? tia_bvh_size(scene) * 3 / 5 : 0); /* without the boxes, which are needed only while
                                                                     building */
}

static uint64_t tables_size(const struct tia_scene *scene)
{
    uint64_t size = sizeof *scene + scene->material_count * (uint64_t)sizeof *scene->materials +
                    scene->sphere_count * (uint64_t)sizeof *scene->spheres +
                    scene->light_count * (uint64_t)sizeof *scene->lights +
                    scene->binding_count * (uint64_t)sizeof *scene->bindings +
                    scene->shape_count * (uint64_t)sizeof *scene->shapes +
                    scene->transform_count * (uint64_t)sizeof *scene->transforms +
                    scene->track_count * (uint64_t)sizeof *scene->tracks;

    for (uint32_t i = 0; i < scene->track_count; i++)
        size += scene->tracks[i].key_count * (uint64_t)sizeof *scene->tracks[i].keys;
    return size + textures_size(scene) + meshes_size(scene) + solids_size(scene);
}

/* ---- the header ---- */

static const char top[] =
    "#include <stdint.h>\n\n"
    "/* Bytes on a machine with 64-bit pointers, with 32-bit ones, and with those and enumerations of a byte, as "
    "arm-none-eabi\n"
    " * has them. Where 64-bit numbers lie at multiples of 4, as on 32-bit x86, and on an AVR, a little less is "
    "needed. "
    "*/\n"
    "#ifndef TIA_BYTES\n"
    "enum tia_bytes_small { TIA_BYTES_SMALL };\n"
    "typedef char tia_bytes_known[sizeof(void *) <= 8 ? 1 : -1]; /* fails on other machines: call tia_view_size there "
    "*/\n"
    "#define TIA_BYTES(wide, narrow, small) \\\n"
    "    (sizeof(void *) == 8 ? (wide) : sizeof(enum tia_bytes_small) > 1 ? (narrow) : (small))\n"
    "#define TIA_WORDS(bytes) (((bytes) + 7) / 8) /* of an array of uint64_t, whose alignment is the right one */\n"
    "#endif\n\n";

static void write_sizes(struct text *text, const char *name, const char *what, const char *tile,
                        const uint64_t bytes[KINDS])
{
    text_print(text, "#define %s_%s%s TIA_BYTES(%lluu, %lluu, %lluu)\n", name, what, tile,
               (unsigned long long)bytes[WIDE], (unsigned long long)bytes[NARROW], (unsigned long long)bytes[SHORT]);
}

static void write_tile(struct text *text, const char *name, const struct scene_memory *m, struct tia_tile tile)
{
    uint64_t hits[KINDS], viewer[KINDS];
    char size[16];

    for (int kind = 0; kind < KINDS; kind++) {
        hits[kind] = hits_size(m->scene, tile, kind);
        viewer[kind] = viewer_size(m, tile, kind);
    }
    (void)snprintf(size, sizeof size, "_%ux%u", tile.width, tile.height);
    write_sizes(text, name, "HITS", size, hits);
    write_sizes(text, name, "VIEWER", size, viewer);
}

/* Writes the size for tile `i`'s width, unless an earlier tile has the same width. */
static void write_rows(struct text *text, const char *name, const struct scene_memory *m,
                       const struct convert_tiles *tiles, unsigned i)
{
    uint64_t rows[KINDS];
    char size[16];

    for (unsigned before = 0; before < i; before++)
        if (tiles->size[before][0] == tiles->size[i][0])
            return;
    for (int kind = 0; kind < KINDS; kind++)
        rows[kind] = rows_size(m, tiles->size[i][0], kind);
    (void)snprintf(size, sizeof size, "_%u", tiles->size[i][0]);
    write_sizes(text, name, "ROWS", size, rows);
}

static void write_stack(struct text *text, const char *name, bool by_row)
{
    text_print(text, "\n/* Stack, at most: of the library's functions that draw, on processors of 32 bits (gcc -Os)");
    if (!by_row) {
        text_print(text, ". */\n#define %s_STACK %uu\n", name, STACK_ALL);
        return;
    }
    text_print(text, "; smaller with the library\n"
                     " * compiled with TIA_CHUNK=32 or 16, and then with TIA_BALL_WORDS=8. */\n");
    text_print(text, "#define %s_STACK %uu\n#define %s_STACK_32 %uu\n", name, STACK_SPHERES, name, STACK_CHUNK_32);
    text_print(text, "#define %s_STACK_16 %uu\n#define %s_STACK_16_8 %uu\n", name, STACK_CHUNK_16, name,
               STACK_CHUNK_16_WORDS_8);
}

static void write_header(struct text *text, const struct request *request, const struct scene_memory *m)
{
    char name[64] = "";
    uint64_t view[KINDS];

    for (size_t i = 0; request->symbol[i]; i++)
        name[i] = (char)toupper((unsigned char)request->symbol[i]);
    for (int kind = 0; kind < KINDS; kind++)
        view[kind] = view_size(m, kind);
    text_print(text, "/* The memory of %s, as tia-compile wrote it: do not edit. */\n", request->source);
    text_print(text, "#ifndef %s_MEMORY\n#define %s_MEMORY\n\n", name, name);
    text_print(text, "%s", top);
    text_print(text,
               "/* A view with at most %u lights; hits of a tile; all that tia_viewer_run asks for on a display of "
               "that size,\n"
               " * with an input and a clock. */\n",
               m->lights);
    write_sizes(text, name, "VIEW", "", view);
    for (unsigned i = 0; i < request->tiles.count; i++)
        write_tile(text, name, m, (struct tia_tile){0, 0, request->tiles.size[i][0], request->tiles.size[i][1]});
    if (request->tiles.count)
        text_print(text,
                   "\n/* tia_draw_rows, with rows of so many pixels; if fewer are drawn at once, the hits are those "
                   "of a tile of one\n * row with so many: ROWS_320 - HITS_320x1 + HITS_64x1. */\n");
    for (unsigned i = 0; i < request->tiles.count; i++)
        write_rows(text, name, m, &request->tiles, i);
    write_stack(text, name, is_drawn_by_row(m->scene));
    text_print(
        text,
        "\n/* Flash, about: the library's part of a program on a Cortex-M3 (gcc -Os), and the scene's tables. */\n");
    text_print(text, "#define %s_FLASH_LIBRARY %uu\n", name, is_drawn_by_row(m->scene) ? FLASH_SPHERES : FLASH_ALL);
    text_print(text, "#define %s_FLASH_SCENE %lluu\n\n#endif\n", name, (unsigned long long)tables_size(m->scene));
}

int memory_write(const struct request *request, const struct tia_scene *scene, char *why)
{
    static struct text text;
    const struct scene_memory m = {scene,
                                   request->lights ? request->lights : scene->light_count + scene->binding_count};

    if (kind_here() == KINDS) {
        (void)snprintf(why, PORT_WHY, "--memory: not on this machine, whose 64-bit numbers are not aligned to 8 bytes");
        return TIA_ERR_UNSUPPORTED;
    }
    if (m.lights < scene->light_count) {
        (void)snprintf(why, PORT_WHY, "--lights: the scene has %u", scene->light_count);
        return TIA_ERR_ARGUMENT;
    }
    int status = text_open(&text, request->memory, why);
    if (status)
        return status;
    write_header(&text, request, &m);
    return text_close(&text);
}
