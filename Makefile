# windfirm: build, test, demo. `make help` lists the targets.
# the version stands in src/windfirm.h, as numbers and as text
VERSION := $(shell awk '/define WF_VERSION_(MAJOR|MINOR|PATCH) / { v = v "." $$3 } END { print substr(v, 2) }' src/windfirm.h)
$(if $(shell grep 'define WF_VERSION "$(VERSION)"' src/windfirm.h),,$(error src/windfirm.h: WF_VERSION is not $(VERSION)))
BUILD   ?= build
B       := $(BUILD)$(if $(SAN),/san)$(if $(FUZZ),/fuzz)
PREFIX  ?= /usr/local
SHARE   ?= $(CURDIR)
CC      ?= cc
CXX     ?= c++
CFLAGS  ?= -O2 -g

# libmatio is optional: without it MATLAB files are refused, naming the package (make MATIO= tries that)
MATIO  := $(shell pkg-config --exists matio 2>/dev/null && echo matio)
# it is loaded when such a file is read, by this name
MATIO_SO := $(if $(MATIO),$(shell readelf -d $$(pkg-config --variable=libdir matio)/libmatio.so | sed -n 's/.*SONAME.*\[\(.*\)\].*/\1/p'))
# libxlsxwriter is optional: without it --xlsx is refused, naming the package
XLSX   := $(shell pkg-config --exists xlsxwriter 2>/dev/null && echo xlsxwriter)
# libjpeg and libpng are optional: without them --photo and --logo are refused, naming the packages
PICTURES := $(shell pkg-config --exists libjpeg libpng 2>/dev/null && echo libjpeg libpng)
PKG    := $(PICTURES) $(if $(MATIO),zlib) $(XLSX) gsl yaml-0.1 jansson libxslt libxml-2.0
WARN   := -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wstrict-prototypes -Wmissing-prototypes -Wvla -Werror
SANF   := $(if $(SAN)$(FUZZ),-fsanitize=address -fsanitize=undefined -fno-sanitize-recover=all -fno-omit-frame-pointer) \
          $(if $(FUZZ),-fsanitize=fuzzer-no-link -fsanitize=float-cast-overflow)
INC     = -Isrc $(patsubst -I%,-isystem %,$(shell pkg-config --cflags $(PKG) $(MATIO)))
ALL     = -std=c17 -D_GNU_SOURCE $(WARN) -ffp-contract=off $(INC) -MMD -MP $(SANF) \
          $(if $(MATIO_SO),-DWF_MATIO='"$(MATIO_SO)"') $(if $(XLSX),-DWF_XLSX) $(if $(PICTURES),-DWF_PICTURES) -DWF_VERSION='"$(VERSION)"'
# least squares: Ceres has no pkg-config file; its one C++ file links with its C++ library
CERES   = -lceres -lglog -lstdc++
LDLIBS  = $(shell pkg-config --libs $(PKG)) -ludunits2 $(CERES) -lm

# Debian packages: to build and to draw; and for tests alone
PACKAGES := gcc libc6-dev pkg-config libgsl-dev libyaml-dev libjansson-dev libudunits2-dev libxslt1-dev libxml2-dev libmatio-dev zlib1g-dev libxlsxwriter-dev libjpeg-dev libpng-dev \
            g++ libceres-dev libeigen3-dev libgoogle-glog-dev gnuplot-nox weasyprint fonts-liberation fonts-wqy-microhei
TEST_PACKAGES := libcmocka-dev poppler-utils gdb python3-jsonschema python3-yaml chromium pandoc

SRC    := $(wildcard src/*.c src/*/*.c)
# where species, models and templates are is compiled into these alone; `make install` compiles them a second time
SHARED := $(shell grep -l WF_SHARE $(SRC))
LIBSRC := $(filter-out src/main.c src/cmd/%,$(SRC))
CMDSRC := $(filter src/main.c src/cmd/%,$(SRC))
TESTS  := $(wildcard tests/test_*.c)
BENCH  := $(wildcard tests/bench*.c)
# harnesses of readers: tests/fuzz/read_NAME.c
READERS := $(patsubst tests/fuzz/read_%.c,%,$(wildcard tests/fuzz/read_*.c))
obj     = $(patsubst %.c,$(B)/%.o,$(1))
bin     = $(patsubst %.c,$(B)/%,$(1))

# the kernels of several states, and of several elements of one state, side by side: each one source, compiled for
# each width (solve/beam_lanes.h, solve/beam_groups.h, solve/beam_inertia.h)
LANES  := $(foreach w,4 8,$(foreach k,lanes groups inertia,$(B)/src/solve/beam_$(k)_$(w).o))

