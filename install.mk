# install.mk - what others link, and what is installed where; the Makefile includes it.
#
#   make install PREFIX=/usr LIBDIR=lib/x86_64-linux-gnu DESTDIR=root

PYTHON ?= $(call found,python3)
PREFIX  ?= /usr/local
DESTDIR ?=
LIBDIR  ?= lib

# ---- the shared library: the core and the vector units ----
# Of its symbols those are seen that libtia.map lists: what the installed headers declare.
$(BUILD)/pic/%.o: %.c $(BUILD)/made-with/core
	$(call compile,CC pic,$(CORE) $(PIC))
$(BUILD)/pic/src/simd/%.o: src/simd/%.c $(BUILD)/made-with/simd
	$(call compile,CC pic,$(call simd_flags,$*) $(PIC))
$(BUILD)/pic/port/simd/%.o: port/simd/%.c $(BUILD)/made-with/host $(BUILD)/made-with/parts
	$(call compile,CC pic,$(HOSTED) $(HAVE_SIMD) $(PIC))
PIC := -fPIC -fno-semantic-interposition
$(LIBSHARED): $(call obj,pic,$(CORE_SRC) $(SIMD_SRC) port/simd/best.c) libtia.map $(BUILD)/made-with/link
	$(call say,LD,$@)$(CC) -shared $(CFLAGS) $(LDFLAGS) -Wl,-soname,$(notdir $@) -Wl,--version-script,libtia.map -Wl,-z,defs \
	    -o $@ $(filter %.o,$^) -lm

# ---- how other builds find it ----
HOMEPAGE := $(if $(wildcard package/home.txt),$(shell sed -n 's/^homepage *= *//p' package/home.txt))
define PC
prefix=$(PREFIX)
libdir=$${prefix}/$(LIBDIR)
includedir=$${prefix}/include

Name: $(1)
Description: $(2)
Version: $(VERSION)
$(if $(HOMEPAGE),URL: $(HOMEPAGE)
)Cflags: -I$${includedir}
Libs: -L$${libdir} -l$(1)$(4)
Libs.private: $(3)

endef
# write_pc: the target by PC. It is written when make expands the recipe, perhaps before anything else is built.
write_pc = $(shell mkdir -p $(@D))$(file >$@,$(call PC,$(1),$(2),$(3),$(4)))@:
# A static library that another one needs, and that needs it, stands twice.
$(BUILD)/tia.pc: install.mk include/tia/tia.h FORCE
	$(call write_pc,tia,integer-only ray tracer,$(if $(BARE),,-ltia-simd -ltia -lm))
# It is static, and needs more of the core than libtia.so shows.
$(BUILD)/tia-radio.pc: install.mk include/tia/tia.h FORCE
	$(call write_pc,tia-radio,paths of radio waves for the ray tracer tia,, $${libdir}/libtia.a)


# The freestanding ports: a panel on a serial bus, a keyboard's bytes.
PORTABLE := port/spi-panel/spi_panel port/ps2/ps2
PORT_HEADERS := $(PORTABLE:%=%.h)
$(LIBDEVICES): $(patsubst %,$(BUILD)/q16/%.o,$(PORTABLE))
$(BUILD)/q16/port/%.o: CORE += -Iport

# ---- the library as two files, for builds that know no other way: python3 writes them ----
.PHONY: amalgamation
amalgamation: $(if $(PYTHON),$(BUILD)/amalgamation/tia.c)
	@$(if $(PYTHON),:,echo "amalgamation: python3 not found (make deps check installs it)" >&2; exit 1)
