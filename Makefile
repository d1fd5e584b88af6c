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
.PHONY: help run test accuracy bench bench-instructions bench-peers bench-firmware performance plots hand-tables
.PHONY: example-policy firmware
.PHONY: peers program build sanitize format lint lint-format lint-rooms lint-tidy analyze install clean gnuplot

# From left to right, whatever -j says: first the packages, then one build at a time, which takes all cores itself.
.NOTPARALLEL:

help: ## print this list
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "make %-18s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

# --- the main jobs ---

DEMO := results/demo

run: program gnuplot ## train CPG-H on the small sphere, replay what it learned, draw both, and write a page to look at, into results/demo
	rm -rf $(DEMO)
	$(TWIDDLE) train --object small-sphere --model cpg-h --seed 1 --trials 5000 --out $(DEMO)
	$(TWIDDLE) replay $(DEMO)
	plots/draw-run $(DEMO)
	$(TWIDDLE) view $(DEMO)

test: deps-run-test-firmware with-tests-emulators peers firmware ## run all tests, on the emulated boards too
	$(build) program tests emulators
	@rm -rf $(BUILD)/golden
	ctest --preset host --parallel $$(nproc) --output-log $(BUILD)/ctest.log
	@cat $(BUILD)/golden/*.txt
	@grep ' tests passed' $(BUILD)/ctest.log

accuracy: deps-run-test with-tests ## measure how far the float and the fixed build are from double, as a table
	$(build) compare_accuracy $(recorders)
	$(addprefix $(BUILD)/bin/,compare_accuracy $(recorders))
recorders := record_accuracy_double record_accuracy record_accuracy_fixed

bench: deps-run-bench with-bench ## measure the speed of the full loop and of the controller's tick
	$(build) bench_control
	$(BUILD)/bin/bench_control

bench-peers: deps-run-bench with-bench peers ## compare speed and accuracy with MuJoCo from PyPI: make bench-peers PEERS_SETS=200
	$(build) bench_rollouts
	PYTHONPATH=peers $(PEERS_VENV)/bin/python -B bench/bench_peers.py \
	    --program $(BUILD)/bin/bench_rollouts --models models --sets $(PEERS_SETS) --out build/bench/peers.csv

# Counted is the program as everybody builds it; a second build of the same machine code knows the source lines.
bench-instructions: deps-run-bench program build/lines/build.ninja ## count the instructions of training runs by piece of the simulation, and compare with docs/results/instructions.csv (about 4 minutes, after two builds)
	cmake --build --preset lines --target program
	python3 -B bench/bench_instructions.py --program $(TWIDDLE) --lines build/lines/bin/twiddle --jobs $(JOBS) \
	    --out build/bench/instructions.csv --recorded docs/results/instructions.csv

PERFORMANCE := build/bench/performance

performance: deps-run-bench gnuplot with-bench ## measure how the cost of a control step grows with the work, and draw it (about 5 minutes), into build/bench
	$(build) bench_growth
	@mkdir -p build/bench
	$(BUILD)/bin/bench_growth build/bench/growth.csv
	@for format in svg png; do \
	    gnuplot -d -e "growth='build/bench/growth.csv'; output='$(PERFORMANCE).$$format'; format='$$format'" \
	        plots/performance.gp || exit 1; echo "$(PERFORMANCE).$$format"; done
	scripts/performance-table build/bench/growth.csv

plots: ## draw the figures of one run again, or of a sweep: make plots RUN=results/demo, or SWEEP=paper
	$(if $(filter file,$(origin SWEEP)),plots/draw-run $(RUN),plots/draw-sweep $(RESULTS))

# What README shows. Both look at a page in a browser, which the tests need, too.
.PHONY: animation index-picture
animation: program deps-run-test ## film the replay of a run into docs/images/replay.webp: make animation RUN=results/demo
	$(TWIDDLE) view $(RUN)
	plots/film-run $(RUN) docs/images/replay.webp

index-picture: program deps-run-test ## photograph the table of a sweep into docs/images/sweep_index.png: make index-picture SWEEP=paper
	$(TWIDDLE) view --index-only $(RESULTS)
	plots/photograph $(RESULTS)/index.html docs/images/sweep_index.png

# Said before the training, not after it.
gnuplot:
	@command -v gnuplot >/dev/null || \
	{ echo "make: gnuplot is not installed; scripts/install-deps installs it" >&2; exit 1; }

# --- the paper's experiments: a sweep of experiments/sweeps ---

SWEEP ?= paper
# A set-up for all of its runs, instead of the manifest's.
SETUP ?=
RESULTS ?= results/$(SWEEP)$(if $(SETUP),-$(basename $(notdir $(SETUP))))
setup_option = $(if $(SETUP),--setup $(SETUP))

# Who does the runs: this machine, or a Slurm cluster (docs/CLUSTER.md).
ENGINE ?= local
engines := local slurm
ifeq ($(filter $(engines),$(ENGINE)),)
  $(error ENGINE=$(ENGINE) is not known; expected one of: $(engines))
endif

# For ENGINE=slurm: runs at a time at most, more arguments for sbatch, and 0 to return when the jobs are submitted.
THROTTLE ?=
SBATCH_ARGS ?=
WAIT ?= 1

.PHONY: paper paper-local paper-slurm paper-results
paper: paper-$(ENGINE) ## train all runs of a sweep into results/SWEEP[-SETUP], make its tables and draw it; goes on where it was stopped: make paper SWEEP=smoke JOBS=2, SETUP=near or ENGINE=slurm

paper-local: program gnuplot
	$(TWIDDLE) sweep experiments/sweeps/$(SWEEP).toml --out $(RESULTS) --jobs $(JOBS) $(setup_option)
	+@$(MAKE) --no-print-directory paper-results

# The results are made by a job on a machine that builds nothing, by a make of its own.
paper-slurm: program
	@scripts/submit-sweep --program $(TWIDDLE) $(if $(THROTTLE),--throttle '$(THROTTLE)') --sbatch '$(SBATCH_ARGS)' \
	    $(if $(filter 0,$(WAIT)),--no-wait) $(setup_option) experiments/sweeps/$(SWEEP).toml $(RESULTS) \
	    make --no-print-directory paper-results SWEEP=$(SWEEP) RESULTS=$(RESULTS) BUILD=$(BUILD)

paper-results: gnuplot ## make tables, figures and pages to look at from the complete runs of a sweep, with the program as it is built: make paper-results SWEEP=smoke
	$(TWIDDLE) summarize $(RESULTS)
	plots/draw-sweep $(RESULTS)
	$(TWIDDLE) view $(RESULTS)

CALIBRATION := results/calibration

.PHONY: calibrate
calibrate: program ## search a set-up that comes near the paper's tables (up to two hours; goes on where it was stopped)
	$(TWIDDLE) calibrate experiments/calibrations/paper.toml --out $(CALIBRATION) --jobs $(JOBS)

.PHONY: confirm
confirm: program ## replay CPG-H's policies of a sweep in both steppers, and print the rotations side by side: make confirm SWEEP=paper
	scripts/confirm-steppers $(RESULTS)

# --- microcontrollers ---

BOARDS := microbit mps2-an386 mps2-an500 virt atmega1284p
FIRMWARE := $(foreach board,$(BOARDS),$(addprefix build/firmware/$(board)-,Os O2))

firmware: deps-firmware $(FIRMWARE) ## build the images of all boards at -Os and -O2, and print what they take of flash, RAM and stack
	@firmware/scripts/size_table.py $(FIRMWARE)

# Quiet, so that the table is what one reads; what fails is shown in full.
build/firmware/%/build.ninja: CMakePresets.json
	@scripts/quietly cmake --preset firmware-$*

.PHONY: $(FIRMWARE)
$(FIRMWARE): %: %/build.ninja
	@scripts/quietly cmake --build $@ --parallel $(JOBS)

# CMSIS_DSP= goes without it, and without a network.
CMSIS_DSP ?= build/cmsis-dsp

bench-firmware: deps-run-firmware with-emulators ## count what controller and learner cost on each emulated board, beside other libraries, into build/bench
	$(if $(CMSIS_DSP),@firmware/bench/fetch-cmsis-dsp $(CMSIS_DSP))
	@scripts/quietly $(build) emulators
	@for board in $(BOARDS); do \
	    scripts/quietly cmake --preset firmware-$$board-O2 -DTWIDDLE_CMSIS_DSP=$(abspath $(CMSIS_DSP)) && \
	    scripts/quietly cmake --build --preset firmware-$$board-O2 --target bench_images --parallel $(JOBS) || exit 1; done
	@python3 -B firmware/bench/bench_firmware.py --run firmware/emulators/run --images build/firmware \
	    --out build/bench/firmware.csv

# --- building ---

# deps-GROUP-GROUP: the packages of these groups of scripts/install-deps. DEPS=no takes what is there, on machines whose
# packages are somebody else's business.
DEPS ?= yes

deps-%:
	@$(if $(filter no,$(DEPS)),:,scripts/install-deps $(subst -, ,$*))

# with-PART-PART: the build folder, configured for the program and these parts, each of which needs packages of its own.
with-%:
	@scripts/configure $(BUILD) $(subst -, ,$*)

# Ninja configures again by itself when a CMakeLists.txt changes.
build = cmake --build $(BUILD) --target

program: deps-run ## build the program, in all number types, into build/host
	@scripts/configure $(BUILD)
	$(build) program

build: deps-run-test-firmware-bench with-tests-bench-emulators ## build everything into build/host: the program, its tests and benchmarks, the emulators
	$(build) all bench

# The other engine, which tests and benchmarks compare with.
PEERS_VENV := build/peers-venv

peers:
	@scripts/install-peers $(PEERS_VENV)

build/lines/build.ninja build/sanitize/build.ninja build/library/build.ninja: build/%/build.ninja: CMakePresets.json
	cmake --preset $*

sanitize: deps-run-test build/sanitize/build.ninja peers ## build and test with the address and undefined-behaviour sanitizers
	cmake --build --preset sanitize
	ctest --preset sanitize --parallel $$(nproc)

install: deps-library build/library/build.ninja ## install the C libraries: make install PREFIX=/usr/local
	cmake --build --preset library
	cmake --install build/library --prefix $(PREFIX)

clean: ## remove build/ (results/ stays)
	rm -rf build

# --- keeping the sources in order ---

EXAMPLE_RUN := build/example-policy

example-policy: program ## train the policy of firmware/examples again, and write its C header
	rm -rf $(EXAMPLE_RUN)
	$(TWIDDLE) train --object small-sphere --model cpg-h --seed 1 --trials 2000 --number fixed --out $(EXAMPLE_RUN)
	$(TWIDDLE) export $(EXAMPLE_RUN) --c-header --name example --out firmware/examples/example_policy.h

HAND := models/icub_right_hand.urdf
HAND_TABLES := controller/src/icub_right_hand.c

hand-tables: deps-run ## write the controller's tables of the hand again from its URDF
	@scripts/configure $(BUILD)
	$(build) twiddle-hand-tables
	$(BUILD)/bin/twiddle-hand-tables $(HAND) >$(BUILD)/icub_right_hand.c
	cp $(BUILD)/icub_right_hand.c $(HAND_TABLES)

# Sources that git knows or would add.
list = git ls-files --cached --others --exclude-standard --deduplicate -z --

format: deps-lint ## format all C and C++ sources
	$(list) '*.c' '*.h' '*.cpp' '*.hpp' | xargs -0 clang-format -i

lint: deps-run-test-firmware-lint lint-format lint-rooms lint-tidy ## check the format and who names the C libraries, and look for mistakes with clang-tidy

lint-format: deps-lint
	$(list) '*.c' '*.h' '*.cpp' '*.hpp' | xargs -0 clang-format --dry-run -Werror

# Which number type the C libraries have, and how their functions are called, is known in two rooms of
# the harness alone.
lint-rooms:
	@others=$$(git grep -lE 'twd_|TWD_' -- harness | grep -vE '^harness/(engine|link)/'); [ -z "$$others" ] || \
	{ echo "make: only harness/engine and harness/link may name the C libraries' functions, not:" $$others >&2; exit 1; }

LINT := $(BUILD)/lint
COMMANDS := $(LINT)/compile_commands.json
own_sources = sed -n 's|^ *"file": "\($(CURDIR)/.*\)",\{0,1\}$$|\1|p' $(COMMANDS) | grep -v '^$(CURDIR)/build/'

# C++ takes most of the time: `make lint`, which every change must pass, leaves out its tests and benchmarks, and the
# static analyzer, which `make analyze` runs. Without the analyzer clang's own warnings come through; of these, `|`
# between comparisons is meant where no branch is wanted.
tidy = $(own_sources) | grep '[.]$(1)$$' | xargs -n 1 -P $$(nproc) clang-tidy -p $(LINT) --quiet
tidy_harness = $(own_sources) | grep '/harness/.*[.]cpp$$' | grep -v '/tests/' | xargs -n 1 -P $$(nproc) \
    clang-tidy -p $(LINT) --quiet --checks=-clang-analyzer-* --extra-arg=-Wno-bitwise-instead-of-logical

# Sources that the build writes, and ours include.
generated := twiddle_git_commit exported_headers

.PHONY: $(COMMANDS)
$(COMMANDS): deps-run-test-firmware-lint with-tests-emulators
	$(build) $(generated)
	@mkdir -p $(LINT)
	@awk -f cmake/first_commands.awk $(BUILD)/compile_commands.json >$@

lint-tidy: $(COMMANDS)
	@$(call tidy,c)
	@$(tidy_harness)

analyze: deps-run-test-firmware-bench-lint with-bench $(COMMANDS) ## look for mistakes in all C++ sources, with clang's static analyzer (10 minutes)
	@$(call tidy,cpp)
