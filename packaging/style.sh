#!/bin/sh
# What a change looks like: clang-format on all files, clang-tidy (.clang-tidy) on the sources that changed. Configures
# build/tidy and compiles nothing.
#   sh packaging/style.sh [SINCE]     SINCE: a commit; otherwise where this branch left origin/main, or the last commit
#   sh packaging/style.sh format      clang-format alone
#   HEFT_TIDY_MOST=40 sh packaging/style.sh   of more changed sources, only the 40 that changed most: a source takes about
#                                     10 s of processor time
set -eu
cd "$(dirname "$0")/.."
if ! git rev-parse --git-dir >/dev/null 2>&1; then
  echo "== Style: skipped, since this folder is no git clone"
  exit 0
fi
what=ON
[ "${1:-}" != format ] || what=format
HEFT_STYLE=$what HEFT_GUI=OFF sh packaging/install-packages.sh
echo "== clang-format"
git ls-files -z '*.cpp' '*.h' | xargs -0 clang-format --dry-run -Werror
[ "$what" = ON ] || exit 0

since=${1:-$(git merge-base HEAD origin/main 2>/dev/null || true)}
[ -n "$since" ] && [ "$since" != "$(git rev-parse HEAD)" ] || since=$(git rev-parse -q --verify HEAD~1 || true)
if [ -z "$since" ]; then
  echo "== clang-tidy: skipped, since there is no earlier commit to compare with"
  exit 0
fi
files=$(git diff --numstat --no-renames --diff-filter=d "$since" -- 'app/*.cpp' 'core/*.cpp' 'ui/*.cpp' | sort -rn | cut -f 3)
gui=${HEFT_GUI:-ON}
[ "$gui" = ON ] || files=$(echo "$files" | grep -v '^ui/\|^app/gui_main' || true)
count=$(echo "$files" | grep -c . || true)
most=${HEFT_TIDY_MOST:-$count}
echo "== clang-tidy: $count sources changed since $(git rev-parse --short "$since")"
[ "$count" -gt 0 ] || exit 0
if [ "$count" -gt "$most" ]; then
  echo "== clang-tidy: only the $most that changed most are checked here; sh packaging/style.sh checks all"
  files=$(echo "$files" | head -n "$most")
fi
# Single files with their own flags: no unity, no precompiled headers.
mkdir -p build
cmake --preset plain -B build/tidy -DHEFT_WITH_GUI="$gui" >build/tidy.log || { tail -n 20 build/tidy.log >&2; exit 1; }
cmake --build build/tidy --target heft_revision >>build/tidy.log  # The header that a build makes
echo "$files" | xargs -P "${JOBS:-$(nproc)}" -n 1 clang-tidy -p build/tidy --quiet
