/* embree_packet_tmpl.h - the template of packets of N rays: PACKET(name) is name and N.
 *
 * Defines meet_N() and shade_N(), which trace the rays and the shadow rays of a wave from number `from` on. */

static void PACKET(set_ray_)(struct PACKET(RTCRay) * to, int i, const struct float_ray *ray, float far, unsigned id)
{
    to->org_x[i] = ray->origin.x;
    to->org_y[i] = ray->origin.y;
    to->org_z[i] = ray->origin.z;
    to->dir_x[i] = ray->direction.x;
    to->dir_y[i] = ray->direction.y;
    to->dir_z[i] = ray->direction.z;
    to->tnear[i] = to->time[i] = 0;
    to->tfar[i] = far;
    to->mask[i] = UINT32_MAX;
    to->flags[i] = 0;
    to->id[i] = id;
}

static void PACKET(meet_)(struct wave *w, struct embree_context *context, unsigned from)
{
    struct PACKET(RTCRayHit) packet;
    int valid[N] __attribute__((aligned(64))), count = (int)(w->count - from < N ? w->count - from : N);

    for (int i = 0; i < N; i++) {
        unsigned k = from + (unsigned)(i < count ? i : 0);
        valid[i] = i < count ? -1 : 0;
        PACKET(set_ray_)(&packet.ray, i, &w->now[k].ray, 1e30F, k);
        packet.hit.geomID[i] = packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
    PACKET(rtcIntersect)(valid, w->embree->made.scene, &context->context, &packet);
    for (int i = 0; i < count; i++)
        w->found[from + (unsigned)i] = (struct found){{.geomID = packet.hit.geomID[i],
                                                       .primID = packet.hit.primID[i],
                                                       .u = packet.hit.u[i],
                                                       .v = packet.hit.v[i],
                                                       .Ng_x = packet.hit.Ng_x[i],
                                                       .Ng_y = packet.hit.Ng_y[i],
                                                       .Ng_z = packet.hit.Ng_z[i]},
                                                      packet.ray.tfar[i]};
}

static void PACKET(shade_)(struct wave *w, struct embree_context *context, unsigned from)
{
    struct PACKET(RTCRay) packet;
    unsigned left = w->shadow_count - from;
    int valid[N] __attribute__((aligned(64))), count = (int)(left < N ? left : N);

    for (int i = 0; i < N; i++) {
        const struct shadow *s = &w->shadow[from + (unsigned)(i < count ? i : 0)];
        valid[i] = i < count ? -1 : 0;
        PACKET(set_ray_)(&packet, i, &s->lit.shadow, s->lit.distance, from + (unsigned)i);
    }
    PACKET(rtcOccluded)(valid, w->embree->made.scene, &context->context, &packet);
    for (int i = 0; i < count; i++)
        w->dark[from + (unsigned)i] = packet.tfar[i] < 0;
}
