#include "polygon.h"

#include "ranges.h"

#define FORM(name) narrow_##name
#include "setup.h"
#undef FORM
#define FORM(name) wide_##name
#include "setup.h"
#undef FORM

static inline int64_t size_of(int64_t a)
{
    return a < 0 ? -a : a;
}

/* Returns the largest absolute coordinate, or -1 when a coordinate is out of range. Directions have twice the range, as
 * they are differences of points. */
static int64_t largest(const struct tia_raster_grid *l, const struct tia_raster_vertex *v, unsigned count)
{
    bool flat = l->projection == TIA_ORTHOGRAPHIC;
    int64_t most = 0, limit = INT64_C(1) << (flat ? FLAT_POINT : RASTER_POINT), far = flat ? 2 * limit : 1;

    for (unsigned i = 0; i < count; i++) {
        bool direction = flat ? v[i].w == 0 : v[i].h == 0;
        int64_t own = limit << direction;
        if (v[i].x <= -own || v[i].x >= own || v[i].y <= -own || v[i].y >= own || v[i].w <= -own || v[i].w >= own ||
            v[i].h > far || v[i].h < (flat ? -far : 0))
            return -1;
        int64_t x = size_of(v[i].x), y = size_of(v[i].y), w = size_of(v[i].w);
        x = x > y ? x : y;
        x = x > w ? x : w;
        most = x > most ? x : most;
    }
    return most;
}

bool tia_polygon_has_range(const struct tia_raster_grid *grid, const struct tia_raster_vertex *corners, unsigned count)
{
    return largest(grid, corners, count) >= 0;
}

/* Prepares a polygon. Its box is `more` pixels larger on every side; its edges are not moved. */
static int init(struct polygon *p, const struct tia_raster_grid *grid, struct tia_tile area,
                const struct tia_raster_vertex *corners, unsigned count, unsigned more)
{
    int64_t most = largest(grid, corners, count), q[TIA_RASTER_CORNERS][3];

    p->count = 0;
    if (most < 0)
        return TIA_ERR_RANGE;
    if (!tia_polygon_box(p, grid, area, corners, count, more))
        return TIA_OK;
    for (unsigned i = 0; i < count; i++) {
        q[i][0] = corners[i].x;
        q[i][1] = corners[i].y;
        q[i][2] = corners[i].w;
    }
    p->count = count;
    p->narrow = most <= grid->narrow;
    if (!(p->narrow ? narrow_set_up(p, grid, q, corners) : wide_set_up(p, grid, q, corners)))
        p->count = 0;
    return TIA_OK;
}

int tia_polygon_init(struct polygon *p, const struct tia_raster_grid *grid, struct tia_tile area,
                     const struct tia_raster_vertex *corners, unsigned count)
{
    int status = init(p, grid, area, corners, count, 0);

    if (!status && p->count)
        tia_depth_scale_init(p, grid);
    return status;
}

/* Each edge is moved outwards by a column and a row: over these its value falls by at most |x| + |y|. */
int tia_polygon_init_enlarged(struct polygon *p, const struct tia_raster_grid *grid, struct tia_tile area,
                              const struct tia_raster_vertex *corners, unsigned count)
{
    int status = init(p, grid, area, corners, count, 2);

    for (unsigned i = 0; i < p->count; i++)
        if (p->narrow) {
            struct narrow_form *e = &p->of.narrow_forms.edge[i];
            e->c += size_of(e->x) + size_of(e->y);
        } else {
            struct wide_form *e = &p->of.wide_forms.edge[i];
            e->c = wide_sum(e->c, wide_sum(wide_size(e->x), wide_size(e->y)));
        }
    return status;
}

void tia_polygon_cut_ahead(struct polygon *p)
{
    if (p->narrow)
        p->of.narrow_forms.edge[p->count] = narrow_form_negated(&p->of.narrow_forms.plane);
    else
        p->of.wide_forms.edge[p->count] = wide_form_negated(&p->of.wide_forms.plane);
    p->count++;
}
