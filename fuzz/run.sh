#!/bin/sh
# Gives arbitrary bytes to the parser of certificates and to the checker in pure Rust, for ten minutes, from certificates
# of every kind on. Neither may panic, hang or need much memory. Needs cargo-fuzz (`cargo install cargo-fuzz`).
set -e
cd "$(dirname "$0")/.."
seeds=fuzz/corpus/certificate
mkdir -p fuzz/corpus

certify() {
  cargo run --release --locked -- certify "$@" --digits 2
}
certify all --output $seeds
cp tests/it/certificates/refused/*.json $seeds
for arch in "pi/2 1/2" "pi/2 0.38" "2.45 1.35" "2.56 1.8" "2.6 2" "2.5 inf" "2.62 inf"; do
  certify state --alpha ${arch% *} --mu ${arch#* } --output "$seeds/state-$(echo $arch | tr '/ ' '--').json"
done
for eta in 0.05 0.15 1.5; do
  certify arch --alpha 80deg --mu 0.35 --eta $eta --output "$seeds/arch-$eta.json"
done
for arch in "2.3 1.05" "2.3 1.07" "2.25 0.99"; do
  certify asymmetric --alpha ${arch% *} --mu ${arch#* } --output "$seeds/asymmetric-${arch#* }.json"
done
certify survey --alpha 70deg..80deg --mu 0.5..0.6 --eta 0.06..0.2 --output $seeds/survey.json

# A stable compiler puts in the instrumentation if it is told so.
RUSTC_BOOTSTRAP=1 cargo fuzz run certificate -- -dict=fuzz/certificate.dict -max_len=6000 \
  -timeout=20 -rss_limit_mb=1024 -max_total_time=600
