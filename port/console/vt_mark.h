/* vt_mark.h - marks a virtual terminal with its owner, for other processes to read. */
#ifndef PORT_CONSOLE_VT_MARK_H
#define PORT_CONSOLE_VT_MARK_H

/* Values of vt_mode.waitv, which the kernel keeps but does not use, while tia has the VT: 't', tia answers the kernel;
 * 'a', the guardian answers for a stopped tia; 'l', the guardian has released the VT for it. */
#define VT_MARK_TAKEN 't'
#define VT_MARK_ANSWERS 'a'
#define VT_MARK_LEFT 'l'

#endif
