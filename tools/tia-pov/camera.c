#include "pov.h"

#include <math.h>

/* The aspect ratio of the picture that POV-Ray renders. */
#define ASPECT "* image_width/image_height"

struct axes {
    struct point u, v, n;
};

static struct axes axes_of(const struct pov *pov)
{
    const struct tia_camera *c = &pov->scene->camera;
    struct axes axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

    if (c->up.x == 0 && c->up.y == 0 && c->up.z == 0)
        return axes;
    axes.n = pov_unit(pov_sum(pov_place(pov, c->eye), pov_scaled(pov_place(pov, c->reference), -1)));
    axes.u = pov_unit(pov_cross(pov_vec3(c->up), axes.n));
    axes.v = pov_cross(axes.n, axes.u);
    return axes;
}

/* Ends the camera's block, with the lens: POV-Ray 3.7 spreads its rays over a disc of a quarter of the aperture. */
static void end_camera(struct pov *pov, const struct axes *axes)
{
    const struct tia_lens *lens = pov->scene->lens;

    if (lens) {
        text_word(&pov->text, "aperture %.10g blur_samples 256 variance 0", 4 * pov_length(pov, lens->radius));
        pov_triple(pov, "focal_point",
                   pov_sum(pov_place(pov, pov->scene->camera.eye), pov_scaled(axes->n, -pov_length(pov, lens->focus))));
    }
    text_print(&pov->text, "\n}\n\n");
}

static void perspective(struct pov *pov, const struct axes *axes)
{
    const struct tia_camera *c = &pov->scene->camera;
    double height = 2 * tan(pov_q16(c->fov) * acos(-1) / 360);

    text_print(&pov->text, "camera {\n");
    pov_triple(pov, "perspective location", pov_place(pov, c->eye));
    pov_triple(pov, "direction", pov_scaled(axes->n, -1));
    pov_triple(pov, "right", pov_scaled(axes->u, height));
    text_word(&pov->text, ASPECT);
    pov_triple(pov, "up", pov_scaled(axes->v, height));
    end_camera(pov, axes);
}

/* Writes the window. Rays of a frustum go from the eye through the window at the distance near. Those of an
 * orthographic camera start in the window, whose centre is POV-Ray's location. */
static void window(struct pov *pov, const struct axes *axes)
{
    const struct tia_camera *c = &pov->scene->camera;
    const struct tia_window *w = &c->window;
    bool frustum = c->projection == TIA_FRUSTUM, wide = w->left == 0 && w->right == 0;
    double width = pov_length(pov, w->right) - pov_length(pov, w->left),
           height = pov_length(pov, w->top) - pov_length(pov, w->bottom);
    struct point across = pov_scaled(axes->u, (pov_length(pov, w->left) + pov_length(pov, w->right)) / 2);
    struct point centre =
        pov_sum(across, pov_scaled(axes->v, (pov_length(pov, w->bottom) + pov_length(pov, w->top)) / 2));
    struct point ahead = pov_scaled(axes->n, frustum ? -pov_length(pov, w->near) : -1);

    text_print(&pov->text, "camera {\n");
    text_word(&pov->text, frustum ? "perspective" : "orthographic");
    pov_triple(pov, "location", frustum ? pov_place(pov, c->eye) : pov_sum(pov_place(pov, c->eye), centre));
    pov_triple(pov, "direction", frustum ? pov_sum(ahead, centre) : ahead);
    pov_triple(pov, "right", pov_scaled(axes->u, wide ? height : width));
    if (wide)
        text_word(&pov->text, ASPECT);
    pov_triple(pov, "up", pov_scaled(axes->v, height));
    end_camera(pov, axes);
}

void pov_camera(struct pov *pov)
{
    struct axes axes = axes_of(pov);

    if (pov->scene->camera.projection == TIA_PERSPECTIVE)
        perspective(pov, &axes);
    else
        window(pov, &axes);
    if (pov->scene->camera.line)
        pov_note(pov, "camera: seen from the middle of its observer line");
    if (pov->scene->camera.samples > 1)
        pov_note(pov, "camera: %u samples per pixel are requested by povray's own option +A",
                 pov->scene->camera.samples);
}
