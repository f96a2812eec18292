#!/usr/bin/env bash
# Installs what gyratory needs on Debian 12, and only what is missing.
# With everything in place it needs neither root nor network.
set -euo pipefail

packages=(
  g++ cmake ninja-build
  libdeal.ii-dev libsuitesparse-dev libopenblas0-serial libeigen3-dev libboost-dev librandom123-dev
  libhdf5-dev libhdf5-openmpi-dev
  libtomlplusplus-dev libudunits2-dev libudunits2-data libcli11-dev libfmt-dev nlohmann-json3-dev
  libgtest-dev libgmock-dev libbenchmark-dev librapidcheck-dev
  python3 python3-numpy python3-h5py python3-matplotlib python3-scipy
  python3-vtk9 python3-pil xvfb xauth
)

if ! command -v dpkg-query >/dev/null; then
  echo "setup.sh: this is not a Debian system; install by other means: ${packages[*]}" >&2
  exit 1
fi

missing=()
for package in "${packages[@]}"; do
  state=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
  [[ $state == installed ]] || missing+=("$package")
done
((${#missing[@]})) || exit 0

as_root=()
if ((EUID != 0)); then
  if ! command -v sudo >/dev/null; then
    echo "setup.sh: as root, run: apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi

echo "Installing ${missing[*]}"
"${as_root[@]}" apt-get update
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install --yes --no-install-recommends "${missing[@]}"
