// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace contactsim {

/// The folder that a file is in, "." of a bare name.
std::filesystem::path folder_of(const std::filesystem::path& path);

/// Whether a path is written to as it is: a terminal, a pipe, /dev/null, an open stream such as /dev/stdout.
bool is_device(const std::filesystem::path& path);

/// What a link points to in the end, also where that is not there yet; of anything else, and of devices, the
/// path.
std::filesystem::path follow_links(std::filesystem::path path);

/// Whether two paths are of one file. Links are followed; of files that are not there yet folder and name
/// count.
bool is_same_file(const std::filesystem::path& one, const std::filesystem::path& other);

/// The name under which a regular output file is written until it is complete.
std::string unfinished_name(const std::string& path);

/// Whether writing a file would destroy another one: under its own name or under its unfinished one.
bool would_overwrite(const std::string& written, const std::string& other);

/// Throws FileError when a file that is to be written is a link to a file outside the folder that the link is
/// in: who is given a folder with decks may be given such links with it. Devices are no files.
void refuse_link_out_of_folder(const std::string& path);

}  // namespace contactsim
