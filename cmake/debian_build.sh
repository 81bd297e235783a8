#!/usr/bin/env bash
# Builds the Debian packages: copies the sources to OUTPUT/libnurbs-VERSION, puts cmake/debian there as debian, packs
# the upstream tarball, and runs dpkg-buildpackage.
set -euo pipefail

if [ $# -lt 2 ]; then
    echo "usage: cmake/debian_build.sh SOURCE OUTPUT [DPKG-BUILDPACKAGE-OPTION...]" >&2
    exit 2
fi
source=$(realpath "$1")
mkdir -p "$2"
output=$(realpath "$2")
shift 2
case "$output" in
*[[:space:]]*)
    echo "debian_build.sh: blanks in \"$output\", which pybuild and dpkg's maps of paths do not take" >&2
    exit 2
    ;;
esac

# Modes of files are in the packages.
umask 022
# Debian's tools run Debian's Python and compilers, whatever else is on the PATH.
export PATH=/usr/sbin:/usr/bin:/sbin:/bin
version=$(dpkg-parsechangelog -l "$source/cmake/debian/changelog" -S Version | sed 's/-[^-]*$//')
SOURCE_DATE_EPOCH=$(dpkg-parsechangelog -l "$source/cmake/debian/changelog" -S Timestamp)
export SOURCE_DATE_EPOCH
name=libnurbs-$version
tree=$output/$name

rm -rf "$tree"
mkdir "$tree"
# What pip and Cargo leave beside the sources of their bindings is no part of them.
tar -C "$source" --exclude=__pycache__ --exclude=target --exclude=Cargo.lock --exclude='*.egg-info' \
    --exclude=capi/bindings/python/build --exclude=cmake/debian -cf - \
    CMakeLists.txt CMakePresets.json LICENSE README.md capi cmake include src tests .clang-format .clang-tidy |
    tar -C "$tree" -xf -
# The same bytes whoever packs them, wherever and whenever.
tar -C "$output" --sort=name --mtime="@$SOURCE_DATE_EPOCH" --owner=0 --group=0 --numeric-owner --mode=go=rX,u+rw \
    --format=gnu -cf - "$name" | xz -T1 >"$output/libnurbs_$version.orig.tar.xz"
# Files keep their times in the packages where they are older than the changelog: those of the tarball.
rm -rf "$tree"
tar -C "$output" -xf "$output/libnurbs_$version.orig.tar.xz"
cp -r "$source/cmake/debian" "$tree/debian"
chmod -R u+rwX,go+rX,go-w "$tree/debian"
cd "$tree"
dpkg-buildpackage --sanitize-env --unsigned-source --unsigned-changes "$@"
