/* view.h - what a pixel shows. */
#ifndef TOOLS_VIEWS_VIEW_H
#define TOOLS_VIEWS_VIEW_H

enum view {
    VIEW_COLOUR,
    VIEW_DEPTH,  /* the distance of what is seen */
    VIEW_NORMAL, /* its shading normal */
    VIEW_OBJECT, /* its number */
    VIEW_COST,   /* boxes, objects and faces that the pixel's rays are tested against */
    VIEW_LIGHT,  /* which lights arrive there */
    VIEW_PATH,   /* the pixel's rays */
    VIEW_COUNT
};

#endif
