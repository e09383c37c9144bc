# SPDX-FileCopyrightText: 2026 the Palmer authors
# SPDX-License-Identifier: GPL-3.0-or-later
# Read by run and check: the Debian packages, and how to build. POSIX shell.

buildPackages="g++ cmake ninja-build git ccache libeigen3-dev libboost-dev nlohmann-json3-dev
libdeflate-dev libxml2-dev libqpdf-dev libpoppler-qt6-dev libzip-dev qt6-base-dev libqt6sql6-sqlite libqt6sql6-psql libqt6opengl6-dev qt6-charts-dev qt6-svg-dev
qt6-tools-dev qt6-tools-dev-tools qt6-l10n-tools qt6-translations-l10n
fontconfig fonts-liberation2 fonts-dejavu-core"

testPackages="postgresql mold python3 python3-jsonschema python3-numpy python3-mpmath python3-pandas mandoc poppler-utils libnss3-tools qpdf appstream"

lintPackages="clang-14 clang-tidy-14 python3"

# Installs those of the packages that are missing; says nothing when all are there.
needPackages() {
    # shellcheck disable=SC2086 # a list of words
    installed=" $(dpkg-query -W -f '${db:Status-Status}:${Package} ' $1 2>/dev/null || true)"
    missing=""
    for package in $1; do
        case "$installed" in
        *" installed:$package "*) ;;
        *) missing="$missing $package" ;;
        esac
    done
    [ -z "$missing" ] && return 0
    if [ "$(id -u)" = 0 ]; then
        asRoot="env"
    elif command -v sudo >/dev/null; then
        asRoot="sudo env"
    else
        echo "Missing packages, and neither root nor sudo to install them:$missing" >&2
        return 1
    fi
    echo "Installing:$missing" >&2
    $asRoot DEBIAN_FRONTEND=noninteractive apt-get update -q >&2
    # shellcheck disable=SC2086 # a list of words
    $asRoot DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $missing >&2
}

# Configures a preset once (ninja does it again when it has to) and builds it, or the targets that are named; speaks
# only when there is work.
configureAndBuild() {
    preset=$1
    shift
    if [ ! -f "build/$preset/build.ninja" ]; then
        cmake --preset "$preset" >&2
    fi
    ninja -C "build/$preset" "$@" >&2
}
