/* technique_switch.c - the technique for shadows, changed by a key. */
#include "loop.h"

enum tia_shadows tia_next_shadows(const struct tia_scene *scene)
{
    if (!scene || !tia_shadows_name((unsigned)scene->shadows))
        return TIA_SHADOWS_TRACED;
    struct tia_scene tried = *scene;

    do {
        unsigned next = (unsigned)tried.shadows + 1;
        tried.shadows = tia_shadows_name(next) ? (enum tia_shadows)next : TIA_SHADOWS_TRACED;
    } while (tried.shadows != scene->shadows && tia_scene_check(&tried, NULL));
    return tried.shadows;
}

/* Selects the next technique; the view and the hits then have another size. */
void tia_viewer_switch(struct loop *loop)
{
    struct tia_scene *variant = loop->viewer->variant;

    variant->shadows = tia_next_shadows(variant);
    loop->view = NULL;
    loop->switched = loop->changed = true;
}
