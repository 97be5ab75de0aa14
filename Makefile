# Makefile - `make` builds tia on all cores, `make help` lists the targets.
#
#   make V=1             shows the commands; make -j N takes N processes instead of one a core
#   make CC=clang, make CFLAGS='-O3 -march=native', make BUILD=dir
#   make CROSS=aarch64-linux-gnu-    for another Linux
#   make CROSS=arm-none-eabi- CFLAGS='-O2 -mthumb -mcpu=cortex-m3'    the library, for no operating system
#   make F64=no          leaves the floating-point references out (targets without an FPU); F128=no: that of 113 bits
#   make DRM=no PNG=no STB=no OSMESA=no EGL=no CHAFA=no JSON=no ASSIMP=no   leaves a part out though its library is there

BUILD   ?= build
# One spelling of each object's path, as the files of dependencies have it.
override BUILD := $(patsubst $(CURDIR)/%,%,$(BUILD))
$(CURDIR)/$(BUILD)/%: $(BUILD)/% ;
CROSS   ?=
found    = $(firstword $(wildcard $(addsuffix /$(1),$(subst :, ,$(PATH)))))
ifeq ($(origin CC),default)
CC      := $(if $(CROSS)$(call found,gcc),$(CROSS)gcc,cc)
NATIVE  := $(if $(CROSS),,yes)
endif
AR      := $(CROSS)ar
PKG_CONFIG ?= $(CROSS)pkg-config
CFLAGS  ?= -O2
VERSION  = $(shell sed -n 's/.*TIA_VERSION "\(.*\)"/\1/p' include/tia/tia.h)

WARN    := -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wstrict-prototypes -Wmissing-prototypes
COMMON  := -std=c11 $(WARN) -Iinclude -MMD -MP
CORE    := $(COMMON) -ffreestanding -iquote src
HOSTED  := $(COMMON) -D_GNU_SOURCE -Iport -Itools -Ibench -pthread

# The compiler's target when it has no operating system: then there is the library alone.
BARE := $(if $(NATIVE),,$(filter %-elf %-eabi %-eabihf %-none avr,$(shell $(CC) -dumpmachine 2>/dev/null)))
LIBRARY_GOALS := all amalgamation arduino deb install uninstall man3 size clean lint deps help $(BUILD)/%
ifneq ($(and $(BARE),$(filter-out $(LIBRARY_GOALS),$(MAKECMDGOALS))),)
$(error $(CC) is for $(BARE), which has no operating system: there is only `make all` or `make install`)
endif

# ---- how make works here ----
# No implicit rules of its own: a build with nothing to do takes half the time.
MAKEFLAGS += -r
# On all cores, unless -j says otherwise or another make gives out the jobs. Of several goals each
# waits for the one before it: nothing is built during a test or a measurement, or cleaned during a build.
GOALS := $(filter-out deps,$(MAKECMDGOALS))
ifneq ($(and $(word 2,$(GOALS)),$(filter-out all tests boards $(BUILD)/%,$(GOALS))),)
.NOTPARALLEL:
else ifeq ($(MAKELEVEL),0)
MAKEFLAGS += $(addprefix -j,$(shell nproc 2>/dev/null))
endif
.DELETE_ON_ERROR:

define newline


endef

# $(call say,WHAT,FILE) in front of a command shows a short line instead of it. V=1 and -n show the
# command, -s neither.
V ?= 0
LOUD := $(or $(V:0=),$(findstring s,$(firstword -$(MAKEFLAGS))),$(findstring n,$(firstword -$(MAKEFLAGS))))
say   = $(if $(LOUD),,@printf '  %-7s %s\n' '$(1)' '$(2)' && )

include deps.mk

# ---- optional libraries: found by pkg-config, else their parts are left out and named ----
F64 ?= $(if $(BARE),no,yes)
# The preprocessor tells whether the compiler has a type of 113 bits.
ifeq ($(origin F128),undefined)
F128 := $(if $(filter no,$(F64)),no,$(or $(shell $(CC) -std=c11 $(CFLAGS) -E -P src/num/probe.h 2>/dev/null | grep '^yes$$'),no))
LACKS_F128 := $(and $(filter yes,$(F64)),$(filter no,$(F128)))
endif
unless_no = $(if $(filter no,$($(1))),,$(2))
WANTED := $(if $(BARE),,$(sort $(call unless_no,DRM,libdrm) $(call unless_no,PNG,libpng) \
                               $(call unless_no,STB,stb) $(call unless_no,CHAFA,chafa) \
                               $(call unless_no,JSON,jansson) $(call unless_no,ASSIMP,assimp) \
                               $(call unless_no,OSMESA,osmesa gl) $(call unless_no,EGL,egl gl)))
