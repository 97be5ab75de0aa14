# boards.mk - programs for boards without an operating system; the Makefile includes it.

ARM_BARE   ?= arm-none-eabi-
RISCV_BARE ?= riscv64-unknown-elf-
AVR_BARE   ?= avr-
PANEL_BOARDS := versatilepb vexpress-a9
SMALL_BOARDS := mps2-an385 mps2-an386 mps2-an500 microbit rv32 atmega1284p
# Boards with 8 KB of RAM.
TINY_BOARDS := stm32vldiscovery
versatilepb_CC := $(ARM_BARE)gcc -marm -mcpu=arm926ej-s -mfloat-abi=soft
vexpress-a9_CC := $(ARM_BARE)gcc -marm -mcpu=cortex-a9 -mfloat-abi=soft -mno-unaligned-access
mps2-an385_CC  := $(ARM_BARE)gcc -mthumb -mcpu=cortex-m3
mps2-an386_CC  := $(ARM_BARE)gcc -mthumb -mcpu=cortex-m4 -mfloat-abi=soft
mps2-an500_CC  := $(ARM_BARE)gcc -mthumb -mcpu=cortex-m7 -mfloat-abi=soft
microbit_CC    := $(ARM_BARE)gcc -mthumb -mcpu=cortex-m0
stm32vldiscovery_CC := $(mps2-an385_CC)
rv32_CC        := $(RISCV_BARE)gcc -march=rv32imac -mabi=ilp32
atmega1284p_CC := $(AVR_BARE)gcc -mmcu=atmega1284p -mrelax
BOARD := $(COMMON) -ffreestanding -iquote src -Iport -O2 -g -ffunction-sections -fdata-sections
BOARD_LD := -static -Wl,--gc-sections,--fatal-warnings
# Boards whose flash is too small for coherence.h: their programs use tia_core_spheres_small.
TIGHT_BOARDS := atmega1284p
spheres = core_spheres$(if $(filter $(1),$(TIGHT_BOARDS)),_small)
# The stack in bytes that a small board's program must have: the limit of tests/slow/freestanding for the core, 6720, or
# 5760 without coherence.h, or 3968 with TIA_CHUNK=16 and TIA_BALL_WORDS=8, and 512 for the program itself. tests/slow/boards measures how much of the stack is used.
small_stack = $(if $(filter $(1),$(TINY_BOARDS)),4480,$(if $(filter $(1),$(TIGHT_BOARDS)),6272,7232))
comma := ,
# The MPS2's images of a Cortex-M4 and M7 have their memory where that of a Cortex-M3 has it.
MORE_MPS2 := mps2-an386 mps2-an500
map_of = $(if $(filter $(MORE_MPS2),$(1)),mps2-an385,$(1))
large_map_of = $(if $(filter $(MORE_MPS2),$(1)),mps2-4m,$(1)-large)
# An AVR's linker script is an addition to avr-libc's; those of other boards are complete.
board_ld = $(if $(filter $(1),$(SMALL_BOARDS) $(TINY_BOARDS)),-Wl$(comma)--defsym=board_stack_min=$(call small_stack,$(1))) \
           $(if $(filter atmega%,$(1)),port/boards/$(1).ld,-nostdlib -Lport/boards -T port/boards/$(2).ld)

BOARD_SRC := port/boards/start.c port/boards/print.c port/boards/memcpy.c
PANEL_SRC := $(BOARD_SRC) port/ps2/ps2.c $(addprefix port/boards/,pl011.c counter.c pl11x.c pl050.c start-arm.S)
versatilepb_SRC := $(PANEL_SRC) port/boards/versatilepb.c
vexpress-a9_SRC := $(PANEL_SRC) port/boards/vexpress-a9.c
mps2-an385_SRC  := $(BOARD_SRC) port/boards/semihost.c port/boards/cortex-m.c
mps2-an386_SRC  := $(mps2-an385_SRC)
mps2-an500_SRC  := $(mps2-an385_SRC)
microbit_SRC    := $(mps2-an385_SRC)
stm32vldiscovery_SRC := $(mps2-an385_SRC)
rv32_SRC        := $(BOARD_SRC) port/boards/semihost.c port/boards/start-riscv.S
atmega1284p_SRC := port/boards/print.c port/boards/atmega1284p.c

# $(call board_compile,board,WHAT,options)
define board_compile
@mkdir -p $(@D)
$(call say,$(2),$< ($(1)))$($(1)_CC) $(3) -c -o $@ $<
endef

