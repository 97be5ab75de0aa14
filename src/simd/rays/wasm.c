/* wasm.c - rays with fixed-width SIMD of WebAssembly: 2 doubles. */
#include "simd/isa/wasm.h"

#include "lanes.h"

#include "pixels_tmpl.h"
#include "seen_tmpl.h"
#include "walk_paths_tmpl.h"

SURE(wasm);
