#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Makes the Debian packages in a folder, where builds are kept, and tries them in a bare Debian 12. As root.
#   tests/package/make_and_try_deb.sh SOURCES FOLDER
set -euo pipefail
"$1/app/package/make_deb.sh" "$2" 1
"$1/tests/package/deb_in_chroot.sh" "$2"/contactsim{,-mpi}_*_amd64.deb
