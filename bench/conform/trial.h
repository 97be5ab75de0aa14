/* trial.h - random triangles with depth and stencil states, drawn exactly and by what is tested, and the search for the
 * fewest that show a difference. */
#ifndef BENCH_CONFORM_TRIAL_H
#define BENCH_CONFORM_TRIAL_H

#include <tia/raster.h>

enum { SIDE = 64, PIXELS = SIDE * SIDE, TRIANGLES = 24, LEVELS = 12, TRIAL_NUMBERS = 2 + 26 * TRIANGLES };

/* A triangle of one depth: 1, nearest, to LEVELS. Corners are in 1/256 of a pixel from the top left of the image. */
struct triangle {
    int32_t x[3], y[3], level;
    struct tia_raster_state state;
};

struct trial {
    struct triangle triangles[TRIANGLES]; /* the index is the face */
    unsigned count;
    uint8_t clear; /* stencil value at first */
};

struct pixels {
    uint32_t face[PIXELS]; /* TIA_NO_FACE at empty pixels */
    uint8_t stencil[PIXELS];
};

/* Draws a trial. Returns false on failure. */
typedef bool trial_drawer(void *ctx, const struct trial *trial, struct pixels *pixels);

/* The rule that a pixel breaks. */
enum rule { RULE_EDGES, RULE_TIES, RULE_DEPTH, RULE_STENCIL, RULES };

/* A finding: the fewest triangles, in the simplest states found, and the pixel. */
struct finding {
    struct trial trial;
    unsigned x, y;
    enum rule rule;
    uint32_t face[2];   /* exact, and found */
    uint8_t stencil[2]; /* likewise */
};

/* Makes a random trial; the state of the generator is *seed. Corners are multiples of `step`. */
void trial_random(struct trial *trial, uint64_t *seed, unsigned step);

/* Returns corner number `corner` in clip coordinates with `one` as 1. */
struct tia_raster_vertex trial_vertex(const struct triangle *triangle, int corner, int64_t one);

/* Writes a trial as numbers, for drawers in other languages: the number of triangles and the stencil value at first;
 * then for each triangle x and y of its corners in 1/256 pixel, its level, the test of depth (enum tia_compare),
 * whether it writes depth, whether it writes colours, whether front and back faces are culled; and for front faces,
 * then for back faces, test, reference, mask and written bits of the stencil and its operations fail, zfail, zpass
 * (enum tia_stencil_op). Returns how many numbers. */
unsigned trial_numbers(const struct trial *trial, int32_t numbers[TRIAL_NUMBERS]);

/* Takes the answer of such a drawer: SIDE x SIDE bytes, the top row first, the number of the triangle that a pixel
 * shows, 255 for none; and as many with the stencil values. */
void trial_take(struct pixels *pixels, const uint8_t bytes[2 * PIXELS]);

/* Draws by the exact rasteriser; `ctx` is ignored. */
bool trial_exact(void *ctx, const struct trial *trial, struct pixels *pixels);

/* Returns the number of pixels that differ; *first receives the first of them. */
unsigned trial_differs(const struct pixels *exact, const struct pixels *found, unsigned *first);

/* Removes triangles and simplifies states and corners as long as some pixel differs, and names the rule. Returns false
 * if the drawer fails, or differs no longer. */
bool trial_shrink(const struct trial *trial, trial_drawer *drawer, void *ctx, struct finding *finding);

#endif
