// SPDX-License-Identifier: BSD-3-Clause
#include "app/sweep/child_processes.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <system_error>

#include "core/base/errors.hpp"

namespace contactsim {

namespace {

constexpr int cannot_run = 127;  // as shells say it

/// What the child does between fork and exec; only calls that are safe there.
///   mask  of signals, as it was before the fork
[[noreturn]] void become(char* const* words, const char* folder, const char* errors, pid_t parent,
                         const sigset_t* mask) {
  // The sweep's own handlers would take a signal that is meant for what the child becomes.
  signal(SIGTERM, SIG_DFL);
  signal(SIGINT, SIG_DFL);
  sigprocmask(SIG_SETMASK, mask, nullptr);
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(cannot_run);  // it was killed before the line above
  const int null = open("/dev/null", O_RDWR);
  const int error_file = open(errors, O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (null < 0 || error_file < 0 || chdir(folder) != 0) _exit(cannot_run);
  dup2(null, STDIN_FILENO);
  dup2(null, STDOUT_FILENO);
  dup2(error_file, STDERR_FILENO);
  execv(words[0], words);
  _exit(cannot_run);
}

}  // namespace

void ChildProcesses::start(std::size_t number, const ChildCommand& command) {
  std::vector<std::string> words = command.words;
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const pid_t parent = getpid();
  // No signal may come before the child has handlers of its own.
  sigset_t stop, before;
  sigemptyset(&stop);
  sigaddset(&stop, SIGTERM);
  sigaddset(&stop, SIGINT);
  sigprocmask(SIG_BLOCK, &stop, &before);
  const pid_t child = fork();
  if (child == 0) become(argv.data(), command.folder.c_str(), command.errors.c_str(), parent, &before);
  sigprocmask(SIG_SETMASK, &before, nullptr);
  if (child < 0)
    throw FileError(command.words[0], "cannot be started (" + std::generic_category().message(errno) + ")");
  running_.emplace(child, number);
}

std::optional<EndedChild> ChildProcesses::take_ended() {
  for (const auto& [child, number] : running_) {
    int status = 0;
    if (waitpid(child, &status, WNOHANG) != child) continue;
    const EndedChild ended{number, WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status)};
    running_.erase(child);
    return ended;
  }
  return std::nullopt;
}

void ChildProcesses::send(int signal) const {
  for (const auto& [child, number] : running_) kill(child, signal);
}

}  // namespace contactsim
