#include "pov.h"

#include <math.h>

double pov_q16(tia_q16 value)
{
    return value / 65536.0;
}

double pov_q30(tia_q30 value)
{
    return value / 1073741824.0;
}

struct point pov_vec3(struct tia_vec3 v)
{
    return (struct point){pov_q16(v.x), pov_q16(v.y), pov_q16(v.z)};
}

double pov_length(const struct pov *pov, tia_q16 length)
{
    return ldexp(pov_q16(length), -(int)pov->scene->scale_bits);
}

struct point pov_place(const struct pov *pov, struct tia_vec3 v)
{
    return (struct point){pov_length(pov, v.x), pov_length(pov, v.y), pov_length(pov, v.z)};
}

struct point pov_dir3(struct tia_dir3 d)
{
    return pov_unit((struct point){pov_q30(d.x), pov_q30(d.y), pov_q30(d.z)});
}

struct point pov_rgb(struct tia_rgb c)
{
    return (struct point){pov_q30(c.r), pov_q30(c.g), pov_q30(c.b)};
}

struct point pov_scaled(struct point a, double f)
{
    return (struct point){a.x * f, a.y * f, a.z * f};
}

struct point pov_sum(struct point a, struct point b)
{
    return (struct point){a.x + b.x, a.y + b.y, a.z + b.z};
}

struct point pov_cross(struct point a, struct point b)
{
    return (struct point){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

struct point pov_unit(struct point a)
{
    return pov_scaled(a, 1 / sqrt(a.x * a.x + a.y * a.y + a.z * a.z));
}

double pov_mean(struct point a)
{
    return (a.x + a.y + a.z) / 3;
}

bool pov_black(struct tia_rgb c)
{
    return c.r == 0 && c.g == 0 && c.b == 0;
}

void pov_axes(struct point n, struct point *a, struct point *b)
{
    double x = fabs(n.x), y = fabs(n.y), z = fabs(n.z);
    struct point e = {0};

    if (x <= y && x <= z)
        e.x = 1;
    else if (y <= z)
        e.y = 1;
    else
        e.z = 1;
    *a = pov_unit(pov_cross(e, n));
    *b = pov_cross(n, *a);
}

void pov_triple(struct pov *pov, const char *name, struct point p)
{
    text_word(&pov->text, "%s%s<%.10g, %.10g, %.10g>", name, *name != '\0' ? " " : "", p.x, p.y, p.z);
}

void pov_transform(struct pov *pov, uint32_t transform)
{
    if (transform == 0)
        return;
    const struct tia_transform *t = &pov->scene->transforms[transform - 1];
    pov_triple(pov, "scale", pov_vec3(t->scale));
    pov_triple(pov, "rotate", pov_vec3(t->rotation));
    pov_triple(pov, "translate", pov_place(pov, t->position));
}
