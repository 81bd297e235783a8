#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# usage: check_alias.sh CXX INCLUDE_FOLDER: what the compiler says where nurbs is taken for the namespace.
set -u
cxx=$1
include=$2
said=$(printf '#define NURBS_CPP_ALIAS nurbs\n#include <nurbs/nurbs.hpp>\n' |
    "$cxx" -std=c++20 -fsyntax-only -I"$include" -x c++ - 2>&1) && { echo "the name nurbs was accepted"; exit 1; }
case $said in
*"NURBS_CPP_ALIAS has to be another name"*) echo "$said" | head -n 3 ;;
*) echo "no word of NURBS_CPP_ALIAS: $said"; exit 1 ;;
esac
