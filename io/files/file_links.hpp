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

/// Throws FileError when a file that is to be written is a link to a file outside the folder that the link is
/// in: who is given a folder with decks may be given such links with it. Devices are no files.
void refuse_link_out_of_folder(const std::string& path);

}  // namespace contactsim
