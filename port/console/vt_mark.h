/* vt_mark.h - marks of a virtual terminal, which show other processes who answers the kernel. */
#ifndef PORT_CONSOLE_VT_MARK_H
#define PORT_CONSOLE_VT_MARK_H

/* Values of vt_mode.waitv while tia has the VT. The kernel stores this member but does not use it. */
#define VT_MARK_TAKEN 't'   /* tia answers the kernel */
#define VT_MARK_ANSWERS 'a' /* the guardian answers the kernel for a stopped tia */
#define VT_MARK_LEFT 'l'    /* the guardian has released the VT for a stopped tia */

#endif
