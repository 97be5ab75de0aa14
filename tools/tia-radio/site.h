/* site.h - a scene for radio waves: its faces and the electrical properties of its materials. */
#ifndef TOOLS_RADIO_SITE_H
#define TOOLS_RADIO_SITE_H

#include "common/scene/scene_load.h"
#include "options.h"
#include "path_wave.h"

struct site {
    struct scene_file file;
    char (*names)[TIA_NAME_MAX + 1]; /* names of the materials; "" for a material without a name */
    uint32_t name_count;
    struct medium *media;
    void *memory;
    struct tia_radio *radio;
    struct world world;
};

/* Opens a site. Returns FINE, or the exit status after printing the reason. */
int site_open(struct site *site, const struct options *options);

/* Converts the options' positions from metres to the scene's unit. */
void site_place(const struct site *site, struct options *options);
void site_close(struct site *site);

/* Returns FINE; or REFUSED, after printing the reason, if the position is inside a wall. */
int site_check_place(const struct site *site, const char *option, struct tia_vec3 place);

#endif
