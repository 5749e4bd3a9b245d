#!/bin/sh
# Builds the benchmark of sweeps (`count.sh runs`: of whole runs; `count.sh robots`: of functions of robots) for the default target and for
# x86-64-v3, runs both and prints tables of both.
# Instructions need valgrind; without it times are printed alone. --quick counts instructions of short chains of rods, no more;
# --check compares those of all rows but the longest with benches/results/counts.csv (of robots: robot_counts.csv), --record writes that
# file.
set -eu
export CARGO_INCREMENTAL=0 # else a program is compiled in parts, and its functions are inlined otherwise
cd "$(dirname "$0")/.."
target=${CARGO_TARGET_DIR:-target}
package=catena
bench=sweep
case ${1-} in
    runs) bench=runs && shift ;;
    robots) package=catena-urdf-robots && bench=robots && shift ;;
esac

# build FLAGS DIRECTORY: prints the path of the program.
build() {
    RUSTFLAGS=$1 cargo bench --quiet -p $package --bench $bench --no-run --target-dir "$2" --message-format=json |
        sed -n 's/.*"executable":"\([^"]*\)".*/\1/p' | tail -n 1
}

default=$(build "" "$target/count-default")
v3=$(build "-C target-cpu=x86-64-v3" "$target/count-v3")
exec "$default" "$@" --against "$v3"
