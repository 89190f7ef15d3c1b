#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Compiles every header alone, twice over, so that each includes what it needs and may be included again.
#   headers_alone.sh COMPILER ROOT FLAGS...
compiler=$1
root=$2
shift 2
cd "$root" || exit 1
check='
header=$1
shift
printf "#include \"%s\"\n#include \"%s\"\n" "$header" "$header" | "$@" -fsyntax-only -x c++ - || { echo "not alone: $header"; exit 1; }
'
find core parser contact io app -name '*.hpp' | sort | tr '\n' '\0' |
  xargs -0 -P "$(nproc)" -I '{}' sh -c "$check" check '{}' "$compiler" "$@"
