#include "progress.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "clock.h"
#include "scenes.h"
#include "terminal/window_title.h"

/* Times. A drawing of less than half a second shows nothing; later a terminal is updated ten times a second, and other
 * outputs get a line once a second. */
enum { FIRST_US = 500000, STEP_US = 100000, LINE_US = 1000000 };

enum { LINE_SIZE = 256 };

static const char erase[] = "\r\033[K", title_restore[] = TITLE_RESTORE;

/* Erases the line, in the handler of a signal. */
static void undo(void *arg)
{
    struct progress *progress = arg;
    ssize_t wrote = 0; /* a failure has no remedy */
    if (progress->shown)
        wrote = write(STDERR_FILENO, erase, sizeof erase - 1);
    if (progress->titled)
        wrote = write(STDERR_FILENO, title_restore, sizeof title_restore - 1);
    (void)wrote;
}

void progress_begin(struct progress *progress, const struct options *options, uint64_t frame_pixels, uint32_t frames)
{
    *progress = (struct progress){.terminal = isatty(STDERR_FILENO) == 1,
                                  .asked = options->progress,
                                  .begun_us = clock_now_us(),
                                  .frame_work = frame_pixels,
                                  .frames = frames,
                                  .share = -1,
                                  .left = -1};
    progress->titles = progress->terminal && title_is_shown(getenv("TERM"));
    scenes_name(options, progress->name, sizeof progress->name);
    (void)pthread_mutex_init(&progress->lock, NULL);
    progress->next_us = progress->begun_us + (progress->terminal ? FIRST_US : LINE_US);
    progress->cleanup = (struct signals_cleanup){.undo = undo, .arg = progress};
    signals_add(&progress->cleanup);
}

bool progress_shows(const struct progress *progress)
{
    return progress->terminal || progress->asked;
}

void progress_start(struct progress *progress)
{
    (void)pthread_mutex_lock(&progress->lock);
    if (!progress->start_us)
        progress->start_us = clock_now_us();
    (void)pthread_mutex_unlock(&progress->lock);
}

void progress_weigh(struct progress *progress, uint64_t done, uint64_t all)
{
    (void)pthread_mutex_lock(&progress->lock);
    progress->done = done;
    progress->frame_work = all;
    (void)pthread_mutex_unlock(&progress->lock);
}

/* ---- the line ---- */

void progress_time(char text[PROGRESS_TIME], double seconds)
{
    unsigned whole = seconds < 1e9 ? (unsigned)(seconds + 0.5) : 1000000000;

    if (seconds < 9.95)
        (void)snprintf(text, PROGRESS_TIME, "%.1f s", seconds);
    else if (whole < 120)
        (void)snprintf(text, PROGRESS_TIME, "%u s", whole);
    else if (whole < 7200)
        (void)snprintf(text, PROGRESS_TIME, "%u min %02u s", whole / 60, whole % 60);
    else
        (void)snprintf(text, PROGRESS_TIME, "%u h %02u min", whole / 3600, whole / 60 % 60);
}

/* Returns the estimated number of seconds left; negative: nothing tells it yet. */
static double seconds_left(const struct progress *progress, uint64_t now)
{
    double all = (double)progress->frame_work * progress->frames, done = (double)progress->done,
           drawn = done - (double)progress->skipped;

    if (progress->left >= 0)
        return progress->left;
    return drawn > 0 && progress->start_us ? (double)(now - progress->start_us) / 1e6 * (all - done) / drawn : -1;
}

static unsigned percent(const struct progress *progress)
{
    double share = progress->share >= 0 ? progress->share
                                        : (double)progress->done / ((double)progress->frame_work * progress->frames);

    return share < 1 ? (unsigned)(share * 100) : 100;
}

