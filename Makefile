# `make` builds couplet and prints the landmark constants; `make test` runs every test.

.DEFAULT_GOAL := run
.PHONY: run build test snapshots lint docs constants checker combinations crates examples exporters bench peers proofs witness m4 coq

run: build
	./target/release/couplet constants

build: m4
	cargo build --release --locked

test: m4
	cargo test --locked --all-features

# The whole outputs in tests/it/snapshots, written anew; `git diff` shows what has changed.
snapshots: m4
	UPDATE_SNAPSHOTS=1 cargo test --locked --all-features --test it outputs::

lint: m4
	cargo fmt --check
	cargo clippy --all-targets --all-features --locked -- -D warnings

docs: m4
	RUSTDOCFLAGS="-D warnings" cargo doc --no-deps --all-features --locked

# The repository's certificates, 100 digits of every landmark; a test says whether they are up to date.
constants: build
	./target/release/couplet certify all --digits 100 --output proofs/constants

# The checker of certificates alone, which must need neither GMP nor MPFR: `couplet check`, and its tests.
checker:
	cargo build --release --locked --no-default-features --features check,cli --target-dir target/checker
	@! cargo tree --locked --no-default-features --features check,cli -e normal,build | grep -E "rug|gmp-mpfr"
	cargo test --locked --no-default-features --features check,cli --target-dir target/checker

# Every sensible build without a warning, and what must not be in it. One folder serves all of them, so
# that no crate is compiled twice for the same features.
COMBINATIONS := none check check,cli mpfr mpfr,check mpfr,cli mpfr,plots mpfr,proptest default default,plots,parquet,proptest
COMMAND := clap|indicatif|ctrlc|tempfile|csv
FIGURES := plotters|resvg
combinations: m4
	@set -e; for features in $(COMBINATIONS); do \
	  echo "features: $$features"; \
	  chosen="--locked --no-default-features --features=$$(echo $$features | sed s/none//)"; \
	  cargo clippy $$chosen --all-targets --quiet --target-dir target/combinations -- -D warnings; \
	  left_out="a-crate-that-is-not"; \
	  case $$features in *mpfr*|*default*) ;; *) left_out="$$left_out|rug|gmp-mpfr-sys|rayon";; esac; \
	  case $$features in *cli*|*default*) ;; *) left_out="$$left_out|$(COMMAND)";; esac; \
	  case $$features in *plots*) ;; *) left_out="$$left_out|$(FIGURES)";; esac; \
	  case $$features in *parquet*) ;; *) left_out="$$left_out|parquet";; esac; \
	  case $$features in *proptest*) ;; *) left_out="$$left_out|proptest";; esac; \
	  case $$features in none) left_out="$$left_out|serde|serde_json|thiserror";; esac; \
	  if cargo tree $$chosen -e normal,build --prefix none | grep -E "^($$left_out) "; then \
	    echo "couplet: a crate is in the build '$$features' that must not be" >&2; exit 1; \
	  fi; \
	done

# The columns `crates` and `seconds` of the README's table of features: each build from nothing.
crates: m4
	@benches/crates.sh

# The programs of examples/; each ends with what it asserts.
examples: m4
	for name in constant state identity own_solver; do \
	  cargo run --locked --quiet --features proptest --example $$name || exit 1; \
	done

# The exported constants read back bit for bit by every language they are written for. `make test` does so
# with those it finds; here the others are installed (but for Julia, which has no package), and Parquet too.
EXPORTERS := g++ gfortran octave python3 texlive-latex-recommended texlive-science
exporters: m4
	@command -v g++ gfortran octave-cli python3 pdflatex >/dev/null && kpsewhich siunitx.sty booktabs.sty >/dev/null || { \
	  if [ "$$(id -u)" = 0 ] && command -v apt-get >/dev/null; then \
	    apt-get update -qq && apt-get install -y -qq --no-install-recommends $(EXPORTERS); \
	  else \
	    echo "couplet: not every language is there; install the packages '$(EXPORTERS)' (sudo apt-get install $(EXPORTERS))" >&2; \
	    exit 1; \
	  fi; }
	cargo test --locked --all-features --test it export::

# Timings of this machine; nothing depends on them.
bench: m4
	cargo bench --locked

# The same job by Arb, PARI, mpmath, ... beside couplet; about 20 minutes.
peers: m4
	benches/peers/run.py

# Every Coq proof: compiled, its assumptions compared with proofs/coq/axioms.txt, and wrong copies of a
# generated file refused. Takes some minutes. Before it the certificates, in a third arithmetic.
proofs: witness coq
	$(MAKE) -C proofs/coq -j2
	$(MAKE) -C proofs/coq check spoil

# The repository's certificates checked once more, by a script over Arb that knows docs/certificate.md and
# nothing of this program. python-flint goes into a virtual environment of its own.
ARB := target/arb
witness:
	@python3 -c 'import flint' 2>/dev/null || [ -x $(ARB)/bin/python3 ] || { \
	  python3 -m venv $(ARB) && $(ARB)/bin/pip install --quiet 'python-flint>=0.8'; } || { \
	  echo "couplet: the third check needs Python 3.10 or newer with venv and python-flint (pip install python-flint)" >&2; \
	  exit 1; }
	@if python3 -c 'import flint' 2>/dev/null; then python=python3; else python=$(ARB)/bin/python3; fi; \
	$$python proofs/check_with_arb.py proofs/constants/*.json

# GMP's configure script, run by the first build, needs m4.
m4:
	@command -v m4 >/dev/null || { \
	  if [ "$$(id -u)" = 0 ] && command -v apt-get >/dev/null; then \
	    apt-get update -qq && apt-get install -y -qq --no-install-recommends m4; \
	  else \
	    echo "couplet: the first build needs m4; install the package 'm4' (sudo apt-get install m4)" >&2; \
	    exit 1; \
	  fi; }

# Coq with its libraries for intervals and real analysis; 1.1 GB on disk.
COQ := coq libcoq-interval libcoq-flocq libcoq-coquelicot
coq:
	@library=$$(coqc -where 2>/dev/null)/user-contrib; \
	[ -e "$$library/Interval/Tactic.vo" ] && [ -e "$$library/Coquelicot/Coquelicot.vo" ] || { \
	  if [ "$$(id -u)" = 0 ] && command -v apt-get >/dev/null; then \
	    apt-get update -qq && apt-get install -y -qq --no-install-recommends $(COQ); \
	  else \
	    echo "couplet: the proofs need Coq with Interval and Coquelicot; install the packages '$(COQ)' (sudo apt-get install $(COQ))" >&2; \
	    exit 1; \
	  fi; }