# what editors complete and check the shipped files by, made by the program that reads them
SCHEMAS := species/schema.json models/schema.json models/field/schema.json models/studies/schema.json
SCHEMA   = $(if $(filter species/%,$@),species,$(if $(filter models/field/%,$@),fit,$(if $(filter models/studies/%,$@),study,model)))

all: $(B)/windfirm $(SCHEMAS) ## build the program and the library (default)
$(SCHEMAS): $(B)/windfirm
	@$(B)/windfirm schema $(SCHEMA) --json-schema >$@.$(notdir $(B)) && mv $@.$(notdir $(B)) $@
$(B)/libwindfirm.a: $(call obj,$(LIBSRC)) $(LANES) $(B)/src/fit/ceres.o
	@rm -f $@
	$(AR) rcs $@ $^
$(B)/windfirm: $(call obj,$(CMDSRC)) $(B)/libwindfirm.a
	$(CC) $(SANF) $(LDFLAGS) $^ $(LDLIBS) -o $@
$(B)/tests/%: $(B)/tests/%.o $(B)/libwindfirm.a
	$(CC) $(SANF) $(LDFLAGS) $^ -lcmocka $(LDLIBS) -o $@
$(B)/tests/test_import_mat: LDLIBS += $(if $(MATIO),$(shell pkg-config --libs matio)) # it writes such files
# A harness with a program around it that gives it files; with FUZZ=1 libFuzzer is that program. --wrap: see fuzz.c.
$(B)/tests/fuzz/%: $(B)/tests/fuzz/read_%.o $(call obj,tests/fuzz/fuzz.c tests/fuzz/fuzz_import.c) \
                   $(if $(FUZZ),,$(B)/tests/fuzz/replay.o) $(B)/libwindfirm.a
	$(CC) $(SANF) $(if $(FUZZ),-fsanitize=fuzzer) $(LDFLAGS) $(WRAP) $(filter %.o,$^) $(filter %.a,$^) $(LDLIBS) -o $@
$(B)/tests/fuzz/%: WRAP = -Wl,--wrap=wf_units_open,--wrap=wf_units_close
$(B)/tests/fuzz/study: $(call obj,$(filter-out src/main.c,$(CMDSRC)))
$(B)/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(ALL) $(CFLAGS) -c $< -o $@
# a new version reaches those that print it
$(call obj,$(shell grep -lw WF_VERSION $(SRC) $(TESTS))): src/windfirm.h
$(call obj,$(SHARED)): ALL += -DWF_SHARE='"$(SHARE)"'
$(B)/%.o: %.cpp
	@mkdir -p $(@D)
	$(CXX) -std=c++17 -Wall -Wextra -isystem /usr/include/eigen3 -Isrc -MMD -MP $(if $(FUZZ),,$(SANF)) $(CFLAGS) -c $< -o $@
