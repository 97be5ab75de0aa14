/* vt.h - one virtual console: found, taken, given back. console.c's own. */
#ifndef PORT_COMMON_VT_H
#define PORT_COMMON_VT_H

#include <linux/vt.h>

#include "device.h"

struct vt {
    int fd;           /* -1: there is none */
    unsigned number;  /* /dev/ttyN */
    unsigned back_to; /* the one that was in front, when it was not this one; 0: it was */
    char path[16];
    char name[PORT_WHY]; /* for people; without a VT, why there is none */
    int kd_mode;         /* what vt_take changes */
    struct vt_mode mode;
};

/* The console that a display would take. Changes nothing; vt_close when done with it. */
void vt_find(struct vt *vt);
void vt_close(struct vt *vt);

/* Brings it in front, in graphics mode where the display needs it, switched from now on by the
 * signals `leave` (may we?) and `enter` (it is yours), which must be blocked. TIA_ERR_DEVICE and
 * `why` when another program has it; where there is no right to change its mode, fd becomes -1. */
int vt_take(struct vt *vt, bool graphics, int leave, int enter, char why[PORT_WHY]);
/* After a stop: true when the guardian answered the kernel meanwhile, and no longer does; then `left`
 * says whether it let go of the console. */
bool vt_resume(const struct vt *vt, int leave, int enter, bool *left);
/* Puts back the mode, and the console in front. */
void vt_give(struct vt *vt);

/* Answers `leave`; false when there was nothing to answer. */
bool vt_let_go(const struct vt *vt);
/* Answers `enter`. */
void vt_entered(const struct vt *vt);
/* Is it in front? */
bool vt_in_front(const struct vt *vt);

#endif
