/* nff.h - the state of the .nff reader; see nff.c. */
#ifndef TIA_READ_NFF_NFF_H
#define TIA_READ_NFF_NFF_H

#include "read/readers.h"
#include "read/text/length.h"
#include "read/triangulation.h"

enum view { VIEW_V = 1, VIEW_FROM = 2, VIEW_AT = 4, VIEW_UP = 8, VIEW_ANGLE = 16, VIEW_ALL = 31 };

struct nff {
    struct tia_text text;
    struct tia_scene *scene;
    struct tia_lengths lengths;
    struct tia_array materials, lights, spheres, shapes, meshes, vertices, normals, faces, groups;
    struct tia_array fine_spheres, fine_shapes; /* further digits of the coordinates and radii */
    struct tia_fine fine;
    struct tia_mesh mesh; /* the mesh of the last f; open while it has vertices */
    bool transmits;       /* the last f is transparent: each of its polygons filters light separately */
    uint32_t polygons;
    struct polygon_corner *corners;
    uint32_t most_corners;
    unsigned view, backgrounds;

    const char *statement; /* the statement read last */
    struct tia_text rest;  /* the rest of its line */

    const struct tia_fault *fault; /* NULL, or the fault whose object is sought */
    const char *line;              /* NULL, or the first word of the view line with the fault */
};

/* Reads a sphere. */
int tia_nff_s(struct nff *n);
/* Reads a cylinder or cone. */
int tia_nff_c(struct nff *n);
/* Reads a polygon. */
int tia_nff_p(struct nff *n);
/* Reads a polygon with normals. */
int tia_nff_pp(struct nff *n);

/* Ends the open mesh, if there is one. */
void tia_nff_close_mesh(struct nff *n);

#endif
