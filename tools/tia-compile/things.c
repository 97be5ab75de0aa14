#include "unit.h"

static void write_material(struct unit *unit, const struct tia_material *m)
{
    text_word(&unit->text, "{");
    text_word(&unit->text, ".colour = {%d, %d, %d},", m->colour.r, m->colour.g, m->colour.b);
    field_rgb(unit, "transmission", m->transmission);
    field_rgb(unit, "emission", m->emission);
    field_unsigned(unit, "emission_bits", m->emission_bits);
    field_unsigned(unit, "bump", m->bump);
    field_rgb(unit, "specular", m->specular);
    field_number(unit, "exponent", m->exponent);
    field_rgb(unit, "mirror", m->mirror);
    field_rgb(unit, "refraction", m->refraction);
    field_number(unit, "index", m->index);
    if (m->fresnel)
        text_word(&unit->text, ".fresnel = true,");
    field_rgb(unit, "facing", m->facing);
    field_unsigned(unit, "texture", m->texture);
    field_unsigned(unit, "opacity", m->opacity);
    text_print(&unit->text, "},\n");
}

void unit_light(struct unit *unit, const struct tia_light *l)
{
#define NAME(KIND, name, what, traits) #KIND,
    static const char *const kinds[] = {TIA_LIGHTS(NAME)};
#undef NAME

    text_word(&unit->text, "{");
    field_vec3(unit, "centre", l->centre);
    field_number(unit, "radius", l->radius);
    field_rgb(unit, "emission", l->emission);
    text_word(&unit->text, ".kind = %s,", kinds[l->kind]);
    field_dir3(unit, "direction", l->direction);
    field_number(unit, "inner", l->inner);
    field_number(unit, "outer", l->outer);
    field_vec3(unit, "side[0]", l->side[0]);
    field_vec3(unit, "side[1]", l->side[1]);
    field_number(unit, "constant", l->constant);
    field_number(unit, "linear", l->linear);
    field_number(unit, "quadratic", l->quadratic);
    field_number(unit, "samples", l->samples);
    field_number(unit, "emission_bits", l->emission_bits);
    field_number(unit, "unit_bits", l->unit_bits);
    text_print(&unit->text, "}");
}

static void write_lights(struct unit *unit)
{
    const struct tia_scene *scene = unit->scene;

    if (scene->light_count == 0)
        return;
    table_begin(unit, "struct tia_light", "lights");
    for (uint32_t i = 0; i < scene->light_count; i++) {
        unit_light(unit, &scene->lights[i]);
        text_print(&unit->text, ",\n");
    }
    table_end(unit);
}

static void write_binding(struct unit *unit, const struct tia_binding *b)
{
    bool letter = (b->key >= 'a' && b->key <= 'z') || (b->key >= '0' && b->key <= '9');

    text_word(&unit->text, letter ? "{.key = '%c'," : "{.key = %d,", b->key);
    field_number(unit, "light", b->light);
    text_word(&unit->text, ".state =");
    unit_light(unit, &b->state);
    text_print(&unit->text, "},\n");
}

static void write_bindings(struct unit *unit)
{
    const struct tia_scene *scene = unit->scene;

    if (scene->binding_count == 0)
        return;
    table_begin(unit, "struct tia_binding", "bindings");
    for (uint32_t i = 0; i < scene->binding_count; i++)
        write_binding(unit, &scene->bindings[i]);
    table_end(unit);
}

static void write_spheres(struct unit *unit)
{
    const struct tia_scene *scene = unit->scene;

    if (scene->sphere_count == 0)
        return;
    table_begin(unit, "struct tia_sphere", "spheres");
    for (uint32_t i = 0; i < scene->sphere_count; i++) {
        const struct tia_sphere *s = &scene->spheres[i];
        text_word(&unit->text, "{{%d, %d, %d}, %d, %uu},", s->centre.x, s->centre.y, s->centre.z, s->radius,
                  s->material);
    }
    table_end(unit);
}

static void fine_place(struct unit *unit, const char *field, struct tia_fine_place p)
{
    if (p.x != 0 || p.y != 0 || p.z != 0)
        text_word(&unit->text, ".%s = {%d, %d, %d},", field, p.x, p.y, p.z);
}

static void write_fine_shape(struct unit *unit, const struct tia_fine_ends *e)
{
    text_word(&unit->text, "{{%d, %d, %d}, {%d, %d, %d}, %d, %d},", e->base.x, e->base.y, e->base.z, e->top.x, e->top.y,
              e->top.z, e->base_radius, e->top_radius);
}

void unit_fine(struct unit *unit)
{
    const struct tia_scene *scene = unit->scene;
    const struct tia_fine *fine = scene->fine;

    if (scene->sphere_count > 0) {
        table_begin(unit, "struct tia_fine_sphere", "fine_spheres");
        for (uint32_t i = 0; i < scene->sphere_count; i++) {
            const struct tia_fine_sphere *s = &fine->spheres[i];
            text_word(&unit->text, "{{%d, %d, %d}, %d},", s->centre.x, s->centre.y, s->centre.z, s->radius);
        }
        table_end(unit);
    }
    if (scene->shape_count > 0) {
        table_begin(unit, "struct tia_fine_ends", "fine_shapes");
        for (uint32_t i = 0; i < scene->shape_count; i++)
            write_fine_shape(unit, &fine->shapes[i]);
        table_end(unit);
    }
    text_print(&unit->text, "static const struct tia_fine %s_fine = {\n", unit->symbol);
    unit->text.indent = 4;
    fine_place(unit, "eye", fine->eye);
    fine_place(unit, "reference", fine->reference);
    field_table(unit, "spheres", scene->sphere_count, "fine_spheres");
    field_table(unit, "shapes", scene->shape_count, "fine_shapes");
    table_end(unit);
}

void unit_fog(struct unit *unit)
{
    const struct tia_fog *fog = unit->scene->fog;

    text_print(&unit->text, "static const struct tia_fog %s_fog = {\n", unit->symbol);
    unit->text.indent = 4;
    field_rgb(unit, "colour", fog->colour);
    field_number(unit, "distance", fog->distance);
    field_number(unit, "height", fog->height);
    field_number(unit, "level", fog->level);
    table_end(unit);
}

void unit_things(struct unit *unit)
{
    const struct tia_scene *scene = unit->scene;

    if (scene->material_count > 0) {
        table_begin(unit, "struct tia_material", "materials");
        for (uint32_t i = 0; i < scene->material_count; i++)
            write_material(unit, &scene->materials[i]);
        table_end(unit);
    }
    write_spheres(unit);
    write_lights(unit);
    write_bindings(unit);
}
