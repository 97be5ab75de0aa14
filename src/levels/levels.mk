# levels.mk - which levels of vector units this compiler makes; the Makefile includes it.

# Vector units: a library of its own, with floating point. A level is a file of src/levels with its own flags, and there
# where the compiler takes them and has plain floats: neither -ffast-math nor a coprocessor that computes wider.
LEVELS_SRC := $(filter src/levels/%,$(CORE_SRC))
CORE_SRC  := $(filter-out src/levels/%,$(CORE_SRC))
LEVEL_NAMES := scalar sse41 avx2 avx512 neon neon32 wasm
flags_scalar :=
flags_sse41  := -msse4.1
flags_avx2   := -mavx2 -mfma
flags_avx512 := -mavx512f -mavx512bw -mavx512dq -mavx512vl
flags_neon   :=
flags_neon32 := -mfpu=neon
flags_wasm   := -msimd128
LEVELS ?= $(if $(BARE),no,yes)
# tools/generate would be too late: the compiler is asked with a line for each level.
LEVELS_HAD := $(if $(filter no,$(LEVELS)),,$(strip $(foreach l,$(LEVEL_NAMES),$(shell $(CC) -std=c11 $(CFLAGS) $(flags_$(l)) -DASK_$(l) -E -P src/levels/asked.h 2>/dev/null | grep -c '^yes$$' | sed -n 's/1/$(l)/p'))))
# `make run` alone makes the one that this processor can do best, beside those that are there.
ifneq ($(LEAN),)
level_asked = $(shell $(CC) -std=c11 $(CFLAGS) -march=native -DASK_$(1) -E -P src/levels/asked.h 2>/dev/null | sed -n 's/^yes$$/$(1)/p')
LEVEL_BEST := $(lastword $(foreach l,$(LEVELS_HAD),$(call level_asked,$(l))))
LEVELS_HAD := $(if $(LEVEL_BEST),$(foreach l,$(LEVELS_HAD),$(if $(filter $(LEVEL_BEST),$(l))$(wildcard $(BUILD)/levels/src/levels/rays/$(l).o),$(l))),$(LEVELS_HAD))
endif
LEVELS_SRC := $(filter-out $(foreach l,$(filter-out $(LEVELS_HAD),$(LEVEL_NAMES)),src/levels/$(l).c src/levels/rays/$(l).c),$(LEVELS_SRC))
HAVE_LEVELS := $(addprefix -DTIA_HAVE_,$(shell echo $(LEVELS_HAD) | tr a-z A-Z))