# $(call image,board,name,sources,linker script,objects): the rule for a board's program. Objects of the core in another
# arithmetic are in a folder named after it. All of the core is linked, or all that scenes of spheres may need on boards
# with programs for no others; --gc-sections drops what the program does not use.
SPHERE_SRC := $(filter src/math/% src/exact/% src/render/span/% src/render/core/dither.c src/render/core/spheres%.c \
    $(addprefix src/render/,view.c hits.c render.c choose.c drawing.c rows.c) src/scene/thesis.c src/scene/shadow_names.c \
    $(addprefix src/scene/check/,scene.c camera.c light.c material.c number_range.c sphere.c) \
    $(addprefix src/viewer/,viewer.c run_spheres.c view_memory.c tiles.c present.c press.c key_events.c watch.c),$(CORE_SRC))
core_of = $(if $(filter $(PANEL_BOARDS) mps2-an385,$(1)),$(CORE_SRC),$(SPHERE_SRC))
bare = $(patsubst %,$(BUILD)/boards/$(1)/%.o,$(basename $(2)))
define image
$(BUILD)/boards/$(1)/$(2).elf: $(call bare,$(1),$(3) $($(1)_SRC) $(call core_of,$(1))) $(5) $(wildcard port/boards/$(4).ld port/boards/$(1).ld) port/boards/sections.ld
	$$(call say,LD,$$@)$$($(1)_CC) $$(BOARD_LD) $(call board_ld,$(1),$(4)) -o $$@ $$(filter %.o,$$^) -lgcc
endef
define bare_rule
$(BUILD)/boards/$(1)/$(2)%.o: %.c port/boards/boards.mk
	$$(call board_compile,$(1),CC $(patsubst %/,%,$(2)),$$(BOARD) $(3))
endef
define board
$(call bare_rule,$(1),,)
$(call bare_rule,$(1),f32/,-DTIA_NUM_F32)
$(call bare_rule,$(1),f64/,-DTIA_NUM_F64)
$(BUILD)/boards/$(1)/%.o: %.S
	$$(call board_compile,$(1),AS)
endef
# Optimisation. Flash is scarce on small boards: all is compiled for size, and src/math/fast.h names what gcc compiles for
# speed even so, as in any other build by -Os. This list is for rays and shadows, which scenes of spheres do not link.
HOT := $(basename $(filter src/flat/% src/raster/% src/samples/% src/shadow/% src/math/normalise.c src/math/power.c \
	$(addprefix src/render/,ao/% estimate/% geometry/% hybrid/% path/% trace/% whitted/%),$(CORE_SRC)))
rv32_SMALL := -msave-restore
rv32_FAST := -mno-save-restore
# What includes fast.h, which AVRs do without; for rv32 beside -mno-save-restore.
FAST := $(basename $(shell grep -l '^.include "math/fast.h"' $(filter src/render/span/%,$(CORE_SRC)) </dev/null))
rv32_HOT := $(FAST)
atmega1284p_SMALL := -mcall-prologues -fno-inline
atmega1284p_FAST := -mno-call-prologues -finline
define optimised
$(BUILD)/boards/$(1)/%.o: BOARD += -Os -DTIA_BALL_WORDS=8 $($(1)_SMALL)
$(patsubst %,$(BUILD)/boards/$(1)/%.o,$(HOT) $($(1)_HOT)): BOARD += -O2 $($(1)_FAST)
$(BUILD)/boards/$(1)/f%.o: BOARD += -O2 $($(1)_FAST)
endef
stm32vldiscovery_SMALL := -DTIA_CHUNK=16
$(foreach b,$(SMALL_BOARDS) $(TINY_BOARDS),$(eval $(call optimised,$(b))))
# The program whose instructions are counted: arithmetic $(2), strips of $(3) rows; $(4) is 1 to store a whole frame's hits.
define counted
$(BUILD)/boards/$(1)/count-$(2).o: tests/boards/count.c
	$$(call board_compile,$(1),CC $(2),$$(BOARD) -DCORE=tia_$(if $(filter-out q16,$(2)),$(2)_)$(call spheres,$(1)) -DROWS=$(3) -DWHOLE=$(4))
