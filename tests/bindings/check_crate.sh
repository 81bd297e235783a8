#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The Rust crate as a user of Cargo has it, without a network: it builds, the examples in its documentation run, and the
# documentation is whole. Exits with 77 if Cargo is not installed.
#   check_crate.sh LIBRARY_FOLDER WORK_FOLDER
set -euo pipefail
if ! command -v cargo >/dev/null; then
    echo "SKIPPED: cargo is not installed"
    exit 77
fi
export NURBS_LIBRARY_DIR=$1 LD_LIBRARY_PATH=$1${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH} CARGO_TARGET_DIR=$2/target
mkdir -p "$2"
# Cargo writes beside the sources.
rm -rf "$2/crate"
cp -r "$(dirname "${BASH_SOURCE[0]}")/../../capi/bindings/rust" "$2/crate"
cd "$2/crate"
cargo test --offline
RUSTDOCFLAGS="-D warnings" cargo doc --offline --no-deps
