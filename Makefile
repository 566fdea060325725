# Front door: make demo, make test, make bench, make validate. The work is done by CMake.
MAKEFLAGS += --no-print-directory
jobs := $(shell nproc)
puadem := build/release/puadem

.PHONY: demo test bench validate build format clean

build: build/release/build.ninja
	@cmake --build build/release --parallel $(jobs) --target puadem

build/release/build.ninja: CMakeLists.txt CMakePresets.json
	@tools/install_dependencies
	@cmake --preset release -DPUADEM_BENCH=OFF >build-configure.log 2>&1 || { cat build-configure.log; exit 1; }
	@rm -f build-configure.log

# The paper's first study on 5,000 grains: packing, pore network, drainage, imbibition, report.
demo: build
	@$(puadem) run cases/drainage-beads/case.toml

# Everything that must hold: module order, unit and verification tests under a warnings-as-errors build,
# the same units under sanitizers, the tiny cases, the README's commands.
test:
	@tools/install_dependencies
	@tools/run_tests

bench:
	@tools/install_dependencies --bench
	@bench/run

# docs/validation.md anew: the drainage study, networks, one fluid, two fluids that move, liquid bridges. BALLS=FOLDER: where finney_packing_4021.csv lies.
validate: build
	@tools/install_dependencies --docs
	@cmake --build build/release --parallel $(jobs) --target verify_network --target verify_two_phase --target verify_bridges
	@tools/validate $(puadem)
	@tools/verify_network build/release/tests/verify_network $(if $(BALLS),--balls $(BALLS))
	@tools/verify_two_phase build/release/tests/verify_two_phase $(puadem)
	@tools/verify_coupling build/release/tests/verify_coupling $(puadem)
	@tools/verify_bridges build/release/tests/verify_bridges

format:
	@git ls-files '*.cpp' '*.hpp' | xargs clang-format -i

clean:
	@rm -rf build
