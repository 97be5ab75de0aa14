/* rounded.c - boxes with rounded edges and corners: all points within r of an inner box.
 *
 * The six planes of the inner box cut a ray's line into at most seven pieces. On a piece, each coordinate is below the
 * inner box, within it or above it, everywhere. Let v + t w be the line's coordinates relative to the nearest corner of
 * the inner box, with 0 for coordinates within it: the piece is inside the shape where |v + t w| <= r. So the surface
 * is a plane where one coordinate is not within, a cylinder where two are not, and a sphere where none is within. With
 * W = |w| and n = w/W,
 *
 *     t = (m -+ c)/W,   m = -v.n,   c = sqrt(r^2 - |v + m n|^2),
 *
 * the form of sphere.c, in which nothing cancels; a plane has c = r.
 *
 * The shape is convex, and so are the pieces of the line inside it. At the ends of a piece it is decided by the
 * coordinates themselves, exactly, whether they are inside. If one end is, the line crosses the surface on this piece;
 * the root is then kept between the ends, whatever its rounding. If none is, the line may only touch the shape within
 * the piece, which the two roots tell. So no crossing is lost between two pieces.
 *
 * The line's origin is first moved to the point nearest to the middle of the box, so that no number is much larger than
 * the shape. */
#include "box.h"
#include "crossings.h"
#include "math/noinline.h"

/* The line along one axis: the coordinate `origin` + t `speed`, the box without its rounding, and the t at which the
 * line meets the planes of the inner box. */
struct track {
    num_length origin, min, max;
    num_unit speed;
    num_length meets[2];
};

struct line {
    struct track axes[3];
    num_length radius, start; /* `start`: t of the ray at the moved origin */
    num_length lo, hi;        /* the part of the line within the outer box, from `from` on */
    bool cut;                 /* the part starts at `from` */
};

/* A piece of the line, and the crossings found so far. */
struct piece {
    num_length from, to;
    bool starts_inside, ends_inside;
    num_length *t;
    unsigned count, room;
};

/* Returns the excess of a coordinate over the inner box: 0 within it. */
static num_length excess(const struct line *line, int i, num_length at)
{
    num_length low = at - line->axes[i].min - line->radius, high = at - line->axes[i].max + line->radius;

    return low < 0 ? low : high > 0 ? high : 0;
}

static num_length coordinate(const struct line *line, int i, num_length t)
{
    return line->axes[i].origin + num_times(t, line->axes[i].speed);
}

static bool is_inside(const struct line *line, num_length t)
{
    struct num_point out = {excess(line, 0, coordinate(line, 0, t)), excess(line, 1, coordinate(line, 1, t)),
                            excess(line, 2, coordinate(line, 2, t))};

    return num_within(line->radius, out);
}

/* Clips the line to the outer box along one axis, and sets the track. */
static bool clip(struct line *line, int i, num_length origin, num_unit speed, num_length min, num_length max)
{
    num_divisor by = num_divisor_of(speed);
    num_length a = num_div_by(min - origin, by), b = num_div_by(max - origin, by);

    line->axes[i] =
        (struct track){origin,
                       min,
                       max,
                       speed,
                       {num_div_by(min + line->radius - origin, by), num_div_by(max - line->radius - origin, by)}};
    if (speed == 0)
        return origin >= min && origin <= max;
    line->lo = (a < b ? a : b) > line->lo ? (a < b ? a : b) : line->lo;
    line->hi = (a < b ? b : a) < line->hi ? (a < b ? b : a) : line->hi;
    return true;
}

static bool approach(const struct prepared_rounded *box, const struct ray *ray, const struct line_part *part,
                     struct line *line)
{
    const struct num_point *min = &box->box.min, *max = &box->box.max;
    struct num_point middle = {(min->x + max->x) / 2, (min->y + max->y) / 2, (min->z + max->z) / 2};
    struct num_point low = num_point_sub(*min, middle), high = num_point_sub(*max, middle);
    struct num_point o = num_point_sub(ray->origin, middle);

    line->start = -num_point_dot(o, ray->direction);
    line->radius = box->radius;
    line->lo = -NUM_LENGTH_MAX;
    line->hi = NUM_LENGTH_MAX;
    o = num_point_at(o, ray->direction, line->start);
    if (!clip(line, 0, o.x, ray->direction.x, low.x, high.x) || !clip(line, 1, o.y, ray->direction.y, low.y, high.y) ||
        !clip(line, 2, o.z, ray->direction.z, low.z, high.z))
        return false;
    if (line->lo > line->hi || line->start + line->hi < part->from || line->start + line->lo > part->limit)
        return false;
    line->cut = part->from - line->start > line->lo;
    line->lo = line->cut ? part->from - line->start : line->lo;
    return true;
}

/* Returns the t at which the piece that starts at `from` ends: the next plane of the inner box, or the end. */
static num_length end_of(const struct line *line, num_length from)
{
    num_length end = line->hi;

    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 2 && line->axes[i].speed != 0; k++)
            if (line->axes[i].meets[k] > from && line->axes[i].meets[k] < end)
                end = line->axes[i].meets[k];
    return end;
}

