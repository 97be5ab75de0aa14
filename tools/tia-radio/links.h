/* links.h - all paths of a link, by any of the methods, in a fixed order. */
#ifndef TOOLS_RADIO_LINKS_H
#define TOOLS_RADIO_LINKS_H

#include <tia/radio.h>

#include "common/thread_pool.h"

enum method { METHOD_IMAGE, METHOD_SBR, METHOD_HYBRID, METHODS };

const char *method_name(enum method method);

/* Largest number of sequences of planes for the image method: more take minutes. */
#define SEQUENCES_MOST UINT64_C(200000000)

struct path_list {
    struct tia_radio_path *paths;
    unsigned count, room;
    bool exhausted; /* there was no memory for more paths */
};

struct search {
    const struct tia_radio *radio;
    struct threads *pool;
    enum method method;
    uint32_t order, walls, density;
};

/* Finds the paths, ordered by length, then reflections, then faces. METHOD_IMAGE and METHOD_HYBRID find the same paths.
 * Returns false if there is no memory. The caller frees the list's paths. */
bool links_find(const struct search *search, struct tia_vec3 from, struct tia_vec3 to, struct path_list *list);

/* ---- many receivers ---- */

/* The distinct sequences of planes that rays from a transmitter meet. */
struct sequences {
    struct sequence {
        uint32_t order, plane[TIA_RADIO_ORDER_MAX];
    } * array;
    size_t count, room;
    bool exhausted;
};

/* Shoots the rays. Returns false if there is no memory. `array` must be freed. */
bool sequences_shoot(const struct search *search, struct tia_vec3 from, struct sequences *sequences);

/* Finds the link's paths along the given sequences, or along all sequences if `sequences` is NULL. Runs on one thread;
 * the paths are in no particular order. Returns false if there is no memory. */
bool links_try(const struct search *search, struct tia_radio_room *room, const struct sequences *sequences,
               struct tia_vec3 from, struct tia_vec3 to, struct path_list *list);

void links_sort(struct path_list *list);

#endif
