// SPDX-License-Identifier: BSD-3-Clause
#include "app/exit_guard.hpp"

#include <fmt/format.h>

#include <exception>
#include <new>

namespace contactsim {

ExitCode guard_exit(const std::function<ExitCode()>& work,
                    const std::function<void(const std::string&)>& tell) {
  try {
    return work();
  } catch (const FileError& error) {
    tell(fmt::format("error: {}", error.what()));
    return ExitCode::file;
  } catch (const SolveError& error) {
    tell(fmt::format("error: {}", error.what()));
    return ExitCode::solve;
  } catch (const std::bad_alloc&) {
    tell("error: out of memory");
    return ExitCode::file;
  } catch (const std::exception& error) {
    tell(fmt::format("contactsim: a bug in the program: {}", error.what()));
    return ExitCode::our_bug;
  }
}

}  // namespace contactsim
