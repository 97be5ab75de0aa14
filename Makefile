# Makefile - tia in one file. `make help` lists the targets.
#
#   make CC=clang, make CROSS=arm-linux-gnueabi-, make CFLAGS='-O3 -march=native', make BUILD=dir
#   make F64=no          leaves the double-precision reference out (targets without an FPU)
#   make DRM=no PNG=no OSMESA=no EGL=no   leaves a part out though its library is there

BUILD   ?= build
CROSS   ?=
ifeq ($(origin CC),default)
CC      := $(CROSS)gcc
ifeq ($(CROSS)$(shell command -v gcc),)
CC      := cc
endif
endif
AR      := $(CROSS)ar
PKG_CONFIG ?= $(CROSS)pkg-config
CFLAGS  ?= -O3 -g
PREFIX  ?= /usr/local
DESTDIR ?=
VERSION := $(shell sed -n 's/.*TIA_VERSION "\(.*\)"/\1/p' include/tia/tia.h)

WARN    := -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wstrict-prototypes -Wmissing-prototypes
COMMON  := -std=c11 $(WARN) -Iinclude -MMD -MP
CORE    := $(COMMON) -ffreestanding -iquote src
HOSTED  := $(COMMON) -D_GNU_SOURCE -Iport -Itools -Ibench -pthread

# ---- what Debian 12 has for it all; `make deps` installs what is missing, with sudo when not root ----
DEPS := gcc libc6-dev make pkg-config python3 libdrm-dev libpng-dev clang clang-format libclang-rt-14-dev \
        universal-ctags file binutils man-db libosmesa6-dev libegl-dev libgl1-mesa-dri \
        gcc-i686-linux-gnu gcc-arm-linux-gnueabi gcc-arm-linux-gnueabihf gcc-aarch64-linux-gnu \
        gcc-riscv64-linux-gnu gcc-s390x-linux-gnu gcc-powerpc-linux-gnu libc6-dev-i386-cross \
        libc6-dev-armel-cross libc6-dev-armhf-cross libc6-dev-arm64-cross libc6-dev-riscv64-cross \
        libc6-dev-s390x-cross libc6-dev-powerpc-cross lib32gcc-12-dev libc6-dev-i386 qemu-user-static \
        gcc-arm-none-eabi gcc-riscv64-unknown-elf qemu-system-arm qemu-system-misc frama-c-base why3 z3 cvc4 gappa \
        qemu-system-x86 seabios busybox-static xz-utils linux-headers-amd64 povray tmux zsh fish
ifneq ($(filter deps,$(MAKECMDGOALS)),)
# An included file that is out of date is made first and the Makefile is read again: so the
# libraries are found in the same call that installs them.
DEPS_MISSING := $(shell for p in $(DEPS); do dpkg-query -W -f '$${Status}\n' $$p 2>/dev/null | \
                        grep -q 'install ok installed' || echo $$p; done)
$(BUILD)/deps.mk: $(if $(DEPS_MISSING),FORCE)
	@mkdir -p $(@D)
	@if [ -n "$(DEPS_MISSING)" ]; then \
	    sudo=; [ "$$(id -u)" = 0 ] || sudo=sudo; \
	    $$sudo apt-get update -q && \
	    $$sudo env DEBIAN_FRONTEND=noninteractive apt-get install -qy --no-install-recommends $(DEPS_MISSING); fi
	@touch $@
FORCE:
include $(BUILD)/deps.mk
endif

# ---- optional libraries: found by pkg-config, else their parts are left out and named ----
F64 ?= yes
have = $(shell $(PKG_CONFIG) --exists $(1) 2>/dev/null && echo yes || echo no)
DRM ?= $(call have,libdrm)
PNG ?= $(call have,libpng)
OSMESA ?= $(call have,osmesa gl)
EGL ?= $(call have,egl gl)
MISSING :=
LIBS := -lm
ifeq ($(DRM),yes)
HOSTED += -DTIA_HAVE_DRM $(shell $(PKG_CONFIG) --cflags libdrm)
LIBS += $(shell $(PKG_CONFIG) --libs libdrm)
else
MISSING += "no libdrm: built without the drm display"
endif
ifeq ($(PNG),yes)
HOSTED += -DTIA_HAVE_PNG $(shell $(PKG_CONFIG) --cflags libpng)
LIBS += $(shell $(PKG_CONFIG) --libs libpng)
else
MISSING += "no libpng: built without .png files"
endif
# The osmesa display loads its library, OSMesa or EGL, when it is opened: only headers are needed.
GL := $(filter yes,$(OSMESA) $(EGL))
ifneq ($(GL),)
HOSTED += -DTIA_HAVE_OSMESA $(if $(filter yes,$(OSMESA)),-DTIA_HAVE_LIBOSMESA) $(if $(filter yes,$(EGL)),-DTIA_HAVE_EGL)
LIBS += -ldl
else
MISSING += "no OSMesa, no EGL: built without the osmesa display"
endif
ifeq ($(F64),yes)
HOSTED += -DTIA_HAVE_F64
endif

