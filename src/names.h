/* names.h - every build's own names, so that all of them link into one program.
 *
 * The public functions keep their names in the product and get the prefix tia_f64_ and so on in
 * the other builds. Names that are not public get a prefix in every build.
 */
#ifndef TIA_NAMES_H
#define TIA_NAMES_H

#define NAMES_JOIN2(prefix, name) prefix##name
#define NAMES_JOIN(prefix, name) NAMES_JOIN2(prefix, name)
#define NAMES(name) NAMES_JOIN(NUM_PREFIX, name)

#ifdef NUM_RENAME
#define tia_view_size NAMES(view_size)
#define tia_view_init NAMES(view_init)
#define tia_view_set_lights NAMES(view_set_lights)
#define tia_hits_size NAMES(hits_size)
#define tia_hits_init NAMES(hits_init)
#define tia_hits_object NAMES(hits_object)
#define tia_trace NAMES(trace)
#define tia_light_tile NAMES(light_tile)
#define tia_render NAMES(render)
#endif

#define lattice_prepare NAMES(lattice_prepare)
#define lattice_reach NAMES(lattice_reach)
#define lattice_form NAMES(lattice_form)
#define lattice_square NAMES(lattice_square)
#define lattice_y NAMES(lattice_y)
#define span_size NAMES(span_size)
#define span_prepare NAMES(span_prepare)
#define span_set_lights NAMES(span_set_lights)
#define span_keep_nearer NAMES(span_keep_nearer)
#define span_trace NAMES(span_trace)
#define span_light NAMES(span_light)
#define ray_size NAMES(ray_size)
#define ray_prepare NAMES(ray_prepare)
#define ray_set_lights NAMES(ray_set_lights)
#define ray_trace NAMES(ray_trace)
#define ray_light NAMES(ray_light)
#define slice_run NAMES(slice_run)
#define sphere_prepare NAMES(sphere_prepare)
#define sphere_run NAMES(sphere_run)
#define sphere_distances NAMES(sphere_distances)
#define light_line_prepare NAMES(light_line_prepare)
#define shadow_line_prepare NAMES(shadow_line_prepare)
#define shade_run NAMES(shade_run)
#define rgb565_thresholds NAMES(rgb565_thresholds)
#define kernel_sphere NAMES(kernel_sphere)
#define kernel_sphere_inside NAMES(kernel_sphere_inside)
#define kernel_light NAMES(kernel_light)
#define kernel_lambert NAMES(kernel_lambert)
#define kernel_shadow NAMES(kernel_shadow)
#define kernel_add NAMES(kernel_add)
#define kernel_pack NAMES(kernel_pack)

#endif
