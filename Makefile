# SPDX-License-Identifier: LGPL-2.1-or-later
#
# make demo         designs case 6 and an anatomical implant, leaves files and pictures in build/demo/
# make test         all tests on this machine's FreeCAD; ONLY="tests/core tests/gui/test_x.py" and MATCH=word choose some
# make test-latest  the same on the newest FreeCAD of Debian, in a root of its own (tools/newest_freecad.sh)
# make validate     the thesis' tables beside ours        make bench    our time beside a rival's
# make brep         the B-Rep engine on cases 1 to 6: how far, time, memory, volumes (CASES="case1 case2" chooses)
# make same-seed    the same designs on both FreeCADs, compared
# make gallery      pictures of every panel and design    make lint     ruff and the test of the layers
# make translations refreshes the .ts files from the sources, and packs them into .qm
# make release      checks, the archive, installed into a clean FreeCAD home and tested there; VERSION=0.2.0 names it first
# make tour         walks the three doors in the window, a picture of each step (ARGS=--docs: the tutorials)
# make types        mypy on what runs without FreeCAD
# make setup        what the others do first: installs what is missing by apt and pip, and says what
# make clean        removes build/

PYTHON = /usr/bin/python3
LATEST = sh tools/newest_freecad.sh run
CHOICE = $(if $(ONLY),--only $(ONLY)) $(if $(MATCH),--match $(MATCH))

.PHONY: help setup test test-latest same-seed brep brep-latest demo bench validate gallery tour translations lint
.PHONY: release types format clean

help:
	@sed -n '3,15s/^# \{0,1\}//p' Makefile

setup:
	@sh tools/setup.sh

test: setup
	@$(PYTHON) tests/run.py --out build/test $(CHOICE)

test-latest:
	@sh tools/newest_freecad.sh build
	@$(LATEST) sh tools/setup.sh
	@$(LATEST) $(PYTHON) tests/run.py --out build/test-latest $(CHOICE)

demo bench validate gallery tour: setup
	@$(PYTHON) tools/$@.py $(ARGS)

brep: setup
	@$(PYTHON) tools/brep_table.py $(CASES)

brep-latest:
	@sh tools/newest_freecad.sh build
	@$(LATEST) sh tools/setup.sh
	@$(LATEST) $(PYTHON) tools/brep_table.py $(CASES)

# One seed, one result: the same designs on both FreeCADs, compared number by number.
same-seed: setup
	@mkdir -p build/same_seed
	@$(PYTHON) tools/same_seed.py write build/same_seed/here.npz
	@sh tools/newest_freecad.sh build
	@$(LATEST) sh tools/setup.sh
	@$(LATEST) $(PYTHON) tools/same_seed.py write build/same_seed/latest.npz
	@$(PYTHON) tools/same_seed.py compare build/same_seed/here.npz build/same_seed/latest.npz

# The same with the newest FreeCAD: make bench-latest, make validate-latest, ...
%-latest:
	@sh tools/newest_freecad.sh build
	@$(LATEST) sh tools/setup.sh
	@$(LATEST) $(PYTHON) tools/$*.py $(ARGS)

# lrelease is installed by the command itself, when it is run.
translations:
	@$(PYTHON) tools/translations.py

types: setup
	@sh tools/pinned.sh mypy 2.4.1

release: setup
	@$(PYTHON) tools/release.py $(if $(VERSION),--version $(VERSION)) $(ARGS)

lint:
	@sh tools/ruff.sh check --output-format concise .
	@sh tools/ruff.sh format --check .
	@$(PYTHON) tests/test_imports.py

format:
	@sh tools/ruff.sh check --fix .
	@sh tools/ruff.sh format .

clean:
	rm -rf build
