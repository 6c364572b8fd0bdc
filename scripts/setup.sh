#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what granum needs and this machine lacks:  scripts/setup.sh run|python|docs|web|test|tidy|bench|solvers
# This is the only place that names the packages, as Debian 12 and 13 and Ubuntu 24.04 do. What matters is whether the
# system offers them, not what it is called. Checked by tests/setup/check_setup.py
# Exit codes: 0 all there, 2 usage, 3 something is missing and cannot be installed from here.
set -euo pipefail

library_packages=(libeigen3-dev libboost-dev libgsl-dev zlib1g-dev libexpat1-dev libfast-float-dev) # cmake/GranumPackage.cmake reads it
run_packages=(g++ cmake ninja-build "${library_packages[@]}" libtomlplusplus-dev nlohmann-json3-dev libfmt-dev)
python_packages=("${run_packages[@]}" python3-dev python3-numpy python3-scipy python3-matplotlib pybind11-dev python3-pytest python3-hypothesis mypy
  python3-pip python3-wheel)
docs_packages=("${python_packages[@]}" doxygen doxygen-awesome-css libjs-mathjax)
web_packages=("${run_packages[@]}" clang lld wasi-libc libclang-rt-dev-wasm32 libc++-dev-wasm32 binaryen
  nodejs chromium)
command -v npm >/dev/null || web_packages+=(npm) # some packages of nodejs bring it along
test_packages=("${docs_packages[@]}" doctest-dev clang-format
  clang lld libclang-rt-dev libc++-dev libc++abi-dev libbenchmark-dev dpkg-dev file pkg-config reuse)
tidy_packages=("${test_packages[@]}" clang-tidy)
bench_packages=("${run_packages[@]}" libbenchmark-dev python3-numpy)
# Beside which bench/solvers measures the network's solver; what is missing is left out there.
solvers_packages=("${bench_packages[@]}" libhypre-dev libsuitesparse-dev libtrilinos-ml-dev libtrilinos-ifpack-dev
  libtrilinos-epetra-dev libtrilinos-epetraext-dev libtrilinos-teuchos-dev)

case "${1:-}" in
run) packages=("${run_packages[@]}") ;;
python) packages=("${python_packages[@]}") ;;
docs) packages=("${docs_packages[@]}") ;;
web) packages=("${web_packages[@]}") ;;
test) packages=("${test_packages[@]}") ;;
tidy) packages=("${tidy_packages[@]}") ;;
bench) packages=("${bench_packages[@]}") ;;
solvers) packages=("${solvers_packages[@]}") ;;
*)
  echo "usage: scripts/setup.sh run|python|docs|web|test|tidy|bench|solvers" >&2
  exit 2
  ;;
esac

[ "${GRANUM_SKIP_SETUP:-0}" = 1 ] && exit 0

# dpkg's own scripts need an exported PATH with the sbin folders.
export PATH="$PATH:/usr/local/sbin:/usr/sbin:/sbin"

give_up() {
  {
    echo "granum: $1"
    echo "  needed, by their names in Debian and Ubuntu: ${missing[*]}"
    echo "  (C++20 compiler, CMake 3.25, Ninja, Eigen 3.4, Boost 1.74, GSL 2.7, zlib, expat, and the small libraries named)"
    echo "  Install them, as root:"
    echo "    apt-get update && apt-get install -y --no-install-recommends ${missing[*]}"
    echo "  Then run again; GRANUM_SKIP_SETUP=1 leaves this check out."
  } >&2
  exit 3
}

missing=("${packages[@]}")
for tool in dpkg-query apt-get apt-cache; do
  command -v "$tool" >/dev/null || give_up "this system has no $tool, so packages are not looked up and installed automatically."
done

missing=()
for package in "${packages[@]}"; do
  state=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$state" = installed ] || missing+=("$package")
done
[ "${#missing[@]}" -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || give_up "packages are missing, and installing them needs root."
  as_root=(sudo)
  [ -t 0 ] || as_root=(sudo -n)
fi

# What apt-get prints is shown where it fails.
apt() {
  local said
  said=$("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300 "$@" </dev/null 2>&1) ||
    { printf '%s\n' "$said" >&2 && return 1; }
}

# Sets `refused` to the missing packages that the system's lists do not offer.
look_up() {
  local package candidate
  refused=()
  for package in "${missing[@]}"; do
    candidate=$(LC_ALL=C apt-cache policy "$package" 2>/dev/null | sed -n 's/^ *Candidate: //p')
    case "$candidate" in
    "" | "(none)") refused+=("$package") ;;
    esac
  done
}

# The package lists are fetched only where they do not yet know, or no longer serve, what is missing.
look_up
if [ "${#refused[@]}" -gt 0 ] || ! apt-get -qq -s install --no-install-recommends "${missing[@]}" >/dev/null 2>&1; then
  apt update || give_up "the package lists cannot be fetched."
  look_up
fi
[ "${#refused[@]}" -eq 0 ] || give_up "this system offers no package ${refused[*]}."

install=(install -y --no-install-recommends "${missing[@]}")
files=0 bytes=0
while read -r _ _ size _; do
  [[ $size =~ ^[0-9]+$ ]] && files=$((files + 1)) bytes=$((bytes + size))
done < <(apt-get -qq --print-uris "${install[@]}" 2>/dev/null)
fetched=""
[ "$files" -eq 0 ] || fetched=" ($files files of $(((bytes + 999999) / 1000000)) MB are fetched, with what they need)"
echo "granum: installing ${#missing[@]} packages$fetched: ${missing[*]}" >&2
apt "${install[@]}" || { apt update && apt "${install[@]}"; } || give_up "the packages cannot be installed."
