// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/exit_guard.hpp"

#include <fmt/format.h>

#include <exception>
#include <new>

#include "core/base/memory_error.hpp"

namespace contactsim {

ExitCode guard_exit(const std::function<ExitCode()>& work,
                    const std::function<void(const std::string&)>& write_line) {
  try {
    return work();
  } catch (const FileError& error) {
    write_line(fmt::format("error: {}", error.what()));
    return ExitCode::file;
  } catch (const SolveError& error) {
    write_line(fmt::format("error: {}", error.what()));
    return ExitCode::solve;
  } catch (const MemoryError& error) {
    write_line(fmt::format("error: {}", error.what()));
    return ExitCode::file;
  } catch (const std::bad_alloc&) {
    write_line("error: out of memory");
    return ExitCode::file;
  } catch (const std::exception& error) {
    write_line(fmt::format("contactsim: a bug in the program: {}", error.what()));
    return ExitCode::our_bug;
  }
}

}  // namespace contactsim
