# pictures.mk - draws the pictures of README.md and docs/ again, and writes the figures there that are counted; the
# Makefile includes it. tests/quick/gallery, tests/quick/course, tests/quick/language and tests/slow/counted compare them
# with today's.

.PHONY: gallery docs counted
counted: all boards $(COUNT_FILES) $(BUILD)/tests/test_spi_figures
	@$(call python,tools/generate/counted.py $(BUILD))
docs: gallery counted language
	@sed -n 's,^    build/\(tia.* docs/course/[a-z0-9-]*\.png.*\),$(BUILD)/\1,p' docs/course/*.md | \
	    while read -r command; do echo "  DRAW    $${command##*docs/course/}"; sh -c "$$command" >/dev/null || exit; done

# The reference of scene files with its pictures, from the manual and from the words that the reader knows, and what
# editors colour by these words.
.PHONY: language
language: $(BUILD)/tia $(BUILD)/tests/scene_words
	@$(call python,python3 tools/generate/language_pictures.py $(BUILD) && python3 tools/generate/language.py $(BUILD) && \
	    python3 tools/generate/editors.py $(BUILD))

comma := ,
draw = $(call say,DRAW,$(1))$(BUILD)/tia $(2) -o $(1)$(newline)
draw_radio = $(call say,DRAW,$(1))$(BUILD)/tia-radio scenes/block.tia -f 3.5G --tx 2$(comma)8$(comma)1 $(2) -o $(1) >/dev/null$(newline)
MODELS := desk knots fjord dice clockwork
gallery: all $(BUILD)/tests/test_raster_mirror
	$(foreach n,glass avenue flake chess castle vase orrery shadow-volume shadow-mapping porch $(MODELS),$(call draw,docs/gallery/$(n).png,scenes/$(n).tia -s 400x300))
	$(call draw,docs/gallery/marbles.png,scenes/marbles.tia --time 5 -s 400x300)
	$(call draw,docs/gallery/cornell.png,scenes/cornell.tia --denoise -s 300x300)
	$(call draw,docs/gallery/window.png,scenes/window.tia --spp 64 --denoise -s 400x300)
	$(call draw,docs/gallery/caustic.png,scenes/caustic.tia --spp 128 --denoise -s 400x300)
	$(call draw,docs/gallery/castle-openness.png,scenes/castle.tia --integrator ao=6 --spp 64 -s 400x300)
	$(call draw,docs/gallery/lightfield.png,scenes/lightfield.tia -s 400x225)
	$(call draw,docs/lightfield/quilt_qs4x2a1.777.png,scenes/lightfield.tia -s 800x224)
	$(call draw,docs/lightfield/panel.png,scenes/lightfield.tia --lenticular pitch=41$(comma)slope=-6.1$(comma)center=0.2 -s 400x225)
	$(call draw,docs/lightfield/module%d.png,scenes/lightfield.tia --modules 9 --module-range 4-4 -s 400x225)
	$(call draw,$(BUILD)/eyes%02d.png,scenes/lightfield.tia --views 14 -s 400x225)
	$(call say,DRAW,docs/lightfield/eyes.png)$(BUILD)/tia-observe -e 0$(comma)0.15$(comma)2.4 --two 0.13 --anaglyph -o docs/lightfield/eyes.png --views 14 scenes/lightfield.tia $(BUILD)/eyes%02d.png
	$(call say,DRAW,docs/lightfield/lenses.png)$(BUILD)/tia-observe -e 0.31$(comma)0.15$(comma)2.4 --lenticular pitch=41$(comma)slope=-6.1$(comma)center=0.2 -o docs/lightfield/lenses.png scenes/lightfield.tia docs/lightfield/panel.png
	$(call draw,docs/light/noisy.png,scenes/cornell.tia -s 128x128 --spp 16)
	$(call draw,docs/light/denoised.png,scenes/cornell.tia -s 128x128 --spp 16 --denoise)
	$(foreach n,normal albedo,$(call draw,docs/light/$(n).png,scenes/cornell.tia -s 128x128 --spp 16 --guide $(n)))
	$(call draw,docs/light/depth.png,scenes/cornell.tia -s 128x128 --spp 16 --guide depth --exposure -10.5)
	$(call draw,docs/light/error.png,scenes/cornell.tia -s 128x128 --spp 16 --guide error --exposure 3)
	$(call draw,docs/tori.png,scenes/shapes/tori.tia -s 480x360)
	$(call draw,docs/desk.png,scenes/desk.tia -s 640x360)
	$(call draw,docs/wrinkles.png,scenes/textures/wrinkles.tia -s 480x360)
	$(foreach n,horizon horizon-none,$(call draw,docs/$(n).png,scenes/textures/$(n).tia -s 400x300))
	$(call draw,docs/solids.png,scenes/solids.tia -s 640x360)
	$(call draw,docs/thesis.png,-k a -s 640x360)
	$(foreach n,place receiver caster,$(call draw,docs/shadows/$(n).png,scenes/shadows/$(n).tia -s 240x180))
	$(foreach n,place receiver caster,$(call draw,docs/shadows/$(n)-bare.png,scenes/shadows/$(n)-bare.tia -s 240x180))
	$(foreach n,1 2,$(call draw,docs/shadows/place-$(n).png,scenes/shadows/place.tia --time $(n) -s 240x180))
	$(call draw,docs/shadows/volume.png,scenes/shadows/volume.tia -s 400x300)
	$(call draw,docs/shadows/open.png,scenes/shadows/open.tia -s 240x180)
	$(foreach n,zpass zpass-plain,$(call draw,docs/shadows/porch-$(n).png,scenes/porch.tia --shadows $(n) -s 400x300))
	$(call draw,docs/shadows/map-none.png,scenes/shadow-mapping.tia --map-size 256 --filter none --bias none -s 240x180)
	$(call draw,docs/shadows/map-constant.png,scenes/shadow-mapping.tia --map-size 256 --filter none --bias constant=0.3 -s 240x180)
	$(call draw,docs/shadows/map.png,scenes/shadow-mapping.tia --map-size 256 -s 240x180)
	$(call draw,docs/shadows/map-steps.png,scenes/shadow-mapping.tia --map-size 64 --filter none -s 240x180)
	$(call draw,docs/shadows/map-smooth.png,scenes/shadow-mapping.tia --map-size 64 -s 240x180)
	$(call draw,docs/shadows/map-exact.png,scenes/shadow-mapping.tia --shadows map-exact -s 240x180)
	$(call draw,docs/shadows/soft-point.png,scenes/shadows/soft.tia -k h -s 240x180)
	$(call draw,docs/shadows/soft-few.png,scenes/shadows/soft.tia -k f -s 240x180)
	$(call draw,docs/shadows/soft.png,scenes/shadows/soft.tia -s 240x180)
	$(call draw,docs/shadows/soft-traced.png,scenes/shadows/soft.tia --shadows traced -s 240x180)
	$(call draw,docs/shadows/soft-7x7.png,scenes/shadows/soft.tia -k h --shadows map --map-size 512 --filter 7x7 --bias plane=1 -s 240x180)
	$(call draw,docs/shadows/soft-pcss.png,scenes/shadows/soft.tia --shadows map --filter pcss --bias plane=1 -s 240x180)
	$(call draw_radio,docs/radio/paths.png,--rx -14$(comma)1.5$(comma)-3 --rx 1$(comma)1.5$(comma)24 --reflections 4 -s 400x300)
	$(call draw_radio,docs/radio/map.png,--map y=1.5 --area -30$(comma)-30$(comma)30$(comma)30 -s 160x160)
	$(call draw_radio,docs/radio/best.png,--tx -20$(comma)14$(comma)-5 --map y=1.5 --area -30$(comma)-30$(comma)30$(comma)30 -s 160x160 --best-server)
	$(BUILD)/tests/test_raster_mirror docs/shadows
	$(BUILD)/tia-compare --shadows --technique zpass-plain -s 400x300 --heatmap docs/shadows/porch-wrong.png scenes/porch.tia
