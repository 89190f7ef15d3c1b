#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# A run takes its libraries from the system and none from the folder that it runs in.
#   own_libraries.sh PROGRAM
set -euo pipefail
program=$(realpath "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
ldd "$program" | awk '$2 == "=>" {print $1}' | while read -r library; do echo "no library" >"$library"; done
[ "$(ls | wc -l)" -gt 5 ]
"$program" --version
