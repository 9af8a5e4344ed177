# SPDX-License-Identifier: LGPL-2.1-or-later
#
# make demo         designs case 6 and an anatomical implant, leaves files and pictures in build/demo/
# make test         all tests on this machine's FreeCAD; ONLY="tests/core tests/gui/test_x.py" and MATCH=word choose some
# make test-latest  the same on the newest FreeCAD of Debian, in a root of its own (tools/newest_freecad.sh)
# make validate     the thesis' tables beside ours        make bench    our time beside a rival's
# make gallery      pictures of every panel and design    make lint     ruff and the test of the layers
# make setup        what the others do first: installs what is missing by apt and pip, and says what
# make clean        removes build/

PYTHON = /usr/bin/python3
LATEST = sh tools/newest_freecad.sh run
CHOICE = $(if $(ONLY),--only $(ONLY)) $(if $(MATCH),--match $(MATCH))

.PHONY: help setup test test-latest demo bench validate gallery lint format clean

help:
	@sed -n '3,9s/^# \{0,1\}//p' Makefile

setup:
	@sh tools/setup.sh

test: setup
	@$(PYTHON) tests/run.py --out build/test $(CHOICE)

test-latest:
	@sh tools/newest_freecad.sh build
	@$(LATEST) sh tools/setup.sh
	@$(LATEST) $(PYTHON) tests/run.py --out build/test-latest $(CHOICE)

demo bench validate gallery: setup
	@$(PYTHON) tools/$@.py $(ARGS)

# The same with the newest FreeCAD: make bench-latest, make validate-latest, ...
%-latest:
	@sh tools/newest_freecad.sh build
	@$(LATEST) sh tools/setup.sh
	@$(LATEST) $(PYTHON) tools/$*.py $(ARGS)

lint:
	@sh tools/ruff.sh check --output-format concise .
	@sh tools/ruff.sh format --check .
	@$(PYTHON) tests/test_imports.py

format:
	@sh tools/ruff.sh check --fix .
	@sh tools/ruff.sh format .

clean:
	rm -rf build
