/* sequences.c - enumerates the sequences of planes that a search tries. */
#include "math/align.h"
#include "search.h"

size_t tia_radio_room_size(void)
{
    return sizeof(struct tia_radio_room);
}

bool tia_radio_can_search(const struct tia_radio *radio, const struct tia_radio_room *room,
                          const struct tia_radio_link *link)
{
    return radio && memory_is_usable(room) && link && link->order <= TIA_RADIO_ORDER_MAX &&
           link->walls <= TIA_RADIO_WALLS_MAX;
}

bool tia_radio_has_ends(const struct tia_radio_link *link)
{
    return link->from.x != link->to.x || link->from.y != link->to.y || link->from.z != link->to.z;
}

static void begin(struct tia_radio_room *room, const struct tia_radio *radio, const struct tia_radio_link *link)
{
    room->radio = radio;
    room->link = link;
    tia_radio_spot(&room->exact.got[0], link->to);
}

static int tell(struct tia_radio_room *room, uint32_t order)
{
    if (!tia_radio_find(room, order))
        return TIA_OK;
    return room->link->found(room->link->ctx, &room->found) ? TIA_OK : TIA_STOPPED;
}

/* Adds a plane to the sequence, and mirrors the receiver's image number `depth` in it. Returns false if no path can use
 * the plane. */
static bool mirror(struct tia_radio_room *room, uint32_t depth, uint32_t number)
{
    const struct radio_plane *plane = &room->radio->planes[number];
    struct number *n = room->exact.number;

    tia_radio_side(&n[0], plane, &room->exact.got[depth], &n[1]);
    if (n[0].sign == 0 || !plane->sides[n[0].sign < 0])
        return false;
    room->plane[depth] = number;
    tia_radio_mirror(&room->exact.got[depth + 1], plane, &room->exact.got[depth], &n[0], &n[1]);
    return true;
}

int tia_radio_try(const struct tia_radio *radio, struct tia_radio_room *room, const struct tia_radio_link *link,
                  const uint32_t *planes, uint32_t order)
{
    if (!tia_radio_can_search(radio, room, link) || !tia_radio_has_ends(link) || !link->found ||
        order > TIA_RADIO_ORDER_MAX || (order && !planes))
        return TIA_ERR_ARGUMENT;
    for (uint32_t i = 0; i < order; i++)
        if (planes[i] >= radio->plane_count)
            return TIA_ERR_ARGUMENT;
    begin(room, radio, link);
    for (uint32_t i = 0; i < order; i++)
        if (!mirror(room, i, planes[order - 1 - i]))
            return TIA_OK;
    return tell(room, order);
}

/* True if a part of a box, enlarged by `slack`, is on side s of a plane, 1 or -1. Only the farthest corner in that
 * direction needs to be tested. */
static bool reaches(const struct radio_plane *plane, const struct tia_bounds *box, int64_t slack, int s)
{
    int64_t at[3];

    for (int k = 0; k < 3; k++)
        at[k] = (plane->n[k] > 0) == (s > 0) ? radio_axis(&box->max, k) + slack : radio_axis(&box->min, k) - slack;
    return wide_sign(wide_difference(wide_dot(plane->n, at), radio_get(plane->d))) == s;
}

/* True if a wave reflected by faces of `before` can reach faces of `next`: each plane has faces that extend to a
 * reflecting side of the other. The fourth corner of a rotated box's side is up to 2 units off the side's plane, so
 * points of the side may be that far outside their corners' box. */
static bool can_follow(const struct radio_plane *before, const struct radio_plane *next)
{
    const struct radio_plane *pair[2] = {before, next};

    for (int i = 0; i < 2; i++) {
        const struct radio_plane *plane = pair[i], *other = pair[1 - i];
        if (other->endless || (plane->sides[0] && plane->sides[1]))
            continue;
        int64_t slack = other->square.high == 0 && other->square.low == 1 ? 0 : 8;
        if (!reaches(plane, &other->bounds, slack, plane->sides[0] ? 1 : -1))
            return false;
    }
    return true;
}

/* Searches depth first, from the receiver: next[] is the next plane to try at each depth. */
int tia_radio_images(const struct tia_radio *radio, struct tia_radio_room *room, const struct tia_radio_link *link)
{
    uint32_t next[TIA_RADIO_ORDER_MAX] = {0}, depth = 0;

    if (!tia_radio_can_search(radio, room, link) || !tia_radio_has_ends(link) || !link->found)
        return TIA_ERR_ARGUMENT;
    begin(room, radio, link);
    int status = tell(room, 0);
    while (!status && link->order > 0) {
        uint32_t number = next[depth]++;
        if (number >= radio->plane_count) {
            if (depth-- == 0)
                break;
            continue;
        }
        if (depth > 0 && (room->plane[depth - 1] == number ||
                          !can_follow(&radio->planes[number], &radio->planes[room->plane[depth - 1]])))
            continue;
        if (!mirror(room, depth, number))
            continue;
        status = tell(room, depth + 1);
        if (depth + 1 < link->order)
            next[++depth] = 0;
    }
    return status;
}

uint64_t tia_radio_sequences(const struct tia_radio *radio, uint32_t order)
{
    uint64_t sum = 1, last = 1;

    if (!radio)
        return 0;
    for (uint32_t i = 0; i < order && last; i++) {
        uint64_t choices = i == 0 ? radio->plane_count : radio->plane_count - 1u;
        struct tia_wide p = tia_wide_product(last, choices);
        if (p.high != 0 || sum + p.low < sum)
            return UINT64_MAX;
        last = p.low;
        sum += last;
    }
    return sum;
}
