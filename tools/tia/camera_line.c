#include "camera_line.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* The fewest digits after the point that tell apart two numbers of Q16.16 times 2^-bits; trailing zeros are dropped. */
static int digits_for(int bits)
{
    int digits = (int)((16 + bits) * 0.30103) + 2;
    return digits < 0 ? 0 : digits;
}

static void append(char line[CAMERA_LINE], const char *word, int count, int digits, const double *values)
{
    size_t used = strlen(line);

    used += (size_t)snprintf(line + used, CAMERA_LINE - used, " %s", word);
    for (int i = 0; i < count && used < CAMERA_LINE; i++) {
        char number[64];
        (void)snprintf(number, sizeof number, "%.*f", digits, values[i]);
        if (strchr(number, '.')) {
            number[strspn(number, "-0123456789.")] = '\0';
            for (size_t last = strlen(number) - 1; number[last] == '0' || number[last] == '.'; last--) {
                bool point = number[last] == '.';
                number[last] = '\0';
                if (point)
                    break;
            }
        }
        used += (size_t)snprintf(line + used, CAMERA_LINE - used, " %s", strcmp(number, "-0") == 0 ? "0" : number);
    }
}

static void append_place(char line[CAMERA_LINE], const char *word, struct tia_vec3 at,
                         const struct tia_placement *placement)
{
    const double values[] = {ldexp(at.x, -16 - placement->bits) + ldexp((double)placement->origin[0], -32),
                             ldexp(at.y, -16 - placement->bits) + ldexp((double)placement->origin[1], -32),
                             ldexp(at.z, -16 - placement->bits) + ldexp((double)placement->origin[2], -32)};

    append(line, word, 3, digits_for(placement->bits), values);
}

void camera_line(char line[CAMERA_LINE], const struct tia_camera *camera, const struct tia_placement *placement)
{
    static const char *const names[] = {"camera", "camera frustum", "camera orthographic"};
    const struct tia_window *w = &camera->window;
    int bits = placement->bits;
    const double up[] = {ldexp(camera->up.x, -16), ldexp(camera->up.y, -16), ldexp(camera->up.z, -16)},
                 fov = ldexp(camera->fov, -16), near = ldexp(w->near, -16 - bits),
                 window[] = {ldexp(w->left, -16 - bits), ldexp(w->right, -16 - bits), ldexp(w->bottom, -16 - bits),
                             ldexp(w->top, -16 - bits)};

    (void)snprintf(line, CAMERA_LINE, "%s", names[camera->projection]);
    append_place(line, "eye", camera->eye, placement);
    if (camera->up.x || camera->up.y || camera->up.z) {
        append_place(line, "look", camera->reference, placement);
        append(line, "up", 3, digits_for(0), up);
    }
    if (camera->projection == TIA_PERSPECTIVE)
        append(line, "fov", 1, digits_for(0), &fov);
    else
        append(line, "window", 4, digits_for(bits), window);
    if (camera->projection == TIA_FRUSTUM)
        append(line, "near", 1, digits_for(bits), &near);
}
