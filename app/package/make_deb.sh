#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Makes the Debian packages for any x86-64 since 2009. contactsim has a build for each level of the psABI, x86-64-v2, -v3
# and -v4, and a program that starts the right one (portable.cpp), contactsim-mpi what mpirun needs beside it. Takes half an
# hour on one core; what is built is kept.
#   app/package/make_deb.sh FOLDER [JOBS]     builds and packages go into FOLDER
# Needs besides what `bootstrap` lists: dpkg-dev, file; for pictures in the manual xvfb and xauth.
set -euo pipefail
source=$(cd "$(dirname "$0")/../.." && pwd)
mkdir -p "$1"
folder=$(cd "$1" && pwd)
jobs=${2:-1}

configure() { # <level> <more arguments>
  cmake -S "$source" -B "$folder/$1" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON \
    -DCONTACTSIM_TESTS=OFF -DCONTACTSIM_PYTHON_PACKAGE=ON -DCONTACTSIM_HARDENED=ON \
    "-DCMAKE_CXX_FLAGS=-march=x86-64-$1 -fno-semantic-interposition" "${@:2}" >"$folder/$1.configure.log"
}

for level in v4 v3; do
  configure $level
  ninja -C "$folder/$level" -j "$jobs" contactsim contactsim_native
done
configure v2 "-DCONTACTSIM_LEVEL_BUILDS=$folder/v3;$folder/v4" -DCONTACTSIM_MPI=ON
ninja -C "$folder/v2" -j "$jobs"
ninja -C "$folder/v2" contactsim_html
(cd "$folder/v2" && cpack)
mv "$folder"/v2/contactsim{,-mpi}_*.deb "$folder"
ls -l "$folder"/contactsim{,-mpi}_*.deb