# the numeric kernels are small fixed-size loops: unroll and vectorise them; sanitizers' checks in each would take the
# compiler a quarter of an hour
FAST   := $(if $(SAN)$(FUZZ),-O1,-O3)
KERNELS := $(wildcard src/solve/*.c src/load/*.c) src/wind/shelter_laws.c src/wind/gust_spectral.c src/wind/fourier.c
$(call obj,$(KERNELS)): CFLAGS += $(FAST)
# Vector instructions in these two objects alone, which run where the processor has them (solve/beam_many.c). Elsewhere
# than on x86-64 the compiler divides the vectors among what the processor has.
WIDE    = $(if $(filter 4,$(WIDTH)),-mavx2,-mavx512f -mavx512dq -mavx512vl -mprefer-vector-width=512)
X86    := $(findstring x86_64,$(shell $(CC) -dumpmachine))
$(LANES): CFLAGS += $(FAST)
# not in CFLAGS, which may be given on the command line
$(LANES): WIDEN = -fno-math-errno -DWF_WIDTH=$(WIDTH) $(if $(X86),$(WIDE),-Wno-psabi)
$(filter %_4.o,$(LANES)): WIDTH = 4
$(filter %_8.o,$(LANES)): WIDTH = 8
$(filter %/beam_lanes_4.o %/beam_lanes_8.o,$(LANES)): src/solve/beam_lanes.c
$(filter %/beam_groups_4.o %/beam_groups_8.o,$(LANES)): src/solve/beam_groups.c
$(filter %/beam_inertia_4.o %/beam_inertia_8.o,$(LANES)): src/solve/beam_inertia.c
$(LANES):
	@mkdir -p $(@D)
	$(CC) $(ALL) $(CFLAGS) $(WIDEN) -c $< -o $@
# a rule that names a file which is not there would be passed over in silence
NAMED   := $(KERNELS) src/main.c src/fit/ceres.cpp
$(if $(filter-out $(wildcard $(NAMED)),$(NAMED)),$(error not there: $(filter-out $(wildcard $(NAMED)),$(NAMED))))

demo: packages ## install what is missing, build, compare bamboo and willow: out/demo/report.pdf
	@$(MAKE) -s -j$$(nproc) all
	@$(B)/windfirm compare species/moso_bamboo.yaml species/weeping_willow.yaml --model models/culm.yaml \
	    --wind 10,15,25 -o out/demo
	@ls -1 out/demo/report.pdf out/demo/report.html
test: packages test-packages ## install what is missing, build, run every test and validation case
	@$(MAKE) -s -j$$(nproc) all programs
	@tests/run.sh $(B)
bench: packages test-packages ## measure speed and memory
	@$(MAKE) -s -j$$(nproc) all $(call bin,$(BENCH)) $(B)/tests/make_scan
	@for b in $(call bin,$(BENCH)); do $$b || exit; done
# The last version before the work on speed, built from this repository's history into $(BUILD)/before.
BEFORE := 1cdf881c219940103f9ff5acdfd142dd2c78bfdb
bench-before: packages test-packages ## whole runs beside those of an earlier version, which is built once: at most 6 minutes
	@$(MAKE) -s -j$$(nproc) all $(B)/tests/bench_before $(B)/tests/make_scan $(BUILD)/before/build/windfirm
	@$(B)/tests/bench_before $(BUILD)/before
$(BUILD)/before/build/windfirm:
	@git cat-file -e $(BEFORE)^{commit} 2>/dev/null || { \
	    echo "bench-before: commit $(BEFORE) is not here: this is no git repository, or a shallow one (git fetch --unshallow)" >&2; exit 1; }
	@rm -rf $(BUILD)/before && mkdir -p $(BUILD)/before && git archive $(BEFORE) | tar x -C $(BUILD)/before
	@$(MAKE) -s -C $(BUILD)/before BUILD=build SAN= FUZZ= SHARE=$(abspath $(BUILD))/before all
bench-peers: packages test-packages ## the same tree in CalculiX (package calculix-ccx, installed when missing): time beside time
	@tools/packages.sh calculix-ccx || true
	@$(MAKE) -s -j$$(nproc) $(B)/tests/bench_beam
	@tests/bench_peers.sh $(B)
# clang, libFuzzer and their sanitizers; `make test` gives the stored inputs to the same readers without them
FUZZ_SECONDS ?= 300
FUZZ_JOBS    ?= 0
fuzz: fuzz-readers ## new inputs for every reader of files, FUZZ_SECONDS each (300), FUZZ_JOBS at once (0: all)
	@tools/fuzz.sh $(BUILD)/fuzz $(FUZZ_SECONDS) $(FUZZ_JOBS) $(READERS)
fuzz-smoke: fuzz-readers ## the same for 10 s each, all at once
	@tools/fuzz.sh $(BUILD)/fuzz 10 0 $(READERS)
fuzz-readers: packages
	@tools/packages.sh clang
	@tools/packages.sh libclang-rt-$$(clang -dumpversion | cut -d. -f1)-dev
	@! tools/fuzz.sh has-libfuzzer || $(MAKE) -s -j$$(nproc) FUZZ=1 CC=clang CFLAGS='-O1 -g' readers
readers: $(READERS:%=$(B)/tests/fuzz/%)
programs: $(call bin,$(TESTS)) readers
packages:
	@tools/packages.sh $(PACKAGES)
test-packages:
	@tools/packages.sh $(TEST_PACKAGES)

check: layers symbols interface house ## rooms, names, installed headers, and the measures of tools/house.sh
layers:
	@awk -f tests/layers.awk $(SRC) $(wildcard src/*.h src/*/*.h src/*/*.cpp)
symbols: $(B)/libwindfirm.a
	@! nm -g --defined-only $< | awk '$$2 ~ /^[TDBRC]$$/ && $$3 !~ /^(wf_|__odr_asan)/' | grep .
interface: # what is installed: number, names, C and C++
	@tools/interface.sh $(HEADERS)
house: all # sizes, circles, callers, the way through the program
	@tools/house.sh $(B)
gallery: all ## every kind of page in both languages as pictures, with contact sheets, in the build folder; fails where a renderer says anything
	@tools/gallery.sh $(B)/windfirm $(B)/gallery
HAN := /usr/share/fonts/opentype/noto/NotoSansCJK-Bold.ttc
han-bold: ## the bold Chinese face of printed pages again, after new Chinese words (Debian package fonts-noto-cjk)
	@tools/packages.sh fonts-noto-cjk
	@$$(sed -n '1s/^#!//p' "$$(command -v weasyprint)") tools/han_bold.py reports/han_bold.ttf $(HAN) reports/strings.xml \
	    reports/messages.xml reports/plots/words.tsv $(wildcard species/*.yaml models/*.yaml models/*/*.yaml)
