/* shadows_report.h - the counts of tia-compare --shadows, as a table or as JSON, on standard output. */
#ifndef TIA_COMPARE_SHADOWS_REPORT_H
#define TIA_COMPARE_SHADOWS_REPORT_H

#include <stdbool.h>
#include <stdint.h>

#include <tia/scene.h>

/* The result of a technique in a scene. The counts are numbers of pixels; light is not compared where the visible
 * object differs from the reference's. */
struct shadows_row {
    const char *name;
    bool fits;              /* false: `fault` has the reason, and the members below it are not set */
    struct tia_fault fault; /* the scene's fault; if its `field` is NULL, a point is too far away */
    uint64_t objects, dark, lit, colours;
    uint64_t wall_us, cpu_us, bytes;
};

struct shadows_report {
    bool json;
    unsigned scenes; /* number of scenes so far */
};

/* Data common to the rows of a scene. */
struct shadows_table {
    const char *scene, *reference;
    unsigned width, height;
    uint64_t seen;  /* number of pixels with an object */
    unsigned light; /* number of the compared light; 0: all */
    const struct shadows_row *rows;
    unsigned count;
    const bool *is_closed; /* an element for each of the scene's meshes */
    uint32_t meshes;
};

void shadows_report_begin(const struct shadows_report *report);
void shadows_report_scene(struct shadows_report *report, const struct shadows_table *table);
void shadows_report_end(const struct shadows_report *report);

#endif
