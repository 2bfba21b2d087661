# Sourced by the scripts that build. It offers
#   setup NEEDED… -- [OPTIONAL…]   installs through apt the Debian packages that are missing
#   configure PRESET               configures build/PRESET, unless nothing has changed
#   build PRESET [TARGET…]         builds it
# All of them speak on standard error only; standard output is left to what the caller runs.
#
# A package is written as its name, or as alternatives, newest baseline first: "a|b".

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

toolchain_packages=(g++ cmake ninja-build ccache)
library_packages=(
  'libboost1.81-dev|libboost1.83-dev|libboost1.88-dev|libboost-dev'
  libgmp-dev libmpfr-dev libgtest-dev libcli11-dev nlohmann-json3-dev libfmt-dev libtbb-dev
  libtomlplusplus-dev libpugixml-dev
)
# Special functions of formulas, and an oracle of the tests.
arb_packages=('libflint-arb-dev|libflint-dev')
oracle_packages=("${arb_packages[@]}" libmpfi-dev libbenchmark-dev gnuplot-nox)
# Of modules of the program: MPI and HDF5, for maps.
module_packages=(libopenmpi-dev openmpi-bin libhdf5-dev)
peer_packages=(libpari-dev)  # of the benchmarks alone
python_packages=(python3-dev pybind11-dev python3-pytest)
# Of some tests of the package, and of its notebooks.
notebook_packages=(python3-hypothesis python3-mpmath python3-numpy python3-pandas python3-matplotlib
  python3-nbclient python3-ipykernel)
# Of the pages of scenes, unless npm comes from elsewhere than Debian.
page_packages=()
if ! { command -v node && command -v npm; } >/dev/null; then page_packages=(nodejs npm); fi

# Compiled objects are shared between checkouts of this project, wherever they lie.
export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1
# Precompiled headers are kept as well: without these ccache would keep nothing that uses one.
export CCACHE_SLOPPINESS=pch_defines,time_macros

say() { printf '%s\n' "$*" >&2; }

die() {
  say "${0##*/}: $*"
  exit 1
}

installed() {
  [[ $(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null) == installed ]]
}

# The first of the alternatives that is installed.
installed_of() {
  local name
  for name in ${1//|/ }; do
    if installed "$name"; then echo "$name" && return 0; fi
  done
  return 1
}

# The first of the alternatives that apt can install, or else the first of them.
available_of() {
  local name
  for name in ${1//|/ }; do
    if [[ -n $(apt-cache --quiet=2 policy "$name" | sed -n '/Candidate: (none)/d; /Candidate:/p') ]]
    then echo "$name" && return; fi
  done
  echo "${1%%|*}"
}

# The packages among the arguments of which no alternative is installed.
missing_of() {
  local package
  for package in "$@"; do
    installed_of "$package" >/dev/null || echo "$package"
  done
}

run_apt() {
  local sudo=()
  ((EUID == 0)) || sudo=(sudo)
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get --quiet=2 --option Dpkg::Use-Pty=0 \
    --option DPkg::Lock::Timeout=300 "$@" >&2 </dev/null
}

install_packages() {
  local packages=() package
  for package in "$@"; do packages+=("$(available_of "$package")"); done
  say "installing: ${packages[*]}"
  run_apt install --yes --no-install-recommends --no-remove "${packages[@]}"
}

setup() {
  local needed=() optional=() missing=() missing_optional=()
  while (($#)) && [[ $1 != -- ]]; do needed+=("$1") && shift; done
  shift || true
  optional=("$@")
  wanted=("${needed[@]}" "${optional[@]}")

  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    local tool
    for tool in cmake ninja c++; do
      command -v "$tool" >/dev/null || die "$tool is missing. $(needs)"
    done
    return 0
  fi

  mapfile -t missing < <(missing_of "${needed[@]}")
  mapfile -t missing_optional < <(missing_of "${optional[@]}")
  ((${#missing[@]} + ${#missing_optional[@]})) || return 0

  if ((EUID != 0)) && ! command -v sudo >/dev/null; then
    ((${#missing[@]} == 0)) || die "these packages are missing, and installing them needs root" \
      "or sudo: ${missing[*]%%|*}"
    say "going on without ${missing_optional[*]%%|*}: installing needs root or sudo"
    return 0
  fi
  run_apt update || say "apt-get update failed; going on with the package lists at hand"
  if ((${#missing[@]})); then
    install_packages "${missing[@]}" || die "apt-get could not install: ${missing[*]%%|*}"
  fi
  if ((${#missing_optional[@]})); then
    install_packages "${missing_optional[@]}" || say "going on without ${missing_optional[*]%%|*}"
  fi
}

# What to install by hand where there is no apt.
needs() {
  echo "Polhode needs: a C++20 compiler, CMake 3.25, Ninja, Boost 1.81, GMP, MPFR, GoogleTest," \
    "CLI11, nlohmann-json, fmt, oneTBB, toml++, pugixml (Debian's packages: ${wanted[*]%%|*})."
}

# What a configured tree depends on and does not see by itself.
fingerprint() {
  local package name
  cksum <"$root/CMakePresets.json"
  echo "${CC-} ${CXX-} ${CXXFLAGS-}"
  echo "node $(node --version 2>/dev/null) npm $(npm --version 2>/dev/null)"
  if command -v dpkg-query >/dev/null; then
    for package in "${toolchain_packages[@]}" "${library_packages[@]}" "${oracle_packages[@]}" \
      "${peer_packages[@]}" "${python_packages[@]}"; do
      name=$(installed_of "$package") || continue
      dpkg-query --show "$name"
    done
  fi
}

configure() {
  local tree=$root/build/$1 print
  print=$(fingerprint)
  if [[ -e $tree/build.ninja && $(cat "$tree/fingerprint" 2>/dev/null) == "$print" ]]; then return; fi
  (cd "$root" && cmake --preset "$@") >&2 || {
    command -v apt-get >/dev/null || say "$(needs)"
    die "cannot configure build/$1"
  }
  printf '%s\n' "$print" >"$tree/fingerprint"
}

build() {
  local preset=$1 targets=()
  shift
  (($#)) && targets=(--target "$@")
  (cd "$root" && cmake --build --preset "$preset" --parallel "$(nproc)" "${targets[@]}") >&2 ||
    die "cannot build build/$preset"
}
