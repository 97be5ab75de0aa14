/* vt_mark.h - who has a virtual terminal, in a place where another process finds it. */
#ifndef PORT_CONSOLE_VT_MARK_H
#define PORT_CONSOLE_VT_MARK_H

/* What the member of a VT's mode that the kernel keeps and does not use, waitv, says while one of
 * ours has the VT: all is well; the guardian answers for a stopped process; it has let go of the
 * console for that process. */
#define VT_MARK_TAKEN 't'
#define VT_MARK_ANSWERS 'a'
#define VT_MARK_LEFT 'l'

#endif
