#!/usr/bin/env bash
# Hashes of six scenes over 100 000 steps (or as many as the argument says) on every target there is here: x86-64 and x86-64-v3, with and
# without lanes, with and without optimisation, aarch64 under QEMU, WebAssembly in node. Says which differ from the first.
#
# Needs: rustup target add aarch64-unknown-linux-musl wasm32-wasip1; qemu-user-static; node.
set -euo pipefail
cd "$(dirname "$0")/../.."
steps=${1:-100000}
target=${CARGO_TARGET_DIR:-target}
first=
failed=0

# hashes NAME COMMAND…: runs a program and compares what it prints with what the first one printed.
hashes() {
    local name=$1 found
    shift
    if ! found=$("$@" "$steps" 2>"$target/seconds"); then
        printf '%-34s does not run\n' "$name"
        failed=1
        return
    fi
    first=${first:-$found}
    if [ "$found" = "$first" ]; then
        printf '%-34s equal   %s\n' "$name" "$(tail -n 1 "$target/seconds")"
    else
        printf '%-34s DIFFERS\n%s\n' "$name" "$found"
        failed=1
    fi
}

# build DIRECTORY FLAGS ARGUMENTS…: builds the program into a directory of its own.
build() {
    local directory=$1 flags=$2
    shift 2
    RUSTFLAGS=$flags cargo build --quiet -p catena-same-bits --target-dir "$target/$directory" "$@"
}

v3="-C target-cpu=x86-64-v3"
build same "" --release
hashes "x86-64" "$target/same/release/catena-same-bits"
printf '%s\n' "$first"
build same-v3 "$v3" --release
hashes "x86-64-v3" "$target/same-v3/release/catena-same-bits"
build same "" --release --features lanes
hashes "x86-64, lanes of four" "$target/same/release/catena-same-bits"
build same-v3 "$v3" --release --features lanes
hashes "x86-64-v3, lanes of four" "$target/same-v3/release/catena-same-bits"
build same ""
hashes "x86-64, debug" "$target/same/debug/catena-same-bits"
build same-v3 "$v3"
hashes "x86-64-v3, debug" "$target/same-v3/debug/catena-same-bits"
build same-arm "-C linker=rust-lld" --release --target aarch64-unknown-linux-musl
hashes "aarch64 (QEMU)" qemu-aarch64-static "$target/same-arm/aarch64-unknown-linux-musl/release/catena-same-bits"
build same-wasm "" --release --target wasm32-wasip1
hashes "wasm32 (node)" node --no-warnings crates/same-bits/run.mjs \
    "$target/same-wasm/wasm32-wasip1/release/catena-same-bits.wasm"
exit $failed
