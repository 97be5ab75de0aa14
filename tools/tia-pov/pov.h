/* pov.h - writes a scene in the language of POV-Ray 3.7.
 *
 * All coordinates are those of the scene's file. POV-Ray is left-handed by default, but its camera defines its own
 * axes: with tia's u as `right`, its pictures are the same as tia's. The angles of rotations are the same, too.
 */
#ifndef TIA_POV_POV_H
#define TIA_POV_POV_H

#include <tia/scene.h>

#include "common/text_file.h"

struct pov {
    struct text text;
    const char *path; /* path of the output; "-": standard output, without picture files */
    char *why;        /* receives the reason of a failure, [PORT_WHY] */
    const struct tia_scene *scene;
    char note[200]; /* the last note, which is not repeated */
    bool failed;    /* writing a picture beside the scene failed; `why` has the reason */
};

struct point {
    double x, y, z;
};

/* Writes the whole scene. Properties that POV-Ray cannot express become a comment, and a line on standard error. */
void pov_write(struct pov *pov, const char *source);

void pov_camera(struct pov *pov);
void pov_lights(struct pov *pov);
void pov_materials(struct pov *pov);
void pov_shapes(struct pov *pov);

/* Writes the material for an object; its texture depends on the shape. `shape` is NULL for a cell of a grid, since
 * cells are written as meshes. */
void pov_material(struct pov *pov, uint32_t material, const struct tia_shape *shape);
/* True if the correct shadow needs a separate, invisible object. */
bool pov_has_shadow(const struct pov *pov, uint32_t material);
/* Writes the material of the invisible object for the shadow. */
void pov_shadow_material(struct pov *pov, uint32_t material, const struct tia_shape *shape);

/* True if a material has a texture, of its colour or as its opacity. */
bool pov_textured(const struct pov *pov, uint32_t material);
/* True if a material's colour has a texture on its surface: any but a noise. */
bool pov_coloured(const struct pov *pov, uint32_t material);
/* Writes the pigment as a function of tia's u, v, with the given `transmit`. Returns false if POV-Ray cannot express
 * it. */
bool pov_texture(struct pov *pov, uint32_t material, double transmit);
/* Writes the pigment of a material whose texture is a noise, in space, as near as POV-Ray's patterns are. Returns false
 * for other materials. */
bool pov_noise(struct pov *pov, uint32_t material, double transmit);
/* Writes the normal of a material whose bump is a noise, as near as POV-Ray's bumps are. */
void pov_bump(struct pov *pov, uint32_t material);
/* True if a material has an opacity that can be written. */
bool pov_has_opacity(const struct pov *pov, uint32_t material);
/* Declares the opacity as a pigment that is white where the opacity is 1. */
void pov_write_opacity(struct pov *pov, uint32_t material);
/* True if the texture has no seam around a sphere: it repeats a whole number of times; a checker, an even number. */
bool pov_closes(const struct pov *pov, uint32_t material);
/* True if POV-Ray evaluates a shape's pigment at the point itself; false if at its own uv_mapping's coordinates, which
 * not all shapes have. */
bool pov_plain(const struct tia_shape *shape);
/* Writes the mapping from u, v to the coordinates at which POV-Ray evaluates the pigment, see pov_plain. */
void pov_mapping(struct pov *pov, uint32_t material, const struct tia_shape *shape);

/* Stores the side and the caps of a textured cylinder or cone with caps as separate shapes, since their texture
 * coordinates differ. Returns their number; 0 for other shapes. */
unsigned pov_parts(const struct pov *pov, const struct tia_shape *shape, struct tia_shape parts[3]);

/* Writes a shape without its material; not for grids and solids. */
void pov_geometry(struct pov *pov, const struct tia_shape *shape);
/* True if a shape has an inside. */
bool pov_closed(const struct tia_scene *scene, const struct tia_shape *shape);

/* Writes a transform as words; nothing for number 0. */
void pov_transform(struct pov *pov, uint32_t transform);

/* Writes the shape of a solid's member, as POV-Ray's own solid object, without its material. */
void pov_solid_geometry(struct pov *pov, const struct tia_shape *member);
/* Writes a solid with its materials. */
void pov_solid(struct pov *pov, const struct tia_shape *shape);

/* Writes a mesh as a mesh2, without its material. */
void pov_mesh(struct pov *pov, const struct tia_mesh *mesh);
/* Writes a triangle as a mesh2, without its material. */
void pov_triangle(struct pov *pov, const struct tia_triangle *triangle);
/* Writes a box as a mesh2 with texture coordinates on its faces, without its material. */
void pov_box(struct pov *pov, struct tia_vec3 min, struct tia_vec3 max);

/* Notes a property that POV-Ray cannot express. */
__attribute__((format(printf, 2, 3))) void pov_note(struct pov *pov, const char *format, ...);

double pov_q16(tia_q16 value);
double pov_q30(tia_q30 value);
struct point pov_vec3(struct tia_vec3 v);
/* Converts a length to the unit of the scene's file. */
double pov_length(const struct pov *pov, tia_q16 length);
/* Converts a point to the unit of the scene's file. */
struct point pov_place(const struct pov *pov, struct tia_vec3 v);
struct point pov_dir3(struct tia_dir3 d); /* returns a normalised direction */
struct point pov_rgb(struct tia_rgb c);
struct point pov_scaled(struct point a, double f);
struct point pov_sum(struct point a, struct point b);
struct point pov_cross(struct point a, struct point b);
struct point pov_unit(struct point a);
double pov_mean(struct point a);
bool pov_black(struct tia_rgb c);
/* Computes the axes A and B that tia/light.h defines for a unit normal. */
void pov_axes(struct point normal, struct point *a, struct point *b);

/* Writes "NAME <x, y, z>" as a word; NAME may be "". */
void pov_triple(struct pov *pov, const char *name, struct point p);

#endif
