/* gl_scene.h - the built-in scene drawn by OpenGL, for comparison. */
#ifndef TESTS_GL_GL_SCENE_H
#define TESTS_GL_GL_SCENE_H

#include <tia/fixed.h>

struct gl_ball {
    double centre[3], radius, colour[3];
};

/* The visible object of a pixel, apart from lights. */
enum gl_thing { GL_GROUND, GL_BALL, GL_SKY };

enum { PICTURE_PIXELS = 640 * 480 };

struct picture {
    unsigned width, height;
    tia_rgb565 colour[PICTURE_PIXELS];
    unsigned char thing[PICTURE_PIXELS]; /* enum gl_thing */
    unsigned char lit[PICTURE_PIXELS];   /* 1: light arrives */
    unsigned char light[PICTURE_PIXELS]; /* 1: the light itself is visible; always 0 after gl_scene_draw */
};

/* Draws the scene with a library of the osmesa display into a picture whose size is set; a light of radius 0 is left
 * out. On failure returns false, and gives the reason in `why`, of PORT_WHY characters. */
bool gl_scene_draw(const char *library, const struct gl_ball *light, struct picture *picture, char *why);

#endif
