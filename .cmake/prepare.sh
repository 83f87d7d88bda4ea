# SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by app/run and tests/run: installs what a bare Debian 12 lacks, and builds a preset.

# What building and running need.
gimbal_packages=(
    cmake ninja-build mold g++ qt6-base-dev qt6-serialport-dev qt6-charts-dev libqt6opengl6-dev qt6-svg-dev
    qt6-tools-dev qt6-tools-dev-tools qt6-l10n-tools libexpected-dev libeigen3-dev libgl-dev libxkbcommon-dev fonts-dejavu-core
    qt6-qpa-plugins libqscintilla2-qt6-dev qt6-translations-l10n libluajit-5.1-dev libsdl2-dev
    pkg-config libavcodec-dev libavformat-dev libswscale-dev libavutil-dev
)

# gimbal_install [PACKAGE...]: what building needs, and these packages beside it
gimbal_install() {
    local missing=()
    local package
    for package in "${gimbal_packages[@]}" "$@"; do
        dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || missing+=("$package")
    done
    [ ${#missing[@]} -eq 0 ] && return 0
    echo "Installing: ${missing[*]}"
    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || { echo "These packages are missing and sudo is not there; install them as root." >&2; return 1; }
        as_root=(sudo)
    fi
    "${as_root[@]}" apt-get update -qq
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

# gimbal_build PRESET [TARGET...]
gimbal_build() {
    local preset=$1
    shift
    [ -f "build/$preset/build.ninja" ] || cmake --preset "$preset" >"/tmp/gimbaldesk-configure-$$.log" 2>&1 \
        || { cat "/tmp/gimbaldesk-configure-$$.log"; rm -f "/tmp/gimbaldesk-configure-$$.log"; return 1; }
    rm -f "/tmp/gimbaldesk-configure-$$.log"
    echo "Building ($preset) in build/$preset ..."
    cmake --build --preset "$preset" ${1:+--target "$@"} -- --quiet
}