# Flags begin with -, the names of the packages that are there do not. All are asked for in one call;
# only where one is missing they are asked for one by one.
ifneq ($(WANTED),)
PACKAGES := $(shell ask() { $(PKG_CONFIG) --cflags --libs "$$@" 2>/dev/null; }; \
    if ask $(WANTED); then echo $(WANTED); else for p in $(WANTED); do ask $$p && echo $$p; done; fi)
endif
have = $(if $(filter-out $(PACKAGES),$(1)),no,yes)
DRM ?= $(call have,libdrm)
PNG ?= $(call have,libpng)
STB ?= $(call have,stb)
CHAFA ?= $(call have,chafa)
JSON ?= $(call have,jansson)
ASSIMP ?= $(call have,assimp)
OSMESA ?= $(call have,osmesa gl)
EGL ?= $(call have,egl gl)
# The osmesa display loads its library, OSMesa or EGL, when it is opened: only headers are needed.
GL := $(filter yes,$(OSMESA) $(EGL))
# stb_image is a header: it is compiled here, and the compiler's warnings about it are off.
HOSTED += $(patsubst -I%,-isystem%,$(filter-out -l% -L% -Wl%,$(filter -%,$(PACKAGES))))
LIBS := $(filter-out -lOSMesa -lEGL -lGL -lstb -lchafa -lglib-2.0 -ljansson -lassimp,$(filter -l% -L% -Wl%,$(PACKAGES))) -lm
MISSING :=
ifeq ($(DRM),yes)
HOSTED += -DTIA_HAVE_DRM
else
MISSING += "no libdrm: built without the drm display"
endif
ifeq ($(PNG),yes)
HOSTED += -DTIA_HAVE_PNG
else
MISSING += "no libpng: built without .png files"
endif
MISSING_RUN := $(MISSING)
ifeq ($(STB),yes)
HOSTED += -DTIA_HAVE_STB
else
MISSING += "no libstb: built without textures from .jpg, .bmp, .tga and .gif files"
endif
# Only what has the terminal's display is linked with it.
ifeq ($(CHAFA),yes)
HOSTED += -DTIA_HAVE_CHAFA
LIBS += -Wl,--as-needed -lchafa -lglib-2.0 -Wl,--no-as-needed
else
MISSING += "no libchafa: built without symbols, sixel and kitty's pictures on terminals"
endif
ifeq ($(JSON),yes)
HOSTED += -DTIA_HAVE_JANSSON
LIBS += -Wl,--as-needed -ljansson -Wl,--no-as-needed
else
MISSING += "no libjansson: built without calibrations of light-field displays from .json files"
endif
# The library is loaded when a model is read: only its headers are needed, of the same version.
ifeq ($(ASSIMP),yes)
HOSTED += -DTIA_HAVE_ASSIMP
LIBS += -ldl
$(BUILD)/host/tools/common/scene/model/assimp/library.o: HOSTED += \
    -DASSIMP_VERSION='"$(shell $(PKG_CONFIG) --modversion assimp | cut -d. -f1,2)"'
else
MISSING += "no libassimp: built without models from .glb, .gltf, .fbx, .dae, .3ds and other files"
endif
# Damaged pictures make its sums overflow, which is harmless where they wrap around.
$(BUILD)/host/tools/common/image/decode_stb.o: HOSTED += -fwrapv
ifneq ($(GL),)
HOSTED += -DTIA_HAVE_OSMESA $(if $(filter yes,$(OSMESA)),-DTIA_HAVE_LIBOSMESA) $(if $(filter yes,$(EGL)),-DTIA_HAVE_EGL)
LIBS += -ldl
else
MISSING += "no OSMesa, no EGL: built without the osmesa display"
endif
ifeq ($(F64),yes)
HOSTED += -DTIA_HAVE_F64
endif
ifeq ($(F64) $(F128),yes yes)
HOSTED += -DTIA_HAVE_F128
endif

# `make run` alone makes what its picture needs: the parts of build/tia below are then linked where they are there.
LEAN := $(if $(GOALS),$(if $(filter-out run,$(GOALS)),,yes))
unless_lean = $(if $(LEAN),$(if $(filter-out $(wildcard $(1)),$(1)),,$(1)),$(1))