$(call image,$(1),count-$(2),,$(call large_map_of,$(1)),$(BUILD)/boards/$(1)/count-$(2).o $(if $(filter-out q16,$(2)),$(call bare,$(1),tests/boards/soft_sqrt.c) $(call bare,$(1)/$(2),$(filter $(NUM_SRC),$(call core_of,$(1))))))
endef
# The program that draws $(2) spheres with $(3) lights, whose instructions are counted.
define crowded
$(BUILD)/boards/$(1)/crowd-$(2)-$(3).o: tests/boards/crowd.c
	$$(call board_compile,$(1),CC,$$(BOARD) -DSPHERES=$(2) -DLIGHTS=$(3))
$(call image,$(1),crowd-$(2)-$(3),,$(1)-large,$(BUILD)/boards/$(1)/crowd-$(2)-$(3).o)
endef
# The program that draws rows of $(1) random scenes, beginning with the number $(2), to compare with the bound of their instructions.
define bounded
$(BUILD)/boards/mps2-an385/bound-$(1)-$(2).o: tests/boards/bound.c
	$$(call board_compile,mps2-an385,CC,$$(BOARD) -DSCENES=$(1) -DSEED=$(2))
$(call image,mps2-an385,bound-$(1)-$(2),,mps2-an385-large,$(BUILD)/boards/mps2-an385/bound-$(1)-$(2).o)
endef
# The program whose checks are counted, in strips of $(2) rows.
define checked
$(BUILD)/boards/$(1)/trust-$(2).o: tests/boards/trust.c
	$$(call board_compile,$(1),CC,$$(BOARD) -DROWS=$(2))
$(call image,$(1),trust-$(2),,$(1)-large,$(BUILD)/boards/$(1)/trust-$(2).o)
endef
# The viewer of the compiled scene $(2).
define shown
$(BUILD)/boards/$(1)/shows-$(2).o: tools/boards/viewer.c
	$$(call board_compile,$(1),CC,$$(BOARD) -DSCENE=compiled_$(2))
$(BUILD)/boards/$(1)/scene-$(2).o: $(BUILD)/scenes/$(2).c
	$$(call board_compile,$(1),CC,$$(BOARD))
$(call image,$(1),$(2),,$(1),$(BUILD)/boards/$(1)/shows-$(2).o $(BUILD)/boards/$(1)/scene-$(2).o)
endef
# The program that draws scene $(1) of the Standard Procedural Databases ray by ray, to count its instructions; mps2-an385
# has memory for all of these scenes.
define rayed
$(BUILD)/boards/mps2-an385/rays-$(1).o: tests/boards/rays.c
	$$(call board_compile,mps2-an385,CC,$$(BOARD) -DSCENE=compiled_$(1))
$(BUILD)/boards/mps2-an385/scene-$(1).o: $(BUILD)/scenes/nff/$(1).c
	$$(call board_compile,mps2-an385,CC,$$(BOARD))
$(call image,mps2-an385,rays-$(1),,mps2-an385-large,$(BUILD)/boards/mps2-an385/rays-$(1).o $(BUILD)/boards/mps2-an385/scene-$(1).o)
endef
$(BUILD)/scenes/nff/%.c: scenes/nff/%.nff $(BUILD)/tia-compile
	@mkdir -p $(@D)
	$(call say,TABLES,$<)$(BUILD)/tia-compile $< -o $@ --name compiled_$*
