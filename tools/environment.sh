# shellcheck shell=bash
# Sourced by the scripts of the project: root folder, locale, number of jobs, compiler cache.
#
# Afterwards the working directory is the root of the project and `stanok_root` names it.
stanok_root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
cd "$stanok_root" || exit

export LC_ALL=C.UTF-8 TZ=UTC

jobs="$(nproc)"
# shellcheck disable=SC2034  # read by the scripts
readonly stanok_root jobs

# A cache that outlives the build folder where there is a home for it; checkouts share their entries.
export CCACHE_DIR="${CCACHE_DIR:-${HOME:-/nonexistent}/.cache/ccache}"
if ! mkdir -p "$CCACHE_DIR" 2>/dev/null || [[ ! -w "$CCACHE_DIR" ]]; then
  CCACHE_DIR="$stanok_root/build/ccache"
fi
export CCACHE_BASEDIR="$stanok_root" CCACHE_NOHASHDIR=1

# Files of the repository that match the patterns, one a line; without git, those found on disk.
tracked_files() {
  if ! git -c safe.directory="$stanok_root" ls-files -- "$@" 2>/dev/null; then
    local pattern
    for pattern in "$@"; do
      find . \( -name build -o -name .git -o -name out \) -prune -o -name "$pattern" -type f -print
    done
  fi
}
