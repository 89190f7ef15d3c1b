// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace contactsim {

/// Whether two paths are of one file. Links are followed; of files that are not there yet the paths count.
bool is_same_file(const std::filesystem::path& one, const std::filesystem::path& other);

/// What a link points to, else the path itself.
std::string link_target(const std::string& path);

/// The name under which a regular output file is written until it is complete.
std::string unfinished_name(const std::string& path);

/// Whether writing a file would destroy another one: under its own name or under its unfinished one.
bool would_overwrite(const std::string& written, const std::string& other);

}  // namespace contactsim
