/* forms.h - a linear function of the pixel, x i + y j + c, in 64 or 128 bits: FORM(name) is the name for the width in
 * use. No guard: forms_narrow.h and forms_wide.h each include this file once. */

struct FORM(form) {
    FORM(number) x, y, c;
};

static inline FORM(number) FORM(form_at)(const struct FORM(form) * f, int i, int j)
{
    return FORM(sum)(FORM(sum)(f->c, FORM(times)(f->x, i)), FORM(times)(f->y, j));
}

/* Returns n.D(i, j) as a function of the pixel. */
static inline struct FORM(form) FORM(form_of)(const FORM(number) n[3], const struct tia_raster_grid *l)
{
    FORM(number) c = FORM(sum)(FORM(times)(n[0], l->x), FORM(times)(n[1], l->y));

    return (struct FORM(form)){FORM(times)(n[0], l->right), FORM(times)(n[1], -(int64_t)l->down),
                               FORM(sum)(c, FORM(times)(n[2], l->w))};
}

static inline void FORM(cross)(const int64_t a[3], const int64_t b[3], FORM(number) n[3])
{
    n[0] = FORM(difference)(FORM(product)(a[1], b[2]), FORM(product)(a[2], b[1]));
    n[1] = FORM(difference)(FORM(product)(a[2], b[0]), FORM(product)(a[0], b[2]));
    n[2] = FORM(difference)(FORM(product)(a[0], b[1]), FORM(product)(a[1], b[0]));
}

/* Adds h m to n. */
static inline void FORM(add_scaled)(FORM(number) n[3], const FORM(number) m[3], int64_t h)
{
    for (int i = 0; i < 3; i++)
        n[i] = FORM(sum)(n[i], FORM(times)(m[i], h));
}

static inline void FORM(negate)(FORM(number) n[3])
{
    FORM(number) zero = FORM(product)(0, 0);

    for (int i = 0; i < 3; i++)
        n[i] = FORM(difference)(zero, n[i]);
}

static inline struct FORM(form) FORM(form_negated)(const struct FORM(form) * f)
{
    FORM(number) zero = FORM(product)(0, 0);

    return (struct FORM(form)){FORM(difference)(zero, f->x), FORM(difference)(zero, f->y),
                               FORM(difference)(zero, f->c)};
}
