#include "unit.h"

#include <tia/mip.h>

static void write_bytes(struct unit *unit, const uint8_t *bytes, size_t count)
{
    for (size_t i = 0; i < count; i++)
        text_word(&unit->text, "%d,", bytes[i]);
}

/* Returns the first texture with the same texels as texture `index`: textures of the same picture share their
 * texels. */
static uint32_t first_with_texels(const struct tia_scene *scene, uint32_t index)
{
    const struct tia_texture *t = scene->textures;
    uint32_t first = 0;

    while (t[first].kind != t[index].kind || t[first].texels != t[index].texels || t[first].width != t[index].width ||
           t[first].height != t[index].height)
        first++;
    return first;
}

static bool texture_has_texels(const struct tia_texture *texture)
{
    return texture->kind == TIA_IMAGE || texture->kind == TIA_OPACITY;
}

static void write_texels(struct unit *unit, uint32_t index)
{
    const struct tia_texture *t = &unit->scene->textures[index];

    if (!texture_has_texels(t) || first_with_texels(unit->scene, index) != index)
        return;
    table_begin(unit, "uint8_t", "texels_%u", index);
    write_bytes(unit, t->texels, (size_t)(t->kind == TIA_IMAGE ? 3 : 1) * t->width * t->height);
    table_end(unit);
    if (!t->mip_levels)
        return;
    table_begin(unit, "uint8_t", "mips_%u", index);
    write_bytes(unit, t->mip_levels, tia_mip_size(t));
    table_end(unit);
}

static void write_texture(struct unit *unit, uint32_t index)
{
    static const char *const kinds[] = {"TIA_CHECKER", "TIA_IMAGE", "TIA_OPACITY", "TIA_NOISE"};
    const struct tia_texture *t = &unit->scene->textures[index];

    text_word(&unit->text, "{.kind = %s,", kinds[t->kind]);
    field_number(unit, "repeat[0]", t->repeat[0]);
    field_number(unit, "repeat[1]", t->repeat[1]);
    field_number(unit, "offset[0]", t->offset[0]);
    field_number(unit, "offset[1]", t->offset[1]);
    field_number(unit, "repeat_bits", t->repeat_bits);
    field_number(unit, "offset_bits", t->offset_bits);
    field_rgb(unit, "cells[0]", t->cells[0]);
    field_rgb(unit, "cells[1]", t->cells[1]);
    if (t->footprint)
        text_word(&unit->text, ".footprint = true,");
    if (t->kind == TIA_NOISE)
        field_number(unit, "octaves", t->octaves);
    field_number(unit, "depth", t->depth);
    if (texture_has_texels(t)) {
        if (t->bilinear)
            text_word(&unit->text, ".bilinear = true,");
        field_number(unit, "width", t->width);
        field_number(unit, "height", t->height);
        field_table(unit, "texels", 1, "texels_%u", first_with_texels(unit->scene, index));
        if (t->mip_levels)
            field_table(unit, "mip_levels", 1, "mips_%u", first_with_texels(unit->scene, index));
    }
    text_print(&unit->text, "},\n");
}

static void write_grids(struct unit *unit)
{
    const struct tia_scene *scene = unit->scene;

    for (uint32_t i = 0; i < scene->grid_count; i++) {
        const uint16_t *size = scene->grids[i].size;
        table_begin(unit, "uint8_t", "cells_%u", i);
        write_bytes(unit, scene->grids[i].cells, (size_t)size[0] * size[1] * size[2]);
        table_end(unit);
    }
    if (scene->grid_count == 0)
        return;
    table_begin(unit, "struct tia_grid", "grids");
    for (uint32_t i = 0; i < scene->grid_count; i++) {
        const struct tia_grid *g = &scene->grids[i];
        text_word(&unit->text, "{");
        field_vec3(unit, "corner", g->corner);
        field_number(unit, "cell", g->cell);
        text_word(&unit->text, ".size = {%d, %d, %d},", g->size[0], g->size[1], g->size[2]);
        field_table(unit, "cells", 1, "cells_%u", i);
        text_print(&unit->text, "},\n");
    }
    table_end(unit);
}

void unit_images(struct unit *unit)
{
    const struct tia_scene *scene = unit->scene;

    for (uint32_t i = 0; i < scene->texture_count; i++)
        write_texels(unit, i);
    if (scene->texture_count > 0) {
        table_begin(unit, "struct tia_texture", "textures");
        for (uint32_t i = 0; i < scene->texture_count; i++)
            write_texture(unit, i);
        table_end(unit);
    }
    write_grids(unit);
}
