/* heatmap_files.h - the heatmaps of a run, which appear together at its end, or not at all. */
#ifndef TIA_COMPARE_HEATMAP_FILES_H
#define TIA_COMPARE_HEATMAP_FILES_H

#include "heatmap.h"
#include "ports.h"

struct pictures {
    const char *name; /* name from the option --heatmap */
    unsigned most;    /* number of frames */
    unsigned count;
    struct image **images;
    char **paths;
    char why[PORT_WHY]; /* reason of a failure */
};

/* Begins a run of `most` frames. Returns false if there is no memory; pictures_end is safe in either case. */
bool pictures_begin(struct pictures *pictures, const char *name, unsigned most);

/* Draws the next heatmap; pictures_publish gives it its name. Returns a negative tia_status on failure. */
int pictures_add(struct pictures *pictures, const struct heatmap *map);

/* Gives all heatmaps their names. Returns a negative tia_status on failure. */
int pictures_publish(struct pictures *pictures);

/* Removes pictures that were not published. */
void pictures_end(struct pictures *pictures);

#endif
