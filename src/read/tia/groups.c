/* groups.c - transforms within transforms.
 *
 * A shape is scaled, rotated and moved: p + R S x. An element with transform i, in a group with transform o, is placed
 * by
 *
 *     p_o + R_o S_o (p_i + R_i S_i x) = (p_o + R_o S_o p_i) + (R_o R_i) (S S_i) x   if S_o R_i = R_i S.
 *
 * Such a diagonal S exists if every inner axis, a column of R_i, mixes only outer axes of equal scale: if S_o is
 * uniform, if R_i turns by right angles, or if R_i turns about an axis and the other two axes have the same scale. All
 * other transforms would shear the shape, which no tia_transform can express; they are refused.
 *
 * Composition is in Q1.62 and Q31.32; a shape's transform is rounded once, at the end. Each of its angles then has an
 * error of 2^-17 degrees. If only one of the composed rotations is not 0, its angles stay as written. */
#include "math/rotation.h"
#include "math/wide.h"
#include "parse_state.h"

#define ONE_Q62 (INT64_C(1) << 62)
#define NOTHING (INT64_C(1) << 20)         /* 2^-42: a smaller component of an axis is 0, apart from rounding */
#define FARTHEST (INT64_C(1) << (18 + 32)) /* limit of a position, Q31.32 */
#define LEAST_SCALE ((int64_t)TIA_SCALE_MIN << 16)
#define MOST_SCALE ((int64_t)TIA_SCALE_MAX << 16)

static bool is_turned(const struct tia_vec3 *rotation)
{
    return rotation->x || rotation->y || rotation->z;
}

static struct tia_place place_of(const struct tia_transform *t)
{
    struct tia_place place = {
        .scale = {(int64_t)t->scale.x << 16, (int64_t)t->scale.y << 16, (int64_t)t->scale.z << 16},
        .position = {(int64_t)t->position.x * 65536, (int64_t)t->position.y * 65536, (int64_t)t->position.z * 65536},
        .rotation = t->rotation,
        .as_written = true};

    tia_rotation_axes(t->rotation, place.axes);
    return place;
}

/* Writes S: for each inner axis, the scale of the outer axes that it mixes. Returns false if their scales differ. */
static bool scale_along(const struct tia_place *outer, const struct tia_place *inner, int64_t scale[3])
{
    for (int i = 0; i < 3; i++) {
        scale[i] = 0;
        for (int k = 0; k < 3; k++) {
            if (inner->axes[i][k] < NOTHING && inner->axes[i][k] > -NOTHING)
                continue;
            if (scale[i] && scale[i] != outer->scale[k])
                return false;
            scale[i] = outer->scale[k];
        }
    }
    return true;
}

/* Writes R_o v, in v's format. */
static void turn(const struct tia_place *outer, const int64_t v[3], int64_t out[3])
{
    for (int k = 0; k < 3; k++) {
        const int64_t row[3] = {outer->axes[0][k], outer->axes[1][k], outer->axes[2][k]};
        out[k] = wide_round(wide_dot(row, v), 62);
    }
}

static void turn_axes(const struct tia_place *outer, const struct tia_place *inner, struct tia_place *out)
{
    out->as_written = false;
    for (int i = 0; i < 3; i++)
        turn(outer, inner->axes[i], out->axes[i]);
}

static void move(const struct tia_place *outer, const struct tia_place *inner, struct tia_place *out)
{
    int64_t scaled[3];

    for (int i = 0; i < 3; i++)
        scaled[i] = wide_round(wide_product(outer->scale[i], inner->position[i]), 32);
    turn(outer, scaled, out->position);
    for (int i = 0; i < 3; i++)
        out->position[i] += outer->position[i];
}

static int refuse(struct tia_parse *job, const char *what, const char *expected)
{
    return tia_text_error(&job->text, &job->first, what, expected);
}