/* Writes the line: the scene, how much is drawn and, if asked, the times. */
static void compose(const struct progress *progress, uint64_t now, char line[LINE_SIZE])
{
    char passed[PROGRESS_TIME], left[PROGRESS_TIME];
    double rest = seconds_left(progress, now);
    int used = snprintf(line, LINE_SIZE, "drawing%s%s: %3u %%", progress->name[0] ? " " : "", progress->name,
                        percent(progress));

    if (progress->text[0])
        used += snprintf(line + used, LINE_SIZE - (size_t)used, ", %s", progress->text);
    else if (progress->frames > 1)
        used += snprintf(line + used, LINE_SIZE - (size_t)used, ", %u of %u frames",
                         (unsigned)(progress->done / progress->frame_work), (unsigned)progress->frames);
    if (!progress->asked)
        return;
    progress_time(passed, (double)(now - progress->begun_us) / 1e6);
    used += snprintf(line + used, LINE_SIZE - (size_t)used, ", %s passed", passed);
    progress_time(left, rest < 0 ? 0 : rest);
    if (rest >= 0)
        (void)snprintf(line + used, LINE_SIZE - (size_t)used, ", %s left", left);
}

/* Cuts the line so that it stays in one row of the terminal. */
static void fit(char line[LINE_SIZE])
{
    struct winsize size;

    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1 && strlen(line) >= size.ws_col)
        line[size.ws_col - 1u] = '\0';
}

/* Sets the window's title: the scene and the percentage. */
static void set_title(struct progress *progress)
{
    char title[TITLE_SIZE], sequence[TITLE_SIZE];

    (void)snprintf(title, sizeof title, "%s %u %%", progress->name[0] ? progress->name : "tia", percent(progress));
    title_sequence(sequence, title);
    (void)fprintf(stderr, "%s%s", progress->titled ? "" : TITLE_SAVE, sequence);
    progress->titled = true;
}

static void print(struct progress *progress, uint64_t now)
{
    char line[LINE_SIZE];

    if (progress->titles)
        set_title(progress);
    compose(progress, now, line);
    if (progress->terminal)
        fit(line);
    (void)fprintf(stderr, progress->terminal ? "\r%s\033[K" : "%s\n", line);
    (void)fflush(stderr);
}

/* Shows the progress; the caller holds the lock. */
static void show(struct progress *progress, uint64_t now)
{
    if (now < progress->next_us)
        return;
    print(progress, now);
    progress->shown = progress->terminal;
    progress->next_us = now + (progress->terminal ? STEP_US : LINE_US);
}

/* ---- the work ---- */

static void add(struct progress *progress, uint64_t work, uint64_t known)
{
    uint64_t now = progress_shows(progress) ? clock_now_us() : 0;

    (void)pthread_mutex_lock(&progress->lock);
    progress->done += work;
    progress->skipped += known;
    if (progress_shows(progress) && progress->done < progress->frame_work * progress->frames)
        show(progress, now);
    (void)pthread_mutex_unlock(&progress->lock);
}

void progress_add(struct progress *progress, uint64_t work)
{
    add(progress, work, 0);
}

void progress_skip(struct progress *progress, uint64_t work)
{
    add(progress, work, work);
}

void progress_say(struct progress *progress, const char *text, double share, double left)
{
    (void)pthread_mutex_lock(&progress->lock);
    (void)snprintf(progress->text, sizeof progress->text, "%s", text);
    progress->share = share;
    progress->left = left;
    if (progress_shows(progress))
        show(progress, clock_now_us());
    (void)pthread_mutex_unlock(&progress->lock);
}

void progress_erase(struct progress *progress)
{
    if (progress->shown)
        (void)fputs(erase, stderr);
    progress->shown = false;
}

void progress_end(struct progress *progress)
{
    progress_erase(progress);
    if (progress->titled)
        (void)fputs(title_restore, stderr);
    progress->titled = false;
    signals_remove(&progress->cleanup);
}

void progress_drawn(void *progress, uint64_t pixels)
{
    if (pixels)
        progress_add(progress, pixels);
    else
        progress_erase(progress);
}
