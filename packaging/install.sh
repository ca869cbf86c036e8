# Installs what is missing of packaging/dependencies. Sourced by packaging/run and packaging/test.

dependencies() { sed -e 's/#.*//' -e '/^[[:space:]]*$/d' -e 's/[[:space:]]*$//' packaging/dependencies; }

missing_dependencies() {
    local package
    for package in $(dependencies); do
        dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q '^install ok installed$' || echo "$package"
    done
}

install_dependencies() {
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        echo "This machine has no apt-get. Sagara builds on Debian 12; the packages it needs are in packaging/dependencies." >&2
        return 1
    fi
    local missing as_root=()
    missing=$(missing_dependencies)
    [ -n "$missing" ] || return 0
    if [ "$(id -u)" -ne 0 ]; then
        if ! command -v sudo >/dev/null || ! sudo -n true 2>/dev/null && [ ! -t 0 ]; then
            echo "Packages are missing and neither root nor sudo is at hand. As root, run:" >&2
            echo "  apt-get install" $missing >&2
            return 1
        fi
        as_root=(sudo)
    fi
    echo "Installing:" $missing
    "${as_root[@]}" apt-get update -qq &&
        "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >/dev/null
}

# build_preset PRESET [TARGET...]: configures a preset once; later calls only build what changed. Shows what the compiler
# says and no more.
build_preset() {
    local preset=$1 status=0
    shift
    [ -f "build/$preset/build.ninja" ] || cmake --preset "$preset" >/dev/null || return 1
    (
        set -o pipefail
        cmake --build --preset "$preset" ${1:+--target "$@"} | { grep -Ev '^(\[[0-9]+/[0-9]+\]|ninja: no work to do)' || true; }
    ) || status=$?
    return "$status"
}
