// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/exit_guard.hpp"

#include <fmt/format.h>

#include <exception>
#include <new>
#include <string_view>

#include "core/base/end_at_once.hpp"
#include "core/base/memory_error.hpp"

namespace contactsim {

namespace {

/// Which exception left a loop of OpenMP is not to be seen here.
[[noreturn]] void end_by_exception() {
  if (!WorkInMemory::lacks_memory()) __gnu_cxx::__verbose_terminate_handler();
  const std::string_view doing = WorkInMemory::now();
  end_at_once(ExitCode::file, {"error: out of memory", doing.empty() ? "" : " while ", doing});
}

}  // namespace

void end_without_memory() {
  std::set_new_handler(WorkInMemory::throw_bad_alloc);
  std::set_terminate(end_by_exception);
}

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
