# Sourced by the other scripts: checks or installs the Debian packages that they need.

# need PACKAGE...: installs missing packages as root or with sudo; otherwise prints the command.
need() {
    local missing=()
    local package
    for package in "$@"; do
        dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || missing+=("$package")
    done
    [ ${#missing[@]} -eq 0 ] && return 0
    local sudo=()
    if [ "$(id -u)" -ne 0 ]; then
        if command -v sudo >/dev/null && sudo -n true 2>/dev/null; then
            sudo=(sudo)
        else
            echo "These packages are missing. Install them, then run this again:" >&2
            echo "  sudo apt-get install ${missing[*]}" >&2
            return 1
        fi
    fi
    echo "installing ${missing[*]}"
    "${sudo[@]}" apt-get update -qq &&
        DEBIAN_FRONTEND=noninteractive "${sudo[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

# Any Boost from 1.74 on is sufficient; Debian's default is installed only if there is none.
boost_packages() {
    dpkg-query -W -f '${Status} ${Package}\n' 'libboost1.*-dev' 2>/dev/null | grep -q '^install ok installed' || echo libboost-dev
    local library
    for library in program-options filesystem; do
        dpkg-query -W -f '${Status} ${Package}\n' "libboost-${library}1.*-dev" 2>/dev/null |
            grep -q '^install ok installed' || echo "libboost-$library-dev"
    done
}

# Needed by CMake to configure everything, including the tests.
need_to_build() {
    need g++ cmake ninja-build catch2 python3 libpugixml-dev libpcap-dev libedit-dev nlohmann-json3-dev $(boost_packages)
}
need_to_test() { need_to_build && need iproute2 libxml2-utils pkgconf python3-clang tshark pybind11-dev python3-dev python3-pytest; }
need_for_docs() { need doxygen python3; }
need_for_site() { need_for_docs && need graphviz plantuml mkdocs mkdocs-material python3-pygments; }
need_for_firmware() { need gcc-arm-none-eabi libstdc++-arm-none-eabi-newlib qemu-system-arm; }
# emscripten has a compiler, libraries and tools of its own: some 0.9 GB with the browser of the tests.
need_for_web() { need emscripten cmake ninja-build python3 nlohmann-json3-dev $(boost_packages); }
need_to_test_web() { need_for_web && need chromium chromium-driver python3-selenium; }
# clang with its sanitizers and libFuzzer, which Debian has in a package of its own.
need_clang() { need clang && need "libclang-rt-$(clang++ -dumpversion | cut -d. -f1)-dev"; }

# Where ccache is installed, whatever CMake configures compiles through it.
if command -v ccache >/dev/null; then
    CMAKE_CXX_COMPILER_LAUNCHER=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)/cmake/cached_compiler
    export CMAKE_CXX_COMPILER_LAUNCHER
fi
