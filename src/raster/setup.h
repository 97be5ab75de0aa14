/* setup.h - a polygon's edges and plane, in 64 or 128 bits as in forms.h. No guard: polygon.c includes this file once
 * for each width.
 */

static void FORM(set_plane)(struct polygon *p, const struct tia_raster_grid *l, FORM(number) sides[3][3],
                            const struct tia_raster_vertex *v)
{
    FORM(number) zero = FORM(product)(0, 0), n[3] = {zero, zero, zero};

    for (int i = 0; i < 3; i++)
        if (v[i].h)
            FORM(add_scaled)(n, sides[(i + 1) % 3], v[i].h);
    if (!p->front)
        FORM(negate)(n);
    p->of.FORM(forms).plane = FORM(form_of)(n, l);
}

/* Returns an edge with the tie rule: pixels are moved to the right, then down. An edge without length covers all
 * pixels. */
static struct FORM(form) FORM(edge_of)(const struct polygon *p, const struct tia_raster_grid *l, FORM(number) n[3])
{
    if (!p->front)
        FORM(negate)(n);
    struct FORM(form) e = FORM(form_of)(n, l);
    int right = FORM(sign)(e.x);
    if (right < 0 || (right == 0 && FORM(sign)(e.y) < 0))
        e.c = FORM(difference)(e.c, FORM(product)(1, 1));
    return e;
}

/* Sets up the edges and the plane; false when the eye is in the polygon's plane. sides[i] is the normal of the side
 * from corner i to the next one. */
static bool FORM(set_up)(struct polygon *p, const struct tia_raster_grid *l, int64_t q[][3],
                         const struct tia_raster_vertex *v)
{
    FORM(number) sides[3][3];

    for (unsigned i = 0; i < 3; i++)
        FORM(cross)(q[i], q[i == 2 ? 0 : i + 1], sides[i]);
    p->det = FORM(determinant)(sides[0], q[2]);
    int sign = wide_sign(p->det);
    if (!sign)
        return false;
    p->front = sign > 0;
    p->det = wide_size(p->det);
    FORM(set_plane)(p, l, sides, v);
    for (unsigned i = 0; i < p->count; i++) {
        if (i >= 2 && p->count > 3)
            FORM(cross)(q[i], q[i + 1 == p->count ? 0 : i + 1], sides[2]);
        p->of.FORM(forms).edge[i] = FORM(edge_of)(p, l, sides[i < 2 ? i : 2]);
    }
    return true;
}
