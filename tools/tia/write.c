/* write.c - a model's scene as text: the camera, lights and materials first, then the meshes.
 *
 * Lengths are those that are stored, so that none is rounded again: a model that was moved to fit, see tia/read.h,
 * stays moved. Images become files beside the scene. */
#include "write.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fail.h"

/* ---- names ---- */

void write_note_name(void *ctx, uint32_t index, const char *name)
{
    struct write_names *names = ctx;

    if (index >= names->count) {
        char **more = realloc(names->names, (index + (size_t)1) * sizeof *more);
        if (!more)
            return; /* the material gets a number */
        memset(more + names->count, 0, (index + (size_t)1 - names->count) * sizeof *more);
        names->names = more;
        names->count = index + 1;
    }
    free(names->names[index]);
    names->names[index] = strdup(name);
}

void write_free_names(struct write_names *names)
{
    for (uint32_t i = 0; i < names->count; i++)
        free(names->names[i]);
    free(names->names);
    *names = (struct write_names){.count = 0};
}

/* Writes a material's name: its number, and what the model calls it, as a word of .tia. */
static void write_material_name(struct text *text, const struct write_names *names, uint32_t index)
{
    const char *name = index < names->count ? names->names[index] : NULL;

    text_print(text, " m%u", index);
    if (name && *name != '\0')
        text_print(text, "-");
    for (unsigned i = 0; name && name[i] != '\0' && i < 60; i++) {
        bool plain = name[i] > ' ' && name[i] < 127 && !strchr("#\"\\", name[i]);
        text_print(text, "%c", plain ? name[i] : '_');
    }
}

/* ---- textures ---- */

struct writing {
    struct text text;
    const struct options *options;
    const struct tia_scene *scene;
    char why[PORT_WHY];
};

/* Returns OUT-N.ppm for OUT.tia, or OUT-N.pgm for an opacity. */
static char *picture_path(const struct writing *w, uint32_t index)
{
    const char *path = w->options->write;
    size_t length = strlen(path);
    char *picture;

    if (length > 4 && strcmp(path + length - 4, ".tia") == 0)
        length -= 4;
    return asprintf(&picture, "%.*s-%u.%s", (int)length, path, index + 1,
                    w->scene->textures[index].kind == TIA_OPACITY ? "pgm" : "ppm") < 0
               ? NULL
               : picture;
}

static int write_picture(struct writing *w, const char *path, const struct tia_texture *t)
{
    size_t texels = (size_t)t->width * t->height;
    static struct text picture;
    int status = text_open(&picture, path, w->why);

    if (status)
        return status;
    text_print(&picture, "P%c\n%u %u\n255\n", t->kind == TIA_OPACITY ? '5' : '6', t->width, t->height);
    (void)sink_write(&picture.sink, t->texels, texels * (t->kind == TIA_OPACITY ? 1 : 3));
    return text_close(&picture);
}

static int write_texture(struct writing *w, uint32_t index)
{
    const struct tia_texture *t = &w->scene->textures[index];
    char *path = picture_path(w, index);
    int status = path ? write_picture(w, path, t) : TIA_ERR_MEMORY;

    if (!status) {
        const char *slash = strrchr(path, '/');
        text_print(&w->text, "texture t%u %s \"%s\"", index, t->kind == TIA_OPACITY ? "opacity" : "image",
                   slash ? slash + 1 : path);
        if (t->repeat[0] != TIA_Q16_ONE || t->repeat[1] != TIA_Q16_ONE || t->repeat_bits)
            write_numbers(&w->text, " repeat", t->repeat, 2, (unsigned)(16 + t->repeat_bits));
        if (t->offset[0] || t->offset[1])
            write_numbers(&w->text, " offset", t->offset, 2, (unsigned)(16 + t->offset_bits));
        text_print(&w->text, "%s\n", t->bilinear ? " bilinear" : "");
    } else if (!path) {
        (void)snprintf(w->why, sizeof w->why, "memory: exhausted");
    }
    free(path);
    return status;
}

