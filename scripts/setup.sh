# Sourced by the scripts beside it: installs what is missing, builds into build/. Every step is skipped when done.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# --help of a script is the comment that it begins with; nothing is installed or built for it.
if [ "$*" = --help ] || [ "$*" = -h ]; then
  sed -n -e 1d -e '/^#/!q' -e 's/^# \{0,1\}//p' "$0"
  exit 0
fi

say() { printf '== %s\n' "$*" >&2; }

# by_hand PACKAGE...: ends with what is to be installed otherwise.
by_hand() {
  say "cannot install packages here (no apt-get, no network or no rights); install these, then run this again: $*"
  exit 3
}

# apt_install PACKAGE...: says which are missing, and installs them.
apt_install() {
  local package missing=()
  for package in "$@"; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return
  command -v apt-get >/dev/null || by_hand "${missing[@]}"
  local sudo=()
  [ "$(id -u)" = 0 ] || sudo=(sudo)
  say "installing packages: ${missing[*]}"
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -qq >&2 || by_hand "${missing[@]}"
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -qq -y --no-install-recommends "${missing[@]}" >/dev/null ||
    by_hand "${missing[@]}"
}

# compile_once: the programs and the Python module are built of the same sources, with the same flags; ccache compiles
# them once.
compile_once() {
  apt_install ccache
  export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_BASEDIR="$root"
}

# configure: makes the build folder $build once, with the options in TANK_DATUM_CMAKE_OPTIONS. Sources are compiled several
# together, in half the time: what they include is most of what each takes.
build="$root/build"
configure() {
  compile_once
  apt_install g++ cmake ninja-build pkg-config libpcl-dev libcli11-dev nlohmann-json3-dev liblzf-dev libssl-dev \
    libfast-float-dev libxxhash-dev libsleef-dev libtomlplusplus-dev libgtest-dev locales python3 libvtk9-dev libx11-dev \
    node-d3
  [ ! -f "$build/build.ninja" ] || return 0
  say "configuring ${build#"$root/"}/"
  cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON ${TANK_DATUM_CMAKE_OPTIONS:-} >&2
}

# build TARGET...: configures, then builds what changed.
build() {
  configure
  say "building ${*} in ${build#"$root/"}/"
  cmake --build "$build" --target "$@" >&2
}

# python_environment: .venv/ with what the Python tests and scripts need, each file by its hash (scripts/pin).
python_environment() {
  local wanted="$root/tests/python/requirements.lock" stamp="$root/.venv/requirements.installed"
  cmp -s "$wanted" "$stamp" && return
  apt_install python3 python3-venv
  say "making .venv/ for the Python tests"
  /usr/bin/python3 -m venv "$root/.venv"
  "$root/.venv/bin/pip" install --quiet --disable-pip-version-check --require-hashes -r "$wanted" >&2
  cp "$wanted" "$stamp"
}

# python_module: the package tank_datum in .venv/, built anew when a source is newer than the last one, by what .venv/ has.
python_module() {
  local stamp="$root/.venv/tank_datum.installed" sources=(CMakeLists.txt src include apps scripts/pyproject.toml)
  [ -f "$stamp" ] && [ -z "$(cd "$root" && find "${sources[@]}" -newer "$stamp" -print -quit)" ] && return
  compile_once
  apt_install python3-dev
  say "building the Python module into .venv/"
  touch "$stamp.begun"
  local options=(--config-settings=cmake.define.CMAKE_UNITY_BUILD=ON)
  case "${TANK_DATUM_CMAKE_OPTIONS:-}" in *WERROR=ON*) options+=(--config-settings=cmake.define.TANK_DATUM_WERROR=ON) ;; esac
  CC=cc CXX=c++ "$root/.venv/bin/pip" install --quiet --disable-pip-version-check --force-reinstall --no-deps \
    --no-build-isolation "${options[@]}" "$root/scripts" >&2
  mv "$stamp.begun" "$stamp"
}
