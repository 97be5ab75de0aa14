/* vt_mark.h - marks a virtual terminal with who has it, for other processes to read. */
#ifndef PORT_CONSOLE_VT_MARK_H
#define PORT_CONSOLE_VT_MARK_H

/* Values of vt_mode.waitv, which the kernel keeps but does not use, while tia has the VT: tia answers the kernel; the
 * guardian does, for a stopped tia; the guardian has released the VT for it. */
#define VT_MARK_TAKEN 't'
#define VT_MARK_ANSWERS 'a'
#define VT_MARK_LEFT 'l'

#endif