golden: all ## write the expected tables of the demo again, after a change that is understood; prints what changes
	@git diff --quiet HEAD || { echo 'make golden: commit first; the change of the tables is to be seen alone'; exit 1; }
	@for m in mean peak; do \
	    $(B)/windfirm compare species/moso_bamboo.yaml species/weeping_willow.yaml --model models/culm.yaml \
	        --wind 10,15,25 -o $(B)/golden/$$m --no-report --quiet $$([ $$m = peak ] || echo --peak mean) || exit; \
	    for t in summary segments shape sweep; do \
	        [ ! -e tests/golden/$$m/$$t.csv ] || tests/changed.awk tests/golden/$$m/$$t.csv $(B)/golden/$$m/tables/$$t.csv; \
	        cp $(B)/golden/$$m/tables/$$t.csv tests/golden/$$m/; done; done

# The interface: src/windfirm.h and what it includes, found by the compiler. Installed, they include one another as
# <windfirm/...>, so that one -I is enough.
HEADERS = $(sort $(filter src/%.h,$(shell $(CC) -MM -Isrc src/windfirm.h)))
# What an installed program differs in from the built one; another PREFIX makes it again.
N := $(B)/install
I := $(DESTDIR)$(PREFIX)
installed = $(patsubst $(B)/%,$(N)/%,$(filter $(call obj,$(SHARED)),$(1))) $(filter-out $(call obj,$(SHARED)),$(1))
$(N)/prefix: FORCE
	@mkdir -p $(@D)
	@echo '$(PREFIX)' | cmp -s - $@ || echo '$(PREFIX)' >$@
$(N)/%.o: %.c $(N)/prefix
	@mkdir -p $(@D)
	$(CC) $(ALL) -DWF_SHARE='"$(PREFIX)/share/windfirm"' $(CFLAGS) -c $< -o $@
$(N)/libwindfirm.a: $(call installed,$(call obj,$(LIBSRC))) $(LANES) $(B)/src/fit/ceres.o
	@rm -f $@
	$(AR) rcs $@ $^
$(N)/windfirm: $(call installed,$(call obj,$(CMDSRC))) $(N)/libwindfirm.a
	$(CC) $(SANF) $(LDFLAGS) $^ $(LDLIBS) -o $@
install: $(N)/windfirm all ## program, manual pages, library, headers, species, models, report templates (DESTDIR, PREFIX)
	install -d $(I)/bin $(I)/lib/pkgconfig $(I)/share/windfirm $(I)/share/man/man1 $(I)/share/bash-completion/completions
	install -m 755 $(N)/windfirm $(I)/bin
	install -m 644 $(N)/libwindfirm.a $(I)/lib
	for h in $(patsubst src/%,%,$(HEADERS)); do \
	    install -d $$(dirname $(I)/include/windfirm/$$h) && \
	    sed 's|^#include "\(.*\)"|#include <windfirm/\1>|' src/$$h >$(I)/include/windfirm/$$h || exit; done
	cp -r species models reports validation $(I)/share/windfirm
	install -m 644 src/windfirm.bash $(I)/share/bash-completion/completions/windfirm
	$(B)/windfirm --help=man >$(I)/share/man/man1/windfirm.1
	for c in $$($(B)/windfirm --help=words | awk -F'\t' '$$2 == "command" { print $$1 }'); do \
	    $(B)/windfirm $$c --help=man >$(I)/share/man/man1/windfirm-$$c.1 || exit; done
	sed 's|@PREFIX@|$(PREFIX)|; s|@VERSION@|$(VERSION)|; s|@REQUIRES@|$(PKG)|' src/windfirm.pc.in \
	    > $(I)/lib/pkgconfig/windfirm.pc
headers: ## the headers that are installed
	@printf '%s\n' $(HEADERS)
FORCE:
clean: ## remove what was built and computed
	rm -rf $(BUILD) out $(SCHEMAS)
help: ## this list
	@awk -F':.*## ' '/^[a-z-]+:.*## / { printf "make %-11s %s\n", $$1, $$2 }' Makefile

.PHONY: all demo test fuzz fuzz-smoke fuzz-readers readers bench bench-before bench-peers programs packages test-packages check layers symbols interface house gallery han-bold golden install headers clean help FORCE
.SECONDARY:
-include $(patsubst %.o,%.d,$(LANES) $(call obj,$(SRC) $(TESTS) $(BENCH) $(wildcard tests/fuzz/*.c)) $(patsubst %.c,$(N)/%.o,$(SHARED)) $(B)/src/fit/ceres.o)
