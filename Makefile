# What to type; `make` alone prints the list. Every target does its own set-up, in folders of the project:
# .tools (Cargo tools), .venv (Python), node_modules (the page), target or $CARGO_TARGET_DIR (what Cargo builds), out (what judder writes).

SHELL := bash
.SHELLFLAGS := -euo pipefail -c
.DEFAULT_GOAL := help
.NOTPARALLEL:

CARGO ?= cargo
TARGET := $(or $(CARGO_TARGET_DIR),target)
# The program of the demo is the one of the tests: who runs both compiles the libraries once. What is shipped, and timed, is the profile dist.
JUDDER := $(TARGET)/debug/judder
SHIPPED := $(TARGET)/dist/judder
# In CI the lock file is taken as it is; on a desk Cargo may still write what Cargo.toml asks for.
LOCKED := $(if $(CI),--locked)

REQUIREMENTS := $(wildcard tests/python/requirements.txt benches/requirements.txt)
PYTHON := .venv/bin/python
# Only the search of the book: no server, no file watcher.
MDBOOK := tools/cargo-tool mdbook 0.5.4 --no-default-features --features search
CARGO_DENY := tools/cargo-tool cargo-deny 0.20.2
# The sources of the page of `judder explore`, and its tests in a browser.
PAGE := crates/judder-explorer/web
# The interactive chart of reports, built from the same sources.
CHART := crates/judder-report/assets/chart
BROWSER_TESTS := crates/judder-explorer/tests/browser
NEXTEST := $(shell $(CARGO) nextest --version >/dev/null 2>&1 && echo yes)

