#!/usr/bin/env bash
# Times dem_speed and other DEM codes in turn on the same beds; exits 1 if a target of ours fails.
#   compare_peers.sh           the quick form: LAMMPS and 5000 stones, within a minute
#   compare_peers.sh --full    every installed peer, 5000 and 50,000 stones, a gyrating bed and 200,000
#                              stones, about 25 minutes
# --peers DIR is the folder with beds/, decks/ and run_bench.py; ../shared/peers beside the checkout
# if not given. --program and --plain name dem_speed as built for this machine and for any x86-64.
set -euo pipefail
export PYTHONDONTWRITEBYTECODE=1
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
for python in $(which -a python3); do
  if "$python" -c 'import numpy' 2> /dev/null; then
    exec "$python" "$here/compare_peers.py" "$@"
  fi
done
echo "no python3 with numpy found; install python3-numpy" >&2
exit 2
