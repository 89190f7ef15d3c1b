// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "app/manual/manual_file.hpp"

namespace contactsim {

/// How Vim knows and colours a deck: syntax/contactsim.vim, ftdetect/contactsim.vim, ftplugin/contactsim.vim.
/// Phrases are those of the rows; what is refused is coloured as an error, what is ignored as a comment.
std::vector<ManualFile> make_vim_files();

/// The same as an extension for Visual Studio Code, with folding of blocks.
std::vector<ManualFile> make_vscode_files();

}  // namespace contactsim