/* Composes *place with the open groups. */
static int compose(struct tia_parse *job, struct tia_place *place)
{
    if (!job->group_count)
        return TIA_OK;
    const struct tia_place *outer = &job->groups[job->group_count - 1].place;
    const struct tia_place inner = *place;
    int64_t scale[3];

    if (!scale_along(outer, &inner, scale))
        return refuse(job, "would be sheared: it is rotated in a group that is scaled unevenly",
                      "one scale for that group, or the rotation around it");
    if (!inner.as_written || is_turned(&inner.rotation)) {
        if (!outer->as_written || is_turned(&outer->rotation))
            turn_axes(outer, &inner, place);
    } else {
        *place = *outer;
    }
    move(outer, &inner, place);
    for (int i = 0; i < 3; i++) {
        place->scale[i] = wide_round(wide_product(scale[i], inner.scale[i]), 32);
        if (place->scale[i] < LEAST_SCALE || place->scale[i] > MOST_SCALE)
            return refuse(job, "is scaled out of range with its groups", "1/1024 to 1024 in all");
        if (place->position[i] > FARTHEST || place->position[i] < -FARTHEST) {
            if (job->pass == TIA_FILLING)
                return refuse(job, "is moved out of range by its groups", "a place nearer to 0");
            place->position[i] = place->position[i] < 0 ? -FARTHEST : FARTHEST;
        }
    }
    return TIA_OK;
}

/* Rounds Q31.32 to Q16.16, to nearest, saturated. Returns false if a component does not fit. */
static bool rounded(const int64_t from[3], struct tia_vec3 *to)
{
    tia_q16 *const out[3] = {&to->x, &to->y, &to->z};
    bool fits = true;

    for (int i = 0; i < 3; i++) {
        int64_t q = tia_round_shift(from[i], 16);
        *out[i] = tia_saturate_s32(q);
        fits = fits && *out[i] == q;
    }
    return fits;
}

/* Composes a transform with the open groups. */
static int set_place(struct tia_parse *job, const struct tia_transform *transform, struct tia_place *place)
{
    *place = place_of(transform);
    int status = compose(job, place);
    if (!status && job->pass == TIA_COUNTING)
        tia_reach_group(&job->reach, place->position);
    return status;
}

bool tia_group_is_still(const struct tia_parse *job)
{
    const struct tia_place *p = &job->groups[job->group_count - 1].place;
    bool still = p->as_written && !is_turned(&p->rotation);

    for (int i = 0; i < 3; i++)
        still = still && !p->position[i] && p->scale[i] == INT64_C(1) << 32;
    return still;
}

int tia_group_place(struct tia_parse *job, struct tia_transform *transform, const struct tia_word *name)
{
    struct tia_place place;

    if (name && tia_parse_moves(job, name))
        return tia_text_error(&job->text, name, "moves", "it outside of groups");
    int status = set_place(job, transform, &place);
    if (status)
        return status;
    if (!rounded(place.position, &transform->position) && job->pass == TIA_FILLING)
        return refuse(job, "is moved out of range by its groups", "a place nearer to 0");
    (void)rounded(place.scale, &transform->scale);
    transform->rotation = place.rotation;
    if (!place.as_written)
        tia_rotation_angles((const int64_t(*)[3])place.axes, &transform->rotation);
    return TIA_OK;
}

static const struct tia_transform unmoved = {.scale = {TIA_Q16_ONE, TIA_Q16_ONE, TIA_Q16_ONE}};

static const struct tia_field group_fields[] = {
    {.word = "at", .kind = TIA_LENGTHS, .count = 3, .offset = offsetof(struct tia_transform, position)},
    {.word = "rotate", .kind = TIA_NUMBERS, .count = 3, .offset = offsetof(struct tia_transform, rotation)},
    {.word = "scale", .kind = TIA_SPREAD, .count = 3, .offset = offsetof(struct tia_transform, scale)},
};

