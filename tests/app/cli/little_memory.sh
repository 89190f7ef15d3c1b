#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# A run in load steps with little memory ends, and says why: libraries of equations may wait for memory for ever.
#   little_memory.sh PROGRAM ROOT
set -euo pipefail
program=$1 root=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp "$root/decks/pressed_ball.i" "$root/decks/pressed_ball.g" "$folder"
cd "$folder"
for kibibytes in 120000 140000 160000 200000 240000; do
  code=0
  (ulimit -v "$kibibytes" && timeout 60 "$program" pressed_ball.i --quiet >/dev/null 2>errors) || code=$?
  if [ "$code" != 0 ] && ! { [ "$code" = 3 ] && grep -q "error: out of memory" errors; }; then
    echo "$kibibytes KiB: exit code $code"
    tail -3 errors
    exit 1
  fi
done
