# `make` builds couplet and prints the landmark constants; `make test` runs every test.

.DEFAULT_GOAL := run
.PHONY: run build test lint docs constants checker exporters bench peers proofs witness m4 coq

run: build
	./target/release/couplet constants

build: m4
	cargo build --release --locked

test: m4
	cargo test --locked

lint: m4
	cargo fmt --check
	cargo clippy --all-targets --locked -- -D warnings

docs: m4
	RUSTDOCFLAGS="-D warnings" cargo doc --no-deps --locked

# The repository's certificates, 100 digits of every landmark; a test says whether they are up to date.
constants: build
	./target/release/couplet certify all --digits 100 --output proofs/constants

# The checker of certificates alone, which must need neither GMP nor MPFR.
checker:
	cargo build --release --locked --no-default-features --features check --target-dir target/checker
	@! cargo tree --locked --no-default-features --features check -e normal,build | grep -E "rug|gmp-mpfr"

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
	cargo clippy --all-targets --locked --features parquet -- -D warnings
	cargo test --locked --features parquet --test export

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
