#include "unit.h"

static void write_field(struct unit *unit, const struct tia_shape *s, const struct tia_shape_field *f)
{
    const void *value = (const char *)s + f->offset;

    switch ((enum tia_shape_value)f->value) {
    case TIA_SHAPE_Q16:
        field_number(unit, f->member, *(const tia_q16 *)value);
        break;
    case TIA_SHAPE_VEC3:
        field_vec3(unit, f->member, *(const struct tia_vec3 *)value);
        break;
    case TIA_SHAPE_DIR3:
        field_dir3(unit, f->member, *(const struct tia_dir3 *)value);
        break;
    case TIA_SHAPE_FLAG:
        field_number(unit, f->member, *(const bool *)value);
        break;
    }
}

/* Writes a triangle without the names of members, which is shorter: scenes have many triangles. */
static void write_triangle(struct unit *unit, const struct tia_triangle *t)
{
    const struct tia_vec3 *c = t->corner;

    text_word(&unit->text, ".triangle = {{{%d, %d, %d}, {%d, %d, %d}, {%d, %d, %d}}}},\n", c[0].x, c[0].y, c[0].z,
              c[1].x, c[1].y, c[1].z, c[2].x, c[2].y, c[2].z);
}

static void write_shape(struct unit *unit, const struct tia_shape *s)
{
#define KIND(kind, name) #kind,
#define NAME(kind, name) #name,
    static const char *const kinds[] = {TIA_SHAPES(KIND)}, *const names[] = {TIA_SHAPES(NAME)};
    const struct tia_shape_field *f = tia_shape_fields(s->kind);
    struct text *text = &unit->text;

    text_word(text, "{.kind = %s,", kinds[s->kind]);
    field_unsigned(unit, "material", s->material);
    field_unsigned(unit, "transform", s->transform);
    if (s->kind == TIA_TRIANGLE) {
        write_triangle(unit, &s->triangle);
    } else if (!f->member) {
        text_word(text, ".%s = %uu},\n", names[s->kind],
                  s->kind == TIA_MESH   ? s->mesh
                  : s->kind == TIA_GRID ? s->grid
                                        : s->solid);
    } else {
        text_word(text, ".%s = {", names[s->kind]);
        for (; f->member; f++)
            write_field(unit, s, f);
        text_print(text, "}},\n");
    }
}

static void write_transforms(struct unit *unit)
{
    const struct tia_scene *scene = unit->scene;

    if (scene->transform_count == 0)
        return;
    table_begin(unit, "struct tia_transform", "transforms");
    for (uint32_t i = 0; i < scene->transform_count; i++) {
        text_word(&unit->text, "{");
        field_vec3(unit, "position", scene->transforms[i].position);
        field_vec3(unit, "rotation", scene->transforms[i].rotation);
        field_vec3(unit, "scale", scene->transforms[i].scale);
        text_print(&unit->text, "},\n");
    }
    table_end(unit);
}

static void write_solids(struct unit *unit)
{
    const struct tia_scene *scene = unit->scene;

    for (uint32_t i = 0; i < scene->solid_count; i++) {
        const struct tia_solid *s = &scene->solids[i];
        table_begin(unit, "struct tia_shape", "members_%u", i);
        for (uint32_t k = 0; k < s->member_count; k++)
            write_shape(unit, &s->members[k]);
        table_end(unit);
        table_begin(unit, "uint8_t", "steps_%u", i);
        for (uint32_t k = 0; k < s->step_count; k++)
            text_word(&unit->text, "%u,", s->steps[k]);
        text_print(&unit->text, "\n");
        table_end(unit);
    }
    if (scene->solid_count == 0)
        return;
    table_begin(unit, "struct tia_solid", "solids");
    for (uint32_t i = 0; i < scene->solid_count; i++) {
        text_word(&unit->text, "{");
        field_table(unit, "members", 1, "members_%u", i);
        field_table(unit, "steps", 1, "steps_%u", i);
        field_unsigned(unit, "member_count", scene->solids[i].member_count);
        field_unsigned(unit, "step_count", scene->solids[i].step_count);
        text_print(&unit->text, "},\n");
    }
    table_end(unit);
}

void unit_shapes(struct unit *unit)
{
    const struct tia_scene *scene = unit->scene;

    write_transforms(unit);
    write_solids(unit);
    if (scene->shape_count == 0)
        return;
    table_begin(unit, "struct tia_shape", "shapes");
    for (uint32_t i = 0; i < scene->shape_count; i++)
        write_shape(unit, &scene->shapes[i]);
    table_end(unit);
}
