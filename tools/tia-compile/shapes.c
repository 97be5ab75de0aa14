#include "unit.h"

/* The shapes of a round outline. */
static void write_round(struct unit *unit, const struct tia_shape *s)
{
    struct text *text = &unit->text;

    switch (s->kind) {
    case TIA_SPHERE:
        text_word(text, ".sphere = {");
        field_vec3(unit, "centre", s->sphere.centre);
        field_number(unit, "radius", s->sphere.radius);
        break;
    case TIA_DISC:
        text_word(text, ".disc = {");
        field_vec3(unit, "centre", s->disc.centre);
        field_dir3(unit, "normal", s->disc.normal);
        field_number(unit, "radius", s->disc.radius);
        break;
    case TIA_CYLINDER:
        text_word(text, ".cylinder = {");
        field_vec3(unit, "base", s->cylinder.base);
        field_vec3(unit, "top", s->cylinder.top);
        field_number(unit, "radius", s->cylinder.radius);
        field_number(unit, "capped", s->cylinder.capped);
        break;
    default:
        text_word(text, ".cone = {");
        field_vec3(unit, "base", s->cone.base);
        field_vec3(unit, "top", s->cone.top);
        field_number(unit, "base_radius", s->cone.base_radius);
        field_number(unit, "top_radius", s->cone.top_radius);
        field_number(unit, "capped", s->cone.capped);
    }
    text_print(text, "}},\n");
}

static void write_triangle(struct unit *unit, const struct tia_triangle *t)
{
    const struct tia_vec3 *c = t->corner;

    text_word(&unit->text, ".triangle = {{{%d, %d, %d}, {%d, %d, %d}, {%d, %d, %d}}}},\n", c[0].x, c[0].y, c[0].z,
              c[1].x, c[1].y, c[1].z, c[2].x, c[2].y, c[2].z);
}

static void write_shape(struct unit *unit, const struct tia_shape *s)
{
    static const char *const kinds[] = {"TIA_SPHERE", "TIA_PLANE",    "TIA_DISC", "TIA_CYLINDER", "TIA_CONE",
                                        "TIA_BOX",    "TIA_TRIANGLE", "TIA_MESH", "TIA_GRID"};
    struct text *text = &unit->text;

    text_word(text, "{.kind = %s,", kinds[s->kind]);
    field_unsigned(unit, "material", s->material);
    field_unsigned(unit, "transform", s->transform);
    switch (s->kind) {
    case TIA_PLANE:
        text_word(text, ".plane = {");
        field_vec3(unit, "point", s->plane.point);
        field_dir3(unit, "normal", s->plane.normal);
        text_print(text, "}},\n");
        break;
    case TIA_BOX:
        text_word(text, ".box = {");
        field_vec3(unit, "min", s->box.min);
        field_vec3(unit, "max", s->box.max);
        text_print(text, "}},\n");
        break;
    case TIA_TRIANGLE:
        write_triangle(unit, &s->triangle);
        break;
    case TIA_MESH:
        text_word(text, ".mesh = %uu},\n", s->mesh);
        break;
    case TIA_GRID:
        text_word(text, ".grid = %uu},\n", s->grid);
        break;
    default:
        write_round(unit, s);
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

void unit_shapes(struct unit *unit)
{
    const struct tia_scene *scene = unit->scene;

    write_transforms(unit);
    if (scene->shape_count == 0)
        return;
    table_begin(unit, "struct tia_shape", "shapes");
    for (uint32_t i = 0; i < scene->shape_count; i++)
        write_shape(unit, &scene->shapes[i]);
    table_end(unit);
}
