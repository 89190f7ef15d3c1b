// SPDX-License-Identifier: BSD-3-Clause
#include "support/program_run.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <stdexcept>

#include "support/replaced.hpp"

namespace contactsim::test {

namespace {

/// Where the standard streams of a process go.
struct Redirection {
  std::string directory;  ///< that it runs in
  std::string out, err;   ///< files, made or emptied
};

/// Starts the program; returns its process id.
pid_t start(std::vector<std::string> arguments, const Redirection& to) {
  arguments.insert(arguments.begin(), CONTACTSIM_PROGRAM);
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, to.directory.c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, to.out.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                   0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, to.err.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                   0600);
  pid_t process = 0;
  const int failure = posix_spawn(&process, CONTACTSIM_PROGRAM, &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) throw std::runtime_error(std::string("cannot run ") + CONTACTSIM_PROGRAM);
  return process;
}

int wait_for(pid_t process) {
  int status = 0;
  if (waitpid(process, &status, 0) != process) throw std::runtime_error("the program was lost");
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// The side of a new terminal that a person would sit at.
int open_terminal() {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  if (terminal < 0 || grantpt(terminal) != 0 || unlockpt(terminal) != 0) {
    throw std::runtime_error("no terminal to be had");
  }
  return terminal;
}

/// All that arrives until the last writer has gone. The terminal ends lines with a carriage return, which is
/// left out.
std::string read_terminal(int terminal) {
  std::string text;
  char buffer[4096];
  for (ssize_t n = 0; (n = read(terminal, buffer, sizeof buffer)) > 0;) {
    text.append(buffer, static_cast<std::size_t>(n));
  }
  close(terminal);
  std::erase(text, '\r');
  return text;
}

}  // namespace

void ProgramDirectory::write(const std::string& name, std::string_view text) const {
  std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
  write_bytes(path(name), text);
}

void ProgramDirectory::edit(const std::string& name, const std::string& part,
                            const std::string& other) const {
  write(name, replaced(read(name), part, other));
}

void ProgramDirectory::copy_decks(const std::vector<std::string>& names) const {
  for (const std::string& name : names) {
    std::filesystem::copy_file(std::string(CONTACTSIM_SOURCE_DIR) + "/decks/" + name, path(name));
  }
}

bool ProgramDirectory::has(const std::string& name) const { return std::filesystem::exists(path(name)); }

std::vector<std::string> ProgramDirectory::list() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(path(""))) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

ProgramOutput ProgramDirectory::run(const std::vector<std::string>& arguments) const {
  const Redirection to{path(""), captured_.file("out"), captured_.file("err")};
  const int exit_code = wait_for(start(arguments, to));
  return {exit_code, read_bytes(to.out), read_bytes(to.err)};
}

ProgramOutput ProgramDirectory::run_and_signal(const std::vector<std::string>& arguments,
                                               const std::string& file, int signal) const {
  const Redirection to{path(""), captured_.file("out"), captured_.file("err")};
  const pid_t process = start(arguments, to);
  while (!has(file) && kill(process, 0) == 0) usleep(2000);
  kill(process, signal);
  const int code = wait_for(process);
  return {code, read_bytes(to.out), read_bytes(to.err)};
}

ProgramOutput ProgramDirectory::run_on_terminal(const std::vector<std::string>& arguments) const {
  const int terminal = open_terminal();
  const Redirection to{path(""), captured_.file("out"), ptsname(terminal)};
  const pid_t process = start(arguments, to);
  std::string err = read_terminal(terminal);
  return {wait_for(process), read_bytes(to.out), std::move(err)};
}

ProgramOutput ProgramDirectory::run_into_full_device(const std::vector<std::string>& arguments) const {
  const Redirection to{path(""), "/dev/full", captured_.file("err")};
  const int exit_code = wait_for(start(arguments, to));
  return {exit_code, "", read_bytes(to.err)};
}

}  // namespace contactsim::test
