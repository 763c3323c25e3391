PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
SHARED := -n 2 --dist loadgroup --no-loadscope-reorder  # tests that share what they make on one worker: tests/sharing.py

.PHONY: demo test soak bench clean

demo: $(VENV)/installed
	$(BIN)/vecpoly demo -o out

# types are checked beside the tests, for a processor that waits for the last group of them is idle;
# what is compiled is kept, so that it is not compiled by every process that a test starts
test: $(VENV)/installed-dev
	$(BIN)/ruff check vecpoly tests benchmarks
	$(BIN)/ruff format --check --quiet vecpoly tests benchmarks
	@$(BIN)/python -m tests.typed > $(VENV)/types.txt 2>&1 & types=$$!; \
	PYTHONDONTWRITEBYTECODE= $(BIN)/pytest $(SHARED); tests=$$?; \
	wait $$types; types=$$?; cat $(VENV)/types.txt; exit $$((tests | types))

soak: $(VENV)/installed-dev
	$(BIN)/python -m tests.generators --count 300 --seed 1 --jobs 2
	$(BIN)/python -m tests.by_lot --count 300 --seed 1
	$(BIN)/python -m tests.fuzz --files 20000 --commands 1000 --classes 3000 --kills 200 --seed 1
	HYPOTHESIS_PROFILE=soak $(BIN)/pytest $(SHARED)  # every law at least forty times as long as in `make test`

bench: $(VENV)/installed-dev
	$(BIN)/python -m benchmarks

$(VENV)/installed: pyproject.toml
	$(PYTHON) -m venv $(VENV)
	$(BIN)/pip install --quiet -e .
	touch $@

$(VENV)/installed-dev: $(VENV)/installed
	$(BIN)/pip install --quiet -e ".[dev]"
	touch $@

clean:
	rm -rf $(VENV) out/*.pdf out/*.html
