#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs a program, and has the dynamic linker write to FOLDER which functions of shared libraries it really calls. That
# needs a program that is linked lazily (-z lazy), and glibc.
#   trace_calls.sh FOLDER PROGRAM [ARGUMENT...]
set -euo pipefail
folder=$1
shift
rm -rf "$folder"
mkdir -p "$folder"
unset LD_BIND_NOW
LD_DEBUG=bindings LD_DEBUG_OUTPUT=$folder/bindings exec "$@"
