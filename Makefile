# On a new machine, start with `make demo` or `make test`; both create .venv if it does not exist.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
CLASS := build/sample_class
export OPENBLAS_NUM_THREADS := 1
unexport PYTHONDONTWRITEBYTECODE  # otherwise each command that a test starts compiles all its imports

.PHONY: demo test every verify docs release bubblewrap clean

demo: $(VENV)/ready bubblewrap
	$(BIN)/python tests/sample_class.py $(CLASS)
	$(BIN)/tam570-grader grade $(CLASS) --out build/sample_results --seed 570 --call 2
	$(BIN)/tam570-grader report build/sample_results

test: $(VENV)/ready bubblewrap
	$(BIN)/ruff check
	$(BIN)/ruff format --check
	$(BIN)/mypy
	$(BIN)/lint-imports
	$(BIN)/tam570-grader stubs --check
	$(BIN)/pytest -q -n 2 --dist loadgroup

# Run the tests that `make test` leaves out.
every: $(VENV)/ready bubblewrap
	$(BIN)/pytest -q -n 2 --dist loadgroup -m slow

verify: test every
	$(BIN)/tam570-grader audit --diagnosis
	$(BIN)/tam570-grader audit --margins
	mkdir -p build && $(BIN)/tam570-grader audit --fairness 100 --keep build/fairness.jsonl
	$(BIN)/python benchmarks/grading.py --peers nbgrader
	$(BIN)/python benchmarks/size.py
	$(BIN)/python benchmarks/autograde.py
	$(BIN)/python benchmarks/error_against_tolerance.py --write
	$(BIN)/python benchmarks/rotations.py
	$(BIN)/python benchmarks/ensembles.py
	$(BIN)/python benchmarks/show.py --peers
	$(BIN)/python benchmarks/run_time_against_error.py
	$(BIN)/python benchmarks/run_time_against_error.py --peers
	$(BIN)/python benchmarks/run_time_for_pages.py

# Build the site in build/site, with warnings as errors, and follow every link.
docs: $(VENV)/docs
	rm -rf build/site
	$(BIN)/sphinx-build -q -W --keep-going -j auto -b html docs build/site
	$(BIN)/python docs/links.py build/site
	@echo "Open build/site/index.html"

# Build a wheel and an sdist in dist/, and try them in a bare environment of each installed Python.
release: $(VENV)/ready
	$(BIN)/python .ci/release.py

$(BIN)/pip:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { echo "Python 3.11 or newer is needed: make PYTHON=python3.12 ..."; exit 1; }
	@$(PYTHON) -m venv $(VENV) || { echo "venv is missing: on Debian, apt-get install python3-venv"; exit 1; }

$(VENV)/ready: pyproject.toml | $(BIN)/pip
	@echo "Installing the course with all that its tests need into $(VENV) (a few minutes, once)"
	$(BIN)/pip install --quiet --disable-pip-version-check -e '.[dev,fast]'
	@touch $@

$(VENV)/docs: pyproject.toml | $(BIN)/pip
	@echo "Installing the course with what its site needs into $(VENV) (a minute, once)"
	$(BIN)/pip install --quiet --disable-pip-version-check -e '.[docs]'
	@touch $@

bubblewrap:
	@if [ "$$(uname)" = Linux ] && ! command -v bwrap >/dev/null; then \
	  if [ "$$(id -u)" = 0 ] && command -v apt-get >/dev/null; then \
	    echo "Installing bubblewrap, the sandbox of the grader"; \
	    apt-get update -qq && apt-get install -y -qq bubblewrap >/dev/null; \
	  else echo "bubblewrap is not installed: submissions will run as plain processes with limits"; fi; fi

clean:
	rm -rf $(VENV) build dist
