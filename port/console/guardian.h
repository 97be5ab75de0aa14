/* guardian.h - a small process that puts the console back when this one dies without doing so.
 *
 * It is forked by the first guardian_keep_..., holds what each of them tells it, and sleeps on a
 * socket that every death closes, SIGKILL's and SIGSEGV's too. Call guardian_keep_... before
 * changing the thing and guardian_forget... after putting it back; when nothing is left to keep
 * the guardian ends. Everything is kept by the name of its node: the guardian holds no device
 * open, so that the kernel's own clean-up (of a DRM master, for one) is not held up.
 */
#ifndef PORT_COMMON_GUARDIAN_H
#define PORT_COMMON_GUARDIAN_H

struct fb_var_screeninfo;

/* Each is 0, or -1 when nobody guards it (fork failed, too many things): go on without. */

/* The text mode of a VT as it is now (KD_TEXT, VT_AUTO), and the VT to bring in front; 0: none. */
int guardian_keep_vt(const char *path, unsigned back_to);
/* The modes of the terminal `fd` as they are now. -1 also when it is no terminal or has no name. */
int guardian_keep_terminal(int fd);
/* The mode and the position of a framebuffer device. */
int guardian_keep_fb(const char *path, const struct fb_var_screeninfo *var);

/* The text that puts the screen of the terminal `fd` back when it is written to it, less than 64
 * bytes. -1 also when the terminal has no name. */
int guardian_keep_screen(int fd, const char *text);

/* It has been put back. `path` or `fd` as given to keep. Safe when it was not kept. */
void guardian_forget_vt(const char *path);
void guardian_forget_terminal(int fd);
void guardian_forget_screen(int fd);
void guardian_forget_fb(const char *path);

#endif
