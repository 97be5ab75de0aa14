/* guardian.h - a small process that restores the console if this process dies without restoring it.
 *
 * The first call of a guardian_keep_... function forks the guardian. The guardian stores the state that each such call
 * passes, and waits at a socket, which the kernel closes when this process dies, even by SIGKILL or SIGSEGV. Call
 * guardian_keep_... before changing something and guardian_forget_... after restoring it; when nothing is left to
 * restore, the guardian ends. If the guardian dies earlier, another one takes its place at once.
 *
 * Most devices are stored only by name. The guardian holds consoles and cards open, to release them on behalf of a
 * stopped process, and keyboards, whose grab has to outlast the process a little.
 */
#ifndef PORT_CONSOLE_GUARDIAN_H
#define PORT_CONSOLE_GUARDIAN_H

struct fb_var_screeninfo;
struct termios;

/* Each guardian_keep_... returns 0, or -1 if the state cannot be guarded (fork failed, or the table is full): go on
 * without a guardian. */

/* Stores the present modes of the VT `fd` (KD_TEXT, VT_AUTO), and the number of the VT to switch back to; 0: none. */
int guardian_keep_vt(int fd, const char *path, unsigned back_to);
/* Stores the modes of the terminal `fd` as they are now, before they become `raw`. Also returns -1 when `fd` is not a
 * terminal or has no name. */
int guardian_keep_terminal(int fd, const struct termios *raw);
/* Stores the mode and the position of a framebuffer device. */
int guardian_keep_fb(const char *path, const struct fb_var_screeninfo *var);
/* Guards a grabbed keyboard: if this process dies, the grab lasts until no key is down. */
int guardian_keep_keyboard(int fd);
/* Guards a DRM device. While this process is stopped, another console can use the device if the guardian runs as root.
 * Drop DRM master before guardian_forget_card: the guardian closes its descriptor only a moment later. */
int guardian_keep_card(int fd);
/* Stores a text of fewer than 96 bytes, to be written to the terminal `fd` at a stop or after the process's death, as
 * soon as the terminal accepts it. Also returns -1 when the terminal has no name. */
int guardian_keep_text(int fd, const char *text);

/* Returns the number of stops at which the guardian restored terminals. Where the kernel permits tracing, the guardian
 * restores the terminals of a stopped process, if it is in their foreground, before its parent is notified of the stop.
 * Read the count before guardian_keep_...: once the count has changed, the terminal has its former modes. To change the
 * terminal again, first call guardian_keep_again and guardian_keep_text, then guardian_sync. */
unsigned guardian_put_back(void);
/* Sends the entry of the terminal `fd` again, with the modes from before the first change. */
void guardian_keep_again(int fd);
/* Waits until the guardian is ready for the next stop. */
void guardian_sync(void);

/* Each guardian_forget_... reports that this process has restored a state. The arguments are those of
 * guardian_keep_...; a state that was not stored is ignored. */

void guardian_forget_vt(const char *path);
void guardian_forget_terminal(int fd);
void guardian_forget_text(int fd, const char *text);
void guardian_forget_fb(const char *path);
void guardian_forget_keyboard(int fd);
void guardian_forget_card(int fd);

#endif
