#!/bin/sh
# Unpacks the valgrind of a later Debian release (the argument, or trixie with 3.24) into target/valgrind, beside the system's, and prints
# how to call it. Valgrind 3.19 does not know a move between registers (vmovq, bytes C5 79 D6 /r) that compilers for x86-64-v3 make.
#
#   export VALGRIND=$(benches/newer_valgrind.sh) && benches/count.sh --record
set -eu
cd "$(dirname "$0")/.."
release=${1:-trixie}
target=${CARGO_TARGET_DIR:-target}
mkdir -p "$target/valgrind"
place=$(cd "$target/valgrind" && pwd)
if [ ! -x "$place/run" ]; then
    mkdir -p "$place/lists/partial" "$place/cache/archives/partial"
    archive=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | grep '/debian/*$' | head -n 1)
    keys=/usr/share/keyrings/debian-archive-keyring.gpg
    echo "deb [signed-by=$keys] $archive $release main" >"$place/sources.list"
    apt() {
        apt-get -qq -o Dir::Etc::sourcelist="$place/sources.list" -o Dir::Etc::sourceparts=/dev/null \
            -o Dir::State::lists="$place/lists" -o Dir::Cache="$place/cache" -o APT::Sandbox::User=root "$@" >&2
    }
    apt update
    (cd "$place" && apt download valgrind && dpkg -x valgrind_*.deb .)
    printf '#!/bin/sh\nVALGRIND_LIB=%s/usr/libexec/valgrind exec %s/usr/bin/valgrind "$@"\n' "$place" "$place" >"$place/run"
    chmod +x "$place/run"
fi
echo "$place/run"