/* ---- materials, lights, the camera ---- */

static void write_colour(struct writing *w, const char *word, struct tia_rgb colour, unsigned bits)
{
    if (colour.r || colour.g || colour.b)
        write_rgb(&w->text, word, colour, bits);
}

static void write_material(struct writing *w, uint32_t index)
{
    const struct tia_material *m = &w->scene->materials[index];

    text_print(&w->text, "material");
    write_material_name(&w->text, &w->options->names, index);
    write_colour(w, " colour", m->colour, 0);
    if (m->texture)
        text_print(&w->text, " texture t%u", m->texture - 1);
    if (m->opacity)
        text_print(&w->text, " opacity t%u", m->opacity - 1);
    write_colour(w, " specular", m->specular, 0);
    if (m->exponent)
        write_numbers(&w->text, " exponent", &m->exponent, 1, 16);
    write_colour(w, " mirror", m->mirror, 0);
    write_colour(w, " refraction", m->refraction, 0);
    if (m->index)
        write_numbers(&w->text, " index", &m->index, 1, 16);
    text_print(&w->text, "%s", m->fresnel ? " fresnel" : "");
    write_colour(w, " transmission", m->transmission, 0);
    write_colour(w, " emission", m->emission, m->emission_bits);
    write_colour(w, " facing", m->facing, 0);
    text_print(&w->text, "\n");
}

static const char *const light_names[] = {
#define LIGHT_NAME(KIND, name, what, traits) [KIND] = #name,
    TIA_LIGHTS(LIGHT_NAME)
#undef LIGHT_NAME
};

/* The attenuation's numbers are for a unit of the file, whose lengths are those of the scene here. */
static void write_attenuation(struct writing *w, const struct tia_light *l)
{
    int bits = l->unit_bits + w->scene->scale_bits;

    if (!l->constant && !l->linear && !l->quadratic)
        return;
    write_numbers(&w->text, " attenuation", &l->constant, 1, 16);
    write_exactly(&w->text, ldexp(l->linear, -16 - bits));
    write_exactly(&w->text, ldexp(l->quadratic, -16 - 2 * bits));
}

static void write_light(struct writing *w, const struct tia_light *l)
{
    text_print(&w->text, "light %s", light_names[l->kind]);
    if (!tia_light_has(l->kind, TIA_LIGHT_PLACELESS))
        write_numbers(&w->text, " at", &l->centre.x, 3, 16);
    if (tia_light_has(l->kind, TIA_LIGHT_DIRECTION))
        write_numbers(&w->text, " direction", &l->direction.x, 3, 30);
    write_rgb(&w->text, " emission", l->emission, l->emission_bits);
    if (tia_light_has(l->kind, TIA_LIGHT_SIDES))
        write_numbers(&w->text, " sides", &l->side[0].x, 6, 16);
    if (l->radius)
        write_numbers(&w->text, tia_light_has(l->kind, TIA_LIGHT_EVERYWHERE) ? " occlusion" : " radius", &l->radius, 1,
                      16);
    if (tia_light_has(l->kind, TIA_LIGHT_CONE)) {
        write_numbers(&w->text, " inner", &l->inner, 1, 16);
        write_numbers(&w->text, " outer", &l->outer, 1, 16);
    }
    if (l->samples)
        text_print(&w->text, " samples %u", l->samples);
    write_attenuation(w, l);
    text_print(&w->text, "\n");
}

static void write_camera(struct writing *w)
{
    static const char *const forms[] = {"camera", "camera frustum", "camera orthographic"};
    const struct tia_camera *c = &w->scene->camera;

    text_print(&w->text, "%s", forms[c->projection]);
    write_numbers(&w->text, " eye", &c->eye.x, 3, 16);
    if (c->up.x || c->up.y || c->up.z) {
        write_numbers(&w->text, " look", &c->reference.x, 3, 16);
        write_numbers(&w->text, " up", &c->up.x, 3, 16);
    }
    if (c->projection == TIA_PERSPECTIVE)
        write_numbers(&w->text, " fov", &c->fov, 1, 16);
    else
        write_numbers(&w->text, " window", &c->window.left, 4, 16);
    if (c->projection == TIA_FRUSTUM)
        write_numbers(&w->text, " near", &c->window.near, 1, 16);
    text_print(&w->text, "\n");
}

