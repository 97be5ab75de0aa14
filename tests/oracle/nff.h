/* nff.h - draws .nff files in double precision, from the numbers as written.
 *
 * The oracle of oracle.h starts from a scene in memory, whose coordinates a reader has rounded: it cannot show the
 * error of that rounding. This one reads the text itself. Its rays start a trillionth of the scene's size off a
 * surface, so it also shows the effect of the library's larger bias. */
#ifndef TESTS_ORACLE_NFF_H
#define TESTS_ORACLE_NFF_H

#include "shape.h"

enum nff_kind { NFF_SPHERE, NFF_CONE, NFF_POLYGON };

struct nff_material {
    double colour[3]; /* colour times Kd */
    double ks, shine, t, index;
    bool shines; /* the material has a highlight */
};

struct nff_thing {
    enum nff_kind kind;
    unsigned material;
    unsigned body; /* body that rays enter: a sphere or cone, or all polygons after the same f */
    struct oracle_vec min, max;
    struct oracle_vec point[2]; /* centre, or base and top */
    double radius[2];
    struct oracle_vec normal;         /* normal of a polygon, on its front */
    const struct oracle_vec *corner;  /* `count` corners */
    const struct oracle_vec *normals; /* normals at the corners of a triangle; NULL: none */
    unsigned count;
};

struct nff_light {
    struct oracle_vec at;
    double emission[3];
    bool coloured; /* the file gives the light a colour */
};

struct nff_tree {
    struct oracle_vec min, max;
    unsigned first, count; /* leaf: its objects; inner node: count is 0, and its two subtrees are the next node and
                              tree[first] */
};

struct nff {
    struct oracle_vec eye, look, up;
    double angle, background[3];
    double extent; /* size of the scene */
    struct nff_material *materials;
    struct nff_light *lights;
    struct nff_thing *things;
    struct nff_tree *trees;
    bool *closed; /* true for bodies that can be entered */
    unsigned material_count, light_count, thing_count, tree_count, body_count;
};

/* Reads the text of a file. Returns NULL if it is not valid. Free the result by nff_free. */
struct nff *nff_read(const char *text);
void nff_free(struct nff *nff);

/* Builds the tree of the objects, for nff_nearest. */
void nff_plant(struct nff *nff);

/* Returns the index of the nearest object on the ray, and stores the hit; thing_count and an infinite t if there is
 * none. */
unsigned nff_nearest(const struct nff *nff, struct ray ray, struct hit *hit);

/* Returns the fraction of white light that passes all objects on the ray up to t = 1. */
double nff_transmission(const struct nff *nff, struct ray ray);

/* Returns pixel (x, y) of a picture of that size. */
tia_rgb565 nff_pixel(const struct nff *nff, unsigned width, unsigned height, unsigned x, unsigned y);

#endif
