#!/usr/bin/env bash
# From a fresh checkout to a picture of a gyratory compaction: sets up, builds, runs, plots.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

bash apps/setup.sh
CMAKE_GENERATOR=${CMAKE_GENERATOR:-Ninja} cmake -S . -B build -DBUILD_TESTING=OFF
cmake --build build --parallel "$(nproc)"

out=run_quickstart
for ((number = 2; ; ++number)); do
  [[ -e $out ]] || break
  out=run_quickstart_$number
done

build/bin/gyratory apps/scenes/gyratory_sma11_150C.toml --out "$out"
apps/plot_run.py "$out" >/dev/null
echo "Open this in a browser: $PWD/$out/report.html"