static bool has_scale(const struct tia_transform *t)
{
    return t->scale.x >= TIA_SCALE_MIN && t->scale.x <= TIA_SCALE_MAX && t->scale.y >= TIA_SCALE_MIN &&
           t->scale.y <= TIA_SCALE_MAX && t->scale.z >= TIA_SCALE_MIN && t->scale.z <= TIA_SCALE_MAX;
}

/* Reads the fields of a group, a repeat block or an operation, and begins it as a group. If `what` is NULL, there are
 * no fields. */
static int begin_group(struct tia_parse *job, const char *what, struct tia_transform *transform)
{
    int status = TIA_OK;

    *transform = unmoved;
    if (what)
        status = tia_fields(&job->text, what, group_fields, TIA_COUNT_OF(group_fields), transform, NULL);
    if (status)
        return status;
    if (job->group_count == TIA_GROUP_DEPTH)
        return refuse(job, "is one too deep", "at most 8 groups within each other");
    if (!has_scale(transform))
        return refuse(job, "is scaled out of range", "1/1024 to 1024");
    job->groups[job->group_count].repeats = false;
    job->groups[job->group_count].operation = 0;
    job->groups[job->group_count].first = job->first;
    return TIA_OK;
}

int tia_line_group(struct tia_parse *job)
{
    struct tia_transform transform;
    int status = begin_group(job, "a group", &transform);

    status = status ? status : set_place(job, &transform, &job->groups[job->group_count].place);
    if (!status)
        job->group_count++;
    return status;
}

int tia_operation_begin(struct tia_parse *job, enum tia_solid_step step)
{
    bool first = !job->solid_groups;
    struct tia_transform transform;
    int status = begin_group(job, first ? NULL : "an operation", &transform);

    if (status)
        return status;
    struct tia_group *group = &job->groups[job->group_count];
    group->operation = (uint8_t)step;
    group->operands = 0;
    if (first)
        group->place = place_of(&transform);
    else
        status = set_place(job, &transform, &group->place);
    job->group_count++;
    job->solid_groups = first ? job->group_count : job->solid_groups;
    return status;
}

/* The first copy is where the block is, and each of the others in the one before it as a group in a group. */
int tia_line_repeat(struct tia_parse *job)
{
    struct tia_transform step;
    int64_t copies;
    int status = tia_text_integer(&job->text, &copies, 1, TIA_REPEATS_MAX);

    status = status ? status : begin_group(job, "a repeat block", &step);
    if (status)
        return status;
    struct tia_group *group = &job->groups[job->group_count];
    group->repeats = true;
    group->left = job->mistakes ? 0 : (uint32_t)copies - 1; /* mistakes are told in the first copy */
    group->step = step;
    group->body = job->text;
    status = set_place(job, &unmoved, &group->place);
    job->group_count++;
    job->repeat_count++;
    return status;
}

/* Goes back to the beginning of a repeat block for its next copy. */
static int go_back(struct tia_parse *job, struct tia_group *group)
{
    struct tia_place place;

    job->first = group->first;
    int status = set_place(job, &group->step, &place);
    group->place = place;
    group->left--;
    job->text = group->body;
    return status;
}

int tia_line_end(struct tia_parse *job)
{
    const struct tia_includes *includes = &job->includes;
    struct tia_group *group;

    if (job->mistakes && job->mistakes->deep) {
        job->mistakes->deep--;
        return TIA_OK;
    }
    if (job->group_count == (includes->depth ? includes->outer[includes->depth - 1].groups : 0))
        return refuse(job, "ends nothing", "a group before it, in the same file");
    int status = tia_text_end(&job->text);
    if (status && !tia_text_goes_on(&job->text))
        return status;
    if (job->mistakes)
        tia_mistake_closed(job, &job->first);
    tia_text_abandon(&job->text);
    group = &job->groups[job->group_count - 1];
    if (group->operation)
        return tia_operation_end(job);
    if (group->repeats && group->left)
        return go_back(job, group);
    job->group_count--;
    job->repeat_count -= group->repeats;
    return TIA_OK;
}