# The tests of the Python package that are marked so. The wheel goes into a fresh environment whose PATH has no cargo: what users get.
define package-tests
	tools/python-environment .venv-package tests/python/package/requirements.txt
	@wheel=$$(mktemp -d); trap 'rm -rf "$$wheel"' EXIT; set -x; \
		PATH="$(CURDIR)/.venv/bin:$$PATH" maturin build --profile dev --out "$$wheel"; \
		PATH="$(CURDIR)/.venv/bin:$$PATH" maturin sdist --out "$$wheel"; \
		.venv-package/bin/python -m pip install --quiet --disable-pip-version-check "$$wheel"/*.whl; \
		JUDDER_WHEEL="$$wheel" JUDDER_SOURCES="$(abspath $(TARGET))/debug/lib_judder.d" PATH="$(CURDIR)/.venv-package/bin:/usr/bin:/bin" \
		.venv-package/bin/python -m pytest -q -p no:cacheprovider -m "$1" tests/python/package
endef

# Those of the page that are chosen by their tags.
define browser-tests
	$(CARGO) build $(LOCKED) --workspace --bins --examples
	chromium=$$(tools/chromium); cd $(BROWSER_TESTS) && \
		CHROMIUM="$$chromium" JUDDER="$(abspath $(TARGET))/debug/judder" npm run --silent test -- $1
endef

.PHONY: help demo test fuzz bench bench-cluster bench-explorer bench-rough inspect validate expensive-tests sdist-tests setup format lint rust-tests doc-tests python-tests page page-tests docs deny advisories dist dist-tests site workflows

help: ## print this list
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "  make %-14s %s\n", $$1, $$2 }' $(firstword $(MAKEFILE_LIST))

demo: ## build judder, reproduce the oscillator paper, say where the report lies
	$(CARGO) build $(LOCKED) -p judder-cli
	"$(JUDDER)" reproduce oscillator-paper --quick
	@printf '\nThe report lies here: %s\n' "$(CURDIR)/out/reproduce/oscillator-paper/report.html"

test: format rust-tests doc-tests python-tests page-tests ## what must hold before a change is proposed
	@printf '\nEvery check passed.\n'

# What takes long, and what looks at all sources for what a change seldom touches. CI runs it after `make test`.
inspect: lint fuzz docs deny workflows ## clippy, a minute of fuzzing, the documentation, the licences, the workflows

validate: inspect expensive-tests ## all that is inspected, and the expensive validation
	@printf '\nAll is validated.\n'

bench: .venv/installed ## time the stability decision, the sliding contact, a limit cycle, modes, assemblies, loci, marches and calls from Python, beside NumPy and SciPy peers
	$(CARGO) bench $(LOCKED) -p judder-oscillator
	$(PYTHON) benches/compare.py
	$(CARGO) bench $(LOCKED) -p judder-contact --bench contact
	$(PYTHON) benches/compare_sliding.py
	$(PYTHON) benches/compare_motion.py
	$(PYTHON) -m pip install --quiet --disable-pip-version-check .
	$(PYTHON) benches/compare_python.py
	$(PYTHON) benches/compare_sweeps.py
	$(PYTHON) benches/compare_modes.py
	$(PYTHON) benches/compare_eigen.py $(JUDDER_DISC_BRAKE)
	$(PYTHON) benches/compare_assemblies.py
	$(PYTHON) benches/compare_march.py
	$(PYTHON) benches/compare_response.py
	$(CARGO) bench $(LOCKED) -p judder-structure --bench reduction
	$(CARGO) bench $(LOCKED) -p judder-sliding

bench-cluster: .venv/installed ## what sweeps on a cluster cost beside their points, with a cluster of this machine
	$(PYTHON) -m pip install --quiet --disable-pip-version-check '.[distributed]'
	$(PYTHON) benches/scaling.py

# The peers stand apart: ASPHER compiles itself and wants g++ and libeigen3-dev.
bench-rough: .venv-peers/installed ## time the elastic contact of rough surfaces, beside Tamaas and ASPHER
	.venv-peers/bin/python benches/compare_rough.py

expensive-tests: .venv/installed $(BROWSER_TESTS)/node_modules/installed ## the tests that `make test` leaves out
ifeq ($(NEXTEST),yes)
	$(CARGO) nextest run $(LOCKED) --workspace --run-ignored only --no-tests pass
else
	$(CARGO) test $(LOCKED) --workspace --lib --bins --tests --examples -- --ignored
endif
	$(call package-tests,expensive)
	$(call browser-tests,--grep @expensive)

# Address space of 4 GiB, where the system limits it.
fuzz: ## feed every door damaged files, six seconds each; FUZZ='--inputs 100000' for more, FUZZ='--door meshes --seconds 600' for one
	$(CARGO) build $(LOCKED) --workspace --bins --examples
	ulimit -v 4194304 2>/dev/null || true; "$(TARGET)/debug/examples/fuzz" $(or $(FUZZ),--seconds 6)

# With a target folder of its own: in a shared one Cargo takes a crate for built whose files outside of it lie elsewhere.
sdist-tests: .venv/installed ## a wheel from the source distribution alone, compiled and called
	@sdist=$$(mktemp -d); trap 'rm -rf "$$sdist"' EXIT; set -x; \
		PATH="$(CURDIR)/.venv/bin:$$PATH"; maturin sdist --out "$$sdist"; \
		CARGO_TARGET_DIR="$$sdist/target" MATURIN_PEP517_ARGS="--profile dev" python -m pip wheel --quiet --disable-pip-version-check \
		--no-build-isolation --no-deps --wheel-dir "$$sdist" "$$sdist"/judder-*.tar.gz; \
		python -m venv "$$sdist/fresh"; \
		"$$sdist/fresh/bin/python" -m pip install --quiet --disable-pip-version-check "$$sdist"/judder-*.whl; \
		cd "$$sdist"; fresh/bin/python -c 'import judder; print(judder.oscillator.point(velocity="30 mm/s").verdict)'

setup: .venv/installed ## fetch and build what the other targets need
	$(CARGO) fetch $(LOCKED)
	$(MDBOOK) >/dev/null
	$(CARGO_DENY) >/dev/null

format: ## check that the code is formatted
	$(CARGO) fmt --all --check

lint: ## clippy, warnings are errors
	$(CARGO) clippy $(LOCKED) --workspace --all-targets -- -D warnings

rust-tests: ## unit, property, validation and convergence tests
ifeq ($(NEXTEST),yes)
	$(CARGO) nextest run $(LOCKED) --workspace
else
	@echo 'cargo-nextest is not installed: cargo test takes its place.'
	$(CARGO) test $(LOCKED) --workspace --lib --bins --tests --examples
endif

doc-tests: ## the examples in the docs and in the book
	$(CARGO) test $(LOCKED) --workspace --doc

# Built for the whole workspace, as the Rust tests are: a build of one crate would choose other features and start over.
python-tests: .venv/installed ## study folders in the real xarray, the book's links, the cases; the Python package from its wheel
	$(CARGO) build $(LOCKED) --workspace --bins --examples
	@sample=$$(mktemp -d); trap 'rm -rf "$$sample"' EXIT; \
		"$(TARGET)/debug/examples/sample_study" "$$sample/study"; \
		set -x; JUDDER="$(abspath $(TARGET))/debug/judder" JUDDER_SAMPLE_STUDY="$$sample/study" \
		$(PYTHON) -m pytest -q -p no:cacheprovider tests/python --ignore tests/python/package
	$(call package-tests,not expensive)

page: $(PAGE)/node_modules/installed ## build the page of `judder explore` and the chart of reports anew, into the sources that the program embeds
	cd $(PAGE) && npm run --silent build

# The page and the chart that stand in the sources must be those that their own sources build.
page-tests: $(PAGE)/node_modules/installed $(BROWSER_TESTS)/node_modules/installed ## the page of `judder explore` and the charts of reports: types, parts, build, themselves in a browser
	cd $(PAGE) && npm run --silent check && npm run --silent test
	@built=$$(mktemp -d); trap 'rm -rf "$$built"' EXIT; \
		for part in page:$(PAGE)/../page chart:$(CHART); do \
			(cd $(PAGE) && npm run --silent "build:$${part%%:*}" -- --outDir "$$built/$${part%%:*}" --emptyOutDir --logLevel warn); \
			diff -r "$$built/$${part%%:*}" "$${part#*:}" || { \
			echo 'What is embedded is not what its sources build: `make page`, and commit what it changes.'; exit 1; }; \
		done
	$(call browser-tests,--grep-invert @expensive)

bench-explorer: $(BROWSER_TESTS)/node_modules/installed ## time the page of `judder explore` in a browser: its start, the map after a slider has moved, frames of a drag
	$(CARGO) build --profile dist $(LOCKED) -p judder-cli
	chromium=$$(tools/chromium); cd $(BROWSER_TESTS) && \
		CHROMIUM="$$chromium" JUDDER="$(abspath $(SHIPPED))" npm run --silent bench

docs: ## build the API documentation and the book
	RUSTDOCFLAGS='-D warnings' $(CARGO) doc $(LOCKED) --workspace --no-deps
	mdbook=$$($(MDBOOK)); "$$mdbook" build docs
	@if grep -rlE '<(script|link|img)[^>]*(https?:)?//' --include='*.html' docs/book; then \
		echo 'The pages above fetch something from outside: the book must be readable offline.'; exit 1; fi

site: ## build the book as a folder of a site, with the site's front page, into `site`
	tools/site "$(or $(shell git describe --tags --exact-match 2>/dev/null),main)" site

deny: ## licences and sources of the dependencies, banned crates
	cargo_deny=$$($(CARGO_DENY)); "$$cargo_deny" --workspace check bans licenses sources

# Of the last commit, optimised: minutes.
dist: .venv-dist/installed ## build what is released of the last commit, into the empty folder `dist`
	PATH="$(CURDIR)/.venv-dist/bin:$$PATH" tools/dist/build dist

dist-tests: .venv-dist/installed ## install and run every artifact where nothing else of judder is
	JUDDER_DIST=dist .venv-dist/bin/python -m pytest -q -p no:cacheprovider tests/dist

# The schema of workflows, and their safety; both work offline.
workflows: .venv/installed ## check the workflows of the forge
	.venv/bin/check-jsonschema --builtin-schema vendor.github-workflows .github/workflows/*.yml
	.venv/bin/zizmor --offline --no-progress .github/workflows

# Not a part of `make test`: its answer depends on the day, and it needs the network.
advisories: ## known vulnerabilities of the dependencies
	cargo_deny=$$($(CARGO_DENY)); "$$cargo_deny" --workspace check advisories

.venv-peers/installed: tools/python-environment benches/peer/requirements.txt
	tools/python-environment .venv-peers benches/peer/requirements.txt
	@touch $@

.venv-dist/installed: tools/python-environment tools/dist/requirements.txt
	tools/python-environment .venv-dist tools/dist/requirements.txt
	@touch $@

.venv/installed: tools/python-environment $(REQUIREMENTS)
	tools/python-environment .venv $(REQUIREMENTS)
	@touch $@

# What the lock file says, nothing else; the browser is the system's.
%/node_modules/installed: %/package-lock.json
	cd $* && PLAYWRIGHT_SKIP_BROWSER_DOWNLOAD=1 npm ci --no-audit --no-fund --loglevel=error
	@touch $@
