/* web.h - a page's canvas, keyboard and pointer, in a worker of its browser: display, input and clock on functions that
 * the worker's script provides (tools/web/page/worker.js).
 *
 * Two of them let the script go on and return later, where the browser can suspend WebAssembly (JavaScript Promise
 * Integration): web_look and web_rest. Where it cannot, web_rest says so when there is nothing to do, and the input's
 * wait returns TIA_STOPPED: the loop ends, and its caller runs it again when there are events.
 */
#ifndef PORT_WEB_H
#define PORT_WEB_H

#include <tia/port.h>

/* The key that a pointer drags something else than the camera with: x and y of such a TIA_EVENT_POINT are by how much,
 * in 2^-16 of the display's width and height. */
#define WEB_DRAGGED 0x200

/* Data about a picture, in the layout that the script reads. */
struct web_frame {
    uint32_t number, crc, block, done, samples, spp;
    uint32_t differs[3];             /* pixels of an error map: by a level, by more, on another path */
    uint32_t light_count;            /* and which of them keys move */
    int32_t light, light_x, light_y; /* -1: none that has a place; in 2^-16 of the picture */
    uint32_t draw_us, key_us, relit;
    const void *state; /* what web_run goes on with */
    uint32_t state_size;
    uint32_t plays; /* it is one of many */
};

struct web_line {
    float ends[2][2]; /* x and y, pixels */
    uint32_t colour;  /* RGB565 */
};

struct web_screen {
    uint16_t width, height;
    tia_rgb565 *pixels;
    bool stays; /* wait has found that nothing can be waited for */
};

extern const struct tia_display web_display; /* the context is a struct web_screen */
extern const struct tia_input web_input;     /* likewise */
extern const struct tia_clock web_clock;     /* ignores its context */

/* Shows the screen's pixels, with what is known of them. */
void web_show(const struct web_screen *screen, const struct web_frame *frame);
void web_draw_lines(const struct web_line *lines, unsigned count);

/* Whether an event is there; the script goes on meanwhile. */
bool web_look(void);

/* The length of a file that the script has, or -1: it takes down the name. Then its bytes. */
int32_t web_file_size(const char *name, uint32_t length);
void web_file_read(const char *name, uint32_t length, void *bytes);

#endif
