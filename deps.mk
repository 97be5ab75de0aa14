# deps.mk - what Debian 12 has for it; `make deps GOALS` installs what these goals use and is missing, with sudo when
# not root. `make deps run`: what the command needs. `make deps`: what a build can use. A goal without a list of its own,
# as `make deps check`: everything. With -n nothing is installed, and what would be is listed.
DEPS_BUILD := gcc libc6-dev pkg-config libdrm-dev libpng-dev
DEPS_ALL := libstb-dev libchafa-dev libjansson-dev libassimp-dev libglib2.0-dev libosmesa6-dev libegl-dev libgl1-mesa-dri
# What tests/slow/arch builds with, and what only all of its builds want.
DEPS_ARCH := gcc-i686-linux-gnu gcc-arm-linux-gnueabi gcc-arm-linux-gnueabihf gcc-aarch64-linux-gnu \
        gcc-riscv64-linux-gnu gcc-s390x-linux-gnu libc6-dev-i386-cross \
        libc6-dev-armel-cross libc6-dev-armhf-cross libc6-dev-arm64-cross libc6-dev-riscv64-cross \
        libc6-dev-s390x-cross lib32gcc-12-dev libc6-dev-i386 qemu-user-static \
        gcc-m68k-linux-gnu libc6-dev-m68k-cross gcc-mips64el-linux-gnuabi64 libc6-dev-mips64el-cross tcc
DEPS_ARCH_FULL := gcc-powerpc-linux-gnu libc6-dev-powerpc-cross gcc-powerpc64le-linux-gnu libc6-dev-ppc64el-cross \
        gcc-mips-linux-gnu libc6-dev-mips-cross gcc-sparc64-linux-gnu libc6-dev-sparc64-cross \
        gcc-hppa-linux-gnu libc6-dev-hppa-cross gcc-alpha-linux-gnu libc6.1-dev-alpha-cross
DEPS_CHECK := make python3 clang clang-format clang-tidy llvm cppcheck libclang-rt-14-dev universal-ctags file binutils man-db \
        $(DEPS_ARCH) \
        gcc-arm-none-eabi gcc-riscv64-unknown-elf qemu-system-arm qemu-system-misc frama-c-base why3 z3 cvc4 gappa \
        qemu-system-x86 seabios busybox-static xz-utils linux-headers-amd64 povray tmux screen zsh fish g++ cmake \
        wasi-libc libclang-rt-14-dev-wasm32 lld clang-16 nodejs chromium fonts-dejavu-core \
        parallel openssh-server openssh-client slurm-wlm slurm-client slurmctld slurmd munge \
        debhelper dpkg-dev lintian mmdebstrap libgl-dev \
        arduino-builder arduino-ctags arduino-core-avr picolibc-arm-none-eabi \
        python3-setuptools python3-wheel python3-pip python3-pytest \
        gcc-avr avr-libc libsimavr-dev libelf-dev sweethome3d-furniture assimp-testmodels glmark2-data \
        shared-mime-info openexr chafa \
        vim nano python3-pygments python3-gi gir1.2-gtksource-4
deps_of_run := $(DEPS_BUILD)
deps_of_all := $(DEPS_BUILD) $(DEPS_ALL)
deps_of_install := $(deps_of_all)
deps_of_bench := $(deps_of_all)
deps_of_gallery := $(deps_of_all)
deps_of_docs = $(deps_of_all) $(deps_of_counted)
deps_of_web := clang lld wasi-libc libclang-rt-14-dev-wasm32
deps_of_deb := debhelper dpkg-dev
deps_of_boards := gcc-arm-none-eabi gcc-riscv64-unknown-elf gcc-avr avr-libc python3
deps_of_counted := $(deps_of_all) $(deps_of_boards) qemu-system-arm qemu-system-misc libsimavr-dev libelf-dev cmake
deps_of_prove := gappa frama-c-base why3 z3 cvc4 python3
deps_of_check-arch := gcc libc6-dev python3 clang libclang-rt-14-dev libclang-rt-14-dev-wasm32 wasi-libc lld nodejs \
        $(DEPS_ARCH) $(DEPS_ARCH_FULL)
deps_of_evidence = $(deps_of_all) gcc-arm-none-eabi gcc-riscv64-unknown-elf frama-c-base cppcheck clang clang-tidy llvm \
        libclang-rt-14-dev python3
deps_of_language := $(deps_of_all) python3
deps_of_lint := clang-format
deps_of_man3 := python3
deps_of_amalgamation := python3
deps_of_arduino := python3
deps_of_clean :=
deps_of_help :=
deps_of_uninstall :=
deps_of = $(if $(filter undefined,$(origin deps_of_$(1))),$(DEPS_BUILD) $(DEPS_ALL) $(DEPS_CHECK),$(deps_of_$(1)))
ifneq ($(filter deps,$(MAKECMDGOALS)),)
DEPS := $(sort $(foreach g,$(or $(GOALS),all),$(call deps_of,$(g))))
DEPS_MISSING := $(if $(DEPS),$(filter-out $(shell dpkg-query -W -f '$${Package} $${Status}\n' $(DEPS) 2>/dev/null | \
                                     sed -n 's/ install ok installed$$//p'),$(DEPS)))
# Make makes included files even with -n, -q and -t.
ifneq ($(strip $(foreach f,n q t,$(findstring $(f),$(firstword -$(MAKEFLAGS))))),)
$(if $(DEPS_MISSING),$(info deps: apt-get would install $(DEPS_MISSING)))
else
# An included file that is out of date is made first and the Makefile is read again: so the
# libraries are found in the same call that installs them.
$(BUILD)/deps.mk: $(if $(DEPS_MISSING),FORCE)
	@mkdir -p $(@D)
	@if [ -n "$(DEPS_MISSING)" ]; then \
	    command -v apt-get >/dev/null || { echo "deps: no apt-get here; Debian calls what is missing: $(DEPS_MISSING)" >&2; exit 1; }; \
	    sudo=; [ "$$(id -u)" = 0 ] || sudo=sudo; \
	    [ -z "$$sudo" ] || command -v sudo >/dev/null || { echo "deps: no sudo here; as root: apt-get install $(DEPS_MISSING)" >&2; \
	        echo "deps: or leave out what they are for: make $(filter-out deps,$(MAKECMDGOALS))" >&2; exit 1; }; \
	    echo "deps: apt-get installs $(DEPS_MISSING) ($(BUILD)/deps.log)"; \
	    { $$sudo apt-get update -q && \
	      $$sudo env DEBIAN_FRONTEND=noninteractive apt-get install -qy --no-install-recommends $(DEPS_MISSING); } \
	        >$(BUILD)/deps.log 2>&1 || { tail -20 $(BUILD)/deps.log >&2; exit 1; }; fi
	@touch $@
include $(BUILD)/deps.mk
endif
endif
