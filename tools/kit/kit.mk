# kit.mk - what the packages for Python and npm carry: `make kit` builds the shared library and the WebAssembly module,
# `make python` a wheel and `make npm` a tarball; the Makefile includes it. package/python, package/npm, docs/kit.md

KIT := $(BUILD)/kit
KIT_C := $(sort $(wildcard tools/kit/*.c) $(addprefix tools/web/,alone.c whole_file.c) $(addprefix tools/common/,checksum.c \
         message_clean.c scene/moment.c scene/scene_load.c scene/scene_part.c scene/scene_report.c scene/model/model.c image/decode.c image/texels.c))
LIBKIT := $(KIT)/libtia-kit.so

# Without optional libraries: the package needs nothing but libc, and reads what the WebAssembly module reads.
KIT_HOSTED := $(filter-out -DTIA_HAVE_%,$(HOSTED))
$(BUILD)/pic/tools/%.o: tools/%.c $(BUILD)/made-with/host
	$(call compile,CC pic,$(KIT_HOSTED) $(PIC))
$(LIBKIT): $(call obj,pic,$(KIT_C) $(CORE_SRC) $(SIMD_SRC) port/simd/best.c) tools/kit/kit.map $(BUILD)/made-with/link
	@mkdir -p $(@D)
	$(call say,LD,$@)$(CC) -shared $(CFLAGS) $(LDFLAGS) -Wl,--version-script,tools/kit/kit.map -Wl,-z,defs -Wl,--gc-sections -s \
	    -o $@ $(filter %.o,$^) -lm

$(KIT)/tia-kit.wasm: $(call web_obj,q16,$(CORE_SRC)) $(call web_obj,simd,$(WASM_SIMD) port/simd/best.c) \
    $(call web_obj,tools,$(KIT_C) tools/web/no_files.c)
	$(link_wasm)

# Copies of package/python and package/npm, with what is built: what their tools pack.
.PHONY: kit python npm
KIT_PYTHON := $(KIT)/python
KIT_NPM := $(KIT)/npm
kit: $(LIBKIT) $(KIT)/tia-kit.wasm
python: $(LIBKIT)
	$(call say,COPY,$(KIT_PYTHON))rm -rf $(KIT_PYTHON) && mkdir -p $(KIT_PYTHON) && cp -R package/python/. LICENSE $(KIT_PYTHON) \
	    && cp $(LIBKIT) $(KIT_PYTHON)/tia_kit && echo $(VERSION) >$(KIT_PYTHON)/tia_kit/VERSION
	$(call say,WHEEL,$(KIT))cd $(KIT_PYTHON) && $(PYTHON) setup.py -q bdist_wheel -d .. 2>wheel.log \
	    || { tail -5 wheel.log >&2; exit 1; }
# The tarball is as `npm pack` makes it: all files below package/. npm itself, which Debian makes of hundreds of packages, is not needed.
npm: $(KIT)/tia-kit.wasm
	$(call say,PACK,$(KIT)/tia-kit-$(VERSION).tgz)rm -rf $(KIT_NPM) && mkdir -p $(KIT_NPM) && cp -R package/npm $(KIT_NPM)/package \
	    && cp LICENSE $< $(KIT_NPM)/package && sed -i 's/@VERSION@/$(VERSION)/' $(KIT_NPM)/package/package.json \
	    && tar --sort=name --owner=0 --group=0 --numeric-owner -C $(KIT_NPM) -czf $(KIT)/tia-kit-$(VERSION).tgz package
