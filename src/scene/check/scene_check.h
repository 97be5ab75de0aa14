/* scene_check.h - the parts of tia_scene_check. Functions return TIA_OK, or fill in the fault and return
 * TIA_ERR_RANGE. */
#ifndef TIA_SCENE_CHECK_SCENE_CHECK_H
#define TIA_SCENE_CHECK_SCENE_CHECK_H

#include "scene/cancel.h"
#include "scene/hull.h"

struct check;

/* Rules for parts of scenes other than spheres. */
struct check_more {
    /* enlarges the box around the camera's eye to cover every position that the eye may have */
    void (*eyes)(const struct tia_scene *scene, struct tia_bounds *eyes);
    int (*camera)(const struct check *check);
    int (*falling)(const struct check *check);
    int (*textures_of)(const struct check *check, const struct tia_material *material);
    /* checks all parts that are checked after spheres and lights */
    int (*parts)(struct check *check);
};

struct check {
    const struct check_more *more; /* NULL: only spheres are accepted */
    const struct tia_scene *scene;
    struct tia_fault *fault; /* may be NULL */
    struct tia_bounds eyes;  /* box around every position that the eye may have */
    const char *thing;       /* name of the kind of object being checked */
    uint32_t index;
    struct cancel *cancel; /* once stopped, TIA_STOPPED is returned */
};

/* Checks a scene as tia_scene_check does. */
int tia_check_scene(const struct tia_scene *scene, struct tia_fault *fault, struct cancel *cancel);
/* Checks a scene, in which objects other than spheres are not allowed. */
int tia_check_spheres(const struct tia_scene *scene, struct tia_fault *fault, struct cancel *cancel);
/* Checks a scene by the rules `more` or, if it is NULL, by those of tia_check_spheres. */
int tia_check_by(const struct check_more *more, const struct tia_scene *scene, struct tia_fault *fault,
                 struct cancel *cancel);

/* Sets *fault to a warning about an accepted scene; if there is none, all pointers in *fault are NULL. */
void tia_check_warn(const struct tia_scene *scene, struct tia_fault *fault);

#define CHECK_FAR "every point must be nearer to the eye than 32768"
#define CHECK_UNIT "each channel must be in 0..1"
#define CHECK_RADIUS "must be at least 2^-10"
#define CHECK_LENGTH "its length must be in 0.5..1.5"

/* Returns a fault from the enclosing function, which has a parameter `check`, unless the condition holds. */
#define REQUIRE(condition, field, rule)                                                                                \
    do {                                                                                                               \
        if (!(condition))                                                                                              \
            return tia_check_refuse(check, field, rule);                                                               \
    } while (0)

/* Calls `one` for each of `count` elements until one has a fault; check->index is the element's number. */
int tia_check_each(struct check *check, const char *thing, uint32_t count, int (*one)(const struct check *check));

/* Fills in the fault of the current element; returns TIA_ERR_RANGE. */
int tia_check_refuse(const struct check *check, const char *field, const char *rule);

/* True if all components are in 0..1. */
bool tia_check_is_unit(const struct tia_rgb *colour);
/* True if the squared length is in 1/4..9/4. */
bool tia_check_is_direction(const struct tia_dir3 *direction);
/* True if x is in least..most. */
bool tia_check_is_between(int32_t x, int32_t least, int32_t most);
bool tia_check_is_scale(struct tia_vec3 scale);
/* True if the points a and b, with components of at most 33 bits, are on one line through 0; always if one of them is
 * 0. */
bool tia_check_is_on_line(const int64_t a[3], const int64_t b[3]);

/* True if two points are at least 2^-10 apart. */
bool tia_check_are_apart(struct tia_vec3 a, struct tia_vec3 b);

/* True if all points of a ball are near every position of the eye: nearer than 32768. */
bool tia_check_is_near(const struct check *check, struct tia_vec3 centre, tia_q16 radius);
/* True if all points of a box are near every position of the eye. */
bool tia_check_is_box_near(const struct check *check, const struct bounds_wide *box);

/* Checks the camera; its window and its line of sight only by the rules for more than spheres. */
int tia_check_camera(const struct check *check);
/* Checks the camera's window and its line of sight. */
int tia_check_look(const struct check *check);

/* Checks the numbers of a material's textures. */
int tia_check_textures_of(const struct check *check, const struct tia_material *material);

/* ---- checks of element number check->index of a kind ---- */

int tia_check_material(const struct check *check);
int tia_check_texture(const struct check *check);
int tia_check_sphere(const struct check *check);
int tia_check_transform(const struct check *check);
int tia_check_mesh(const struct check *check);
int tia_check_grid(const struct check *check);
int tia_check_solid(const struct check *check);
int tia_check_shape(const struct check *check);
int tia_check_track(const struct check *check);
int tia_check_fall(const struct check *check);

/* ---- checks of the whole scene, and helpers ---- */

/* Checks gravity and the falling balls as a whole, if the scene has any. */
int tia_check_falling(const struct check *check);
/* True if shapes can be hidden: the scene's last mesh has no faces, see motion.h. */
bool tia_check_can_hide(const struct check *check);

int tia_check_light(const struct check *check, const struct tia_light *light);
/* True if all points of the light are near every position of the eye. */
bool tia_check_is_light_near(const struct check *check, const struct tia_light *light);

/* Checks that the box of a shape is near every position of the eye and, if the shape has a transform, not too flat. */
int tia_check_placed(const struct check *check, const struct tia_shape *shape, const struct bounds_wide *box);

/* Checks that a transformed box is not too flat; the shape has a transform. */
int tia_check_roundness(const struct check *check, const struct tia_shape *shape, const struct bounds_wide *box);

/* Checks the shapes that use meshes and grids, the scene's unit of length, and its fine digits. */
int tia_check_uses(struct check *check);

/* Checks the observer line and the light field. */
int tia_check_light_field(struct check *check);

/* Enlarges the box around all positions of the eye to cover the observer line at each of them. */
void tia_check_eyes(const struct tia_camera *camera, struct tia_bounds *eyes);

/* Checks the renderer's settings. */
int tia_check_rendering(struct check *check);
/* Checks the scene by the rules of its technique for shadows. */
int tia_check_shadows(struct check *check);

static inline bool check_is_array(const void *array, uint32_t count)
{
    return array || !count;
}

#endif
