# web.mk - `make web`: a page with the viewer in WebAssembly, in $(BUILD)/web, for any static server; the Makefile
# includes it. The core is freestanding; the tools use wasi-libc for memory, strings and functions of real numbers.

WEB     := $(BUILD)/web
WEB_O   := $(BUILD)/wasm
WASM_CC ?= clang
WASM_LD ?= wasm-ld
# No 128-bit integers: without an instruction for their products clang calls a function, which takes 1.25 times as long.
WASM_CFLAGS ?= -O2 -mbulk-memory -DTIA_NO_INT128
WASM_LIB := /usr/lib/wasm32-wasi
WASM_BUILTINS = $(shell $(WASM_CC) --print-resource-dir 2>/dev/null)/lib/wasi/libclang_rt.builtins-wasm32.a

WEB_TOOLS := $(sort $(wildcard tools/web/*.c) port/web/web.c tools/common/light_copy.c tools/common/checksum.c tools/common/steer.c \
             tools/common/crc_join.c \
             $(wildcard tools/common/views/*.c) $(addprefix tools/common/,message_clean.c scene/moment.c scene/scene_load.c scene/scene_part.c scene/scene_report.c scene/model/model.c image/decode.c image/texels.c \
             record/record.c record/row_hashes.c record/merkle.c record/sha256.c))
web_obj = $(patsubst %.c,$(WEB_O)/$(1)/%.o,$(2))
WASM_CORE = $(WASM_CC) --target=wasm32 $(CORE) $(WASM_CFLAGS)
WASM_TOOL = $(WASM_CC) --target=wasm32-wasi --sysroot=/usr $(COMMON) -D_GNU_SOURCE -Iport -Itools $(WASM_CFLAGS)
$(WEB_O)/q16/%.o: %.c
	@mkdir -p $(@D)
	$(call say,WASM,$<)$(WASM_CORE) -c -o $@ $<
$(WEB_O)/f64/%.o: %.c
	@mkdir -p $(@D)
	$(call say,WASM f64,$<)$(WASM_CORE) -DTIA_NUM_F64 -fno-math-errno -c -o $@ $<
$(WEB_O)/watched/%.o: %.c
	@mkdir -p $(@D)
	$(call say,WASM obs,$<)$(WASM_CORE) -DTIA_WATCHED -c -o $@ $<
$(WEB_O)/tools/%.o: %.c
	@mkdir -p $(@D)
	$(call say,WASM,$<)$(WASM_TOOL) -c -o $@ $<

# The code for vector units, of all instruction sets only wasm.
WASM_SIMD := $(filter-out $(foreach l,$(filter-out wasm,$(SIMD_NAMES)),src/simd/$(l).c src/simd/rays/$(l).c),$(call c_below,src/simd))
$(WEB_O)/simd/%.o: %.c
	@mkdir -p $(@D)
	$(call say,WASM,$<)$(WASM_TOOL) -iquote src -fno-math-errno -ffp-contract=$(if $(filter src/simd/rays/%,$<),fast,off) -DTIA_HAVE_WASM \
	    $(if $(filter %/wasm.c,$<),$(flags_wasm)) -c -o $@ $<

# Bytes of stack of a page's thread: paths and Whitted's rays have arrays of fixed size on it.
WEB_STACK := 1048576
define link_wasm
@mkdir -p $(@D)
$(call say,LD,$@)$(WASM_LD) --no-entry --gc-sections --strip-all --compress-relocations --fatal-warnings -z stack-size=$(WEB_STACK) \
    -o $@ $^ -L$(WASM_LIB) -lc $(WASM_BUILTINS)
endef
$(WEB)/tia.wasm: $(call web_obj,q16,$(CORE_SRC)) $(call web_obj,f64,$(NUM_SRC)) $(call web_obj,watched,$(NUM_SRC)) $(call web_obj,simd,$(WASM_SIMD) port/simd/best.c) \
    $(call web_obj,tools,$(WEB_TOOLS))
	$(link_wasm)

# WebGL 2 beside the exact rasteriser, docs/conform.md.
$(WEB)/conform.wasm: $(call web_obj,q16,$(CORE_SRC)) $(call web_obj,tools,$(addprefix bench/conform/,conform_page.c compare.c trial.c shrink.c) tools/web/no_files.c)
	$(link_wasm)

# The page, and the scenes with their files.
WEB_PAGE   := $(patsubst tools/web/page/%,$(WEB)/%,$(filter-out %/sw.js,$(wildcard tools/web/page/*)))
WEB_SCENES := $(patsubst %,$(WEB)/%,$(wildcard scenes/*.tia scenes/*.p[gp]m scenes/*.ply))
$(WEB)/%: tools/web/page/%
	@mkdir -p $(@D)
	$(call say,COPY,$@)cp $< $@
$(WEB)/scenes/%: scenes/%
	@mkdir -p $(@D)
	$(call say,COPY,$@)cp $< $@
# Small pictures of the scenes, by the command.
WEB_THUMBNAILS := $(if $(filter yes,$(PNG)),$(patsubst scenes/%.tia,$(WEB)/thumbnails/%.png,$(wildcard scenes/*.tia)))
$(WEB)/thumbnails/%.png: scenes/%.tia $(BUILD)/tia
	@mkdir -p $(@D)
	$(call say,DRAW,$@)$(BUILD)/tia $< -s 160x120 $(if $(filter thesis,$*),-k a) -o $@
# The reference of scene files, and the editor's help, from the manual; with its pictures.
WEB_LANGUAGE := $(if $(call found,python3),$(addprefix $(WEB)/,language.html language.json $(patsubst docs/%,%,$(wildcard docs/language/*.png))))
$(WEB_LANGUAGE) &: $(addprefix tools/generate/,language.py mdoc.py words.py) man/tia-scene.5 $(wildcard docs/language/*.png) $(BUILD)/tests/scene_words
	$(call say,WRITE,$(WEB)/language.html)$(or $(PYTHON),python3) tools/generate/language.py $(BUILD) --page $(WEB)
# The service worker: with the names of all files, and a hash of them as its version.
$(WEB)/sw.js: tools/web/page/sw.js $(WEB)/tia.wasm $(WEB)/conform.wasm $(WEB_PAGE) $(WEB_SCENES) $(WEB_THUMBNAILS) $(WEB_LANGUAGE) $(WEB)/gallery.json
	$(call say,LIST,$@)sed "s|@VERSION@|$$(cat $^ | sha256sum | cut -c 1-16)|; s|@FILES@|$(subst $() $(),'$(comma) ',$(patsubst $(WEB)/%,%,$(filter $(WEB)/%,$^)))|" $< >$@
# The names of the scenes, and the checksums of tests/golden/web.crc.
$(WEB)/gallery.json: tests/golden/web.crc $(wildcard scenes/*.tia) port/web/web.mk
	@mkdir -p $(@D)
	$(call say,LIST,$@){ printf '{"version": "%s",\n "scenes": [%s],\n "pinned": {\n' '$(VERSION)' \
	    '$(subst $() $(),$(comma) ,$(patsubst scenes/%.tia,"%",$(wildcard scenes/*.tia)))'; \
	    sed -n '/^[^#]/s/\(.*\) \([0-9a-f]*\)$$/  "\1": "\2"/p' $< | sed '$$!s/$$/,/'; printf '}}\n'; } >$@

WEB_MISSING = $(strip $(if $(call found,$(WASM_CC)),,clang) $(if $(call found,$(WASM_LD)),,lld) \
    $(if $(wildcard $(WASM_LIB)/libc.a),,wasi-libc) $(if $(wildcard $(WASM_BUILTINS)),,libclang-rt-14-dev-wasm32))
# `check` builds the page before testing it. Only for these goals is the compiler run to find missing tools.
.PHONY: web
ifneq ($(filter web check,$(MAKECMDGOALS)),)
check: $(if $(WEB_MISSING),,web)
ifeq ($(WEB_MISSING),)
web: $(WEB)/sw.js
	@echo "web: python3 -m http.server -d $(WEB), then http://localhost:8000/"
else
web:
	@echo "web: no $(subst $() $(),$(comma) no ,$(WEB_MISSING)): the page cannot be built (make deps check installs it)" >&2; exit 1
endif
endif
