#!/usr/bin/env bash
# Builds docs/live.html from crates/live/live.html.in and the library compiled for browsers; needs the target wasm32-unknown-unknown.
set -euo pipefail
cd "$(dirname "$0")/../.."
cargo build --profile wasm -p catena-live --target wasm32-unknown-unknown
wasm=${CARGO_TARGET_DIR:-target}/wasm32-unknown-unknown/wasm/catena_live.wasm
size=$(stat -c %s "$wasm")
echo "$size bytes"
[ "$size" -lt 500000 ]
{
    sed '/@WASM@/,$d' crates/live/live.html.in
    printf '<script id="wasm" type="text/plain">%s</script>\n' "$(base64 -w 0 "$wasm")"
    sed '1,/@WASM@/d' crates/live/live.html.in
} >docs/live.html
