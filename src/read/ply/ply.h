/* ply.h - the header of a .ply file, and the numbers behind it. */
#ifndef TIA_READ_PLY_PLY_H
#define TIA_READ_PLY_PLY_H

#include "read/model/plain.h"

#define PLY_ELEMENTS 16
#define PLY_PROPERTIES 256 /* of all elements */

enum ply_type { PLY_NONE, PLY_I8, PLY_U8, PLY_I16, PLY_U16, PLY_I32, PLY_U32, PLY_F32, PLY_F64 };

/* What a property means. */
enum ply_role {
    PLY_X,
    PLY_Y,
    PLY_Z,
    PLY_NX,
    PLY_NY,
    PLY_NZ,
    PLY_U,
    PLY_V,
    PLY_RED,
    PLY_GREEN,
    PLY_BLUE,
    PLY_ROLES,
    PLY_CORNERS = PLY_ROLES, /* the list of a polygon's vertices */
    PLY_OTHER
};

struct ply_property {
    uint8_t type, count_type, role; /* count_type: PLY_NONE, or that of a list's number of items */
};

enum ply_kind { PLY_UNKNOWN, PLY_VERTEX, PLY_FACE };

struct ply_element {
    enum ply_kind kind;
    uint32_t count, roles; /* roles: bit n if a property has role n */
    unsigned first, end;   /* the range of its properties */
};

struct ply {
    struct tia_plain *p;
    struct tia_text text;
    bool binary, big_endian;
    struct ply_element elements[PLY_ELEMENTS];
    struct ply_property properties[PLY_PROPERTIES];
    unsigned element_count, property_count;
    const char *at;    /* next byte of a binary file */
    const char *thing; /* the element being read, for messages: "vertex" */
    uint32_t number;   /* its number, from 1 */
};

/* Sets the error of the element being read; returns TIA_ERR_RANGE. */
int tia_ply_error(struct ply *ply, const char *why);

/* Reads the header; the next byte of a binary file is ply->at. */
int tia_ply_header(struct ply *ply);

/* Reads a number of a type with `bits` fractional bits, 0 to 32. The number must be below 2^31 in size. */
int tia_ply_number(struct ply *ply, uint8_t type, unsigned bits, int64_t *out);

/* Skips a number of any value in a binary file. */
int tia_ply_skip(struct ply *ply, uint8_t type);

#endif
