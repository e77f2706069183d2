# `make` builds couplet, shows an arch and says what to try; `make check` has that program check itself; `make test` runs every test.
.DEFAULT_GOAL := run
.PHONY: run build check test slow lint docs msrv deny packages semver dist dist-equal dist-try snapshots pictures constants states \
        checker combinations house examples exporters c library install uninstall header wheel notebooks page page-test \
        reference metadata bench limits peers proofs witness arb verified verified-test m4 coq ocaml trial aarch64

# Everything at once, chosen in the same words by every command, so that nothing is compiled twice. Not `--all-features`:
# `system-gmp` takes GMP and MPFR from the system, which may have them too old.
ALL := --workspace --features proptest
# The command and its libraries are in a profile of cargo; in that of tests, `dev`, and with what is built beside the command in
# TOGETHER, all are of the same crates (.ci/run).
COUPLET_PROFILE ?= release
COMMAND := target/$(COUPLET_PROFILE:dev=debug)/couplet
CERTIFICATES := proofs/constants/*.json proofs/states/*.json proofs/asymmetric/*.json proofs/surveys/*.json
# What was skipped because a program is missing: the last lines of `make test` and `make c`.
SKIPPED := $(CURDIR)/target/skipped

# No path of this machine stands in a program that is handed on. That of Linux has no tables for what unwinds, as a panic ends it.
release library: export RUSTFLAGS = --remap-path-prefix=$(CURDIR)=/couplet --remap-path-prefix=$(or $(CARGO_HOME),$(HOME)/.cargo)=/cargo \
  $(if $(TOGETHER)$(filter library,$@),,$(and $(filter Linux,$(shell uname -s)),-C force-unwind-tables=no))

# $(call need,TEST,PACKAGES,WHY): if the test fails, says so and installs Debian packages as root, and names them otherwise.
# An installation that was cut off before is finished first: apt-get refuses to work next to one.
define need
@{ $(1); } >/dev/null 2>&1 || { \
  if [ "$$(id -u)" = 0 ] && command -v apt-get >/dev/null; then \
    echo "couplet: $(strip $(3)); installing the packages '$(strip $(2))' with apt-get" >&2; \
    export DEBIAN_FRONTEND=noninteractive; dpkg --configure -a >&2; \
    apt-get update -qq && apt-get install -y -qq --no-install-recommends $(strip $(2)); \
  else \
    echo "couplet: $(strip $(3)); install the packages '$(strip $(2))' (sudo apt-get install $(strip $(2)))" >&2; exit 1; \
  fi; }
endef
# $(call cargo_tool,NAME): ends where a tool of cargo is missing.
cargo_tool = command -v $(1) >/dev/null || { echo "couplet: $(1) is missing (cargo install --locked $(1))" >&2; exit 1; }
# $(call environment,FOLDER,PACKAGES): a virtual environment of Python with packages.
environment = python3 -m venv $(1) && $(1)/bin/pip install --quiet --disable-pip-version-check $(2)

run: build
	@echo
	./$(COMMAND) state --weight heyman --half-opening 90deg --friction 0.5
	@printf '%s\n' '' 'That is a semicircular arch at its least thickness. To try:' \
	  '  ./target/release/couplet assess --span 10m --rise 3m --thickness 60cm --friction 0.6' \
	  '  ./target/release/couplet constants                     the landmark points, proved' \
	  '  ./target/release/couplet draw --half-opening 90deg --friction 0.5 -o arch.svg' \
	  '  ./target/release/couplet --help                        everything else'

build: m4
	@[ -e $(COMMAND) ] || echo 'couplet: the first build compiles GMP, MPFR and about 150 crates; it takes some minutes'
	@$(MAKE) --no-print-directory release
release:
	cargo build --profile $(COUPLET_PROFILE) --locked --package couplet $(TOGETHER)
# The program that was built, by what is stored: its certificates, its constants and states, the examples of the pages.
check: build
	@tests/check.sh $(COMMAND)
# Not the profile of `make`: tests look at overflows and at the code's own assertions.
test: m4
	@mkdir -p target && : > $(SKIPPED)
	COUPLET_SKIPPED=$(SKIPPED) cargo test --locked $(ALL)
	@sort -u $(SKIPPED)
# The thirty slowest tests, with their seconds.
slow: m4
	cargo --config 'target."cfg(all())".runner = ["env", "RUSTC_BOOTSTRAP=1"]' test --locked $(ALL) --tests -- \
	  -Z unstable-options --report-time | sed -n 's/^test \(.*\) \.\.\. ok <\(.*\)s>$$/\2 \1/p' | sort -rn | head -n 30
# The whole outputs in tests/it/snapshots and the picture of the rooms, written anew; `git diff` shows what has changed.
snapshots: m4
	UPDATE_SNAPSHOTS=1 cargo test --locked $(ALL) --test it -- outputs:: door::
pictures: build
	cd docs/pictures && ../../$(COMMAND) map -o map.svg
	cd docs/pictures && ../../$(COMMAND) draw --half-opening 80deg --friction 0.35 -o arch.svg
	cd docs/pictures && ../../$(COMMAND) draw --span 8m±3cm --rise 4m±3cm --thickness 47cm..49cm --friction 0.55..0.75 -o arches.svg
	cd docs/pictures && ../../$(COMMAND) map --plane opening-friction --mark 87deg..93deg,0.55..0.75 -o survey.svg
	$(COMMAND) study accuracy --only landmark,state -o target/accuracy
	cp target/accuracy/error-against-time.svg docs/pictures/accuracy.svg
lint: m4
	cargo fmt --all --check
	cargo clippy --all-targets $(ALL) --locked -- -D warnings
docs: m4
	RUSTDOCFLAGS="-D warnings" cargo doc --no-deps $(ALL) --locked

# What a script of .ci does stands at its top: the stated Rust version, every sensible build, the Python package, and a release
# (docs/release.md).
msrv dist-try:
	@.ci/$@
combinations wheel dist dist-equal: m4
	@.ci/$@
# Whether every crate has a licence of deny.toml's list and comes from the registry.
deny:
	@$(call cargo_tool,cargo-deny)
	cargo deny --locked --workspace check licenses bans sources
# Every crate as the registry would have it, in target/package, each built from what is in it; `PACKAGE=--no-verify` builds none.
packages: m4
	cargo package --workspace --locked $(PACKAGE)
# Whether what the library offered in the last version, it still offers.
semver: m4
	@last=$$(git tag --list 'v[0-9]*' --sort=-version:refname | head -n 1); \
	if [ -z "$$last" ]; then echo 'couplet: no version has a tag yet, so there is nothing to compare with'; exit 0; fi; \
	$(call cargo_tool,cargo-semver-checks); \
	cargo semver-checks --package couplet --package couplet-check --baseline-rev "$$last"

# The repository's certificates: 100 digits of every landmark; one state of each collapse mode, one asymmetric solution of (19) of each
# kind, for each weight, and verdicts on surveys; then every one as a theorem. Tests say whether they are up to date.
constants: build
	./$(COMMAND) certify all --digits 100 --output proofs/constants
states: build
	proofs/certify.sh ./$(COMMAND) proofs
	./$(COMMAND) prove --coq proofs/coq/generated --certificate proofs/*/*.json

