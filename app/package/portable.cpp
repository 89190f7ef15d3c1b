// SPDX-License-Identifier: BSD-3-Clause
// What the Debian package has as contactsim: it goes on as the build for the newest processor that this one
// is. Those builds are <prefix>/libexec/contactsim/x86-64-v2, -v3 and -v4. Compiled for any x86-64.
#include <sys/auxv.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace {

/// The psABI's level of this processor as its system lets it be used, "" below the lowest that there is a
/// build for. Source: x86-64 psABI, Microarchitecture levels.
std::string level_of_processor() {
  if (__builtin_cpu_supports("x86-64-v4")) return "x86-64-v4";
  if (__builtin_cpu_supports("x86-64-v3")) return "x86-64-v3";
  return __builtin_cpu_supports("x86-64-v2") ? "x86-64-v2" : "";
}

/// Where this program is; a chroot may lack /proc.
std::filesystem::path path_of_self() {
  std::error_code failure;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", failure);
  if (!failure) return self;
  return std::filesystem::canonical(reinterpret_cast<const char*>(getauxval(AT_EXECFN)), failure);
}

}  // namespace

int main(int, char** argv) {
  const char* asked = std::getenv("CONTACTSIM_LEVEL");  // to measure and test: a level that the processor has
  const std::string level = asked != nullptr ? asked : level_of_processor();
  if (level.empty()) {
    std::fputs("contactsim: this processor is older than x86-64-v2 (2009); build from the sources for it\n",
               stderr);
    return 1;
  }
  const auto program = path_of_self().parent_path().parent_path() / "libexec" / "contactsim" / level;
  execv(program.c_str(), argv);
  std::fprintf(stderr, "contactsim: %s cannot be started\n", program.c_str());
  return 1;
}
