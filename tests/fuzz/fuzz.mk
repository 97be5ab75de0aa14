# The fuzzers with corpora and changed inputs of their own, replay.c, for a compiler without libFuzzer.
FUZZERS := $(notdir $(wildcard tests/fuzz/corpus/*))
replays: $(FUZZERS:%=$(BUILD)/fuzz/%)
.PHONY: replays
beside = $(filter-out $(BUILD)/host/tools/$(1)/$(1).o,$(call obj,host,$(wildcard tools/$(1)/*.c)))
$(BUILD)/fuzz/options: $(call beside,tia)
$(BUILD)/fuzz/parts: $(call beside,tia-join)
$(BUILD)/fuzz/radio: $(call beside,tia-radio)
$(BUILD)/fuzz/resume: $(call obj,host,$(addprefix tools/tia/,finished.c resume.c resume_file.c))
$(BUILD)/tests/fuzz/%.o: HOSTED += -Wno-missing-prototypes -iquote .
$(FUZZERS:%=$(BUILD)/fuzz/%): $(BUILD)/fuzz/%: $(BUILD)/tests/fuzz/%.o $(BUILD)/tests/fuzz/replay.o $(BUILD)/liboracle.a \
    $(LIBCOMMON) $(LIBPORTS) $(LIBWATCHED) $(LIBSIMD) $(BUILD)/libtia-chk.a $(LIBF64) $(LIBRADIO) $(LIBTIA)
	@mkdir -p $(@D)
	$(link)
$(FUZZERS:%=$(BUILD)/fuzz/%): LIBS := $(OVERFLOW) $(LIBS)
