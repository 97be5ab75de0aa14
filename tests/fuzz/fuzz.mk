# The fuzzers, driven by replay.c, or by libFuzzer with FUZZ_DRIVER= LDFLAGS=-fsanitize=fuzzer.
FUZZERS := $(notdir $(wildcard tests/fuzz/corpus/*))
FUZZ_DRIVER := $(BUILD)/tests/fuzz/replay.o
.PHONY: fuzzers
fuzzers: $(FUZZERS:%=$(BUILD)/fuzzers/%)
beside = $(filter-out $(BUILD)/host/tools/$(1)/$(1).o,$(call obj,host,$(wildcard tools/$(1)/*.c)))
$(BUILD)/fuzzers/options: $(call beside,tia)
$(BUILD)/fuzzers/parts: $(BUILD)/host/tools/tia-join/join_sums.o
$(BUILD)/fuzzers/radio: $(call beside,tia-radio)
$(BUILD)/fuzzers/resume: $(call obj,host,$(addprefix tools/tia/,finished.c resume.c resume_file.c))
$(BUILD)/tests/fuzz/%.o: HOSTED += -Wno-missing-prototypes -iquote .
$(FUZZERS:%=$(BUILD)/fuzzers/%): $(BUILD)/fuzzers/%: $(BUILD)/tests/fuzz/%.o $(FUZZ_DRIVER) $(BUILD)/liboracle.a \
    $(LIBCOMMON) $(LIBPORTS) $(LIBWATCHED) $(LIBSIMD) $(BUILD)/libtia-chk.a $(LIBF64) $(LIBRADIO) $(LIBTIA) \
    $(BUILD)/made-with/link
	@mkdir -p $(@D)
	$(link)
$(FUZZERS:%=$(BUILD)/fuzzers/%): LIBS := $(OVERFLOW) $(LIBS)
