#include "embree_waves.h"

#include <string.h>

#include "embree_shade.h"

#define SIDE 32 /* pixels of a tile's side */
#define TILE (SIDE * SIDE)
#define WAVE (16 * TILE) /* most rays of a wave: a picture with more is not drawn */
#define STREAM 64        /* rays of a stream */

/* A ray of the eye, or one that was sent on. */
struct wave_ray {
    struct float_ray ray;
    float throughput[3];
    unsigned pixel;
};

struct found {
    struct RTCHit hit;
    float far;
};

struct shadow {
    struct lighting lit; /* the part has the throughput in it */
    unsigned pixel;
};

struct wave {
    const struct embree *embree;
    enum embree_way way;
    bool first; /* the eye's rays, which are coherent, and their shadow rays */
    bool full;  /* it has no room for more rays */
    unsigned count, next_count, hits, shadow_count;
    struct wave_ray now[WAVE], next[WAVE];
    struct found found[WAVE];
    struct point point[WAVE];
    unsigned met[WAVE]; /* the ray of each point */
    struct shadow shadow[WAVE];
    bool dark[WAVE];
    float through[WAVE][3];
    float colour[TILE][3];
    struct RTCRayHit stream[STREAM];
    struct RTCRay shadow_stream[STREAM];
};

#define PACKET(name) name##8
#define N 8
#include "embree_packet_tmpl.h"
#undef N
#undef PACKET
#define PACKET(name) name##16
#define N 16
#include "embree_packet_tmpl.h"
#undef N
#undef PACKET

static void meet_stream(struct wave *w, struct embree_context *context, unsigned from)
{
    unsigned count = w->count - from < STREAM ? w->count - from : STREAM;

    for (unsigned i = 0; i < count; i++)
        start_ray(&w->stream[i], &w->now[from + i].ray, 1e30F);
    if (w->way == EMBREE_STREAMS)
        rtcIntersect1M(w->embree->made.scene, &context->context, w->stream, count, sizeof w->stream[0]);
    else
        for (unsigned i = 0; i < count; i++)
            rtcIntersect1(w->embree->made.scene, &context->context, &w->stream[i]);
    for (unsigned i = 0; i < count; i++)
        w->found[from + i] = (struct found){w->stream[i].hit, w->stream[i].ray.tfar};
}

static void shade_stream(struct wave *w, struct embree_context *context, unsigned from)
{
    unsigned left = w->shadow_count - from, count = left < STREAM ? left : STREAM;

    for (unsigned i = 0; i < count; i++) {
        const struct shadow *s = &w->shadow[from + i];
        w->shadow_stream[i] = ray_of(&s->lit.shadow, s->lit.distance);
        w->shadow_stream[i].id = from + i;
    }
    if (w->way == EMBREE_STREAMS)
        rtcOccluded1M(w->embree->made.scene, &context->context, w->shadow_stream, count, sizeof w->shadow_stream[0]);
    else
        for (unsigned i = 0; i < count; i++)
            rtcOccluded1(w->embree->made.scene, &context->context, &w->shadow_stream[i]);
    for (unsigned i = 0; i < count; i++)
        w->dark[from + i] = w->shadow_stream[i].tfar < 0;
}

/* A function that traces some rays of a wave, and their number. */
struct tracer {
    void (*run)(struct wave *w, struct embree_context *context, unsigned from);
    unsigned step;
};

static unsigned width_of(const struct wave *w)
{
    if (w->way == EMBREE_PACKETS_8 || (w->way == EMBREE_FIRST_8 && w->first))
        return 8;
    return w->way == EMBREE_PACKETS_16 || (w->way == EMBREE_FIRST_16 && w->first) ? 16 : 1;
}

static void run(struct wave *w, unsigned count, struct tracer by8, struct tracer by16, struct tracer by1)
{
    unsigned width = width_of(w);
    struct tracer tracer = width == 8 ? by8 : width == 16 ? by16 : by1;
    struct embree_context context;

    rtcInitIntersectContext(&context.context);
    context.context.flags = w->first ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    context.through = w->through;
    for (unsigned from = 0; from < count; from += tracer.step)
        tracer.run(w, &context, from);
}

static void add(struct wave *w, unsigned pixel, const float colour[3], const float by[3])
{
    for (int c = 0; c < 3; c++)
        w->colour[pixel][c] += colour[c] * by[c];
}

