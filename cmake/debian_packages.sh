# shellcheck shell=bash
# Sourced by tests/run and capi/examples/run: installs the Debian packages that are missing.

build_packages=(g++ cmake ninja-build libeigen3-dev libhwy-dev)

as_root() {
    if [ "$(id -u)" -eq 0 ]; then
        "$@"
    elif command -v sudo >/dev/null; then
        sudo "$@"
    else
        echo "installing packages needs root or sudo: $*" >&2
        return 1
    fi
}

is_installed() {
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# Another process may hold a lock, as on a machine that has just started. DPkg::Lock::Timeout waits for those of dpkg;
# for those of the lists and of the archives apt does not wait, and is called again.
lock_patience=1800 # seconds

apt_get() { # apt_get ARGUMENT...
    local said deadline=$((SECONDS + lock_patience)) status=0
    while true; do
        said=$(as_root env LC_ALL=C DEBIAN_FRONTEND=noninteractive \
            apt-get -qq -o Dpkg::Use-Pty=0 -o "DPkg::Lock::Timeout=$lock_patience" "$@" 2>&1 >/dev/null) && status=0 || status=$?
        [ "$status" -ne 0 ] && [[ $said == *'Could not get lock'* ]] && [ "$SECONDS" -lt "$deadline" ] || break
        sleep 1
    done
    [ -z "$said" ] || printf '%s\n' "$said" >&2
    return "$status"
}

install_packages() { # install_packages NAME...
    local missing=() name
    for name in "$@"; do
        is_installed "$name" || missing+=("$name")
    done
    if [ ${#missing[@]} -eq 0 ]; then
        echo "== all $# Debian packages needed are installed"
        return
    fi
    echo "== installing Debian packages: ${missing[*]}"
    apt_get update
    apt_get install --yes --no-install-recommends "${missing[@]}"
}
