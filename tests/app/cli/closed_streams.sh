#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# A run whose standard streams are closed ends as one whose streams are open, and writes as much; so does
# one whose reader goes away, with exit code 3.
#   closed_streams.sh PROGRAM ROOT
set -euo pipefail
program=$1 root=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for streams in open closed gone; do
  mkdir "$folder/$streams"
  cp "$root/decks/two_blocks.i" "$root/decks/two_blocks.g" "$folder/$streams"
  cd "$folder/$streams"
  if [ "$streams" = open ]; then
    "$program" two_blocks.i >/dev/null 2>&1
  elif [ "$streams" = gone ]; then
    { sleep 0.5 && "$program" two_blocks.i 2>/dev/null || echo $? >code; } | true
    [ "$(cat code)" = 3 ]
  else
    "$program" two_blocks.i <&- >&- 2>&-
  fi
done
cd "$folder"
cmp <(stat -c %s open/two_blocks.e) <(stat -c %s closed/two_blocks.e)
cmp <(stat -c %s open/two_blocks.e) <(stat -c %s gone/two_blocks.e)
cmp <(grep -v "second\|wall\| s \|20[0-9][0-9]" open/two_blocks.log) \
  <(grep -v "second\|wall\| s \|20[0-9][0-9]" closed/two_blocks.log)