# The checker of certificates alone, in pure Rust: what it needs, and what it says of every stored certificate.
checker:
	cargo build --release --locked --package couplet-check --target-dir target/checker
	@! cargo tree --locked --package couplet-check -e normal,build | grep -E "rug|gmp-mpfr|resvg|proc-macro"
	@[ $$(cargo tree --locked --package couplet-check -e normal,build --prefix none | sed 's/ (.*//' | sort -u | wc -l) -le 20 ] || \
	  { echo "couplet: the checker has more than 20 crates" >&2; exit 1; }
	target/checker/release/couplet-check $(CERTIFICATES) >target/checker/said
	@echo "$$(grep -c ': accepted' target/checker/said) certificates accepted"
examples: m4
	cargo build --locked --quiet $(ALL) --examples
	for name in constant state identity own_solver; do target/debug/examples/$$name || exit 1; done
# The exported constants read back bit for bit by every language they are written for: here those that `make test` does not find are
# installed (but for Julia, which has no package).
exporters: m4
	$(call need,command -v g++ gfortran octave-cli python3 pdflatex && kpsewhich siunitx.sty booktabs.sty,\
	g++ gfortran octave python3 texlive-latex-recommended texlive-science,not every language is there)
	cargo test --locked $(ALL) --test it export::

# The library for C. Examples and tests run in every language that is there; what the command says is what they have to say.
C := target/c
c: build library
	$(call need,command -v gcc && command -v g++,g++,the tests of the library for C need a compiler)
	@mkdir -p target && : > $(SKIPPED)
	COUPLET_C=$(CURDIR)/$(C) COUPLET=$(CURDIR)/$(COMMAND) COUPLET_SKIPPED=$(SKIPPED) cargo test --locked $(ALL),made --test c
	@sort -u $(SKIPPED)
library: m4
	c/build.sh $(C)
# The command and that library, as they were built last, in a prefix; packagers have a DESTDIR before it.
PREFIX := /usr/local
INTO = $(DESTDIR)$(PREFIX)
install: | $(COMMAND) $(C)
	install -d $(INTO)/bin
	install $(COMMAND) $(INTO)/bin/couplet
	cp -RP $(C)/. $(INTO)
$(COMMAND) $(C):
	@$(MAKE) --no-print-directory $(if $(filter $(C),$@),library,build)
uninstall:
	rm -f $(INTO)/bin/couplet $(INTO)/include/couplet_c.* $(INTO)/lib/libcouplet_c.* $(INTO)/lib/pkgconfig/couplet_c.pc
	rm -rf $(INTO)/lib/cmake/couplet_c
# The header of that library, made anew of its source.
header:
	UPDATE_SNAPSHOTS=1 cargo test --locked $(ALL),made --test c header::the_header
# The notebooks in python/notebooks, run and stored anew; `git diff` shows what has changed. `make wheel` compares.
notebooks: m4
	$(call environment,target/notebooks,./python -r python/notebooks/requirements.txt)
	target/notebooks/bin/python python/notebooks/run.py --write

