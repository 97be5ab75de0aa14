/* kept.h - what the guardian keeps: a table that both processes have, and the messages that keep
 * the two alike. guardian.c's and guard.c's own. */
#ifndef PORT_CONSOLE_KEPT_H
#define PORT_CONSOLE_KEPT_H

#include <linux/fb.h>
#include <linux/vt.h>
#include <stdbool.h>
#include <sys/types.h>
#include <termios.h>
#include <time.h>

enum kind { NOTHING, VT, TERMINAL, TEXT, FB, KEYBOARD, CARD, WATCHER };

#define KEPT_TEXT 96

/* A thing that is kept: how to find it, and how it was. */
struct thing {
    enum kind kind;
    bool forget; /* of a message: it is kept no longer */
    char path[64];
    struct timespec made; /* TERMINAL, TEXT: the node's change time, which differs for another terminal */
    int fd;               /* VT, KEYBOARD, CARD: this process's descriptor of it, else -1 */
    union {
        struct {
            int kd_mode;
            struct vt_mode mode;
            unsigned back_to;
        } vt;
        struct {
            struct termios before, raw;
        } terminal;
        char text[KEPT_TEXT];
        struct fb_var_screeninfo fb;
        pid_t watcher; /* a message only: see guard.h */
    } was;
};

/* A display, its console and its input, with all the keyboards that evdev.c takes. */
#define THINGS 40
extern struct thing kept[THINGS];

/* The place of the same thing in the table, or NULL. */
struct thing *kept_find(const struct thing *like);
/* Is there anything of this kind? */
bool kept_any(enum kind kind);
bool kept_nothing(void);

/* Follows a message. -1: there is no room. */
int kept_note(const struct thing *message);

#endif
