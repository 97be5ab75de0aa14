/* view.c - the camera. */
#include <math.h>

#include "convert.h"

/* ---- a model without camera and lights ---- */

/* Returns the distance from `middle` to the farthest corner of a face. */
static double radius_of(const struct convert *c, const double middle[3])
{
    double most = 0;

    for (uint32_t i = 0; i < c->use_count; i++) {
        const struct aiMesh *mesh = c->from->mMeshes[c->uses[i].mesh];
        for (unsigned v = 0; v < mesh->mNumVertices; v++) {
            double own[3] = {(double)mesh->mVertices[v].x, (double)mesh->mVertices[v].y, (double)mesh->mVertices[v].z};
            double at[3];
            affine_point(&c->uses[i].to_world, own, at);
            bool inside = vector_is_finite(at);
            for (int k = 0; k < 3; k++) {
                inside = inside && at[k] >= c->box.min[k] && at[k] <= c->box.max[k];
                at[k] -= middle[k];
            }
            most = inside ? fmax(most, vector_length(at)) : most;
        }
    }
    return most;
}

static int frame(struct convert *c)
{
    double middle[3];

    for (int i = 0; i < 3; i++)
        middle[i] = c->box.min[i] / 2 + c->box.max[i] / 2;
    double radius = ldexp(radius_of(c, middle), c->bits) * TIA_Q16_ONE;
    if (!(radius >= TIA_RADIUS_MIN))
        return convert_fail(c, TIA_ERR_RANGE, "all faces lie in one point, expected a model");
    c->pack.header.camera = tia_model_view(convert_place(c, middle), (uint64_t)ceil(radius), NULL);
    return TIA_OK;
}

/* ---- the camera of the file ---- */

/* Returns the field of view from below to above, in degrees. Importers give the one from left to right, but that of
 * glTF gives this one times the aspect, or without an aspect this one. */
static double field_of_view(const struct convert *c, const struct aiCamera *from)
{
    double given = (double)from->mHorizontalFOV, aspect = from->mAspect > 0 ? (double)from->mAspect : 4.0 / 3;
    double angle = !convert_is_gltf(c) ? 2 * atan(tan(given / 2) / aspect) : from->mAspect > 0 ? given / aspect : given;
    double degrees = angle * 180 / acos(-1.0);
    return degrees >= 1 && degrees <= 170 ? degrees : 40;
}

/* Sets the projection; that of an orthographic camera has half its width. */
static void set_projection(struct convert *c, struct tia_camera *camera, const struct aiCamera *from)
{
    double aspect = from->mAspect > 0 ? (double)from->mAspect : 4.0 / 3;
    double half = ldexp((double)from->mOrthographicWidth / aspect, c->bits);

    if (half > 0 && half < 1 << 14) {
        tia_q16 top = convert_fixed(half, TIA_Q16_ONE);
        camera->projection = TIA_ORTHOGRAPHIC;
        camera->window = (struct tia_window){.bottom = -top, .top = top};
    } else {
        camera->fov = convert_fixed(field_of_view(c, from), TIA_Q16_ONE);
    }
}

/* The directions of a camera: ahead and up. Returns false if they have none, or are too close to each other. */
static bool directions_of(const struct aiCamera *from, const struct affine *place, double ahead[3], double up[3])
{
    double own[3] = {(double)from->mLookAt.x, (double)from->mLookAt.y, (double)from->mLookAt.z};
    double own_up[3] = {(double)from->mUp.x, (double)from->mUp.y, (double)from->mUp.z};

    affine_vector(place, own, ahead);
    affine_vector(place, own_up, up);
    if (!vector_normalise(ahead) || !vector_normalise(up))
        return false;
    return fabs(ahead[0] * up[0] + ahead[1] * up[1] + ahead[2] * up[2]) < 0.99999;
}

/* Whether some of the model's box may be in a picture twice as wide as high. */
static bool sees_model(const struct convert *c, const double at[3], const double ahead[3], const double up[3],
                       double slope)
{
    double across[3] = {ahead[1] * up[2] - ahead[2] * up[1], ahead[2] * up[0] - ahead[0] * up[2],
                        ahead[0] * up[1] - ahead[1] * up[0]};
    unsigned outside = 31;

    for (unsigned corner = 0; corner < 8; corner++) {
        double x = 0, y = 0, z = 0;
        for (unsigned i = 0; i < 3; i++) {
            double to = (corner >> i & 1 ? c->box.max[i] : c->box.min[i]) - at[i];
            x += to * across[i], y += to * up[i], z += to * ahead[i];
        }
        outside &= (z <= 0 ? 1u : 0) | (x > 2 * slope * z ? 2u : 0) | (x < -2 * slope * z ? 4u : 0) |
                   (y > slope * z ? 8u : 0) | (y < -slope * z ? 16u : 0);
    }
    return outside == 0;
}

/* The target is ahead, as far away as the model's middle. */
static bool take_camera(struct convert *c, const struct aiCamera *from)
{
    struct affine place;
    double own[3] = {(double)from->mPosition.x, (double)from->mPosition.y, (double)from->mPosition.z};
    const double none[3] = {0, 0, 0};
    double at[3], ahead[3], up[3], to[3], target[3];

    (void)convert_node_place(c, &from->mName, &place);
    /* libassimp gives a camera of glTF the translation of its node once more */
    affine_point(&place, convert_is_gltf(c) ? none : own, at);
    if (!directions_of(from, &place, ahead, up) || !convert_reaches(c, at))
        return false;
    for (int i = 0; i < 3; i++)
        to[i] = at[i] - (c->box.min[i] / 2 + c->box.max[i] / 2);
    double distance = fmax(vector_length(to), ldexp(1, 8 - c->bits));
    for (int i = 0; i < 3; i++)
        target[i] = at[i] + distance * ahead[i];
    c->pack.header.camera =
        (struct tia_camera){.eye = convert_place(c, at),
                            .reference = convert_place(c, target),
                            .up = {convert_fixed(up[0], TIA_Q16_ONE), convert_fixed(up[1], TIA_Q16_ONE),
                                   convert_fixed(up[2], TIA_Q16_ONE)}};
    set_projection(c, &c->pack.header.camera, from);
    return c->pack.header.camera.projection == TIA_ORTHOGRAPHIC ||
           sees_model(c, at, ahead, up, tan(field_of_view(c, from) * acos(-1.0) / 360));
}

int convert_view(struct convert *c)
{
    if (!convert_lights(c))
        return convert_exhausted(c);
    int status = frame(c);
    struct tia_camera default_camera = c->pack.header.camera;
    if (status || c->from->mNumCameras == 0 || take_camera(c, c->from->mCameras[0]))
        return status;
    c->pack.header.camera = default_camera;
    convert_warn(c, TIA_WARN_RANGE, "the camera does not see the model: left out");
    return TIA_OK;
}
