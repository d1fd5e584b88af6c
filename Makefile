# The front door: a thin face on CMake's presets. Every target does the set-up that it needs.
# A line `target: ## text` is what `make` without arguments prints about the target.

BUILD := build/host
TWIDDLE := $(BUILD)/bin/twiddle

# Variables to set on the command line, e.g. `make plots RUN=results/demo`.
RUN ?= results/demo
JOBS ?= 2
PEERS_SETS ?= 200
PREFIX ?= /usr/local

.DEFAULT_GOAL := help
.PHONY: help run test bench bench-peers performance plots first-figures hand-tables
.PHONY: deps build sanitize format lint lint-format lint-tidy install clean gnuplot

help: ## print this list
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "make %-14s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

# --- the main jobs ---

DEMO := results/demo

run: build gnuplot ## train CPG-H on the small sphere, replay what it learned, and draw both, into results/demo
	rm -rf $(DEMO)
	$(TWIDDLE) train --object small-sphere --model cpg-h --seed 1 --trials 5000 --out $(DEMO)
	$(TWIDDLE) replay $(DEMO)
	plots/draw-run $(DEMO)

test: build ## run all tests
	ctest --preset host --parallel $$(nproc)

bench: build ## measure the speed of the full loop and of the controller's tick
	$(BUILD)/bin/bench_control

PEERS := bench/peers
PEERS_VENV := build/peers-venv

bench-peers: build $(PEERS_VENV)/installed ## compare speed and accuracy with MuJoCo from PyPI: make bench-peers PEERS_SETS=200
	$(PEERS_VENV)/bin/python -B $(PEERS)/bench_peers.py --program $(BUILD)/bin/bench_rollouts --models models \
	    --sets $(PEERS_SETS) --out build/bench/peers.csv

$(PEERS_VENV)/installed: $(PEERS)/requirements.txt | deps
	@python3 -m venv --clear $(PEERS_VENV)
	@$(PEERS_VENV)/bin/pip install -qqq --disable-pip-version-check --retries 1 --requirement $< || \
	{ echo "make: pip could not install MuJoCo from PyPI, which bench-peers compares with; is PyPI reachable?" >&2; exit 1; }
	@touch $@

PERFORMANCE := build/bench/performance

performance: build gnuplot ## measure how the cost of a control step grows with the work, and draw it (about 5 minutes), into build/bench
	@mkdir -p build/bench
	$(BUILD)/bin/bench_growth build/bench/growth.csv
	@for format in svg png; do \
	    gnuplot -d -e "growth='build/bench/growth.csv'; output='$(PERFORMANCE).$$format'; format='$$format'" \
	        plots/performance.gp || exit 1; echo "$(PERFORMANCE).$$format"; done
	scripts/performance-table build/bench/growth.csv

plots: ## draw one run again: make plots RUN=results/demo
	plots/draw-run $(RUN)

# Said before the training, not after it.
gnuplot:
	@command -v gnuplot >/dev/null || \
	{ echo "make: gnuplot is not installed; scripts/install-deps installs it" >&2; exit 1; }

# --- the first figures: 3 objects x 5 models x 5 seeds ---

FIRST := results/first
FIRST_TRIALS := 5000
FIRST_OBJECTS := small-sphere medium-cylinder large-cube
FIRST_MODELS := cpg-s cpg-m cpg-c cpg-h cpg-h-no-centre
FIRST_SEEDS := 1 2 3 4 5
FIRST_CELLS := $(foreach object,$(FIRST_OBJECTS),$(addprefix $(object)/,$(FIRST_MODELS)))
FIRST_RUNS := $(foreach seed,$(FIRST_SEEDS),$(FIRST_CELLS:%=$(FIRST)/%/seed-$(seed)))

# The parts of OBJECT/MODEL[-no-centre]/seed-N.
part = $(word $(1),$(subst /, ,$*))
first_object = $(call part,1)
first_model = $(patsubst %-no-centre,%,$(call part,2)) $(if $(findstring -no-centre,$(call part,2)),--no-centre)
first_seed = $(patsubst seed-%,%,$(call part,3))

