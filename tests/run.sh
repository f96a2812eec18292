#!/usr/bin/env bash
# Builds gyratory with its tests and runs all but the slow ones. Options go to ctest.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

bash apps/setup.sh
CMAKE_GENERATOR=${CMAKE_GENERATOR:-Ninja} cmake -S . -B build -DBUILD_TESTING=ON
cmake --build build --parallel "$(nproc)"
ctest --test-dir build --label-exclude slow --output-on-failure --parallel 2 "$@"