# The boards whose compiler is installed; the tests report the others.
BOARDS := $(foreach b,$(PANEL_BOARDS) $(SMALL_BOARDS) $(TINY_BOARDS),$(if $(call found,$(firstword $($(b)_CC))),$(b)))
$(foreach b,$(BOARDS),$(eval $(call board,$(b))))
BOARDS_PANEL := $(filter $(PANEL_BOARDS),$(BOARDS))
BOARDS_SMALL := $(filter $(SMALL_BOARDS),$(BOARDS))
BOARDS_TINY := $(filter $(TINY_BOARDS),$(BOARDS))
$(foreach b,$(BOARDS_PANEL),$(eval $(call image,$(b),viewer,tools/boards/viewer.c,$(b))))
$(foreach b,$(BOARDS_PANEL),$(eval $(call shown,$(b),castle)))
$(foreach b,$(BOARDS_PANEL),$(eval $(call image,$(b),pattern,tests/boards/pattern.c,$(b))))
$(foreach b,$(BOARDS_SMALL),$(eval $(call image,$(b),frames,tests/boards/frames.c,$(call map_of,$(b)))))
$(BUILD)/boards/atmega1284p/tests/boards/frames.o: BOARD += -DROWS=1 -DLARGE=0 -DCORE=tia_core_spheres_small
# On the AVR a double is only a float, so there is no f64; a Cortex-M4 or M7 usually has an FPU. The RAM of the AVR and of the Cortex-M0 has room for one row.
counted_in = q16 $(if $(filter $(MORE_MPS2),$(1)),,f32 $(if $(findstring atmega,$(1)),,f64))
rows_of = $(if $(findstring atmega,$(1)),1,$(if $(findstring microbit,$(1)),1,3))
$(foreach b,$(BOARDS_SMALL),$(foreach n,$(call counted_in,$(b)),$(eval $(call counted,$(b),$(n),$(call rows_of,$(b),$(n)),$(if $(filter mps2-% rv32,$(b)),1,0)))))
# A Cortex-M0 of 16 KB has no room for 64 spheres.
BOARDS_CROWDED := $(filter mps2-an385 microbit rv32,$(BOARDS))
crowds_of = 4 16 $(if $(filter microbit,$(1)),,64)
$(foreach b,$(BOARDS_CROWDED),$(foreach n,$(call crowds_of,$(b)),$(eval $(call crowded,$(b),$(n),4))))
BOARDS_SHADOWS := $(filter vexpress-a9 mps2-an385,$(BOARDS))
$(foreach b,$(BOARDS_SHADOWS),$(eval $(call image,$(b),shadows,tests/boards/shadows.c,$(if $(filter mps2-an385,$(b)),$(b)-large,$(b)))))
RAYED := $(if $(filter mps2-an385,$(BOARDS)),$(patsubst scenes/nff/%.nff,%,$(wildcard scenes/nff/*.nff)))
$(foreach n,$(RAYED),$(eval $(call rayed,$(n))))
$(if $(filter mps2-an385,$(BOARDS)),$(foreach n,20-1 1000-2 600-3,$(eval $(call bounded,$(firstword $(subst -, ,$(n))),$(lastword $(subst -, ,$(n)))))))
.SECONDARY: $(RAYED:%=$(BUILD)/scenes/nff/%.c)
$(BUILD)/boards/shadows $(BUILD)/boards/light: $(BUILD)/boards/%: tests/boards/%.c $(LIBTIA)
	@mkdir -p $(@D)
	$(call say,LD,$@)$(CC) $(COMMON) $(CFLAGS) $(LDFLAGS) -o $@ $< $(LIBTIA)
$(BUILD)/boards/observed: $(BUILD)/host/tests/boards/observed.o $(LIBCOMMON) $(LIBPORTS) $(LIBWATCHED) $(LIBTIA) $(BUILD)/made-with/link
	@mkdir -p $(@D)
	$(link)
$(if $(filter mps2-an385,$(BOARDS)),$(eval $(call image,mps2-an385,light,tests/boards/light.c,mps2-an385-64k)))
EXAMPLES := $(filter mps2-an385 microbit rv32,$(BOARDS))
$(foreach b,$(EXAMPLES),$(eval $(call image,$(b),example,tests/boards/example_main.c,$(b))))
$(foreach b,$(BOARDS_TINY),$(eval $(call image,$(b),rows,tests/boards/rows_main.c,$(b))))
# The sources that are compiled once more, as other build systems do it: see tests/boards/ways.py.
$(BUILD)/boards/spheres: port/boards/boards.mk $(SPHERE_SRC)
	@mkdir -p $(@D) && echo $(SPHERE_SRC) >$@
$(if $(filter microbit,$(BOARDS)),$(eval $(call image,microbit,mul64,tests/boards/mul64.c,microbit)))
# What no board's program here uses is compiled for those that may: the example for two cores, such as an RP2040's, and the
# panels that receive what has changed.
OTHERS := $(patsubst %,$(BUILD)/boards/%/tests/boards/two_cores.o,$(filter microbit rv32,$(BOARDS))) \
          $(foreach b,$(filter microbit atmega1284p,$(BOARDS)),$(addprefix $(BUILD)/boards/$(b)/,port/spi-panel/spi_panel.o src/render/damage.o))
$(BUILD)/boards/%/tests/boards/two_cores.o: BOARD += -Wno-missing-prototypes
$(BUILD)/boards/example: tests/boards/example_main.c tests/boards/example.c tests/boards/thesis.h $(LIBTIA)
	@mkdir -p $(@D)
	$(call say,LD,$@)$(CC) $(COMMON) $(CFLAGS) $(LDFLAGS) -o $@ $< $(LIBTIA)
TRUST_ROWS := 2 8 24
$(if $(filter mps2-an385,$(BOARDS)),$(foreach n,$(TRUST_ROWS),$(eval $(call checked,mps2-an385,$(n)))))
TRUSTED := $(if $(filter mps2-an385,$(BOARDS)),$(TRUST_ROWS:%=$(BUILD)/boards/mps2-an385/trust-%.elf))
IMAGES := $(foreach n,viewer castle,$(BOARDS_PANEL:%=$(BUILD)/boards/%/$(n).elf)) $(BOARDS_PANEL:%=$(BUILD)/boards/%/pattern.elf) $(BOARDS_SMALL:%=$(BUILD)/boards/%/frames.elf) \
          $(BOARDS_SHADOWS:%=$(BUILD)/boards/%/shadows.elf)
CROWDED := $(foreach b,$(BOARDS_CROWDED),$(foreach n,$(call crowds_of,$(b)),$(BUILD)/boards/$(b)/crowd-$(n)-4.elf))
COUNTED := $(foreach b,$(BOARDS_SMALL),$(patsubst %,$(BUILD)/boards/$(b)/count-%.elf,$(call counted_in,$(b))))

$(BUILD)/boards/insn.so: tests/boards/insn.c
	@mkdir -p $(@D)
	$(call say,LD,$@)$(CC) -std=c11 $(WARN) -O2 -shared -fPIC -o $@ $<
# Runs an AVR's program. It is not built without libsimavr; the tests report that.
SIMAVR := $(if $(filter atmega1284p,$(BOARDS)),$(if $(wildcard /usr/include/simavr/sim_avr.h),$(BUILD)/boards/simavr))
$(BUILD)/boards/simavr: tests/boards/simavr.c
	@mkdir -p $(@D)
	$(call say,LD,$@)$(CC) -std=c11 -D_GNU_SOURCE $(WARN) -isystem /usr/include/simavr -O2 -o $@ $< -lsimavr -lelf

# The programs whose instructions are counted, and those that count instructions and rays.
COUNT_FILES := $(COUNTED) $(CROWDED) $(BOARDS_SHADOWS:%=$(BUILD)/boards/%/shadows.elf) $(BUILD)/boards/insn.so $(SIMAVR) \
               $(TRUSTED) $(RAYED:%=$(BUILD)/boards/mps2-an385/rays-%.elf) $(BUILD)/boards/observed

.PHONY: boards check-boards size-boards count count-rays cycles ways check-row-bound
boards: $(IMAGES) $(BOARDS_SMALL:%=$(BUILD)/boards/%/count-q16.elf) $(BUILD)/boards/insn.so $(SIMAVR) $(addprefix $(BUILD)/boards/,example shadows light) \
        $(if $(filter mps2-an385,$(BOARDS)),$(addprefix $(BUILD)/boards/mps2-an385/,light.elf bound-20-1.elf) $(BUILD)/boards/microbit/mul64.elf) \
        $(EXAMPLES:%=$(BUILD)/boards/%/example.elf) $(BOARDS_TINY:%=$(BUILD)/boards/%/rows.elf) $(BUILD)/boards/spheres $(OTHERS)
check: boards $(COUNT_FILES)
check-boards: all boards
	@$(run_tests) tests/slow/boards
size: size-boards
size-boards: boards
	@$(call python,tests/boards/size.py $(BUILD))
count: $(filter-out $(BUILD)/boards/mps2-an385/rays-%,$(COUNT_FILES))
	@$(call python,tests/boards/count.py $(BUILD))
cycles: $(BOARDS_SMALL:%=$(BUILD)/boards/%/count-q16.elf) $(BUILD)/boards/insn.so
	@$(call python,tests/boards/cycles.py $(BUILD))
ways: boards
	@$(call python,tests/boards/ways.py $(BUILD))
check-row-bound: $(addprefix $(BUILD)/boards/,mps2-an385/bound-1000-2.elf insn.so)
	@$(call python,tests/boards/bound.py $(BUILD) 1000-2)
count-rays: $(RAYED:%=$(BUILD)/boards/mps2-an385/rays-%.elf) $(BUILD)/boards/insn.so
	@$(call python,tests/boards/count.py --rays $(BUILD))
