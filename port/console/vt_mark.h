/* vt_mark.h - marks a virtual terminal for other processes: which process answers the kernel. */
#ifndef PORT_CONSOLE_VT_MARK_H
#define PORT_CONSOLE_VT_MARK_H

/* Values of vt_mode.waitv, which the kernel stores but does not use, while tia has the VT. */
#define VT_MARK_TAKEN 't'   /* tia answers the kernel */
#define VT_MARK_ANSWERS 'a' /* the guardian answers the kernel for a stopped tia */
#define VT_MARK_LEFT 'l'    /* the guardian has released the VT for a stopped tia */

#endif
