# simd.mk - the instruction sets that this compiler makes; the Makefile includes it.

# Vector units: a library of its own, with floating point. An instruction set is a file of src/simd and one of
# src/simd/rays with flags of their own; it is made where the compiler takes these and has plain floats: neither
# -ffast-math nor a coprocessor that computes wider.
SIMD_SRC := $(filter src/simd/%,$(CORE_SRC))
CORE_SRC  := $(filter-out src/simd/%,$(CORE_SRC))
SIMD_NAMES := scalar sse41 avx2 avx512 neon neon32 rvv wasm
flags_scalar :=
flags_sse41  := -msse4.1
flags_avx2   := -mavx2 -mfma
flags_avx512 := -mavx512f -mavx512bw -mavx512dq -mavx512vl
flags_neon   :=
flags_neon32 := -mfpu=neon
flags_rvv    := -march=rv64gcv
flags_wasm   := -msimd128
# yes, no, or the instruction sets that are wanted.
SIMD ?= $(if $(BARE),no,yes)
SIMD_WANTED := $(if $(filter yes,$(SIMD)),$(SIMD_NAMES),$(filter-out no,$(SIMD)))
# tools/generate would be too late: the compiler is tried with a line for each instruction set.
SIMD_HAD := $(strip $(foreach l,$(SIMD_WANTED),$(shell $(CC) -std=c11 $(CFLAGS) $(flags_$(l)) -DASK_$(l) -E -P src/simd/probe.h 2>/dev/null | grep -c '^yes$$' | sed -n 's/1/$(l)/p')))
# `make run` alone makes the best instruction set of this processor, besides those that are built already.
ifneq ($(LEAN),)
simd_asked = $(shell $(CC) -std=c11 $(CFLAGS) -march=native -DASK_$(1) -E -P src/simd/probe.h 2>/dev/null | sed -n 's/^yes$$/$(1)/p')
SIMD_BEST := $(lastword $(foreach l,$(SIMD_HAD),$(call simd_asked,$(l))))
SIMD_HAD := $(if $(SIMD_BEST),$(foreach l,$(SIMD_HAD),$(if $(filter $(SIMD_BEST),$(l))$(wildcard $(BUILD)/simd/src/simd/rays/$(l).o),$(l))),$(SIMD_HAD))
endif
SIMD_SRC := $(filter-out $(foreach l,$(filter-out $(SIMD_HAD),$(SIMD_NAMES)),src/simd/$(l).c src/simd/rays/$(l).c),$(SIMD_SRC))
HAVE_SIMD := $(addprefix -DTIA_HAVE_,$(shell echo $(SIMD_HAD) | tr a-z A-Z))
