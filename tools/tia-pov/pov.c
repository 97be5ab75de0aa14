#include "pov.h"

static struct point ambient(const struct tia_scene *scene)
{
    struct point sum = {0};

    for (uint32_t i = 0; i < scene->light_count; i++)
        if (tia_light_has(scene->lights[i].kind, TIA_LIGHT_EVERYWHERE))
            sum = pov_sum(sum, pov_rgb(scene->lights[i].emission));
    return sum;
}

/* Writes the settings. POV-Ray's level counts the camera ray, too. With adc_bailout 0, it does not end faint rays
 * early. */
static void write_settings(struct pov *pov)
{
    uint32_t depth = pov->scene->depth != 0 ? pov->scene->depth : TIA_DEPTH_DEFAULT;

    text_print(&pov->text, "global_settings {\n");
    text_word(&pov->text, "assumed_gamma 1.0 max_trace_level %u adc_bailout 0", depth + 1);
    pov_triple(pov, "ambient_light rgb", ambient(pov->scene));
    text_print(&pov->text, "\n}\n\n");
    pov->text.indent = 0;
    pov_triple(pov, "background { rgb", pov_rgb(pov->scene->background));
    text_print(&pov->text, " }\n\n");
}

/* POV-Ray's ground fog has the same density. */
static void write_fog(struct pov *pov)
{
    const struct tia_fog *fog = pov->scene->fog;

    text_print(&pov->text, "fog {\n");
    text_word(&pov->text, "fog_type %d distance %.10g", fog->height ? 2 : 1, pov_length(pov, fog->distance));
    pov_triple(pov, "rgb", pov_rgb(fog->colour));
    if (fog->height)
        text_word(&pov->text, "fog_offset %.10g fog_alt %.10g", pov_length(pov, fog->level),
                  pov_length(pov, fog->height));
    text_print(&pov->text, "\n}\n\n");
}

void pov_write(struct pov *pov, const char *source)
{
    text_print(&pov->text, "// %s, as tia-pov wrote it. As tia draws it:\n", source);
    text_print(&pov->text, "//     povray +I... +O... +W640 +H480 -A -D File_Gamma=1.0\n#version 3.7;\n\n");
    pov->text.indent = 4;
    write_settings(pov);
    pov->text.indent = 4;
    if (pov->scene->fog)
        write_fog(pov);
    pov->text.indent = 4;
    pov_camera(pov);
    pov_lights(pov);
    pov_materials(pov);
    pov_shapes(pov);
}
