#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Compiles a program with a binding, and runs it. Exits with 77 if the language is not installed.
set -euo pipefail

usage() {
    echo "usage: run_binding.sh fortran|rust|python PROGRAM LIBRARY_FOLDER WORK_FOLDER [ARGUMENT...]" >&2
    exit 2
}
[ $# -ge 4 ] || usage
language=$1
program=$(realpath "$2")
library=$(realpath "$3")
mkdir -p "$4"
work=$(realpath "$4")
shift 4
bindings=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../../capi/bindings")
export LD_LIBRARY_PATH=$library${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}

need() {
    if ! command -v "$1" >/dev/null; then
        echo "SKIPPED: $1 is not installed"
        exit 77
    fi
}

run_fortran() {
    local compiler=${FC:-gfortran} module objects=()
    need "$compiler"
    local flags=(-std=f2018 -O2 -Wall -Wextra -Wno-compare-reals -Werror)
    for module in nurbs_constants nurbs_c nurbs_support nurbs_handles nurbs_splines nurbs_frames nurbs_calculus \
        nurbs_reduction nurbs_lists nurbs_compatible nurbs_continuities nurbs_continuation nurbs_projections \
        nurbs_segments nurbs_placements nurbs_curves nurbs_shapes nurbs_coons nurbs_recognition \
        nurbs_closest nurbs_measures nurbs_bounds nurbs_features nurbs_edits nurbs_deformations nurbs; do
        "$compiler" "${flags[@]}" -J"$work" -c "$bindings/fortran/$module.f90" -o "$work/$module.o"
        objects+=("$work/$module.o")
    done
    "$compiler" "${flags[@]}" -I"$work" "$program" "${objects[@]}" -L"$library" -lnurbs -o "$work/program"
    "$work/program" "$@"
}

run_rust() {
    local compiler=${RUSTC:-rustc}
    need "$compiler"
    local flags=(--edition 2021 -D warnings -L "$library")
    "$compiler" "${flags[@]}" --crate-type rlib --crate-name nurbs --out-dir "$work" "$bindings/rust/src/lib.rs"
    "$compiler" "${flags[@]}" --extern nurbs="$work/libnurbs.rlib" -L "$work" -o "$work/program" "$program"
    "$work/program" "$@"
}

run_python() {
    local interpreter=${PYTHON:-python3}
    need "$interpreter"
    if ! "$interpreter" -c 'import numpy' 2>/dev/null; then
        echo "SKIPPED: $interpreter has no NumPy"
        exit 77
    fi
    NURBS_LIBRARY=$library/libnurbs.so PYTHONPATH=$bindings/python PYTHONDONTWRITEBYTECODE=1 \
        "$interpreter" -W error "$program" "$@"
}

case $language in
fortran | rust | python) "run_$language" "$@" ;;
*) usage ;;
esac
