# make run        install, run the casting demo and draw its picture
# make test       install with the test tools and run the quick tests
# make validate   the long tests and every published number (hours)
# make figures    draw every picture of the manual anew
# make study      measure the tables of the studies anew (hours)
# make lint docs clean
#
# PYTHON=python3.12 make run   chooses the interpreter (3.11 or newer)

PYTHON ?= python3
BIN := .venv/bin
DEMO := results/casting-demo
# the package as it is installed, with kernels and scenarios inside, for the type checker
HOUSE := build/house/warpsph
GRAPHICS_PACKAGES := libegl1 libgl1-mesa-dri
EXTRA_dev := [dev]
EXTRA_docs := [docs]

.PHONY: run test validate figures study lint docs clean graphics

run: .venv/installed-run graphics
	$(BIN)/warpsph run casting --preset demo --output $(DEMO).vtkhdf --overwrite
	@$(BIN)/warpsph render $(DEMO).vtkhdf --output $(DEMO).png --overwrite
	@echo "Look at $(DEMO).png; more with: $(BIN)/warpsph --help"

test: .venv/installed-dev
	$(BIN)/pytest -m "not slow"

validate: .venv/installed-dev
	$(BIN)/pytest -m slow
	@mkdir -p build
	$(BIN)/warpsph verify --slow --json build/verify.json

figures: .venv/installed-run graphics
	$(BIN)/python docs/figures.py

study: .venv/installed-run
	$(BIN)/python docs/parameter_study.py
	$(BIN)/python docs/conduction_study.py

lint: .venv/installed-dev
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	@rm -rf $(HOUSE) && mkdir -p $(HOUSE) \
	&& ln -s $(CURDIR)/warpsph/* $(CURDIR)/kernels $(CURDIR)/scenarios $(HOUSE)
	$(BIN)/mypy $(HOUSE)

docs: .venv/installed-docs
	$(BIN)/mkdocs build --strict --site-dir build/site
	@echo "Open build/site/index.html"

clean:
	rm -rf .venv build dist .pytest_cache .ruff_cache .hypothesis *.egg-info

# VTK dies at its first picture where the graphics libraries are missing; without them warpsph draws with matplotlib.
graphics: .venv/installed-run
	@$(BIN)/python -c 'import sys; from warpsph.pictures.graphics import graphics_available as g; sys.exit(not g())' \
	|| { [ "$$(id -u)" = 0 ] && command -v apt-get >/dev/null \
	     && echo "Installing graphics libraries: $(GRAPHICS_PACKAGES)" \
	     && { apt-get update && DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends \
	          $(GRAPHICS_PACKAGES); } >/dev/null 2>&1; } \
	|| echo "No graphics libraries: matplotlib draws the picture. For the finer one: apt-get install $(GRAPHICS_PACKAGES)"

.venv/bin/python:
	@command -v $(PYTHON) >/dev/null \
	|| { echo "$(PYTHON) is not here; install Python 3.11 or newer, or name it: PYTHON=... make"; exit 1; }
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' \
	|| { echo "$(PYTHON) is too old; warpsph needs Python 3.11 or newer: PYTHON=python3.12 make"; exit 1; }
	@$(PYTHON) -c 'import ensurepip, venv' 2>/dev/null \
	|| { echo "$(PYTHON) has no venv; install it (Debian, Ubuntu: apt-get install python3-venv)"; exit 1; }
	$(PYTHON) -m venv .venv

.venv/installed-%: pyproject.toml | .venv/bin/python
	@echo "Installing warpsph and its libraries into .venv; this takes a minute or two, once"
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable '.$(EXTRA_$*)'
	@touch $@
