# windfirm: build, test, demo. `make help` lists the targets.
BUILD  ?= build
B      := $(BUILD)$(if $(SAN),/san)
PREFIX ?= /usr/local
CC     ?= cc
CXX    ?= c++
CFLAGS ?= -O2 -g

LIBS   := gsl yaml-0.1 jansson udunits libxslt libxml-2.0
PKG    := $(filter-out udunits,$(LIBS))
WARN   := -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wstrict-prototypes -Wmissing-prototypes -Wvla -Werror
SANF   := $(if $(SAN),-fsanitize=address -fsanitize=undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
INC     = -Isrc $(patsubst -I%,-isystem %,$(shell pkg-config --cflags $(PKG)))
ALL     = -std=c17 -D_GNU_SOURCE $(WARN) -ffp-contract=off $(INC) -MMD -MP $(SANF) -DWF_SHARE='"$(SHARE)"'
LDLIBS  = $(shell pkg-config --libs $(PKG)) -ludunits2 -lm
SHARE  ?= $(CURDIR)

SRC    := $(wildcard src/*.c src/*/*.c)
LIBSRC := $(filter-out src/main.c src/cmd/%,$(SRC))
CMDSRC := $(filter src/main.c src/cmd/%,$(SRC))
TESTS  := $(wildcard tests/test_*.c)
obj     = $(patsubst %.c,$(B)/%.o,$(1))

all: $(B)/windfirm
$(B)/libwindfirm.a: $(call obj,$(LIBSRC))
	@rm -f $@
	$(AR) rcs $@ $^
$(B)/windfirm: $(call obj,$(CMDSRC)) $(B)/libwindfirm.a
	$(CC) $(SANF) $(LDFLAGS) $^ $(LDLIBS) -o $@
$(B)/tests/%: $(B)/tests/%.o $(B)/libwindfirm.a
	$(CC) $(SANF) $(LDFLAGS) $^ -lcmocka $(LDLIBS) -o $@
$(B)/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(ALL) $(CFLAGS) -c $< -o $@
# the numeric kernels are small fixed-size loops: unroll and vectorise them
$(B)/src/solve/%.o: CFLAGS += -O3

check: layers symbols
layers:
	@awk -f tests/layers.awk $(SRC) $(wildcard src/*/*.h)
symbols: $(B)/libwindfirm.a
	@! nm -g --defined-only $< | awk '$$2 ~ /^[TDBRC]$$/ && $$3 !~ /^wf_/' | grep .
clean:
	rm -rf $(BUILD) out
.PHONY: all check layers symbols clean
.SECONDARY:
-include $(patsubst %.o,%.d,$(call obj,$(SRC) $(TESTS)))
