#include "unit.h"

void unit_tracks(struct unit *unit)
{
    static const char *const targets[] = {
        "TIA_MOVES_EYE",       "TIA_MOVES_REFERENCE",   "TIA_MOVES_LIGHT",       "TIA_ROTATES_LIGHT",
        "TIA_MOVES_TRANSFORM", "TIA_ROTATES_TRANSFORM", "TIA_SCALES_TRANSFORM",  "TIA_SHOWS_SHAPE",
        "TIA_SHOWS_LIGHT",     "TIA_SETS_COLOUR",       "TIA_SETS_TRANSMISSION", "TIA_SETS_EMISSION",
        "TIA_SETS_SPECULAR",   "TIA_SETS_MIRROR",       "TIA_SETS_REFRACTION",   "TIA_SETS_FACING"};
    const struct tia_scene *scene = unit->scene;

    for (uint32_t i = 0; i < scene->track_count; i++) {
        table_begin(unit, "struct tia_keyframe", "keys_%u", i);
        for (uint32_t j = 0; j < scene->tracks[i].key_count; j++) {
            const struct tia_keyframe *k = &scene->tracks[i].keys[j];
            text_word(&unit->text, "{%d, {%d, %d, %d}},", k->time, k->value.x, k->value.y, k->value.z);
        }
        table_end(unit);
    }
    if (scene->track_count == 0)
        return;
    table_begin(unit, "struct tia_track", "tracks");
    for (uint32_t i = 0; i < scene->track_count; i++) {
        const struct tia_track *t = &scene->tracks[i];
        text_word(&unit->text, "{.target = %s,", targets[t->target]);
        field_unsigned(unit, "index", t->index);
        if (t->smooth)
            text_word(&unit->text, ".smooth = true,");
        field_table(unit, "keys", 1, "keys_%u", i);
        field_unsigned(unit, "key_count", t->key_count);
        text_print(&unit->text, "},\n");
    }
    table_end(unit);
}

static void unit_falling(struct unit *unit)
{
    const struct tia_falling *falling = unit->scene->falling;

    if (!falling)
        return;
    table_begin(unit, "struct tia_fall", "falls");
    for (uint32_t i = 0; i < falling->count; i++) {
        const struct tia_fall *f = &falling->balls[i];
        text_word(&unit->text, "{%u, {%d, %d, %d}, %d, %d},", f->shape, f->velocity.x, f->velocity.y, f->velocity.z,
                  f->restitution, f->mass);
    }
    table_end(unit);
    text_print(&unit->text, "static const struct tia_falling %s_falling = {\n", unit->symbol);
    unit->text.indent = 4;
    field_table(unit, "balls", falling->count, "falls");
    field_unsigned(unit, "count", falling->count);
    field_vec3(unit, "gravity", falling->gravity);
    field_number(unit, "end", falling->end);
    table_end(unit);
}

static void write_camera(struct unit *unit)
{
    static const char *const projections[] = {"TIA_PERSPECTIVE", "TIA_FRUSTUM", "TIA_ORTHOGRAPHIC"};
    const struct tia_camera *c = &unit->scene->camera;

    text_word(&unit->text, ".camera = {");
    field_vec3(unit, "eye", c->eye);
    field_number(unit, "fov", c->fov);
    text_word(&unit->text, ".projection = %s,", projections[c->projection]);
    field_vec3(unit, "reference", c->reference);
    field_vec3(unit, "up", c->up);
    field_number(unit, "window.left", c->window.left);
    field_number(unit, "window.right", c->window.right);
    field_number(unit, "window.bottom", c->window.bottom);
    field_number(unit, "window.top", c->window.top);
    field_number(unit, "window.near", c->window.near);
    field_unsigned(unit, "samples", c->samples);
    field_number(unit, "line", c->line);
    text_print(&unit->text, "},\n");
}

struct reference {
    const char *table, *count;
    uint32_t n;
};

/* Writes the scene's references to tables, then their lengths, in the order of struct tia_scene, which C++ requires. */
static void refer(struct unit *unit, const struct reference *references, unsigned count)
{
    for (unsigned i = 0; i < count; i++)
        field_table(unit, references[i].table, references[i].n, "%s", references[i].table);
    for (unsigned i = 0; i < count; i++)
        field_unsigned(unit, references[i].count, references[i].n);
}

