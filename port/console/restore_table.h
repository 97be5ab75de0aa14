/* restore_table.h - the table of states that the guardian has to restore. Both processes have a copy; messages keep the
 * two the same. Private to the guardian's files. */
#ifndef PORT_CONSOLE_RESTORE_TABLE_H
#define PORT_CONSOLE_RESTORE_TABLE_H

#include <linux/fb.h>
#include <linux/vt.h>
#include <stdbool.h>
#include <sys/types.h>
#include <termios.h>
#include <time.h>

enum kind { NOTHING, VT, TERMINAL, TEXT, FB, KEYBOARD, CARD, THREADS, SYNC };

#define KEPT_TEXT 96

/* A console, terminal or device: its name, and the state to restore. */
struct saved {
    enum kind kind;
    bool forget;   /* in a message: remove the entry from the table */
    bool put_back; /* TERMINAL, TEXT: restored at a stop */
    char path[64];
    struct timespec made; /* TERMINAL, TEXT: the node's ctime, which a later terminal of the same name does not have */
    int fd;               /* VT, KEYBOARD, CARD: this process's descriptor of the device, else -1 */
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

/* Number of entries: enough for a display, its console, and as many keyboards as evdev.c opens. */
#define KEPT_MOST 40
extern struct saved kept[KEPT_MOST];

/* Returns the entry for the console, terminal or device of `like`, or NULL. */
struct saved *kept_find(const struct saved *like);
/* True if the table has an entry of this kind. */
bool kept_any(enum kind kind);
/* True if the table is empty. */
bool kept_nothing(void);

/* Allocates the memory that both processes share: the counts, numbers and answers below. Without that memory nothing is
 * counted, and no function waits. */
void kept_share(void);
/* Returns the number of the guardian in charge. */
unsigned kept_guardian(void);
/* Makes this process the guardian in charge, the successor of number `before`; false if `before` has a successor
 * already. */
bool kept_take_over(unsigned before);
/* Records that the guardian in charge has completed its work. */
void kept_finish(void);
/* True if the guardian with this number has completed its work. */
bool kept_is_finished(unsigned guardian);
/* Counts a stop at which terminals were restored. */
void kept_count_put_back(void);
/* Returns the number of stops at which terminals were restored. */
unsigned kept_put_back(void);
/* Answers a SYNC message. */
void kept_answer(void);
/* Drops old answers; call it before sending a SYNC message. */
void kept_forget_answers(void);
/* Waits for the answer to a SYNC message, timeout_ms at most. */
void kept_await_answer(int timeout_ms);

/* Applies a message to the table. Returns 0, or -1 when the table is full or lacks the entry to remove. */
int kept_note(const struct saved *message);

#endif
