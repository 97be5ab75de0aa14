/* sure_check.h - hooks of the templates for a build that traces the fixed-point ray beside each certified one
 * (SURE_CHECK, see tests/test_ray_bounds.c); in any other build they are empty. */
#ifndef TIA_SIMD_RAYS_SURE_CHECK_H
#define TIA_SIMD_RAYS_SURE_CHECK_H

#ifdef SURE_CHECK
struct query;
struct rays;
struct shade;
struct lit;
static void check_camera(const struct sure_block *b, const struct rays *r);
static void check_push(int item, bool refracted);
static void check_pop(int item);
static void check_met(const struct rays *r, const struct query *q);
static void check_surface(const struct shade *h);
static void check_own(const struct lit *lit);
static void check_shadow(unsigned lanes);
#else
#define check_camera(b, r) ((void)0)
#define check_push(item, refracted) ((void)0)
#define check_pop(item) ((void)0)
#define check_met(r, q) ((void)0)
#define check_surface(h) ((void)0)
#define check_own(lit) ((void)0)
#define check_shadow(lanes) ((void)0)
#endif

#endif