# The map as a page that proves what it shows and checks certificates; and whether what it shows is what the command prints.
page: build
	$(call need,page/build.sh --ready && command -v python3,rustc-web cargo-web rust-web-src lld python3,\
	the page needs Python and the target wasm32-unknown-unknown (rustup target add wasm32-unknown-unknown))
	page/make.sh $(COMMAND) target/page/index.html
page-test: page
	page/test.py target/page/index.html $(COMMAND)
# The citable bundle of certificates, with scripts that replay it.
reference: build checker verified arb
	$(arb) proofs/reference/make.py target/reference $(COMMAND) \
	  --checker target/checker/release/couplet-check --verified $(VERIFIED)/couplet-verified --arb $$python
# codemeta.json and .zenodo.json, written anew from CITATION.cff; a test says whether they are up to date.
metadata:
	$(call environment,target/metadata,'cffconvert==2.0.0')
	proofs/reference/metadata.py target/metadata/bin/cffconvert
# Tests with new seeds for SECONDS, once all is compiled; it begins with the seed SEED, and prints it (.ci/trial).
SECONDS := 600
trial: m4
	@.ci/trial $(SECONDS)
# The states of 64-bit ARM, under an emulator, are those of this machine bit for bit; ARCHES of them.
ARCHES := 100000
aarch64: build
	@.ci/aarch64 $(ARCHES) $(COMMAND)

# The size of the house (`benches/house.py --time` has the seconds of builds too); timings of this machine; every option with limits at
# both of them, within a minute or with its time; the same job by Arb, PARI, mpmath, ... beside couplet, in about 40 minutes.
house: m4
	@benches/house.py
bench: m4
	cargo bench --locked
limits: build
	benches/limits.py $(COMMAND)
peers: m4
	benches/peers/run.py
# Every Coq proof: compiled, its assumptions compared with proofs/coq/axioms.txt, and wrong copies of a generated file refused.
# Takes some minutes. Before it the certificates, in a third arithmetic.
proofs: witness coq
	$(MAKE) -C proofs/coq -j2
	$(MAKE) -C proofs/coq check spoil
# The checker of which Coq has proved that what it accepts is true, as a program. It checks every stored certificate.
VERIFIED := target/verified
verified: coq ocaml
	$(MAKE) -C proofs/coq -j2 verified/SurveySound.vo verified/Faster.vo
	mkdir -p $(VERIFIED)
	cp proofs/verified/*.ml $(VERIFIED)/
	cd $(VERIFIED) && coqc -q -w -ambiguous-paths,-extraction-opaque-accessed -R ../../proofs/coq Couplet \
	  -o $$PWD/Extract.vo ../../proofs/coq/verified/Extract.v
	cd $(VERIFIED) && ocamlfind ocamlopt -w -a -O3 -unsafe -inline 200 -package zarith -c faster.ml verified.mli verified.ml
	cd $(VERIFIED) && ocamlfind ocamlopt -w -a -package zarith -linkpkg faster.cmx verified.cmx json.ml reader.ml statement.ml \
	  main.ml -o couplet-verified
	$(VERIFIED)/couplet-verified check proofs/*/*.json >$(VERIFIED)/said || { cat $(VERIFIED)/said; exit 1; }
	@echo "$$(grep -c '^accepted' $(VERIFIED)/said) certificates accepted by the verified checker"
# The verified checker beside the quick one, on every certificate that the tests spoil: more than 10,000 files.
verified-test: verified
	proofs/verified/compare.py $(VERIFIED)/couplet-verified $(VERIFIED)/spoiled

# The repository's certificates checked once more, by a script over Arb that knows docs/certificate.md and nothing of this program. `arb`
# sets the shell's `python` to one that has Arb.
ARB := target/arb
arb = if python3 -c 'import flint' 2>/dev/null; then python=python3; else python=$(ARB)/bin/python3; fi;
witness: arb
	@$(arb) $$python proofs/check_with_arb.py $(CERTIFICATES)
arb:
	@python3 -c 'import flint' 2>/dev/null || [ -x $(ARB)/bin/python3 ] || { $(call environment,$(ARB),'python-flint>=0.8'); } || { \
	  echo "couplet: the third check needs Python 3.10 or newer with venv and python-flint (pip install python-flint)" >&2; exit 1; }

# For the first build, whose GMP is configured with m4; Coq, with 1.1 GB on disk; OCaml, for the program that Coq extracts.
m4:
	$(call need,command -v m4,m4,the first build needs m4)
coq:
	$(call need,library=$$(coqc -where)/user-contrib && [ -e "$$library/Interval/Tactic.vo" ] \
	&& [ -e "$$library/Coquelicot/Coquelicot.vo" ],coq libcoq-interval libcoq-flocq libcoq-coquelicot,\
	the proofs need Coq with Interval and Coquelicot)
ocaml:
	$(call need,[ -e "$$(ocamlfind query zarith)/z.cmi" ],ocaml-nox ocaml-findlib libzarith-ocaml-dev,the verified checker needs OCaml with Zarith)