$(BUILD)/amalgamation/tia.c: tools/generate/amalgamation.py $(CORE_SRC) $(RADIO_SRC) $(wildcard include/tia/*.h src/*/*.h src/*/*/*.h src/*/*/*/*.h)
	$(call say,WRITE,$(@D))$(PYTHON) $< $(@D) $(CORE_SRC) $(RADIO_SRC)

# As Arduino wants a library: with headers at the top of src/.
.PHONY: arduino
ARDUINO := $(BUILD)/arduino/tia
arduino: tools/generate/amalgamation.py $(CORE_SRC) $(wildcard include/tia/*.h src/*/*.h src/*/*/*.h src/*/*/*/*.h package/arduino/* package/arduino/*/* package/arduino/examples/*/*) tests/boards/thesis.h
	$(call say,WRITE,$(ARDUINO))rm -rf $(ARDUINO) && mkdir -p $(ARDUINO) && cp -R package/arduino/. LICENSE $(ARDUINO) \
	    && cp tests/boards/thesis.h $(ARDUINO)/src/tia_thesis.h && $(or $(PYTHON),python3) $< $(ARDUINO)/src $(CORE_SRC)

# ---- what is installed: mode:file:place below PREFIX ----
# Colours of scene files in editors. Visual Studio Code and Pygments take theirs from a folder that users name.
EDITORS := package/editors
EDITOR_PLACES := 644:$(EDITORS)/nano/tia.nanorc:share/nano/tia.nanorc \
    $(foreach v,4 5,644:$(EDITORS)/gtksourceview/tia.lang:share/gtksourceview-$(v)/language-specs/tia.lang) \
    $(foreach f,$(wildcard $(EDITORS)/vim/*/tia.vim),644:$(f):$(f:$(EDITORS)/vim/%=share/vim/vimfiles/%)) \
    $(foreach f,$(wildcard $(addprefix $(EDITORS)/,vscode/*.json vscode/*/*.json pygments/*.*)),644:$(f):$(f:$(EDITORS)/%=share/tia/%))
INSTALLED := $(if $(LIBF64),$(PROGRAMS),$(filter-out tia-compare,$(PROGRAMS)))
PLACES := $(foreach p,$(INSTALLED),755:$(BUILD)/$(p):bin/$(p) 644:man/$(p).1:share/man/man1/$(p).1) \
    644:man/tia-scene.5:share/man/man5/tia-scene.5 \
    $(foreach l,$(LIBTIA) $(LIBRADIO) $(LIBDEVICES) $(if $(BARE),,$(LIBSIMD)),644:$(l):$(LIBDIR)/$(notdir $(l))) \
    $(if $(BARE),,644:$(LIBSHARED):$(LIBDIR)/libtia.so.$(VERSION)) \
    $(foreach n,tia tia-radio,644:$(BUILD)/$(n).pc:$(LIBDIR)/pkgconfig/$(n).pc) \
    $(foreach n,$(wildcard package/cmake/*.cmake),644:$(BUILD)/$(notdir $(n)):$(LIBDIR)/cmake/tia/$(notdir $(n))) \
    $(foreach h,$(wildcard include/tia/*.h),644:$(h):$(h)) \
    $(foreach h,$(PORT_HEADERS),644:$(h):include/tia/ports/$(notdir $(h))) \
    $(foreach s,$(wildcard scenes/*.* scenes/*/*.*),644:$(s):share/tia/$(s)) \
    644:LICENSE:share/doc/tia/LICENSE 644:README.md:share/doc/tia/README.md \
    $(if $(BARE),,$(EDITOR_PLACES) 644:package/complete/tia.bash:share/bash-completion/completions/tia \
    644:package/freedesktop/tia.thumbnailer:share/thumbnailers/tia.thumbnailer 644:package/freedesktop/tia.xml:share/mime/packages/tia.xml \
    644:package/editors/vim/compiler/tia.vim:share/vim/vimfiles/compiler/tia.vim \
    644:package/complete/_tia:share/zsh/site-functions/_tia 644:package/complete/tia.fish:share/fish/vendor_completions.d/tia.fish)
# The reference, a page for each header and one that leads to it for each function: python3 writes it.
paren := (
RADIO_NAMES = $(shell sed -n 's/^[a-z].*[ *]\(tia_radio_[a-z_]*\)$(paren).*/\1/p' include/tia/radio.h)
MAN3 = $(sort $(RADIO_NAMES) $(patsubst tia_tia,tia,$(patsubst include/tia/%.h,tia_%,$(wildcard include/tia/*.h))) \
    $(patsubst %;,%,$(filter tia_%;,$(file <libtia.map))))
MAN3_DIR = $(DESTDIR)$(PREFIX)/share/man/man3
$(BUILD)/man3.made: tools/generate/reference.py libtia.map man/tia.1 $(wildcard include/tia/*.h)
	$(call say,PAGES,$(BUILD)/man3)$(PYTHON) $< $(BUILD)/man3 && touch $@
.PHONY: man3
ifneq ($(PYTHON),)
man3: $(BUILD)/man3.made
put_man3 = $(call say,INSTALL,$(MAN3_DIR))install -d $(MAN3_DIR) && install -m 644 $(MAN3:%=$(BUILD)/man3/%.3) $(MAN3_DIR)
else
man3:
	@echo "note: no python3: without the man pages of section 3 (make deps check installs it)"
endif

# ---- packages for Debian: built from a copy of the sources, as dpkg-buildpackage wants them ----
.PHONY: deb
DEB := $(BUILD)/deb
DEB_TREE := $(DEB)/tia-$(VERSION)
deb:
	@command -v dpkg-buildpackage >/dev/null || { echo "deb: dpkg-buildpackage not found (make deps check installs it)" >&2; exit 1; }
	$(call say,COPY,$(DEB_TREE))rm -rf $(DEB) && mkdir -p $(DEB_TREE) && cp -R $(filter-out build $(firstword $(subst /, ,$(BUILD))),$(wildcard *)) $(DEB_TREE) \
	    && cp -R package/debian $(DEB_TREE)/debian
	$(call say,BUILD,$(DEB)/*.deb)cd $(DEB_TREE) && env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL -u BUILD -u CC -u F64 dpkg-buildpackage -us -uc -b >../build.log 2>&1 \
	    || { tail -20 ../build.log >&2; exit 1; }
	@ls $(DEB)/*.deb

# Names of the shared library that lead to it.
SHARED_LINKS := $(if $(BARE),,$(LIBDIR)/libtia.so.0 $(LIBDIR)/libtia.so)
$(BUILD)/%.cmake: package/cmake/%.cmake include/tia/tia.h
	@sed 's/@VERSION@/$(VERSION)/' $< >$@
mode_of = $(word 1,$(subst :, ,$(1)))
from    = $(word 2,$(subst :, ,$(1)))
place   = $(word 3,$(subst :, ,$(1)))
put     = $(call say,INSTALL,$(DESTDIR)$(PREFIX)/$(call place,$(1)))install -D -m $(call mode_of,$(1)) $(call from,$(1)) $(DESTDIR)$(PREFIX)/$(call place,$(1))$(newline)
shared_link = @ln -sf libtia.so.$(VERSION) $(DESTDIR)$(PREFIX)/$(1)$(newline)
install: all man3 $(if $(BARE),,$(LIBSHARED)) $(filter $(BUILD)/%.pc $(BUILD)/%.cmake,$(foreach p,$(PLACES),$(call from,$(p))))
	$(foreach p,$(PLACES),$(call put,$(p)))$(foreach l,$(SHARED_LINKS),$(call shared_link,$(l)))
	$(put_man3)
# Folders that are left empty are removed, too, up to PREFIX.
uninstall:
	$(call say,REMOVE,$(DESTDIR)$(PREFIX))cd $(DESTDIR)$(PREFIX) && rm -f $(foreach p,$(PLACES),$(call place,$(p))) $(SHARED_LINKS) \
	    $(MAN3:%=share/man/man3/%.3) && rmdir -p $(sort share/man/man3/ $(foreach p,$(PLACES),$(dir $(call place,$(p))))) 2>/dev/null || :
