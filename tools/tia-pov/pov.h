/* pov.h - a scene in POV-Ray's language, 3.7.
 *
 * POV-Ray's camera names its own axes, so all coordinates stay as they are: its pictures are as
 * right-handed as ours when `right` is our u. Its rotations turn like ours by the numbers.
 */
#ifndef TIA_POV_POV_H
#define TIA_POV_POV_H

#include <tia/scene.h>

#include "common/text.h"

struct pov {
    struct text text;
    const char *path; /* of the scene in POV-Ray's language; "-": pictures have no place to go */
    char *why;        /* [PORT_WHY] */
    const struct tia_scene *scene;
    char note[200]; /* the last one: it is not repeated */
    bool failed;    /* a picture beside the scene could not be written; *why says why */
};

struct point {
    double x, y, z;
};

/* Writes the whole scene; what cannot be said is a comment there and a line on standard error. */
void pov_write(struct pov *pov, const char *source);

/* Its parts. */
void pov_camera(struct pov *pov);
void pov_lights(struct pov *pov);
void pov_materials(struct pov *pov);
void pov_shapes(struct pov *pov);

/* The material of an object of that shape, with what its texture needs to know of it: `shape` is NULL
 * for one without a shape of its own, a cell of a grid, as which it has got the coordinates of a mesh. */
void pov_material(struct pov *pov, uint32_t material, const struct tia_shape *shape);
/* Whether only an object of its own, unseen, casts the right shadow for it; and that one's material. */
bool pov_has_shadow(const struct pov *pov, uint32_t material);
void pov_shadow_material(struct pov *pov, uint32_t material, bool closed);

/* Whether a material has a texture. Its pigment, in tia's u, v, which lets `transmit` through: false when it
 * cannot be said. */
bool pov_textured(const struct pov *pov, uint32_t material);
bool pov_texture(struct pov *pov, uint32_t material, double transmit);
/* Whether it closes around a sphere: it repeats a whole number of times, checkers an even one. */
bool pov_closes(const struct pov *pov, uint32_t material);
/* Where POV-Ray looks a shape's pigment up: at the place itself where the shape is flat, else at the coordinates of
 * its own uv_mapping. And what takes a textured pigment there. */
bool pov_flat(const struct tia_shape *shape);
void pov_mapping(struct pov *pov, uint32_t material, const struct tia_shape *shape);

/* A mesh2 up to its material: of a mesh, a triangle, or a box with coordinates on its faces. */
void pov_mesh(struct pov *pov, const struct tia_mesh *mesh);
void pov_triangle(struct pov *pov, const struct tia_triangle *triangle);
void pov_box(struct pov *pov, struct tia_vec3 min, struct tia_vec3 max);

/* What POV-Ray has no words for. */
__attribute__((format(printf, 2, 3))) void pov_note(struct pov *pov, const char *format, ...);

double pov_q16(tia_q16 value);
double pov_q30(tia_q30 value);
struct point pov_vec3(struct tia_vec3 v);
struct point pov_dir3(struct tia_dir3 d); /* normalised */
struct point pov_rgb(struct tia_rgb c);
struct point pov_scaled(struct point a, double f);
struct point pov_sum(struct point a, struct point b);
struct point pov_cross(struct point a, struct point b);
struct point pov_unit(struct point a);
double pov_mean(struct point a);
bool pov_black(struct tia_rgb c);
/* light.h's axes A, B of a unit normal. */
void pov_axes(struct point normal, struct point *a, struct point *b);

/* "NAME <x, y, z>" as a word; NAME may be "". */
void pov_triple(struct pov *pov, const char *name, struct point p);

#endif
