/* view_kind.h - the kinds of false colours. */
#ifndef TOOLS_VIEWS_VIEW_KIND_H
#define TOOLS_VIEWS_VIEW_KIND_H

enum view {
    VIEW_COLOUR,
    VIEW_DEPTH,  /* distance of the visible point */
    VIEW_NORMAL, /* shading normal at the visible point */
    VIEW_OBJECT, /* number of the visible object */
    VIEW_COST,   /* number of boxes, objects and faces that the pixel's rays are tested against */
    VIEW_LIGHT,  /* lights that reach the visible point */
    VIEW_PATH,   /* number of the pixel's rays */
    VIEW_COUNT
};

#endif
