#!/bin/sh
# Builds the benchmark of sweeps for the default target and for x86-64-v3, runs both and prints one table.
# Instructions need valgrind; without it times are printed alone. Arguments are words, of which scenes must contain one.
set -eu
cd "$(dirname "$0")/.."
target=${CARGO_TARGET_DIR:-target}

# build FLAGS DIRECTORY: prints the path of the program.
build() {
    RUSTFLAGS=$1 cargo bench --quiet --bench sweep --no-run --target-dir "$2" --message-format=json |
        sed -n 's/.*"executable":"\([^"]*\)".*/\1/p' | tail -n 1
}

default=$(build "" "$target/count-default")
v3=$(build "-C target-cpu=x86-64-v3" "$target/count-v3")
exec "$default" --against "$v3" "$@"
