# bench.mk - builds the measuring program; the Makefile includes it.

# TINYGL=FOLDER: a built TinyGL, to compare the rasteriser with. The program linked with it is bench-tinygl. TinyGL's own
# Makefile uses OpenMP.
TINYGL ?=
TINYGL_LIB := $(if $(TINYGL),$(firstword $(wildcard $(addprefix $(TINYGL)/,lib/libTinyGL.a src/libTinyGL.a libTinyGL.a))))
ifneq ($(TINYGL),)
$(if $(and $(TINYGL_LIB),$(wildcard $(TINYGL)/include/zbuffer.h)),,$(error TINYGL=$(TINYGL): no include/zbuffer.h or no lib/libTinyGL.a there))
endif
BENCH := $(BUILD)/bench$(if $(TINYGL),-tinygl)
$(if $(TINYGL),$(BENCH): LIBS += -lgomp)
$(if $(filter yes,$(OSMESA)),$(BENCH): LDFLAGS += -Xlinker --wrap=tia_raster_draw)

# Embree 3, found by its header since Debian's package has no pkg-config file. EMBREE=no leaves it out, and so does a cross
# compiler.
EMBREE ?= $(if $(and $(NATIVE),$(wildcard /usr/include/embree3/rtcore.h /usr/local/include/embree3/rtcore.h)),yes,no)
EMBREE_SRC := $(addprefix bench/embree/,$(if $(filter yes,$(EMBREE)),embree_world.c embree_draw.c embree_items.c embree_scene.c embree_waves.c,no_embree.c))
$(if $(filter yes,$(EMBREE)),$(BENCH): LIBS += -lembree3)
# Optimised for this processor, and without errno from mathematical functions.
$(addprefix $(BUILD)/host/bench/,$(addprefix embree/,embree_draw.o embree_items.o embree_waves.o) float_paths.o float_world.o): HOSTED += -march=native -fno-math-errno

# The float loops are the baselines of the SIMD kernels. Each is compiled with its kernel's flags, if that kernel is built.
LANES_SRC := $(wildcard bench/lanes_*.c)
BENCH_SRC := $(sort $(filter-out $(LANES_SRC) $(if $(TINYGL),bench/tinygl.c),$(wildcard bench/*.c)) $(filter $(SIMD_HAD:%=bench/lanes_%.c),$(LANES_SRC)))
$(BUILD)/host/bench/lanes_%.o: bench/lanes_%.c $(BUILD)/made-with/host
	$(call compile,CC,$(HOSTED) -iquote src $(flags_$*) -fno-math-errno)
$(BUILD)/host/bench/float_lanes.o: $(BUILD)/made-with/parts
$(BUILD)/host/bench/float_lanes.o: HOSTED += $(HAVE_SIMD)
$(BENCH): $(call obj,host,$(BENCH_SRC) $(EMBREE_SRC) $(if $(GL),bench/gl/gl_raster.c)) \
          $(if $(TINYGL),$(BUILD)/tinygl/bench/tinygl.o $(TINYGL_LIB)) $(LIBCOMMON) $(LIBPORTS) $(LIBF64) $(LIBSIMD) $(LIBRADIO) $(LIBTIA) $(LIBWATCHED) $(BUILD)/made-with/link
	$(link)
$(BENCH): LIBS := $(LIBWATCHED) $(LIBTIA) $(LIBS)
# FORCE: TINYGL may differ from that of the last build.
$(BUILD)/tinygl/%.o: %.c FORCE
	$(call compile,CC,$(HOSTED) -DTIA_HAVE_TINYGL -isystem $(TINYGL)/include)
$(call obj,host,bench/shadow_scene.c bench/shadow_frames.c bench/shadows.c bench/shadows_gl.c): HOSTED += -iquote src
bench: $(BENCH)
	@$(BENCH)

# The time from a key to its picture, measured in a guest.
.PHONY: bench-latency
bench-latency: all $(BUILD)/vm/probe $(BUILD)/tests/test_ports
	@BUILD=$(BUILD) bench/latency.py $(SCENES)

# OpenGL beside the exact rasteriser, docs/conform.md.
.PHONY: conform
CONFORM_OBJ := $(call obj,host,$(addprefix bench/conform/,trial.c shrink.c))
$(BUILD)/tests/test_conform: $(CONFORM_OBJ)
ifneq ($(GL),)
$(BUILD)/tia-conform: $(CONFORM_OBJ) $(call obj,host,$(addprefix bench/conform/,tia-conform.c compare.c piped.c) bench/gl/gl_raster.c) $(LIBPORTS) $(LIBSIMD) $(LIBTIA) $(BUILD)/made-with/link
	$(link)
conform: $(BUILD)/tia-conform
	@$<
else
conform:
	@echo "conform: no OSMesa, no EGL (make deps installs them)" >&2; exit 1
endif
