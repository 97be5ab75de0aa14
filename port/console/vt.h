/* vt.h - finds, takes and releases one virtual console. Private to console.c. */
#ifndef PORT_COMMON_VT_H
#define PORT_COMMON_VT_H

#include <linux/vt.h>

#include "device.h"

struct vt {
    int fd;           /* -1: no console */
    unsigned number;  /* the N of /dev/ttyN */
    unsigned back_to; /* number of the console that was in front; 0: this one was */
    char path[16];
    char name[PORT_WHY]; /* name for messages; without a VT, the reason */
    int kd_mode;         /* text or graphics; this and `mode` are the modes before vt_take */
    struct vt_mode mode;
};

/* Finds the console that a display would take. Changes nothing; call vt_close at the end. */
void vt_find(struct vt *vt);
void vt_close(struct vt *vt);

/* Switches to the console, in graphics mode if `graphics`. From now on the kernel sends `leave` to request the console
 * and `enter` when this process has it again; both signals must be blocked. Returns TIA_OK, with fd = -1 if this
 * process may not change the console's mode, or TIA_ERR_DEVICE and `why` when another program has the console. */
int vt_take(struct vt *vt, bool graphics, int leave, int enter, char why[PORT_WHY]);
/* Makes this process answer the kernel again after a stop; true if the guardian answered meanwhile. *left becomes true
 * if the guardian released the console. */
bool vt_resume(const struct vt *vt, int leave, int enter, bool *left);
/* Restores the modes, and switches back to the console that was in front. */
void vt_give(struct vt *vt);

/* Answers the signal `leave` by releasing the console; false when the kernel expects no answer. */
bool vt_let_go(const struct vt *vt);
/* Answers the signal `enter`. */
void vt_entered(const struct vt *vt);
/* True if the console is in front. */
bool vt_in_front(const struct vt *vt);

#endif
