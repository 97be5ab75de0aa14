#include "guardian.h"

#include <linux/kd.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "console/keeper.h"

static struct saved named(enum kind kind, const char *path)
{
    struct saved saved = {.kind = kind, .fd = -1};

    (void)snprintf(saved.path, sizeof saved.path, "%s", path);
    return saved;
}

/* ---- consoles, framebuffers, keyboards ---- */

int guardian_keep_vt(int fd, const char *path, unsigned back_to)
{
    struct saved saved = named(VT, path);

    saved.fd = fd;
    saved.was.vt.back_to = back_to;
    if (ioctl(fd, KDGETMODE, &saved.was.vt.kd_mode) != 0 || ioctl(fd, VT_GETMODE, &saved.was.vt.mode) != 0)
        return -1;
    return keeper_keep(&saved);
}

int guardian_keep_fb(const char *path, const struct fb_var_screeninfo *var)
{
    struct saved saved = named(FB, path);

    saved.was.fb = *var;
    return keeper_keep(&saved);
}

/* Returns an entry that is identified by its descriptor, since a process may have several keyboards, with long
 * names. */
static struct saved numbered(enum kind kind, int fd)
{
    struct saved saved = {.kind = kind, .fd = fd};

    (void)snprintf(saved.path, sizeof saved.path, "descriptor %d", fd);
    return saved;
}

int guardian_keep_keyboard(int fd)
{
    const struct saved saved = numbered(KEYBOARD, fd);

    return keeper_keep(&saved);
}

int guardian_keep_card(int fd)
{
    const struct saved saved = numbered(CARD, fd);

    return keeper_keep(&saved);
}

void guardian_forget_vt(const char *path)
{
    struct saved saved = named(VT, path);

    keeper_forget(&saved);
}

void guardian_forget_fb(const char *path)
{
    struct saved saved = named(FB, path);

    keeper_forget(&saved);
}

void guardian_forget_keyboard(int fd)
{
    struct saved saved = numbered(KEYBOARD, fd);

    keeper_forget(&saved);
}

void guardian_forget_card(int fd)
{
    struct saved saved = numbered(CARD, fd);

    keeper_forget(&saved);
}

/* ---- terminals ---- */

static bool describe_terminal(enum kind kind, int fd, struct saved *saved)
{
    struct stat s;

    *saved = (struct saved){.kind = kind, .fd = -1};
    if (ttyname_r(fd, saved->path, sizeof saved->path) != 0 || fstat(fd, &s) != 0)
        return false;
    saved->made = s.st_ctim;
    return true;
}

static bool describe_text(int fd, const char *text, struct saved *saved)
{
    if (!describe_terminal(TEXT, fd, saved) || strlen(text) >= sizeof saved->was.text)
        return false;
    (void)snprintf(saved->was.text, sizeof saved->was.text, "%s", text);
    return true;
}

int guardian_keep_terminal(int fd, const struct termios *raw)
{
    struct saved saved;

    if (!describe_terminal(TERMINAL, fd, &saved) || tcgetattr(fd, &saved.was.terminal.before) != 0)
        return -1;
    saved.was.terminal.raw = *raw;
    return keeper_keep(&saved);
}

/* Sends the stored modes, those before the first change, since the present modes may still be the raw ones. */
void guardian_keep_again(int fd)
{
    struct saved saved;

    if (describe_terminal(TERMINAL, fd, &saved))
        keeper_again(&saved);
}

void guardian_sync(void)
{
    keeper_sync();
}

unsigned guardian_put_back(void)
{
    return kept_put_back();
}

int guardian_keep_text(int fd, const char *text)
{
    struct saved saved;

    return describe_text(fd, text, &saved) ? keeper_keep(&saved) : -1;
}

void guardian_forget_terminal(int fd)
{
    struct saved saved;

    if (describe_terminal(TERMINAL, fd, &saved))
        keeper_forget(&saved);
}

void guardian_forget_text(int fd, const char *text)
{
    struct saved saved;

    if (describe_text(fd, text, &saved))
        keeper_forget(&saved);
}
