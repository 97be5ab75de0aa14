# Makefile - tia in one file. `make help` lists the targets.
#
#   make CC=clang, make CROSS=arm-linux-gnueabi-, make CFLAGS='-O3 -march=native', make BUILD=dir
#   make F64=no          leaves the double-precision reference out (targets without an FPU)
#   make DRM=no PNG=no OSMESA=no EGL=no   leaves a part out though its library is there

BUILD   ?= build
CROSS   ?=
ifeq ($(origin CC),default)
CC      := $(CROSS)gcc
endif
AR      := $(CROSS)ar
PKG_CONFIG ?= $(CROSS)pkg-config
CFLAGS  ?= -O2 -g
PREFIX  ?= /usr/local
DESTDIR ?=
VERSION := $(shell sed -n 's/.*TIA_VERSION "\(.*\)"/\1/p' include/tia/tia.h)

WARN    := -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wstrict-prototypes -Wmissing-prototypes
COMMON  := -std=c11 $(WARN) -Iinclude -MMD -MP
CORE    := $(COMMON) -ffreestanding -iquote src
HOSTED  := $(COMMON) -D_GNU_SOURCE -Iport -pthread

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
CORE_SRC  := $(sort $(wildcard src/*.c src/shape/*.c))
PLAIN_SRC := $(addprefix src/,scene.c crc.c math.c angle.c thesis.c viewer.c keys.c)
NUM_SRC   := $(filter-out $(PLAIN_SRC),$(CORE_SRC))
PORT_DIRS := common memory none fbdev evdev terminal image $(if $(filter yes,$(DRM)),drm) \
             $(if $(GL),osmesa) $(if $(filter yes,$(OSMESA)),osmesa/mesa) $(if $(filter yes,$(EGL)),osmesa/egl)
PORT_SRC  := $(sort $(wildcard port/*.c $(PORT_DIRS:%=port/%/*.c)))
ORACLE_SRC := $(sort $(wildcard tests/oracle/*.c))
TESTS     := $(patsubst tests/%.c,$(BUILD)/tests/%,$(sort $(wildcard tests/test_*.c)))

obj = $(patsubst %.c,$(BUILD)/$(1)/%.o,$(2))
LIBTIA := $(BUILD)/libtia.a
LIBF64 := $(if $(filter yes,$(F64)),$(BUILD)/libtia-f64.a $(BUILD)/libtia-f32.a)
LIBPORTS := $(BUILD)/libports.a

.PHONY: all run check check-quick bench deps install uninstall size lint clean help tests
all: $(LIBTIA) $(LIBF64) $(BUILD)/tia
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
$(BUILD)/host/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(HOSTED) $(CFLAGS) -c -o $@ $<
$(BUILD)/tests/%.o: tests/%.c
	@mkdir -p $(@D)
	$(CC) $(HOSTED) -iquote src -iquote tests $(CFLAGS) -c -o $@ $<

$(LIBTIA): $(call obj,q16,$(CORE_SRC))
$(BUILD)/libtia-f64.a: $(call obj,f64,$(NUM_SRC))
$(BUILD)/libtia-f32.a: $(call obj,f32,$(NUM_SRC))
$(LIBPORTS): $(call obj,host,$(PORT_SRC))
$(BUILD)/liboracle.a: $(patsubst tests/%.c,$(BUILD)/tests/%.o,$(ORACLE_SRC))
%.a:
	@rm -f $@
	$(AR) rcs $@ $^

# A program of tools/ is NAME.c and, where it has more files, those of tools/NAME/.
define program
$(BUILD)/$(1): $(call obj,host,tools/$(1).c $(sort $(wildcard tools/$(1)/*.c))) $(LIBPORTS) $(LIBF64) $(LIBTIA)
	$$(CC) -pthread $$(CFLAGS) $$(LDFLAGS) -o $$@ $$^ $$(LIBS)
endef
$(foreach p,$(patsubst tools/%.c,%,$(wildcard tools/*.c)),$(eval $(call program,$(p))))

$(TESTS): $(BUILD)/tests/%: $(BUILD)/tests/%.o $(BUILD)/liboracle.a $(LIBPORTS) $(LIBF64) $(LIBTIA)
	$(CC) -pthread $(CFLAGS) $(LDFLAGS) -o $@ $^ $(LIBS)

# ---- longer proofs ----
.PHONY: check-exhaustive
$(BUILD)/tests/exhaustive: $(BUILD)/tests/exhaustive.o $(LIBTIA)
	$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ -lm
check-exhaustive: $(BUILD)/tests/exhaustive
	tests/run $<

clean:
	rm -rf $(BUILD)

-include $(shell find $(BUILD) -name '*.d' 2>/dev/null)
