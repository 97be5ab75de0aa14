/* kept.h - the table of what the guardian has to put back. Both processes have a copy; messages keep the two the same.
 * Private to the guardian's files. */
#ifndef PORT_CONSOLE_KEPT_H
#define PORT_CONSOLE_KEPT_H

#include <linux/fb.h>
#include <linux/vt.h>
#include <stdbool.h>
#include <sys/types.h>
#include <termios.h>
#include <time.h>

enum kind { NOTHING, VT, TERMINAL, TEXT, FB, KEYBOARD, CARD, THREADS, SYNC };

#define KEPT_TEXT 96

/* A console, terminal or device: how to find it, and the state to put back. */
struct saved {
    enum kind kind;
    bool forget;   /* in a message: remove it from the table */
    bool put_back; /* TERMINAL, TEXT: a stop has put it back */
    char path[64];
    struct timespec made; /* TERMINAL, TEXT: the node's ctime; a later terminal of the same name has another */
    int fd;               /* VT, KEYBOARD, CARD: this process's descriptor for it, else -1 */
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
        struct {
            pid_t reports, holds;
        } threads; /* in messages only: see traced.h */
    } was;
};

/* Enough for a display, its console, and as many keyboards as evdev.c takes. */
#define KEPT_MOST 40
extern struct saved kept[KEPT_MOST];

/* The table's entry for the same console, terminal or device, or NULL. */
struct saved *kept_find(const struct saved *like);
/* Does the table have an entry of this kind? */
bool kept_any(enum kind kind);
bool kept_nothing(void);

/* In memory that both processes share, from kept_share on; without that nothing is counted, and nobody waits. First,
 * how often a stop has put terminals back. Second, the guardian's answer to a SYNC message: the other process forgets
 * old ones before it sends that, and then waits timeout_ms at most. */
void kept_share(void);
/* Third, the number of the guardian in charge; and of the last one that has left nothing to do. The one after `before`
 * takes over, unless another process has: then false. */
unsigned kept_guardian(void);
bool kept_take_over(unsigned before);
void kept_finish(void);
bool kept_is_finished(unsigned guardian);
void kept_count_put_back(void);
unsigned kept_put_back(void);
void kept_answer(void);
void kept_forget_answers(void);
void kept_await_answer(int timeout_ms);

/* Does what a message says. 0, or -1: the table is full, or has nothing to remove. */
int kept_note(const struct saved *message);

#endif