/* ---- shapes ---- */

static void write_instance(struct writing *w, const struct tia_shape *shape)
{
    text_print(&w->text, "instance mesh%u material", shape->mesh);
    write_material_name(&w->text, &w->options->names, shape->material);
    if (shape->transform) {
        const struct tia_transform *t = &w->scene->transforms[shape->transform - 1];
        write_numbers(&w->text, " at", &t->position.x, 3, 16);
        write_numbers(&w->text, " rotate", &t->rotation.x, 3, 16);
        write_numbers(&w->text, " scale", &t->scale.x, 3, 16);
    }
    text_print(&w->text, "\n");
}

/* Writes the model's coordinates in the file that was read, if they are others. */
static void write_place(struct writing *w)
{
    const struct tia_placement *p = &w->options->file.placement;

    if (p->bits || p->origin[0] || p->origin[1] || p->origin[2])
        text_print(&w->text, "# The model was moved by %.6f %.6f %.6f, then scaled by 2^%d.\n",
                   -ldexp((double)p->origin[0], -32), -ldexp((double)p->origin[1], -32),
                   -ldexp((double)p->origin[2], -32), p->bits);
}

static int write_all(struct writing *w)
{
    const struct tia_scene *s = w->scene;
    int status = TIA_OK;

    text_print(&w->text, "# Written by tia --write from a model; see tia-scene(5).\n");
    write_place(w);
    write_camera(w);
    text_print(&w->text, "samples %u\ndepth %u\nfilter footprint\n", s->camera.samples ? s->camera.samples : 1,
               s->depth ? s->depth : TIA_DEPTH_DEFAULT);
    write_rgb(&w->text, "background", s->background, 0);
    text_print(&w->text, "\n");
    for (uint32_t i = 0; i < s->light_count; i++)
        write_light(w, &s->lights[i]);
    for (uint32_t i = 0; i < s->texture_count && !status; i++)
        status = write_texture(w, i);
    for (uint32_t i = 0; i < s->material_count; i++)
        write_material(w, i);
    for (uint32_t i = 0; i < s->shape_count; i++)
        write_instance(w, &s->shapes[i]);
    for (uint32_t i = 0; i < s->mesh_count; i++) {
        text_print(&w->text, "mesh mesh%u\n", i);
        write_mesh(&w->text, &s->meshes[i]);
        text_print(&w->text, "end\n");
    }
    return status;
}

/* ---- the file ---- */

/* True if the scene has nothing but what the readers of models make. */
static bool is_model(const struct tia_scene *s)
{
    for (uint32_t i = 0; i < s->shape_count; i++)
        if (s->shapes[i].kind != TIA_MESH)
            return false;
    return !s->sphere_count && !s->grid_count && !s->track_count && !s->falling && !s->binding_count;
}

int write_scene(const struct options *options)
{
    static struct writing w;

    w.options = options;
    w.scene = &options->scene;
    if (options->scene_format == TIA_FORMAT_TIA || options->scene_format == TIA_FORMAT_NFF || !is_model(w.scene))
        return fail(EXIT_USAGE, "--write: %.200s is a scene, expected a model", options->scene_path);
    if (strcmp(options->write, "-") == 0 && w.scene->texture_count)
        return fail(EXIT_USAGE, "--write -: the model has images, which need a file's name");
    if (text_open(&w.text, options->write, w.why))
        return fail(EXIT_RUNNING, "%s", w.why);
    if (write_all(&w)) {
        sink_discard(&w.text.sink);
        return fail(EXIT_RUNNING, "%s", w.why);
    }
    return text_close(&w.text) ? fail(EXIT_RUNNING, "%s", w.why) : EXIT_FINE;
}
