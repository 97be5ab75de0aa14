/* view_kind.h - the kinds of false colours. */
#ifndef TOOLS_VIEWS_VIEW_KIND_H
#define TOOLS_VIEWS_VIEW_KIND_H

enum view {
    VIEW_COLOUR,
    VIEW_DEPTH,  /* distance of the visible point */
    VIEW_NORMAL, /* its shading normal */
    VIEW_OBJECT, /* its object's number */
    VIEW_COST,   /* boxes, objects and faces that the pixel's rays are tested against */
    VIEW_LIGHT,  /* the lights that arrive there */
    VIEW_PATH,   /* the pixel's rays */
    VIEW_COUNT
};

#endif
