/* arguments.h - parses the command line, and loads the scene. */
#ifndef TOOLS_TIA_ARGUMENTS_H
#define TOOLS_TIA_ARGUMENTS_H

#include "options.h"

/* Parses the command line. Returns COMMAND_RUN; or the exit status: EXIT_FINE after --help and --version, any other
 * after an error message. */
int arguments_parse(struct options *options, int argc, char **argv);

/* Sets the options to their defaults. */
void arguments_default(struct options *options);

/* Checks the options once the command line is parsed; argv has the scenes. Returns EXIT_FINE, or the exit status after
 * an error message. */
int arguments_check(struct options *options, int argc, char **argv);

/* Reads the scene and its keys; called after arguments_parse if something is to be drawn. Returns EXIT_FINE, or
 * EXIT_USAGE or EXIT_RUNNING after an error message. */
int arguments_load(struct options *options);

/* Prints the warnings about a scene. */
void arguments_warn(const struct scene_file *file);

/* Chooses the core and the scene for options->views, once the scene is loaded. */
void arguments_set_view(struct options *options);

/* Frees the options; safe at any time after arguments_parse. */
void arguments_free(struct options *options);

#endif
