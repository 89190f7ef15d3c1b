// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <linux/capability.h>
#include <sys/prctl.h>
#include <unistd.h>

namespace contactsim::test {

/// Makes programs that are started from now on obey the modes of files and folders, those that root starts
/// too. Returns whether they do.
inline bool make_programs_obey_modes() {
  return geteuid() != 0 || prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE, 0, 0, 0) == 0;
}

}  // namespace contactsim::test
