#!/usr/bin/env bash
# clang-tidy over Logic and the command line: lint.sh BUILD_FOLDER. Prints findings only; fails if there are any.
# A file whose text, headers' texts and settings are as when it last passed is passed over.
set -euo pipefail
build=$1
mapfile -t files < <(git ls-files 'Logic/*.cpp' 'Modules/CommandLine/*.cpp')
mkdir -p "$build/lint"
headers=$(cat .clang-tidy $(git ls-files '*.h') | sha256sum | cut -c1-16)
one() {
  local file=$1 stamp
  stamp="$3/lint/$(echo "$2 $(sha256sum "$file")" | sha256sum | cut -c1-32)"
  [ -f "$stamp" ] && return
  local text
  if text=$(clang-tidy-14 --quiet -p "$3" "$file" 2>/dev/null); then touch "$stamp"; else printf '%s\n' "$text"; return 1; fi
}
export -f one
printf '%s\n' "${files[@]}" | xargs -P "$(nproc)" -I{} bash -c 'one "$@"' _ {} "$headers" "$build" && echo "lint: ${#files[@]} files, no findings"