static void find_points(struct wave *w)
{
    const struct embree *e = w->embree;

    w->hits = 0;
    for (unsigned i = 0; i < w->count; i++) {
        const struct found *found = &w->found[i];
        if (found->hit.geomID == RTC_INVALID_GEOMETRY_ID) {
            add(w, w->now[i].pixel, e->background, w->now[i].throughput);
            continue;
        }
        w->met[w->hits] = i;
        find_point(e, &w->now[i].ray, &found->hit, found->far, &w->point[w->hits++]);
    }
}

static void add_light(struct wave *w, const struct embree_light *light)
{
    w->shadow_count = 0;
    for (unsigned k = 0; k < w->hits; k++) {
        const struct wave_ray *from = &w->now[w->met[k]];
        struct shadow *s = &w->shadow[w->shadow_count];
        if (!find_lighting(&w->point[k], light, &s->lit))
            continue;
        for (int c = 0; c < 3; c++) {
            s->lit.part[c] *= from->throughput[c];
            w->through[w->shadow_count][c] = 1;
        }
        s->pixel = from->pixel;
        w->shadow_count++;
    }
    run(w, w->shadow_count, (struct tracer){shade_8, 8}, (struct tracer){shade_16, 16},
        (struct tracer){shade_stream, STREAM});
    for (unsigned i = 0; i < w->shadow_count; i++)
        if (!w->dark[i])
            add(w, w->shadow[i].pixel, w->shadow[i].lit.part, w->through[i]);
}

static void send_on(struct wave *w)
{
    struct bounces bounces;

    for (unsigned k = 0; k < w->hits; k++) {
        const struct wave_ray *from = &w->now[w->met[k]];
        find_bounces(&w->point[k], &bounces);
        w->full = w->full || w->next_count + 2 > WAVE;
        for (int i = 0; i < bounces.count && !w->full; i++) {
            struct wave_ray *next = &w->next[w->next_count];
            next->ray = bounces.ray[i];
            next->pixel = from->pixel;
            w->next_count += scale_throughput(from->throughput, bounces.part[i], next->throughput);
        }
    }
}

static void draw_wave(struct wave *w, bool last)
{
    run(w, w->count, (struct tracer){meet_8, 8}, (struct tracer){meet_16, 16}, (struct tracer){meet_stream, STREAM});
    find_points(w);
    for (uint32_t i = 0; i < w->embree->given->light_count; i++)
        add_light(w, &w->embree->lights[i]);
    w->next_count = 0;
    if (!last)
        send_on(w);
    memcpy(w->now, w->next, w->next_count * sizeof w->now[0]);
    w->count = w->next_count;
    w->first = false;
}

/* Begins a tile: rays in blocks of 4 x 4 pixels. */
static void begin_tile(struct wave *w, const struct eye_rays *eye, unsigned left, unsigned top)
{
    w->count = 0;
    w->first = true;
    memset(w->colour, 0, sizeof w->colour);
    for (unsigned i = 0; i < TILE; i++) {
        unsigned block = i / 16, x = block % (SIDE / 4) * 4 + i % 4, y = block / (SIDE / 4) * 4 + i / 4 % 4;
        if (left + x < eye->width && top + y < eye->height)
            w->now[w->count++] = (struct wave_ray){eye_ray(eye, left + x, top + y), {1, 1, 1}, y * SIDE + x};
    }
}

static void draw_tile(struct wave *w, const struct eye_rays *eye, unsigned left, unsigned top, tia_rgb565 *pixels)
{
    begin_tile(w, eye, left, top);
    for (unsigned depth = 0; w->count && depth <= w->embree->depth; depth++)
        draw_wave(w, depth == w->embree->depth);
    for (unsigned i = 0; i < TILE; i++) {
        unsigned x = left + i % SIDE, y = top + i / SIDE;
        if (x < eye->width && y < eye->height)
            pixels[(size_t)y * eye->width + x] = pixel_of(w->colour[i]);
    }
}

bool embree_draw_waves(const struct embree *e, enum embree_way way, const struct eye_rays *eye, tia_rgb565 *pixels)
{
    static struct wave wave; /* of 4.6 MB, static so that no picture waits for new pages but the first */
    struct wave *w = &wave;

    w->embree = e;
    w->way = way;
    w->full = false;
    for (unsigned y = 0; y < eye->height && !w->full; y += SIDE)
        for (unsigned x = 0; x < eye->width && !w->full; x += SIDE)
            draw_tile(w, eye, x, y, pixels);
    return !w->full;
}