static void write_integration(struct unit *unit)
{
    const struct tia_integration *how = &unit->scene->integration;

    field_unsigned(unit, "integration.integrator", (uint32_t)how->integrator);
    field_unsigned(unit, "integration.spp", how->spp);
    field_number(unit, "integration.distance", how->distance);
    field_unsigned(unit, "integration.tone", (uint32_t)how->tone);
    field_number(unit, "integration.exposure", how->exposure);
}

static void write_shadows(struct unit *unit)
{
    const struct tia_shadow_map *map = &unit->scene->shadow_map;

    field_unsigned(unit, "shadows", (uint32_t)unit->scene->shadows);
    field_unsigned(unit, "shadow_map.size", map->size);
    field_unsigned(unit, "shadow_map.bias", (uint32_t)map->bias);
    field_number(unit, "shadow_map.amount", map->amount);
    field_number(unit, "shadow_map.amount_bits", map->amount_bits);
    field_unsigned(unit, "shadow_map.filter", (uint32_t)map->filter);
}

static void write_scene(struct unit *unit)
{
    const struct tia_scene *s = unit->scene;
    const struct reference parts[] = {{"materials", "material_count", s->material_count},
                                      {"spheres", "sphere_count", s->sphere_count},
                                      {"lights", "light_count", s->light_count},
                                      {"bindings", "binding_count", s->binding_count}};
    const struct reference more[] = {
        {"shapes", "shape_count", s->shape_count},       {"transforms", "transform_count", s->transform_count},
        {"textures", "texture_count", s->texture_count}, {"meshes", "mesh_count", s->mesh_count},
        {"grids", "grid_count", s->grid_count},          {"solids", "solid_count", s->solid_count}};
    const struct reference tracks = {"tracks", "track_count", s->track_count};

    text_print(&unit->text, "const struct tia_scene %s = {\n", unit->symbol);
    unit->text.indent = 4;
    write_camera(unit);
    field_rgb(unit, "background", s->background);
    refer(unit, parts, sizeof parts / sizeof *parts);
    refer(unit, more, sizeof more / sizeof *more);
    field_unsigned(unit, "depth", s->depth);
    write_integration(unit);
    write_shadows(unit);
    field_number(unit, "scale_bits", s->scale_bits);
    if (s->fine)
        text_word(&unit->text, ".fine = &%s_fine,", unit->symbol);
    if (s->fog)
        text_word(&unit->text, ".fog = &%s_fog,", unit->symbol);
    if (s->lens)
        text_word(&unit->text, ".lens = &%s_lens,", unit->symbol);
    if (s->bvh)
        text_word(&unit->text, ".bvh = &%s_bvh,", unit->symbol);
    refer(unit, &tracks, 1);
    if (s->falling)
        text_word(&unit->text, ".falling = &%s_falling,", unit->symbol);
    if (unit->text.column > 0)
        text_print(&unit->text, "\n");
    text_print(&unit->text, "};\n");
}

void unit_write(struct unit *unit, const char *source, const struct convert_telltales *telltales, const uint32_t *crcs)
{
    const struct tia_scene *scene = unit->scene;

    unit->text.tight = true;
    text_print(&unit->text, "/* %s, as tia-compile wrote it: do not edit. */\n// clang-format off\n", source);
    if (scene->bvh)
        text_print(&unit->text, "#include <tia/bvh.h>\n");
    if (tia_scene_moves(scene))
        text_print(&unit->text, "#include <tia/motion.h>\n");
    text_print(&unit->text, "#include <tia/scene.h>\n%s\n", telltales ? "#include <tia/trust.h>\n" : "");
    /* the declaration avoids a warning in programs with -Wmissing-variable-declarations */
    text_print(&unit->text, "extern const struct tia_scene %s;\n\n", unit->symbol);
    unit_things(unit);
    if (scene->fine)
        unit_fine(unit);
    if (scene->fog)
        unit_fog(unit);
    if (scene->lens)
        text_print(&unit->text, "static const struct tia_lens %s_lens = {%d, %d};\n", unit->symbol, scene->lens->radius,
                   scene->lens->focus);
    unit_shapes(unit);
    unit_images(unit);
    unit_meshes(unit);
    unit_tracks(unit);
    unit_falling(unit);
    unit_bvh(unit);
    write_scene(unit);
    if (telltales)
        unit_telltales(unit, telltales, crcs);
}
