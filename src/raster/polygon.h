/* polygon.h - a polygon prepared for drawing: its edges and its plane as linear functions of the pixel. */
#ifndef TIA_RASTER_POLYGON_H
#define TIA_RASTER_POLYGON_H

#include <tia/raster.h>

#include "forms_narrow.h"
#include "forms_wide.h"

/* Scale from f to nearness, f/det 2^scale, in one multiplication: (f / 2^cut) reciprocal / 2^shift. */
struct depth_scale {
    uint64_t reciprocal;
    unsigned cut, shift;
    int64_t least, most; /* values of f / 2^cut beyond which nearness is clamped, to 0 and to 2^62 */
    int64_t zero;        /* nearness where f is 0: 0, or 2^61 in orthographic views */
    int64_t step;        /* step of nearness to the next pixel on the right; its error is below 2 */
    bool steady;         /* nearness is clamped nowhere in the polygon's box; always false for low boxes */
};

#define POLYGON_EDGES (TIA_RASTER_CORNERS + 1) /* the edges between corners, and one of tia_polygon_cut_ahead */

/* A pixel is covered if the values of all edges are >= 0; the constant of an edge is reduced by 1 if the tie rule
 * excludes pixels with the value 0. At a pixel 1/t is plane/det. */
struct polygon {
    unsigned count;
    bool narrow, front;
    int x0, x1, y0, y1; /* a box that contains all covered pixels: x0 <= x < x1, y0 <= y < y1 */
    union {
        struct {
            struct narrow_form edge[POLYGON_EDGES], plane;
        } narrow_forms;
        struct {
            struct wide_form edge[POLYGON_EDGES], plane;
        } wide_forms;
    } of;
    wide det; /* above 0 */
    struct depth_scale depth;
};

/* True if the corners are in the range of raster.h. */
bool tia_polygon_has_range(const struct tia_raster_grid *grid, const struct tia_raster_vertex *corners, unsigned count);

/* Prepares a polygon. Returns TIA_OK, with p->count = 0 when no pixel is covered, or TIA_ERR_RANGE. */
int tia_polygon_init(struct polygon *p, const struct tia_raster_grid *grid, struct tia_tile area,
                     const struct tia_raster_vertex *corners, unsigned count);

/* Prepares an enlarged polygon, without depth: it covers all pixels whose centres are at most one column and one row
 * from a point of the polygon, and a few more beside its corners. The corners may be directions. */
int tia_polygon_init_enlarged(struct polygon *p, const struct tia_raster_grid *grid, struct tia_tile area,
                              const struct tia_raster_vertex *corners, unsigned count);

/* Excludes the pixels where the polygon's h is above 0, by a further edge. */
void tia_polygon_cut_ahead(struct polygon *p);

/* Sets the polygon's box in `area`: the pixels that the corners can cover, and `more` on every side; false when the box
 * is empty. The box may be a little too large, never too small. */
bool tia_polygon_box(struct polygon *p, const struct tia_raster_grid *grid, struct tia_tile area,
                     const struct tia_raster_vertex *corners, unsigned count, unsigned more);

void tia_depth_scale_init(struct polygon *p, const struct tia_raster_grid *grid);

static inline bool polygon_edge_covers(const struct polygon *p, unsigned edge, int x, int y)
{
    return p->narrow ? narrow_form_at(&p->of.narrow_forms.edge[edge], x, y) >= 0
                     : !wide_is_negative(wide_form_at(&p->of.wide_forms.edge[edge], x, y));
}

#endif