# ---- sources: one object per file and arithmetic ----
# All below src/render is compiled once for each arithmetic, see src/num/README.md; the rest knows integers alone.
c_below   = $(sort $(foreach d,$(1),$(wildcard $(d)/*.c $(d)/*/*.c $(d)/*/*/*.c)))
CORE_SRC  := $(filter-out src/render/no_rays.c src/scene/no_shapes.c,$(call c_below,src))
NUM_SRC   := $(filter src/render/%,$(CORE_SRC))
# Boards without the room for more than spheres link no_rays.c and no_shapes.c instead of these.
LARGE_SRC := $(filter $(addsuffix /%,$(addprefix src/,read scene/bvh scene/shapes render/geometry render/trace render/whitted)),$(CORE_SRC)) \
             $(addprefix src/,math/rotation.c scene/bounds.c scene/motion.c) $(addprefix src/scene/check/,shape.c mesh.c track.c)
SMALL_SRC := $(filter-out $(LARGE_SRC),$(CORE_SRC)) src/render/no_rays.c src/scene/no_shapes.c
PORT_DIRS := console pixels memory none fbdev evdev terminal ps2 spi-panel $(if $(filter yes,$(DRM)),drm) \
             $(if $(GL),osmesa) $(if $(filter yes,$(OSMESA)),osmesa/mesa) $(if $(filter yes,$(EGL)),osmesa/egl)
