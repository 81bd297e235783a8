#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Compiles a program with a binding, and runs it; the functions that it calls are written to WORK_FOLDER/calls. The
# binding is compiled once, beside WORK_FOLDER. Exits with 77 if the language is not installed.
set -euo pipefail

usage() {
    echo "usage: run_binding.sh fortran|rust|python|python_single PROGRAM LIBRARY_FOLDER WORK_FOLDER [ARGUMENT...]" >&2
    exit 2
}
[ $# -ge 4 ] || usage
language=$1
program=$(realpath "$2")
library=$(realpath "$3")
mkdir -p "$4"
work=$(realpath "$4")
shift 4
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
bindings=$(realpath "$here/../../capi/bindings")
compiled=$(dirname "$work")/$language
export LD_LIBRARY_PATH=$library${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}

need() {
    if ! command -v "$1" >/dev/null; then
        echo "SKIPPED: $1 is not installed"
        exit 77
    fi
}

# compile_once COMMAND SOURCE...: in the folder $compiled, one at a time, and again if a source is newer.
compile_once() {
    local command=$1
    shift
    mkdir -p "$compiled"
    (
        flock 9
        if [ ! -e "$compiled/done" ] || [ -n "$(find "$@" "${BASH_SOURCE[0]}" -newer "$compiled/done")" ]; then
            rm -f "$compiled/done"
            (cd "$compiled" && "$command" "$@")
            touch "$compiled/done"
        fi
    ) 9>"$compiled/lock"
}

fortran_modules() {
    "$compiler" "${flags[@]}" -c "$bindings/fortran/nurbs_all.f90" "$here/expectations.f90" "$here/smoke_support.f90"
    rm -f libmodules.a
    ar cr libmodules.a ./*.o
}

run_fortran() {
    local compiler=${FC:-gfortran}
    need "$compiler"
    local flags=(-std=f2018 -O1 -Wall -Wextra -Wno-compare-reals -Werror)
    compile_once fortran_modules "$bindings"/fortran/*.f90 "$here/expectations.f90" "$here/smoke_support.f90"
    "$compiler" "${flags[@]}" -J"$work" -I"$compiled" "$program" -L"$compiled" -lmodules -L"$library" -lnurbs \
        -Wl,-z,lazy -o "$work/program"
    "$here/trace_calls.sh" "$work/calls" "$work/program" "$@"
}

rust_crate() {
    "$compiler" "${flags[@]}" --crate-type rlib --crate-name nurbs "$bindings/rust/src/lib.rs"
}

run_rust() {
    local compiler=${RUSTC:-rustc}
    need "$compiler"
    local flags=(--edition 2021 -D warnings -C relro-level=partial -L "$library")
    compile_once rust_crate "$bindings"/rust/src/*.rs
    "$compiler" "${flags[@]}" --extern nurbs="$compiled/libnurbs.rlib" -L "$compiled" -o "$work/program" "$program"
    "$here/trace_calls.sh" "$work/calls" "$work/program" "$@"
}

interpreter=${PYTHON:-python3}

need_python() {
    need "$interpreter"
    if ! "$interpreter" -c 'import numpy' 2>/dev/null; then
        echo "SKIPPED: $interpreter has no NumPy"
        exit 77
    fi
}

run_python() {
    need_python
    mkdir -p "$work/calls"
    NURBS_LIBRARY=$library/libnurbs.so PYTHONPATH=$bindings/python PYTHONDONTWRITEBYTECODE=1 \
        "$interpreter" -W error "$here/trace_calls.py" "$work/calls/ctypes" "$program" "$@"
}

# The package with its compiled part, beside links to the rest.
python_package() {
    rm -rf nurbs
    mkdir nurbs
    ln -s "$bindings"/python/nurbs/*.py* nurbs
    "$compiler" -std=c99 -O2 -Wall -Wextra -Werror -shared -fPIC -I"$headers" "$bindings/python/nurbs/_single.c" \
        -o nurbs/_single.abi3.so
}

run_python_single() {
    need_python
    local compiler=${CC:-cc} headers
    need "$compiler"
    headers=$("$interpreter" -c 'import sysconfig; print(sysconfig.get_path("include"))')
    if [ ! -e "$headers/Python.h" ] || ! "$interpreter" -c 'import sys; sys.exit(sys.version_info < (3, 11))'; then
        echo "SKIPPED: $interpreter is older than 3.11, or its headers are missing"
        exit 77
    fi
    compile_once python_package "$bindings"/python/nurbs/*
    NURBS_LIBRARY=$library/libnurbs.so PYTHONPATH=$compiled:$here PYTHONDONTWRITEBYTECODE=1 "$interpreter" "$program" "$@"
}

case $language in
fortran | rust | python | python_single) "run_$language" "$@" ;;
*) usage ;;
esac
