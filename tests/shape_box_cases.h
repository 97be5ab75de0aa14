/* shape_box_cases.h - boxes, see shape_check.h. */
#include "shape_check.h"

struct box {
    real min[3], max[3];
};

static real part(struct vec p, int i)
{
    return i == 0 ? p.x : i == 1 ? p.y : p.z;
}

static struct vec axis_of(uint32_t face)
{
    real one = face & 1 ? 1 : -1;

    return (struct vec){face / 2 == 0 ? one : 0, face / 2 == 1 ? one : 0, face / 2 == 2 ? one : 0};
}

static real face_margin(const struct box *box, struct vec p, uint32_t face)
{
    real margin = 1e9L;

    for (int i = 0; i < 3; i++)
        if (i != (int)(face / 2))
            margin = least(margin, least(part(p, i) - box->min[i], box->max[i] - part(p, i)));
    return margin;
}

static bool face_candidate(const struct box *box, uint32_t face, struct vec o, struct vec d, struct candidate *found)
{
    int i = (int)(face / 2);
    real t = ((face & 1 ? box->max[i] : box->min[i]) - part(o, i)) / part(d, i);

    if (size(part(d, i)) < (real)0x1p-41)
        return false;
    *found = (struct candidate){t, face_margin(box, add(o, t, d), face), 1, face, axis_of(face)};
    return true;
}

static real face_distance(const struct box *box, struct vec p, uint32_t face)
{
    real off = part(p, (int)(face / 2)) - (face & 1 ? box->max : box->min)[face / 2];

    return most(size(off), -face_margin(box, p, face));
}

static void face_coordinates(const struct box *box, struct vec p, uint32_t face, real uv[2])
{
    int i = face / 2 == 0 ? 2 : 0, k = face / 2 == 1 ? 2 : 1;

    uv[0] = (part(p, i) - box->min[i]) / (box->max[i] - box->min[i]);
    uv[1] = (part(p, k) - box->min[k]) / (box->max[k] - box->min[k]);
}

static int box_candidates(const struct subject *s, struct vec o, struct vec d, struct candidate found[])
{
    int count = 0;

    for (uint32_t face = 0; face < 6; face++)
        count += face_candidate(s->what, face, o, d, &found[count]);
    return count;
}

static real box_distance(const struct subject *s, struct vec p, uint32_t element)
{
    return element > 5 ? 1e9L : face_distance(s->what, p, element);
}

static struct vec box_normal(const struct subject *s, struct vec p, uint32_t element)
{
    (void)s;
    (void)p;
    return axis_of(element);
}

static void box_coordinates(const struct subject *s, struct vec p, uint32_t element, real uv[2])
{
    face_coordinates(s->what, p, element, uv);
}

static real box_curvature(const struct subject *s, struct vec p, uint32_t element)
{
    const struct box *box = s->what;
    real smallest = box->max[0] - box->min[0];

    (void)p;
    (void)element;
    for (int i = 1; i < 3; i++)
        smallest = least(smallest, box->max[i] - box->min[i]);
    return 1 / smallest;
}

/* A point of a face; `near` its edges every second time. */
static struct vec any_of_face(const struct box *box, uint32_t face, bool near)
{
    real p[3];

    for (int i = 0; i < 3; i++) {
        double edge = near ? (chance() < 0 ? 0 : 1) + chance() * exp2(between(-40, -3)) : between(0, 1);
        p[i] = box->min[i] + edge * (box->max[i] - box->min[i]);
    }
    p[face / 2] = (face & 1 ? box->max : box->min)[face / 2];
    return (struct vec){p[0], p[1], p[2]};
}

static void check_box(double far, double smallest, double largest)
{
    struct tia_vec3 min = any_place(far), max = min;
    struct box box;
    struct subject s = {.what = &box,
                        .candidates = box_candidates,
                        .distance = box_distance,
                        .normal = box_normal,
                        .uv = box_coordinates,
                        .curvature = box_curvature};
    double scale = largest;

    for (int i = 0; i < 3; i++) {
        double edge = any_length(smallest, largest);
        *(i == 0 ? &max.x : i == 1 ? &max.y : &max.z) += (tia_q16)(edge * 65536);
        scale = edge < scale ? edge : scale;
        box.min[i] = part(position(min), i);
        box.max[i] = part(position(max), i);
    }
    s.extent = length(position(min)) + length(position(max));
    shape_box(&s.shape, &(struct tia_box){min, max});
    for (uint32_t i = 0; i < 18; i++)
        check_rays_through(&s, any_of_face(&box, i % 6, i > 8), axis_of(i % 6), scale);
}