/* Adds a crossing. If rounding gives too many, the last one counts. */
static void add(const struct line *line, struct piece *piece, num_length t)
{
    piece->count -= piece->count == piece->room;
    piece->t[piece->count++] = line->start + num_length_clamp(t, piece->from, piece->to);
}

/* Adds the crossings on a piece. */
static void cross(const struct line *line, struct piece *piece)
{
    num_length middle = piece->from + (piece->to - piece->from) / 2, v[3] = {0, 0, 0};
    num_unit w[3] = {0, 0, 0};

    for (int i = 0; i < 3; i++) {
        const struct track *track = &line->axes[i];
        num_length side = excess(line, i, coordinate(line, i, middle));
        if (side == 0)
            continue;
        v[i] = track->origin - (side < 0 ? track->min + line->radius : track->max - line->radius);
        w[i] = track->speed;
    }
    struct num_dir along = {w[0], w[1], w[2]}, n = num_dir_normalised(along);
    struct num_point from = {v[0], v[1], v[2]};
    num_length m = -num_point_dot(from, n), c = num_half_chord(line->radius, num_point_at(from, n, m));
    num_unit speed = num_dir_dot(along, n);
    if (speed == 0)
        return;
    c = c < 0 && piece->starts_inside != piece->ends_inside ? 0 : c;
    num_length near = num_div(m - c, speed), far = num_div(m + c, speed);
    bool touches = !piece->starts_inside && !piece->ends_inside && c >= 0 && near <= piece->to && far >= piece->from;
    if (touches || (!piece->starts_inside && piece->ends_inside))
        add(line, piece, near);
    if (touches || (piece->starts_inside && !piece->ends_inside))
        add(line, piece, far);
}

NOINLINE unsigned rounded_crossings(const struct prepared_rounded *box, const struct ray *ray,
                                    const struct line_part *part, num_length t[ROUNDED_CROSSINGS])
{
    struct line line;
    struct piece piece = {.t = t};

    if (!approach(box, ray, part, &line))
        return 0;
    piece.from = line.lo;
    piece.starts_inside = line.cut && is_inside(&line, line.lo);
    piece.room = piece.starts_inside ? 1 : ROUNDED_CROSSINGS;
    do {
        piece.to = end_of(&line, piece.from);
        piece.ends_inside = piece.to < line.hi && is_inside(&line, piece.to);
        cross(&line, &piece);
        piece.from = piece.to;
        piece.starts_inside = piece.ends_inside;
    } while (piece.from < line.hi && piece.count < part->most);
    return piece.count;
}

static bool intersect(const struct shape *shape, const struct ray *ray, num_length limit,
                      struct intersection *intersection)
{
    const struct line_part ahead = {0, limit, 1};
    num_length t[ROUNDED_CROSSINGS];

    intersection->element = 0;
    if (!rounded_crossings(&shape->rounded, ray, &ahead, t))
        return false;
    intersection->t = t[0];
    return t[0] >= 0 && t[0] <= limit;
}

static bool chord_of(const struct shape *shape, const struct ray *ray, num_length after, struct chord *chord)
{
    const struct line_part whole = {-NUM_LENGTH_MAX, NUM_LENGTH_MAX, ROUNDED_CROSSINGS};
    num_length t[ROUNDED_CROSSINGS];
    unsigned count = rounded_crossings(&shape->rounded, ray, &whole, t);

    return crossings_chord(t, count, after, chord);
}

/* Returns the point minus the nearest point of the inner box. */
static struct num_point outwards(const struct prepared_rounded *box, struct num_point p)
{
    const struct num_point *min = &box->box.min, *max = &box->box.max;
    num_length r = box->radius;

    return num_point_sub(p, (struct num_point){num_length_clamp(p.x, min->x + r, max->x - r),
                                               num_length_clamp(p.y, min->y + r, max->y - r),
                                               num_length_clamp(p.z, min->z + r, max->z - r)});
}

static void surface_at(const struct shape *shape, struct num_point point, uint32_t element, struct surface *surface)
{
    (void)element;
    (void)num_normalise(outwards(&shape->rounded, point), &surface->normal);
    surface->smooth = surface->normal;
}

static num_length size_of(num_length x)
{
    return x < 0 ? -x : x;
}

static void uv_at(const struct shape *shape, struct num_point point, uint32_t element, num_length uv[2])
{
    struct num_point out = outwards(&shape->rounded, point);
    num_length x = size_of(out.x), y = size_of(out.y), z = size_of(out.z);
    uint32_t face = x >= y && x >= z ? 0 + (out.x > 0) : y >= z ? 2 + (out.y > 0) : 4 + (out.z > 0);

    (void)element;
    box_uv(&shape->rounded.box, point, face, uv);
}

static void prepare(struct shape *shape, const struct tia_scene *scene, const struct tia_shape *given)
{
    const struct tia_rounded *b = &given->rounded;

    (void)scene;
    shape->rounded.box = (struct prepared_box){num_point_of(b->min), num_point_of(b->max)};
    shape->rounded.radius = num_length_of(b->radius);
}

const struct shape_kind SHAPE_KIND(rounded) = {prepare, intersect, shape_occludes, surface_at, uv_at, chord_of};
