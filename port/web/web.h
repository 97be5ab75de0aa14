/* web.h - display, input and clock of a web page, in a worker of the browser, built on functions that the worker's
 * script provides (tools/web/page/worker.js).
 *
 * If the browser can suspend WebAssembly (JavaScript Promise Integration), two of these functions, host_look and
 * host_rest, let the script run before they return. If the browser cannot, host_rest reports that, and the input's wait
 * returns TIA_STOPPED: the viewer's loop ends, and its caller runs it again when there are events.
 */
#ifndef PORT_WEB_H
#define PORT_WEB_H

#include <tia/port.h>

/* The key of a TIA_EVENT_POINT that drags something other than the camera: its x and y are the movement, in 2^-16 of
 * the display's width and height. */
#define WEB_DRAGGED 0x200

/* Data about a picture, in the layout that the script reads. */
struct web_frame {
    uint32_t number, crc, block, done, samples, spp;
    uint32_t differs[3];  /* error map: number of pixels that differ by one level, by more, by another path */
    uint32_t light_count; /* number of lights, including those that keys move */
    int32_t light, light_x,
        light_y; /* the light that keys move, -1: no light with a position; x and y in 2^-16 of the picture */
    uint32_t draw_us, key_us, relit;
    const void *state; /* state from which another worker can continue */
    uint32_t state_size;
    uint32_t plays;  /* not 0: the scene moves over time */
    uint32_t paused; /* not 0: a key has stopped it */
    int32_t time;    /* time of the picture, in 2^-16 s */
    uint32_t copied; /* share of the pixels, or of their samples, that other workers have drawn; in 2^-16 */
};

/* A frame that other workers may help to draw, in the layout that the script reads. */
struct web_share {
    const void *state; /* state of the frame, as in struct web_frame */
    uint32_t state_size;
    tia_rgb565 *pixels; /* receives the rows that other workers have drawn; NULL: parts of samples are wanted instead */
    uint8_t *have;      /* for each row, set to 1 after its pixels */
    uint32_t samples;   /* samples of a pixel of these rows; 0: all that the settings ask for */
};

struct web_line {
    float ends[2][2]; /* x and y of both ends, pixels */
    uint32_t colour;  /* RGB565 */
};

struct web_screen {
    uint16_t width, height;
    tia_rgb565 *pixels;
    bool stays; /* set by the input's wait if the browser cannot suspend WebAssembly */
};

extern const struct tia_display web_display; /* the display; its context is a struct web_screen */
extern const struct tia_input web_input;     /* the input; its context is a struct web_screen */
extern const struct tia_clock web_clock;     /* the clock; ignores its context */

/* Shows the screen's pixels, with the data of their frame. */
void web_show(const struct web_screen *screen, const struct web_frame *frame);
/* Draws lines over the pixels. */
void web_draw_lines(const struct web_line *lines, unsigned count);

/* Asks other workers for rows of a frame, which may arrive until the next call; NULL: rows are wanted no longer. */
void web_share(const struct web_share *share);

/* True if an event is pending. Lets the script run first, if the browser can. */
bool web_look(void);

/* Returns the size in bytes of a file that the script has. If it does not have the file, returns -1 and records the
 * name as missing. `length` is the length of `name`. */
int32_t web_file_size(const char *name, uint32_t length);
/* Copies the bytes of a file, as many as web_file_size returned. */
void web_file_read(const char *name, uint32_t length, void *bytes);

#endif
