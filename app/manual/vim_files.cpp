// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "app/manual/grammars.hpp"
#include "app/manual/phrase_pattern.hpp"

namespace contactsim {

namespace {

/// A phrase at the start of a command, where blanks and underscores are the same.
std::string match_of(const char* group, const std::vector<std::string>& phrases) {
  if (phrases.empty()) return "";
  return fmt::format("syn match {} /\\c\\%(^\\|;\\)\\s*\\zs\\%({}\\)\\>/\n", group,
                     phrase_pattern(phrases, "[ _\\t]\\+", "\\|"));
}

constexpr const char* syntax_begin =
    R"(" Vim syntax of decks of contactsim, written by `contactsim manual vim`
if exists('b:current_syntax')
  finish
endif
syn case ignore
syn match contactsimNumber /\<[0-9]\+\%(\.[0-9]*\)\?\%([eEdD][-+]\?[0-9]\+\)\?\>/
syn match contactsimNumber /\.[0-9]\+\%([eEdD][-+]\?[0-9]\+\)\?\>/
syn keyword contactsimValue on off
syn match contactsimEnd /\%(^\|;\)\s*\zsend\>/
)";

constexpr const char* syntax_end = R"(syn region contactsimString start=/"/ end=/"/ oneline
syn region contactsimAprepro start=/{/ end=/}/
syn match contactsimComment /[#$].*/ contains=contactsimAprepro

hi def link contactsimBlock Structure
hi def link contactsimEnd Structure
hi def link contactsimCommand Keyword
hi def link contactsimIgnored SpecialComment
hi def link contactsimRefused Error
hi def link contactsimNumber Number
hi def link contactsimValue Boolean
hi def link contactsimString String
hi def link contactsimAprepro PreProc
hi def link contactsimComment Comment
let b:current_syntax = 'contactsim'
)";

constexpr const char* detect = R"(" Decks by what they hold: other programs have files of these names too.
augroup contactsim
  au! BufRead,BufNewFile *.i,*.inp,*.inc
    \ if join(getline(1, 200)) =~? '\<begin\s\+\(sierra\|contact\|material\|function\|procedure\|presto\|results\|parameters\)\>'
    \ | setlocal filetype=contactsim | endif
augroup END
)";

constexpr const char* plugin = R"(setlocal commentstring=#\ %s comments=:#,:$
let b:match_ignorecase = 1
let b:match_words = '\<begin\>:\<end\>'
)";

}  // namespace

std::vector<ManualFile> make_vim_files() {
  const PhraseSets sets = phrase_sets();
  return {{"syntax/contactsim.vim", syntax_begin + match_of("contactsimRefused", sets.refused) +
                                        match_of("contactsimIgnored", sets.ignored) +
                                        match_of("contactsimCommand", sets.commands) +
                                        match_of("contactsimBlock", sets.blocks) + syntax_end},
          {"ftdetect/contactsim.vim", detect},
          {"ftplugin/contactsim.vim", plugin}};
}

}  // namespace contactsim