# ---- sources: one object per file and arithmetic ----
# The folders of src/render are compiled once for each arithmetic, see src/num/README.md; the rest uses integers alone.
c_below   = $(sort $(foreach d,$(1),$(wildcard $(d)/*.c $(d)/*/*.c $(d)/*/*/*.c $(d)/*/*/*/*.c)))
CORE_SRC  := $(call c_below,src)
# Radio waves are a library of their own, which needs the core.
RADIO_SRC := $(filter src/radio/%,$(CORE_SRC))
CORE_SRC  := $(filter-out src/radio/%,$(CORE_SRC))
# All in a directory of src/render.
NUM_SRC   := $(filter-out $(wildcard src/render/*.c),$(filter src/render/%,$(CORE_SRC)))
include src/simd/simd.mk
PORT_DIRS := console pixels memory none fbdev evdev terminal ps2 spi-panel $(if $(filter yes,$(DRM)),drm) \
             terminal/$(if $(filter yes,$(CHAFA)),,no-)chafa $(if $(GL),osmesa) $(if $(filter yes,$(OSMESA)),osmesa/mesa) $(if $(filter yes,$(EGL)),osmesa/egl)
PORT_SRC  := $(sort $(wildcard port/*.c $(PORT_DIRS:%=port/%/*.c)))
# What commands share, and the scenes and measures that commands, tests and benchmarks share.
COMMON_SRC := $(filter-out $(if $(filter yes,$(ASSIMP)),,tools/common/scene/model/assimp/%),$(call c_below,tools/common))
ORACLE_SRC := $(sort $(wildcard tests/oracle/*.c))
TESTS     := $(patsubst tests/%.c,$(BUILD)/tests/%,$(sort $(wildcard tests/test_*.c)))

obj = $(patsubst %.c,$(BUILD)/$(1)/%.o,$(2))
LIBTIA := $(BUILD)/libtia.a
LIBRADIO := $(BUILD)/libtia-radio.a
LIBDEVICES := $(BUILD)/libtia-ports.a
LIBSHARED := $(BUILD)/libtia.so.0
LIBF128 := $(if $(filter yes,$(F128)),$(BUILD)/libtia-f128.a)
LIBF64 := $(if $(filter yes,$(F64)),$(BUILD)/libtia-f64.a $(BUILD)/libtia-f32.a $(LIBF128))
LIBSIMD := $(BUILD)/libtia-simd.a
LIBWATCHED := $(BUILD)/libtia-watched.a
TIA_F64 := $(call unless_lean,$(LIBF64))
TIA_WATCHED := $(call unless_lean,$(LIBWATCHED))
LIBPORTS := $(BUILD)/libports.a
LIBCOMMON := $(BUILD)/libcommon.a
LIBDRAWING := $(BUILD)/libdrawing.a
PROGRAMS := $(if $(BARE),,tia tia-compare tia-join tia-compile tia-pov tia-observe tia-radio tia-verify)

.PHONY: all run check check-quick test bench deps install uninstall size lint clean help tests FORCE
all: $(LIBTIA) $(LIBRADIO) $(LIBDEVICES) $(if $(BARE),,$(LIBSIMD)) $(LIBF64) $(PROGRAMS:%=$(BUILD)/%)
	@$(call name_missing,$(MISSING))
	@$(if $(LACKS_F128),echo "note: $(CC) has no type of 113 bits: built without the f128 reference",:)

name_missing = for m in $(1); do echo "note: $$m (make deps installs it)"; done
ifneq ($(BARE),)
name_missing = echo "note: no operating system on $(BARE): libtia.a alone, without the commands, the displays$(if $(LIBF64),, and the f64 reference)"
endif

# ---- what objects and programs are made with ----
# A file each for the compiler, its flags and the libraries found; what is made with them depends on it. It is written
# again only when its text changes.
COMPILER := $(realpath $(call found,$(firstword $(CC)))) $(CC)
made_with_core := $(COMPILER) $(CORE) $(CFLAGS) $(MEASURING_CFLAGS) $(REFERENCE_CFLAGS)
made_with_host := $(COMPILER) $(HOSTED) $(CFLAGS) $(MEASURING_CFLAGS) $(TEST_CFLAGS)
made_with_parts := $(HAVE_SIMD) $(if $(TIA_F64),-DTIA_LINKED_F64) $(if $(filter %-f128.a,$(TIA_F64)),-DTIA_LINKED_F128) $(if $(TIA_WATCHED),-DTIA_LINKED_WATCHED)
made_with_simd := $(COMPILER) $(CORE) $(foreach l,$(SIMD_NAMES),$(flags_$(l))) $(CFLAGS)
made_with_link := $(COMPILER) $(CFLAGS) $(LDFLAGS) $(LIBS)
same = $(and $(findstring x$(1)x,x$(2)x),$(findstring x$(2)x,x$(1)x))
define made_with_file
$(BUILD)/made-with/$(1): $(if $(call same,$(strip $(file <$(BUILD)/made-with/$(1))),$(strip $(made_with_$(1)))),,FORCE)
	@mkdir -p $$(@D) && printf '%s\n' '$$(subst ','\'',$$(strip $$(made_with_$(1))))' >$$@
endef
$(foreach m,core host simd parts link,$(eval $(call made_with_file,$(m))))

# $(call compile,WHAT,options): where one source makes several objects, WHAT names the arithmetic.
define compile
@mkdir -p $(@D)
$(call say,$(1),$<)$(CC) $(2) $(CFLAGS) -c -o $@ $<
endef
# More flags for what surrounds the library: the other arithmetics, ports and commands; the floating-point references;
# and the tests' own files.
$(foreach v,f32 f64 watched chk host,$(BUILD)/$(v)/%.o): override CFLAGS += $(MEASURING_CFLAGS)
$(foreach v,f32 f64,$(BUILD)/$(v)/%.o): override CFLAGS += $(REFERENCE_CFLAGS)
$(BUILD)/tests/%.o: override CFLAGS += $(TEST_CFLAGS)
link = $(call say,LD,$@)$(CC) -pthread $(CFLAGS) $(LDFLAGS) -o $@ $(filter %.o,$^) $(filter %.a,$^) $(LIBS)

$(BUILD)/q16/%.o: %.c $(BUILD)/made-with/core
	$(call compile,$(if $(filter $(NUM_SRC),$<),CC q16,CC),$(CORE))
$(BUILD)/f64/%.o: %.c $(BUILD)/made-with/core
	$(call compile,CC f64,$(CORE) -DTIA_NUM_F64 -fno-math-errno)
$(BUILD)/watched/%.o: %.c $(BUILD)/made-with/core
	$(call compile,CC obs,$(CORE) -DTIA_WATCHED)
$(BUILD)/f32/%.o: %.c $(BUILD)/made-with/core
	$(call compile,CC f32,$(CORE) -DTIA_NUM_F32 -fno-math-errno)
$(BUILD)/f128/%.o: %.c $(BUILD)/made-with/core
	$(call compile,CC f128,$(CORE) -DTIA_NUM_F128 -fno-math-errno)
# Of a file of src/simd/.
simd_flags = $(filter-out -ffreestanding,$(CORE)) $(flags_$(notdir $(1))) -fno-math-errno -ffp-contract=$(if $(filter rays/%,$(1)),fast,off)
# Packets of rays have many loops over lanes, which -O3 unrolls.
$(foreach v,simd pic,$(BUILD)/$(v)/src/simd/rays/%.o): override CFLAGS := $(patsubst -O2,-O3,$(CFLAGS))
$(BUILD)/simd/src/simd/%.o: src/simd/%.c $(BUILD)/made-with/simd
	$(call compile,CC,$(call simd_flags,$*))
$(BUILD)/simd/port/simd/%.o: port/simd/%.c $(BUILD)/made-with/host $(BUILD)/made-with/parts
	$(call compile,CC,$(HOSTED) $(HAVE_SIMD))
$(BUILD)/host/%.o: %.c $(BUILD)/made-with/host
	$(call compile,CC,$(HOSTED))
$(BUILD)/tests/%.o: tests/%.c $(BUILD)/made-with/host
	$(call compile,CC,$(HOSTED) -Wno-missing-field-initializers -iquote src -iquote tests)
# The checking build: what num_chk.h does not see, sums and differences, the compiler checks. Without
# the compiler's runtime for it, a fault is a trap instead of a line.
OVERFLOW := -fsanitize=signed-integer-overflow,shift -fno-sanitize-recover=all
overflow = $(OVERFLOW) $$(cat $(BUILD)/chk/flags)
$(BUILD)/chk/flags: $(BUILD)/made-with/core
	@mkdir -p $(@D)
	@echo 'int main(int n, char **v) { return v ? n + 1 : 0; }' >$@.c; \
	if $(CC) $(OVERFLOW) -o $@.probe $@.c 2>/dev/null; then : ; else echo -fsanitize-undefined-trap-on-error; fi >$@
$(BUILD)/chk/%.o: %.c $(BUILD)/chk/flags
	$(call compile,CC chk,$(CORE) -DTIA_NUM_CHK $(overflow))

$(LIBTIA): $(call obj,q16,$(CORE_SRC))
$(LIBRADIO): $(call obj,q16,$(RADIO_SRC))
$(BUILD)/libtia-f64.a: $(call obj,f64,$(NUM_SRC))
$(BUILD)/libtia-f32.a: $(call obj,f32,$(NUM_SRC))
$(BUILD)/libtia-f128.a: $(call obj,f128,$(NUM_SRC))
$(LIBWATCHED): $(call obj,watched,$(NUM_SRC))
$(BUILD)/libtia-chk.a: $(call obj,chk,$(NUM_SRC))
# The code common to all instruction sets is built even for a processor without vector units: tests call it.
$(LIBSIMD): $(call obj,simd,$(SIMD_SRC) port/simd/best.c)
$(LIBPORTS): $(call obj,host,$(PORT_SRC))
$(LIBCOMMON): $(call obj,host,$(COMMON_SRC))
# All of tia but its main(): other commands draw with it.
$(LIBDRAWING): $(call obj,host,$(filter-out tools/tia/tia.c,$(sort $(wildcard tools/tia/*.c))))
$(BUILD)/liboracle.a: $(patsubst tests/%.c,$(BUILD)/tests/%.o,$(ORACLE_SRC))
%.a:
	@rm -f $@
	$(call say,AR,$@)$(AR) rcs $@ $^

# A program is all of tools/NAME/. Those of DRAWING draw as tia does.
DRAWING := tia tia-verify tia-join
define program
$(BUILD)/$(1): $(call obj,host,$(sort $(wildcard tools/$(1)/*.c))) $(if $(filter-out tia,$(filter $(1),$(DRAWING))),$(LIBDRAWING)) $(LIBCOMMON) $(LIBPORTS) $(if $(filter $(1),$(DRAWING)),$(TIA_F64),$(LIBF64)) $(LIBSIMD) $(if $(filter tia-radio,$(1)),$(LIBRADIO)) $(LIBTIA) $(BUILD)/made-with/link
	$$(link)
endef
$(foreach p,$(PROGRAMS),$(eval $(call program,$(p))))

# A picture to compare with, drawn by GL.
$(if $(GL),$(BUILD)/tests/test_gl_picture: $(BUILD)/tests/gl/gl_scene.o)
$(if $(GL),$(BUILD)/tests/test_gl_raster $(BUILD)/tests/test_gl_shadows: $(call obj,host,bench/gl/gl_raster.c))
$(if $(filter yes,$(OSMESA)),$(BUILD)/tests/test_gl_shadows: LDFLAGS += -Xlinker --wrap=tia_raster_draw)
$(if $(filter %-f128.a,$(LIBF64)),$(BUILD)/tests/test_mirrors: $(patsubst %,$(BUILD)/tests/mirrors/chain_%.o,q16 f32 f64 f128))
CHK_TESTS := $(addprefix $(BUILD)/tests/,test_ranges test_ray_ranges test_limits test_shapes_chk)
$(CHK_TESTS): $(BUILD)/libtia-chk.a
$(BUILD)/host/tools/tia/arithmetic.o: $(BUILD)/made-with/parts
$(BUILD)/host/tools/tia/arithmetic.o: HOSTED += $(filter -DTIA_LINKED_%,$(made_with_parts))
$(DRAWING:%=$(BUILD)/%): $(TIA_WATCHED)
$(DRAWING:%=$(BUILD)/%): LIBS := $(TIA_WATCHED) $(LIBTIA) $(LIBS)
$(BUILD)/tests/test_observe: $(LIBWATCHED)
$(BUILD)/tests/test_observe: LIBS := $(LIBWATCHED) $(LIBTIA) $(LIBS)
$(CHK_TESTS): LIBS := $(BUILD)/libtia-chk.a $(LIBTIA) $(overflow) $(LIBS)
$(TESTS): $(BUILD)/tests/%: $(BUILD)/tests/%.o $(BUILD)/liboracle.a $(LIBCOMMON) $(LIBPORTS) $(LIBF64) $(LIBSIMD) $(LIBRADIO) $(LIBTIA) $(BUILD)/made-with/link
	$(link)

# Scenes as const tables: for a test, and for boards without files.
COMPILED := every $(filter-out thesis,$(patsubst scenes/%.tia,%,$(wildcard scenes/*.tia)))
$(BUILD)/scenes/%.c: scenes/%.tia $(wildcard scenes/*.p[gp]m scenes/*.ply) $(BUILD)/tia-compile
	@mkdir -p $(@D)
	$(call say,TABLES,$<)$(BUILD)/tia-compile $< -o $@ --name compiled_$(subst -,_,$*)
$(BUILD)/scenes/every.c: tests/scenes/every.tia $(BUILD)/tia-compile
	@mkdir -p $(@D)
	$(call say,TABLES,$<)$(BUILD)/tia-compile $< -o $@ --name compiled_every
TELLTALES := ball=40,20,48,56 horizon=0,60,128,4 corner=0,0,8,8
$(BUILD)/scenes/telltales.c: scenes/thesis.tia $(BUILD)/tia-compile
	@mkdir -p $(@D)
	$(call say,TABLES,$<)$(BUILD)/tia-compile $< -o $@ --name compiled --crc 128x96 $(TELLTALES:%=--rectangle %)
$(BUILD)/scenes/%.o: $(BUILD)/scenes/%.c $(BUILD)/made-with/core
	$(call compile,CC,$(COMMON))
$(BUILD)/tests/test_compiled: $(COMPILED:%=$(BUILD)/scenes/%.o)
$(BUILD)/tests/test_telltales: $(BUILD)/scenes/telltales.o
.SECONDARY: $(COMPILED:%=$(BUILD)/scenes/%.c) $(BUILD)/scenes/telltales.c

# ---- longer proofs ----
.PHONY: check-exhaustive prove check-accuracy check-exact check-arch check-freestanding check-matrix check-simd check-denoise check-threads check-deb check-assimp check-light check-rays-billion check-trust check-mutants check-bounds evidence fuzz
$(BUILD)/tests/exhaustive: $(BUILD)/tests/exhaustive.o $(LIBTIA) $(BUILD)/made-with/link
	$(link)
# The words of scene files, from the tables of their reader: tools/generate/language.py makes files of them.
$(BUILD)/tests/scene_words: $(BUILD)/tests/scene_words.o $(LIBTIA) $(BUILD)/made-with/link
	$(link) $(foreach f,word_is fields text_name text_file,-Xlinker --wrap=tia_$(f))
check-exhaustive: $(BUILD)/tests/exhaustive
	@$(run_tests) $<
prove:
	@$(alone) tests/slow/prove
check-accuracy: all tests
	@ACCURACY_SCENES=100 $(run_tests) tests/slow/accuracy
check-exact: $(BUILD)/tia-compare
	@EXACT_FULL=yes $(run_tests) tests/slow/exact
check-arch:
	@ARCH_FULL=yes $(run_tests) tests/slow/arch
check-freestanding:
	@FREESTANDING_FULL=yes $(run_tests) tests/slow/freestanding
check-matrix: all
	@MATRIX_FULL=yes $(run_tests) tests/slow/build-matrix tests/slow/sanitised
check-simd: $(addprefix $(BUILD)/tests/test_,simd_spans simd_rays ray_bounds)
	@SIMD_SCENES=100000 SIMD_TIMES=10 $(run_tests) tests/slow/simd
check-denoise: all
	@DENOISE_FULL=yes $(run_tests) tests/slow/denoise
check-threads: all
	@THREADS_FULL=yes $(run_tests) tests/slow/threads
check-deb: all
	@DEB_FULL=yes $(run_tests) tests/slow/deb
check-assimp: all
	@ASSIMP_FULL=yes $(run_tests) tests/slow/assimp
check-light: $(BUILD)/tests/test_cornell
	@LIGHT_TIMES=20 $(run_tests) tests/slow/light
check-rays-billion: $(BUILD)/tests/test_ray_bounds
	@$< --rays $(or $(RAYS),1000000000) $(PASS)
check-trust: $(BUILD)/tests/test_seal
	@TRUST_FULL=yes $(run_tests) $<
SECONDS ?= 600
check-mutants:
	@$(alone) tests/mutate
# The report for certifiers, docs/evidence.md; PARTS='misra stack': these parts.
evidence: all $(addprefix $(BUILD)/tests/test_,$(file <tests/evidence/tests.txt))
	@$(call python,$(alone) tests/evidence/evidence.py $(BUILD) $(PARTS))
# The vector units' kernels once more, with their bounds scaled by the environment.
SCALED_TESTS := ray_steps ray_scatter ray_areas ray_grids ray_spawned ray_sights ray_ends ray_tubes ray_pixels ray_edges ray_pairs ray_bounds simd_samples \
    simd_bounds simd_steps simd_pixels simd_cells simd_maps span_error steps
check-bounds:
	@$(MAKE) --no-print-directory BUILD=$(BUILD)/scaled CFLAGS='$(CFLAGS) -DBOUND_SCALES=\"../tests/bound_scales.h\"' \
	    $(SCALED_TESTS:%=$(BUILD)/scaled/tests/test_%)
	@BUILD=$(BUILD)/scaled tests/bounds
	@$(BUILD)/scaled/tests/test_ray_bounds --uses
fuzz:
	@$(alone) FUZZ_SECONDS=$(SECONDS) tests/fuzz/run
include tests/fuzz/fuzz.mk

deps:
	@echo "deps: all there"

# ---- running, testing, measuring ----
python = if command -v python3 >/dev/null; then $(1); else echo "$@: python3 not found (make deps installs it)"; fi

# Shows the picture, then tells what it was and what to type next.
SAID = $(BUILD)/run.said
run: $(BUILD)/tia
	@$(call name_missing,$(MISSING_RUN))
	@$(BUILD)/tia -k a --stats 2>$(SAID); status=$$?; sed '/^{/d' $(SAID) >&2; [ $$status = 0 ] || exit $$status; \
	size=$$(sed -n 's/^{.*"size": "\([^"]*\)".*/\1/p' $(SAID)); \
	case $$(sed -n 's/^{.*"display": "\([^"]*\)".*/\1/p' $(SAID)) in \
	file) where="into $$(sed -n 's/.*: wrote \([^ ]*\).*/\1/p' $(SAID))" to=' -o glass.png';; \
	terminal) where='on this terminal' to=;; \
	*) where='on the screen' to=;; esac; \
	echo "drawn: a ball, its light above left (tia -k a), $$size, $$where"; \
	[ "$$to" ] || echo 'keys:  a d s w, arrows, page up and down move the light; any other key quits'; \
	echo "next:  $(BUILD)/tia scenes/glass.tia$$to"; \
	echo "more:  ls scenes, $(BUILD)/tia --help, man -l man/tia.1, make help"

# Tests are independent of this make: those that build start one of their own.
alone = env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL
run_tests = $(alone) tests/run
processors = $$(nproc 2>/dev/null || echo 1)
# One more at a time than there are processors, as some wait for terminals, clocks and guests.
on_all_cores = $(run_tests) -j $$(($(processors) + 1))
# With CHECK_QUICK set tests try fewer random cases, see check_count in tests/check.h; check tries all.
# Those that take longest are begun first, so that in the end no processor waits for one of them.
LONG  := $(addprefix tests/slow/,sanitised arch vm build-matrix accuracy)
# tests/slow/accuracy runs the one that is left out.
QUICK := $(sort $(wildcard tests/quick/*)) $(filter-out $(BUILD)/tests/test_rays_accuracy,$(TESTS))
SLOW  := $(LONG) $(filter-out $(LONG),$(sort $(wildcard tests/slow/*)))
# Left out by check-quick: they take two seconds or more.
LONGER := $(addprefix tests/quick/,background benchmark compare convert denoise editors exact eye far-lights headers lint mirrors moves osmesa palettes \
  resume shadows telltales words) \
  $(addprefix $(BUILD)/tests/test_,bounds compiled frames gl_picture gl_raster mirrors osmesa ray_bounds shadow_curved shapes shapes_chk shapes_f64 \
  simd_large simd_rays simd_shadows simd_spans simd_stack span_error span_exact)
TOOLS := $(PROGRAMS:%=$(BUILD)/%)
export BUILD CC F64
VM_PROGRAMS := $(BUILD)/vm/probe $(BUILD)/vm/controller
tests: $(TESTS) $(TOOLS) $(VM_PROGRAMS) $(BUILD)/tests/scene_words
check-quick: all tests
	@CHECK_QUICK=yes $(on_all_cores) $(filter-out $(LONGER),$(QUICK))
check: all tests
	@$(on_all_cores) $(SLOW) $(QUICK)

# One test, make test T=NAME, or one case of it, C=CASE. Of the test programs those are built that it is or names.
.PHONY: test-built
test-built: $(TESTED) $(if $(filter tests/%,$(TESTED)),all) $(if $(filter tests/slow/vm,$(TESTED)),$(VM_PROGRAMS))
	@:
test:
	@tested=$$(tests/choose '$(T)') && $(MAKE) --no-print-directory test-built TESTED="$$tested" && \
	$(run_tests) $(if $(C),-c '$(C)') $${tested%% *}

# Real kernel drivers in guests, also the tests that take long; the table of their results comes last.
.PHONY: check-vm
$(BUILD)/vm/probe: tests/vm/probe.c $(BUILD)/made-with/host
	@mkdir -p $(@D)
	$(call say,LD,$@)$(CC) $(HOSTED) $(CFLAGS) $(LDFLAGS) -o $@ $<
$(BUILD)/vm/controller: $(BUILD)/host/tests/vm/controller.o $(LIBPORTS) $(LIBSIMD) $(LIBTIA) $(BUILD)/made-with/link
	@mkdir -p $(@D)
	$(link)
check-vm: all $(VM_PROGRAMS) $(BUILD)/tests/test_ports
	@VM_FULL=yes $(run_tests) tests/slow/vm; status=$$?; $(call python,tests/vm/table); exit $$status

include bench/bench.mk

size: $(LIBTIA)
	@$(CROSS)size -t $(LIBTIA)

LINTED = $(sort $(filter-out tests/boards/thesis.h,$(foreach d,include src port tools bench tests,$(wildcard $(d)/*.[ch] $(d)/*/*.[ch] $(d)/*/*/*.[ch] $(d)/*/*/*/*.[ch])))) # but what tia-compile wrote
lint:
	@if command -v clang-format >/dev/null; then clang-format --dry-run -Werror $(LINTED); \
	else echo "lint: no clang-format (make deps installs it)"; fi

include install.mk

ifeq ($(BARE),)
include port/boards/boards.mk
include port/web/web.mk
include tools/kit/kit.mk
endif

include pictures.mk

clean:
	$(call say,REMOVE,$(BUILD))rm -rf $(BUILD)

help:
	@echo "all (default)      the commands and the library, in build/, on all cores; V=1 shows how"
	@echo "run                shows the picture"
	@echo "deps               installs what a build can use (Debian 12); deps run: what run needs;"
	@echo "                   deps check: what the tests use as well"
	@echo "check-quick        the tests that take a second or two; check: all of them"
	@echo "test T=NAME C=CASE one test, or one case of it: make test T=ray_bounds C=scene_files"
	@echo "check-boards prove                             parts of check"
	@echo "check-accuracy check-exact check-arch check-freestanding check-matrix check-simd check-denoise check-threads check-deb check-light check-vm fuzz   parts of check, for longer"
	@echo "                   check-matrix: all builds, and all C tests and fuzzers under ASan and UBSan"
	@echo "check-trust          each bit of a view changed, without and with checks: some minutes"
	@echo "check-rays-billion   10^9 rays by vector units against plain C, or RAYS=N"
	@echo "check-exhaustive check-mutants check-bounds    longer than check"
	@echo "evidence           MISRA, static analysis, run-time errors, stack, coverage, requirements: build/evidence.md"
	@echo "bench count size   time, instructions a pixel on boards, flash, RAM and stack"
	@echo "cycles ways        cycles a pixel on boards, by models; instructions, flash and stack by each build system"
	@echo "bench-latency      from a key to its picture, in a guest; SCENES='chess glass': of these"
	@echo "bench TINYGL=DIR   bench with TinyGL (github.com/C-Chads/tinygl), built in DIR"
	@echo "conform            OpenGL beside the exact rasteriser: docs/conform.md"
	@echo "boards             programs for boards without an operating system"
	@echo "web                the viewer as a page for browsers, in build/web"
	@echo "python npm         packages for the tests of other programs, in build/kit: docs/kit.md"
	@echo "docs               draws the pictures of docs again and counts their figures; gallery: the pictures"
	@echo "                   without the course's; counted: the figures"
	@echo "language           docs/language.md with its pictures, and what editors colour scene files by"
	@echo "man3               the reference of the library, in build/man3: man pages made from the headers"
	@echo "amalgamation       the library as two files, tia.c and tia.h, in build/amalgamation"
	@echo "arduino            a library for Arduino, in build/arduino/tia (docs/ecosystems.md has the others)"
	@echo "deb                packages for Debian in build/deb: tia, libtia0, libtia-dev, tia-doc"
	@echo "install uninstall  below DESTDIR and PREFIX (/usr/local)"
	@echo "lint clean help"
	@echo "The top of the Makefile tells of CC, CROSS, CFLAGS, BUILD and of leaving parts out."

-include $(shell find $(BUILD) -path $(BUILD)/deb -prune -o -name '*.d' -type f -print 2>/dev/null)
