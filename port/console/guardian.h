/* guardian.h - a small process that puts the console back when this one dies without doing so.
 *
 * The first guardian_keep_... forks it. It remembers what each of them passes, and sleeps on a socket that the kernel
 * closes however this process dies, by SIGKILL and SIGSEGV too. Call guardian_keep_... before changing something and
 * guardian_forget_... after putting it back; with nothing left to remember, the guardian ends. If it dies earlier,
 * another one takes its place at once.
 *
 * It knows most of them only by name. It keeps consoles and cards open, to release them on behalf of a stopped process,
 * and keyboards, whose grab has to outlast the process a little.
 */
#ifndef PORT_CONSOLE_GUARDIAN_H
#define PORT_CONSOLE_GUARDIAN_H

struct fb_var_screeninfo;
struct termios;

/* Each returns 0, or -1 when it cannot be guarded (fork failed, the table is full): go on without. */

/* The text mode of a VT as it is now (KD_TEXT, VT_AUTO), and the VT to switch back to; 0: none. */
int guardian_keep_vt(int fd, const char *path, unsigned back_to);
/* The modes of the terminal `fd` as they are now, before they become `raw`. Also -1 when it is no terminal or has no
 * name. */
int guardian_keep_terminal(int fd, const struct termios *raw);
/* The mode and the position of a framebuffer device. */
int guardian_keep_fb(const char *path, const struct fb_var_screeninfo *var);
/* A grabbed keyboard: if this process dies, the grab lasts until no key is down. */
int guardian_keep_keyboard(int fd);
/* A DRM device. While this process is stopped, another console can have it if the guardian runs as root. Drop DRM
 * master before guardian_forget_card: the guardian closes its descriptor only a moment later. */
int guardian_keep_card(int fd);
/* Text of less than 96 bytes to write to the terminal `fd` as soon as it accepts it. Also -1 when the terminal has no
 * name. */
int guardian_keep_text(int fd, const char *text);

/* Where the kernel lets it, the guardian puts back the terminals of a process that is stopped, too, before the parent
 * sees that: those that it has in front. The count of these times, to be read before guardian_keep_...; when it has
 * changed, the terminal is as it was before, and whoever changes it again calls guardian_keep_again and
 * guardian_keep_text first, and then guardian_sync: that waits until the guardian is ready for the next stop. */
unsigned guardian_put_back(void);
void guardian_keep_again(int fd);
void guardian_sync(void);

/* Reports that it has been put back. The arguments are those of guardian_keep_...; safe when nothing was kept. */
void guardian_forget_vt(const char *path);
void guardian_forget_terminal(int fd);
void guardian_forget_text(int fd, const char *text);
void guardian_forget_fb(const char *path);
void guardian_forget_keyboard(int fd);
void guardian_forget_card(int fd);

#endif