PORT_SRC  := $(sort $(wildcard port/*.c $(PORT_DIRS:%=port/%/*.c)))
# What commands share, and the scenes and measures that commands, tests and benchmarks share.
COMMON_SRC := $(call c_below,tools/common bench/corpus)
ORACLE_SRC := $(sort $(wildcard tests/oracle/*.c))
TESTS     := $(patsubst tests/%.c,$(BUILD)/tests/%,$(sort $(wildcard tests/test_*.c)))

obj = $(patsubst %.c,$(BUILD)/$(1)/%.o,$(2))
LIBTIA := $(BUILD)/libtia.a
LIBF64 := $(if $(filter yes,$(F64)),$(BUILD)/libtia-f64.a $(BUILD)/libtia-f32.a)
LIBPORTS := $(BUILD)/libports.a
LIBCOMMON := $(BUILD)/libcommon.a
PROGRAMS := tia tia-compare tia-join tia-compile tia-pov

.PHONY: all run check check-quick bench deps install uninstall size lint clean help tests FORCE
all: $(LIBTIA) $(LIBF64) $(PROGRAMS:%=$(BUILD)/%)
	@for m in $(MISSING); do echo "note: $$m (make deps installs it)"; done

$(BUILD)/q16/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(CORE) $(CFLAGS) -c -o $@ $<
$(BUILD)/f64/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(CORE) -DTIA_NUM_F64 -fno-math-errno $(CFLAGS) -c -o $@ $<
$(BUILD)/f32/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(CORE) -DTIA_NUM_F32 -fno-math-errno $(CFLAGS) -c -o $@ $<
# The checking build: what num_chk.h does not see, sums and differences, the compiler checks.
OVERFLOW := -fsanitize=signed-integer-overflow,shift -fno-sanitize-recover=all
# Without the compiler's runtime for it, a fault is a trap instead of a line.
OVERFLOW += $(if $(shell echo 'int main(int n, char **v) { return v ? n + 1 : 0; }' | \
                $(CC) $(OVERFLOW) -x c -o /dev/null - 2>&1),-fsanitize-undefined-trap-on-error)
$(BUILD)/chk/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(CORE) -DTIA_NUM_CHK $(OVERFLOW) $(CFLAGS) -c -o $@ $<
$(BUILD)/host/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(HOSTED) $(CFLAGS) -c -o $@ $<
$(BUILD)/tests/%.o: tests/%.c
	@mkdir -p $(@D)
	$(CC) $(HOSTED) -Wno-missing-field-initializers -iquote src -iquote tests $(CFLAGS) -c -o $@ $<

$(LIBTIA): $(call obj,q16,$(CORE_SRC))
$(BUILD)/libtia-f64.a: $(call obj,f64,$(NUM_SRC))
$(BUILD)/libtia-f32.a: $(call obj,f32,$(NUM_SRC))
$(BUILD)/libtia-chk.a: $(call obj,chk,$(NUM_SRC))
$(LIBPORTS): $(call obj,host,$(PORT_SRC))
$(LIBCOMMON): $(call obj,host,$(COMMON_SRC))
$(BUILD)/liboracle.a: $(patsubst tests/%.c,$(BUILD)/tests/%.o,$(ORACLE_SRC))
%.a:
	@rm -f $@
	$(AR) rcs $@ $^

# A program is all of tools/NAME/.
define program
$(BUILD)/$(1): $(call obj,host,$(sort $(wildcard tools/$(1)/*.c))) $(LIBCOMMON) $(LIBPORTS) $(LIBF64) $(LIBTIA)
	$$(CC) -pthread $$(CFLAGS) $$(LDFLAGS) -o $$@ $$(filter %.o,$$^) $$(filter %.a,$$^) $$(LIBS)
endef
$(foreach p,$(PROGRAMS),$(eval $(call program,$(p))))

# A picture to compare with, drawn by GL.
$(if $(GL),$(BUILD)/tests/test_gl_picture: $(BUILD)/tests/gl/scene.o)
CHK_TESTS := $(addprefix $(BUILD)/tests/,test_ranges test_ray_ranges test_limits test_shapes_chk)
$(CHK_TESTS): $(BUILD)/libtia-chk.a
$(CHK_TESTS): LIBS := $(BUILD)/libtia-chk.a $(LIBTIA) $(OVERFLOW) $(LIBS)
$(TESTS): $(BUILD)/tests/%: $(BUILD)/tests/%.o $(BUILD)/liboracle.a $(LIBCOMMON) $(LIBPORTS) $(LIBF64) $(LIBTIA)
	$(CC) -pthread $(CFLAGS) $(LDFLAGS) -o $@ $(filter %.o,$^) $(filter %.a,$^) $(LIBS)

# Scenes as const tables: for a test, and for boards without files.
COMPILED := every $(filter-out thesis,$(patsubst scenes/%.tia,%,$(wildcard scenes/*.tia)))
$(BUILD)/scenes/%.c: scenes/%.tia $(wildcard scenes/*.ppm) $(BUILD)/tia-compile
	@mkdir -p $(@D)
	$(BUILD)/tia-compile $< -o $@ --name compiled_$*
$(BUILD)/scenes/every.c: tests/scenes/every.tia $(BUILD)/tia-compile
	@mkdir -p $(@D)
	$(BUILD)/tia-compile $< -o $@ --name compiled_every
$(BUILD)/scenes/%.o: $(BUILD)/scenes/%.c
	$(CC) $(COMMON) $(CFLAGS) -c -o $@ $<
$(BUILD)/tests/test_compiled: $(COMPILED:%=$(BUILD)/scenes/%.o)
.SECONDARY: $(COMPILED:%=$(BUILD)/scenes/%.c)

# ---- longer proofs ----
.PHONY: check-exhaustive prove check-arch check-mutants fuzz
$(BUILD)/tests/exhaustive: $(BUILD)/tests/exhaustive.o $(LIBTIA)
	$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -lm
check-exhaustive: $(BUILD)/tests/exhaustive
	tests/run $<
prove:
	@tests/slow/prove
check-arch:
	@tests/run tests/slow/arch
SECONDS ?= 600
check-mutants:
	tests/mutate
fuzz:
	@FUZZ_SECONDS=$(SECONDS) tests/slow/fuzz

deps:
	@echo "deps: all there"

# ---- running, testing, measuring ----
python = if command -v python3 >/dev/null; then $(1); else echo "$@: python3 not found (make deps installs it)"; fi

run: all
	$(BUILD)/tia

QUICK := $(TESTS) $(sort $(wildcard tests/quick/*))
SLOW  := $(sort $(wildcard tests/slow/*))
TOOLS := $(PROGRAMS:%=$(BUILD)/%)
export BUILD CC F64
tests: $(TESTS) $(TOOLS) $(BUILD)/vm/probe
check-quick: all tests
	@tests/run $(QUICK)
check: all tests
	@tests/run $(QUICK) $(SLOW)

# Real kernel drivers in guests; the table of what they said comes last.
.PHONY: check-vm
$(BUILD)/vm/probe: tests/vm/probe.c
	@mkdir -p $(@D)
	$(CC) $(HOSTED) $(CFLAGS) $(LDFLAGS) -o $@ $<
check-vm: all $(BUILD)/vm/probe $(BUILD)/tests/test_ports
	@tests/run tests/slow/vm; status=$$?; $(call python,tests/vm/table); exit $$status

$(BUILD)/bench: $(call obj,host,$(sort $(wildcard bench/*.c))) $(LIBCOMMON) $(LIBPORTS) $(LIBF64) $(LIBTIA)
	$(CC) -pthread $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LIBS)
bench: $(BUILD)/bench
	@$(BUILD)/bench

size: $(LIBTIA)
	@$(CROSS)size -t $(LIBTIA)

LINTED := $(sort $(foreach d,include src port tools bench tests,$(wildcard $(d)/*.[ch] $(d)/*/*.[ch] $(d)/*/*/*.[ch] $(d)/*/*/*/*.[ch])))
lint:
	@if command -v clang-format >/dev/null; then clang-format --dry-run -Werror $(LINTED); \
	else echo "lint: no clang-format (make deps installs it)"; fi

# ---- installing ----
INSTALL := install -D -m
install: all
	$(INSTALL) 755 $(BUILD)/tia $(DESTDIR)$(PREFIX)/bin/tia
	$(INSTALL) 755 $(BUILD)/tia-join $(DESTDIR)$(PREFIX)/bin/tia-join
	$(if $(LIBF64),$(INSTALL) 755 $(BUILD)/tia-compare $(DESTDIR)$(PREFIX)/bin/tia-compare)
	$(INSTALL) 755 $(BUILD)/tia-compile $(DESTDIR)$(PREFIX)/bin/tia-compile
	$(INSTALL) 755 $(BUILD)/tia-pov $(DESTDIR)$(PREFIX)/bin/tia-pov
	$(INSTALL) 644 $(LIBTIA) $(DESTDIR)$(PREFIX)/lib/libtia.a
	for h in include/tia/*.h; do $(INSTALL) 644 $$h $(DESTDIR)$(PREFIX)/$$h; done
	$(INSTALL) 644 man/tia.1 $(DESTDIR)$(PREFIX)/share/man/man1/tia.1
	$(INSTALL) 644 man/tia-compile.1 $(DESTDIR)$(PREFIX)/share/man/man1/tia-compile.1
	$(INSTALL) 644 man/tia-pov.1 $(DESTDIR)$(PREFIX)/share/man/man1/tia-pov.1
	$(INSTALL) 644 man/tia-scene.5 $(DESTDIR)$(PREFIX)/share/man/man5/tia-scene.5
	$(INSTALL) 644 man/tia-join.1 $(DESTDIR)$(PREFIX)/share/man/man1/tia-join.1
	$(if $(LIBF64),$(INSTALL) 644 man/tia-compare.1 $(DESTDIR)$(PREFIX)/share/man/man1/tia-compare.1)
	printf '%s\n' 'prefix=$(PREFIX)' 'Name: tia' 'Description: integer-only ray tracer' 'Version: $(VERSION)' \
	    'Cflags: -I$${prefix}/include' 'Libs: -L$${prefix}/lib -ltia' >$(BUILD)/tia.pc
	$(INSTALL) 644 $(BUILD)/tia.pc $(DESTDIR)$(PREFIX)/lib/pkgconfig/tia.pc
uninstall:
	rm -f $(addprefix $(DESTDIR)$(PREFIX)/,bin/tia bin/tia-compare bin/tia-join bin/tia-compile bin/tia-pov \
	    lib/libtia.a lib/pkgconfig/tia.pc share/man/man1/tia.1 share/man/man1/tia-compare.1 \
	    share/man/man1/tia-join.1 share/man/man1/tia-compile.1 share/man/man1/tia-pov.1 share/man/man5/tia-scene.5)
	rm -f $(addprefix $(DESTDIR)$(PREFIX)/,$(wildcard include/tia/*.h))
	-rmdir $(DESTDIR)$(PREFIX)/include/tia

# ---- boards without an operating system ----
ARM_BARE   ?= arm-none-eabi-
RISCV_BARE ?= riscv64-unknown-elf-
PANEL_BOARDS := versatilepb vexpress-a9
SMALL_BOARDS := mps2-an385 microbit rv32
versatilepb_CC := $(ARM_BARE)gcc -marm -mcpu=arm926ej-s -mfloat-abi=soft
vexpress-a9_CC := $(ARM_BARE)gcc -marm -mcpu=cortex-a9 -mfloat-abi=soft -mno-unaligned-access
mps2-an385_CC  := $(ARM_BARE)gcc -mthumb -mcpu=cortex-m3
microbit_CC    := $(ARM_BARE)gcc -mthumb -mcpu=cortex-m0 -DTIA_NO_CLZ -DTIA_MUL64='"math/arm/mul64.h"'
rv32_CC        := $(RISCV_BARE)gcc -march=rv32im -mabi=ilp32 -DTIA_NO_CLZ
BARE := $(COMMON) -ffreestanding -iquote src -Iport -O2 -g -ffunction-sections -fdata-sections
BARE_LD := -nostdlib -static -Wl,--gc-sections,--fatal-warnings -Lport/boards

BOARD_SRC := port/boards/start.c port/boards/print.c port/boards/memory.c
PANEL_SRC := $(BOARD_SRC) port/ps2/ps2.c $(addprefix port/boards/,pl011.c counter.c pl11x.c pl050.c start-arm.S)
versatilepb_SRC := $(PANEL_SRC) port/boards/versatilepb.c
vexpress-a9_SRC := $(PANEL_SRC) port/boards/vexpress-a9.c
mps2-an385_SRC  := $(BOARD_SRC) port/boards/semihost.c port/boards/cortex-m.c
microbit_SRC    := $(mps2-an385_SRC)
rv32_SRC        := $(BOARD_SRC) port/boards/semihost.c port/boards/start-riscv.S

# A board's program, $(call image,board,name,sources,linker script,objects), and its objects: those
# of the core in another arithmetic lie in a folder of its name.
bare = $(patsubst %,$(BUILD)/boards/$(1)/%.o,$(basename $(2)))
define image
$(BUILD)/boards/$(1)/$(2).elf: $(call bare,$(1),$(3) $($(1)_SRC) $(if $(filter $(1),$(SMALL_BOARDS)),$(SMALL_SRC),$(CORE_SRC))) $(5) port/boards/$(4).ld port/boards/sections.ld
	$$($(1)_CC) $$(BARE_LD) -T port/boards/$(4).ld -o $$@ $$(filter %.o,$$^) -lgcc
endef
define bare_rule
$(BUILD)/boards/$(1)/$(2)%.o: %.c
	@mkdir -p $$(@D)
	$$($(1)_CC) $$(BARE) $(3) -c -o $$@ $$<
endef
define board
$(call bare_rule,$(1),,)
$(call bare_rule,$(1),f32/,-DTIA_NUM_F32)
$(call bare_rule,$(1),f64/,-DTIA_NUM_F64)
$(BUILD)/boards/$(1)/%.o: %.S
	@mkdir -p $$(@D)
	$$($(1)_CC) -c -o $$@ $$<
endef
# The counted program in arithmetic $(2), with a hit buffer for $(3) rows, kept whole or not.
define counted
$(BUILD)/boards/$(1)/count-$(2).o: tests/boards/count.c
	@mkdir -p $$(@D)
	$$($(1)_CC) $$(BARE) -DCORE=tia_core_$(2) -DROWS=$(3) -DWHOLE=$(4) -c -o $$@ $$<
$(call image,$(1),count-$(2),,$(1)-large,$(BUILD)/boards/$(1)/count-$(2).o $(if $(filter-out q16,$(2)),$(call bare,$(1),tests/boards/soft_sqrt.c) $(call bare,$(1)/$(2),$(filter src/render/%,$(SMALL_SRC)))))
endef
# The viewer of a compiled scene, $(2).
define shown
$(BUILD)/boards/$(1)/shows-$(2).o: tools/boards/viewer.c
	@mkdir -p $$(@D)
	$$($(1)_CC) $$(BARE) -DSCENE=compiled_$(2) -c -o $$@ $$<
$(BUILD)/boards/$(1)/scene-$(2).o: $(BUILD)/scenes/$(2).c
	@mkdir -p $$(@D)
	$$($(1)_CC) $$(BARE) -c -o $$@ $$<
$(call image,$(1),$(2),,$(1),$(BUILD)/boards/$(1)/shows-$(2).o $(BUILD)/boards/$(1)/scene-$(2).o)
endef
# Those boards whose compiler is there; the tests name the others.
BOARDS := $(foreach b,$(PANEL_BOARDS) $(SMALL_BOARDS),$(if $(shell command -v $(firstword $($(b)_CC))),$(b)))
$(foreach b,$(BOARDS),$(eval $(call board,$(b))))
BOARDS_PANEL := $(filter $(PANEL_BOARDS),$(BOARDS))
BOARDS_SMALL := $(filter $(SMALL_BOARDS),$(BOARDS))
$(foreach b,$(BOARDS_PANEL),$(eval $(call image,$(b),viewer,tools/boards/viewer.c,$(b))))
$(foreach b,$(BOARDS_PANEL),$(eval $(call shown,$(b),castle)))
$(foreach b,$(BOARDS_PANEL),$(eval $(call image,$(b),pattern,tests/boards/pattern.c,$(b))))
$(foreach b,$(BOARDS_SMALL),$(eval $(call image,$(b),frames,tests/boards/frames.c,$(b))))
$(foreach b,$(BOARDS_SMALL),$(foreach n,q16 f32 f64,$(eval $(call counted,$(b),$(n),$(if $(findstring microbit,$(b)),$(if $(findstring f64,$(n)),1,2),3),$(if $(findstring microbit,$(b)),0,1)))))
$(if $(filter mps2-an385,$(BOARDS)),$(eval $(call image,mps2-an385,example,tests/boards/example_main.c,mps2-an385)))
$(if $(filter microbit,$(BOARDS)),$(eval $(call image,microbit,mul64,tests/boards/mul64.c,microbit)))
$(BUILD)/boards/example: tests/boards/example_main.c tests/boards/example.c $(LIBTIA)
	@mkdir -p $(@D)
	$(CC) $(COMMON) $(CFLAGS) $(LDFLAGS) -o $@ $< $(LIBTIA)
IMAGES := $(foreach n,viewer castle,$(BOARDS_PANEL:%=$(BUILD)/boards/%/$(n).elf)) $(BOARDS_PANEL:%=$(BUILD)/boards/%/pattern.elf) $(BOARDS_SMALL:%=$(BUILD)/boards/%/frames.elf)
COUNTED := $(foreach n,q16 f32 f64,$(BOARDS_SMALL:%=$(BUILD)/boards/%/count-$(n).elf))

$(BUILD)/boards/insn.so: tests/boards/insn.c
	@mkdir -p $(@D)
	$(CC) -std=c11 $(WARN) -O2 -shared -fPIC -o $@ $<

.PHONY: boards check-boards size-boards count
boards: $(IMAGES) $(BOARDS_SMALL:%=$(BUILD)/boards/%/count-q16.elf) $(BUILD)/boards/insn.so $(BUILD)/boards/example \
        $(if $(filter mps2-an385,$(BOARDS)),$(BUILD)/boards/mps2-an385/example.elf $(BUILD)/boards/microbit/mul64.elf)
check: boards
check-boards: all boards
	@tests/run tests/slow/boards
size: size-boards
size-boards: boards
	@$(call python,tests/boards/size.py $(BUILD))
count: $(COUNTED) $(BUILD)/boards/insn.so
	@$(call python,tests/boards/count.py $(BUILD))

# The pictures of README.md and docs/scenes.md, which a test compares with what is drawn.
.PHONY: gallery
gallery: all
	for n in glass flake chess castle vase orrery; do \
	    $(BUILD)/tia scenes/$$n.tia -s 400x300 -o docs/gallery/$$n.png || exit; done
	$(BUILD)/tia scenes/glass.tia -s 640x360 -o docs/glass.png
	$(BUILD)/tia -k a -s 640x360 -o docs/thesis.png

clean:
	rm -rf $(BUILD)

help:
	@echo "all (default)      the command, the library and tia-compare, in build/"
	@echo "run                shows the picture"
	@echo "deps               installs what the build and the tests use (Debian 12)"
	@echo "check-quick        the tests that take seconds; check: all of them"
	@echo "check-arch check-boards check-vm fuzz prove    parts of check"
	@echo "check-exhaustive check-mutants                 longer than check"
	@echo "bench count size   time, instructions a pixel on boards, flash, RAM and stack"
	@echo "boards             programs for boards without an operating system"
	@echo "gallery            draws the pictures of docs again"
	@echo "install uninstall  below DESTDIR and PREFIX (/usr/local)"
	@echo "lint clean help"
	@echo "The top of the Makefile tells of CC, CROSS, CFLAGS, BUILD and of leaving parts out."

-include $(shell find $(BUILD) -name '*.d' 2>/dev/null)
