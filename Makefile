# `make` builds couplet and prints the landmark constants; `make test` runs every test.

.DEFAULT_GOAL := run
.PHONY: run build test lint docs bench m4

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

# Timings of this machine; nothing depends on them.
bench: m4
	cargo bench --locked

# GMP's configure script, run by the first build, needs m4.
m4:
	@command -v m4 >/dev/null || { \
	  if [ "$$(id -u)" = 0 ] && command -v apt-get >/dev/null; then \
	    apt-get update -qq && apt-get install -y -qq --no-install-recommends m4; \
	  else \
	    echo "couplet: the first build needs m4; install the package 'm4' (sudo apt-get install m4)" >&2; \
	    exit 1; \
	  fi; }
