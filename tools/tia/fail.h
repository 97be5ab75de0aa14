/* fail.h - error messages: one line, "tia: WHAT: WHY". */
#ifndef TOOLS_TIA_FAIL_H
#define TOOLS_TIA_FAIL_H

#include "common/scene/file.h"

/* The exit statuses. */
enum { EXIT_FINE, EXIT_RUNNING, EXIT_USAGE, EXIT_DISPLAY, EXIT_INPUT };

/* Prints "tia: " and the text to standard error. Control characters, as in odd file names, become '?', so that the
 * message is always one line. Returns `status`. */
__attribute__((format(printf, 2, 3))) int fail(int status, const char *format, ...);

/* Reports an invalid value of an option; `rule` is the reason. Returns EXIT_USAGE. */
int wrong(const char *option, const char *value, const char *rule);

/* Reports a scene file that was not read: all its mistakes with their lines or, into a text, the first one. Returns
 * `status`. */
int fail_scene(int status, struct scene_file *file);

/* Reports a failed write to standard output, by errno. Returns EXIT_RUNNING. */
int fail_output(void);

/* Names the command in later messages; "tia" at first. */
void fail_as(const char *name);

/* Sends later messages to text[size], where each replaces the one before; text NULL: to standard error, the default. */
void fail_into(char *text, size_t size);

/* Returns a message for a tia_status, for failures that have no other reason. */
const char *fail_reason(int status);

/* A view that could not be created: its scene, its lights and its size. */
struct fail_view {
    const struct tia_scene *scene;
    const struct tia_light *lights;
    uint32_t light_count;
    unsigned width, height;
};
/* Writes the reason for a failure to why[size]: after TIA_ERR_RANGE, the object or light that is too far away for the
 * scene's shadow technique. */
void fail_view_reason(char *why, size_t size, int status, const struct fail_view *view);

/* Prints a message as `fail` does, for a message that is not an error. */
__attribute__((format(printf, 1, 2))) void note(const char *format, ...);

#endif