first-figures: build gnuplot ## train the runs of README's first table (JOBS=2 at a time; goes on where it was stopped) and print it
	+@$(MAKE) --no-print-directory --jobs=$(JOBS) --output-sync=target $(FIRST_RUNS)
	scripts/summarise-first $(FIRST)
	@for format in svg png; do \
	    gnuplot -d -e "summary='$(FIRST)/summary.csv'; output='$(FIRST)/first_results.$$format'; format='$$format'" \
	        plots/first_results.gp || exit 1; echo "$(FIRST)/first_results.$$format"; done

# A finished run says so and ends; one of other settings in the same folder is refused.
.PHONY: $(FIRST_RUNS)
$(FIRST_RUNS): $(FIRST)/%:
	@$(TWIDDLE) train --object $(first_object) --model $(first_model) --seed $(first_seed) \
	    --trials $(FIRST_TRIALS) --out $@ --resume

# --- the paper's experiments: a sweep of models/sweeps ---

SWEEP ?= paper
# A set-up for all of its runs, instead of the manifest's.
SETUP ?=
RESULTS ?= results/$(SWEEP)$(if $(SETUP),-$(basename $(notdir $(SETUP))))

.PHONY: paper
paper: build ## train all runs of a sweep into results/SWEEP[-SETUP] and make its tables; goes on where it was stopped: make paper SWEEP=smoke SETUP=near JOBS=2
	$(TWIDDLE) sweep models/sweeps/$(SWEEP).toml --out $(RESULTS) --jobs $(JOBS) $(if $(SETUP),--setup $(SETUP))
	$(TWIDDLE) summarize $(RESULTS)

# --- building ---

deps:
	@scripts/install-deps

# Ninja configures again by itself when a CMakeLists.txt changes.
build/%/build.ninja: CMakePresets.json | deps
	cmake --preset $*

build: $(BUILD)/build.ninja deps ## build everything into build/host
	cmake --build --preset host

sanitize: build/sanitize/build.ninja deps ## build and test with the address and undefined-behaviour sanitizers
	cmake --build --preset sanitize
	ctest --preset sanitize --parallel $$(nproc)

install: build ## install library and program: make install PREFIX=/usr/local
	cmake --install $(BUILD) --prefix $(PREFIX)

clean: ## remove build/ (results/ stays)
	rm -rf build

# --- keeping the sources in order ---

HAND := models/icub_right_hand.urdf
HAND_TABLES := controller/src/icub_right_hand.c

hand-tables: build ## write the controller's tables of the hand again from its URDF
	$(BUILD)/bin/twiddle-hand-tables $(HAND) >$(BUILD)/icub_right_hand.c
	cp $(BUILD)/icub_right_hand.c $(HAND_TABLES)

# Sources that git knows or would add.
list = git ls-files --cached --others --exclude-standard --deduplicate -z --

format: ## format all C and C++ sources
	$(list) '*.c' '*.h' '*.cpp' '*.hpp' | xargs -0 clang-format -i

lint: lint-format lint-tidy ## check the format, and look for mistakes with clang-tidy

lint-format: deps
	$(list) '*.c' '*.h' '*.cpp' '*.hpp' | xargs -0 clang-format --dry-run -Werror

LINT := $(BUILD)/lint
COMMANDS := $(LINT)/compile_commands.json
own_sources = sed -n 's|^ *"file": "\($(CURDIR)/.*\)",\{0,1\}$$|\1|p' $(COMMANDS) | grep -v '^$(CURDIR)/build/'

lint-tidy: build
	@mkdir -p $(LINT)
	@awk -f cmake/first_commands.awk $(BUILD)/compile_commands.json >$(COMMANDS)
	$(own_sources) | xargs -n 1 -P $$(nproc) clang-tidy -p $(LINT) --quiet
