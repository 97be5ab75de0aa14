/* vt.h - finds, takes and gives back one virtual console. Private to console.c. */
#ifndef PORT_COMMON_VT_H
#define PORT_COMMON_VT_H

#include <linux/vt.h>

#include "device.h"

struct vt {
    int fd;           /* -1: there is none */
    unsigned number;  /* /dev/ttyN */
    unsigned back_to; /* number of the console that was in front; 0: this one was */
    char path[16];
    char name[PORT_WHY]; /* name for messages; without a VT, the reason */
    int kd_mode;         /* kd_mode and mode: as vt_take found them */
    struct vt_mode mode;
};

/* Finds the console that a display would take. Changes nothing; vt_close when done with it. */
void vt_find(struct vt *vt);
void vt_close(struct vt *vt);

/* Switches to the console, in graphics mode if the display needs that. From now on the kernel sends `leave` to request
 * the console and `enter` when it is this process's again; both must be blocked. TIA_ERR_DEVICE and `why` when another
 * program has it; without the right to change its mode, fd becomes -1. */
int vt_take(struct vt *vt, bool graphics, int leave, int enter, char why[PORT_WHY]);
/* Repairs the state after a stop; true if the guardian answered the kernel meanwhile. From then on this process answers
 * again; *left: the guardian released the console. */
bool vt_resume(const struct vt *vt, int leave, int enter, bool *left);
/* Puts the mode back, and switches back to the console that was in front. */
void vt_give(struct vt *vt);

/* Answers `leave`; false when there was nothing to answer. */
bool vt_let_go(const struct vt *vt);
/* Answers `enter`. */
void vt_entered(const struct vt *vt);
/* True if the console is in front. */
bool vt_in_front(const struct vt *vt);

#endif
