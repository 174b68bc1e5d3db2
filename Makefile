# SPDX-License-Identifier: BSD-3-Clause
# Every target installs the Debian packages that it needs first and says so (tools/setup).
# The work is done by CMake (CMakePresets.json) and by the scripts in tools/.
MAKEFLAGS += --no-print-directory
.DEFAULT_GOAL := help
.PHONY: help demo paper validation build package python test test-full nightly check docs format clean

# CMake takes the launcher from the environment; ccache only where it is installed.
use_ccache = export CMAKE_CXX_COMPILER_LAUNCHER=$$(command -v ccache || true);

help:
	@echo "make demo       build, run the box beam of the paper, draw it, list the files to open"
	@echo "make paper      build, run the paper's three examples with every search method, write docs/paper.md (10 minutes)"
	@echo "make validation DECKS=folder  run others' models with reference results, write docs/validation.md (30 minutes)"
	@echo "make build      release programs and the pages of crumple report and compare: build/release, build/viewer"
	@echo "make package    Debian packages; tar files of a program that needs only the C library"
	@echo "make python     the Python packages crumple and cellsearch, tested: build/python/python"
	@echo "make test       release build and all quick tests"
	@echo "make test-full  after make test: clang, sanitizers, golden hashes, all checks"
	@echo "make nightly    long property runs and fuzzing"
	@echo "make check      static checks only"
	@echo "make docs       the documentation as a site of plain files: build/docs/index.html"
	@echo "make format     write all C++ files as clang-format wants them"
	@echo "make clean      remove build/ and out/"

demo:
	@tools/setup build picture
	@$(MAKE) build
	@tools/demo

paper:
	@tools/setup build picture
	@$(MAKE) build
	@/usr/bin/python3 bench/paper build/release/crumple

validation:
	@[ -d "$(DECKS)" ] || { echo "DECKS=folder names the folder of the decks: see bench/validation.py --help"; exit 2; }
	@$(MAKE) build
	@/usr/bin/python3 bench/validation.py --program build/release/crumple --decks "$(DECKS)"

build:
	@tools/setup build
	@echo "Building the release programs in build/release ..."
	@mkdir -p build; $(use_ccache) cmake -C cmake/build_once.cmake --preset release -DCRUMPLE_TESTS=OFF -DCRUMPLE_KERNELS=native >build/configure.log 2>&1 || { cat build/configure.log; exit 1; }
	@cmake --build --preset release
	@tools/setup viewer || echo "Without nodejs and npm the report's page cannot be built."
	@tools/build_viewer
	@echo "Built: build/release/crumple, build/release/cellsearch-bench"

package:
	@tools/setup build viewer package
	@$(use_ccache) tools/package

python:
	@tools/setup build python
	@$(use_ccache) cmake --preset python && cmake --build --preset python
	@ctest --test-dir build/python --output-on-failure -R '^python\.'
	@echo "Built and tested: export PYTHONPATH=$(CURDIR)/build/python/python"

test:
	@tools/setup build python viewer test
	@$(use_ccache) tools/test

test-full:
	@tools/setup build python viewer test check mpi picture report docs
	@$(use_ccache) tools/test_full

nightly:
	@tools/setup build python viewer package test check mpi docs
	@$(use_ccache) tools/nightly

check:
	@tools/setup build python test check mpi docs
	@$(use_ccache) tools/check

docs:
	@tools/setup docs
	@tools/build_docs

format:
	@tools/setup check
	@tools/check_format --fix

clean:
	@echo "Removing build/ and out/"
	@rm -rf build out
