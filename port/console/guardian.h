/* guardian.h - a small process that puts the console back when this one dies without doing so.
 *
 * It is forked by the first guardian_keep_..., holds what each of them tells it, and sleeps on a
 * socket that every death closes, SIGKILL's and SIGSEGV's too. Call guardian_keep_... before
 * changing the thing and guardian_forget_... after putting it back; when nothing is left to keep
 * the guardian ends. If it dies before that, another one takes its place at once.
 *
 * Most things it knows by name only. It holds consoles and cards open to let go of them for a
 * process that is stopped, and keyboards to keep their grab for a while after a death.
 */
#ifndef PORT_CONSOLE_GUARDIAN_H
#define PORT_CONSOLE_GUARDIAN_H

struct fb_var_screeninfo;
struct termios;

/* Each is 0, or -1 when nobody guards it (fork failed, too many things): go on without. */

/* The text mode of a VT as it is now (KD_TEXT, VT_AUTO), and the VT to bring in front; 0: none. */
int guardian_keep_vt(int fd, const char *path, unsigned back_to);
/* The modes of the terminal `fd` as they are now, which are going to be `raw`. -1 also when it is no
 * terminal or has no name. */
int guardian_keep_terminal(int fd, const struct termios *raw);
/* The mode and the position of a framebuffer device. */
int guardian_keep_fb(const char *path, const struct fb_var_screeninfo *var);
/* A keyboard that is grabbed: after a death the grab lasts until no key is down. */
int guardian_keep_keyboard(int fd);
/* A DRM device. While this process is stopped, another console can have it, if the guardian is
 * root's. Drop the master's rights before this is forgotten: the guardian closes it a moment later. */
int guardian_keep_card(int fd);
/* What to write to the terminal `fd`, less than 96 bytes, as soon as it takes it. -1 also when the
 * terminal has no name. */
int guardian_keep_text(int fd, const char *text);

/* It has been put back. `path`, `fd` and `text` as given to keep. Safe when it was not kept. */
void guardian_forget_vt(const char *path);
void guardian_forget_terminal(int fd);
void guardian_forget_text(int fd, const char *text);
void guardian_forget_fb(const char *path);
void guardian_forget_keyboard(int fd);
void guardian_forget_card(int fd);

#endif
