// SPDX-License-Identifier: BSD-3-Clause
#include <nlohmann/json.hpp>

#include "app/manual/grammars.hpp"
#include "app/manual/phrase_pattern.hpp"
#include "core/base/version.hpp"

namespace contactsim {

namespace {

using Json = nlohmann::ordered_json;

/// Adds the phrases at the start of a command, if any.
void add_phrases(Json& patterns, const char* scope, const std::vector<std::string>& phrases) {
  if (phrases.empty()) return;
  patterns.push_back({{"name", scope},
                      {"match", "(?i)(?<=^|;)\\s*(?:" + phrase_pattern(phrases, "[ _\\t]+", "|") + ")\\b"}});
}

Json make_grammar() {
  const PhraseSets sets = phrase_sets();
  Json patterns = Json::array();
  patterns.push_back({{"name", "meta.preprocessor.aprepro.contactsim"}, {"begin", "\\{"}, {"end", "\\}"}});
  patterns.push_back({{"name", "comment.line.contactsim"}, {"match", "[#$].*$"}});
  patterns.push_back({{"name", "string.quoted.double.contactsim"}, {"match", "\"[^\"]*\""}});
  add_phrases(patterns, "keyword.control.block.contactsim", sets.blocks);
  patterns.push_back({{"name", "keyword.control.block.contactsim"}, {"match", "(?i)(?<=^|;)\\s*end\\b"}});
  add_phrases(patterns, "support.function.contactsim", sets.commands);
  add_phrases(patterns, "comment.line.ignored.contactsim", sets.ignored);
  add_phrases(patterns, "invalid.illegal.contactsim", sets.refused);
  patterns.push_back(
      {{"name", "constant.numeric.contactsim"},
       {"match", "(?<![A-Za-z_0-9])[-+]?(?:[0-9]+\\.?[0-9]*|\\.[0-9]+)(?:[eEdD][-+]?[0-9]+)?\\b"}});
  patterns.push_back({{"name", "constant.language.contactsim"}, {"match", "(?i)\\b(?:on|off)\\b"}});
  return {{"name", "contactsim"}, {"scopeName", "source.contactsim"}, {"patterns", patterns}};
}

Json make_package() {
  const Json language{{"id", "contactsim"},
                      {"aliases", {"contactsim deck"}},
                      {"extensions", {".i"}},
                      {"firstLine", "(?i)^\\s*begin\\s+(sierra|contact|material|function)\\b"},
                      {"configuration", "./language-configuration.json"}};
  const Json grammar{{"language", "contactsim"},
                     {"scopeName", "source.contactsim"},
                     {"path", "./syntaxes/contactsim.tmLanguage.json"}};
  return {{"name", "contactsim"},
          {"displayName", "contactsim decks"},
          {"version", version},
          {"publisher", "contactsim"},
          {"license", "BSD-3-Clause"},
          {"engines", {{"vscode", "^1.50.0"}}},
          {"contributes", {{"languages", Json::array({language})}, {"grammars", Json::array({grammar})}}}};
}

Json make_configuration() {
  return {{"comments", {{"lineComment", "#"}}},
          {"brackets", Json::array({Json::array({"{", "}"})})},
          {"folding",
           {{"markers", {{"start", "^\\s*[Bb][Ee][Gg][Ii][Nn]\\b"}, {"end", "^\\s*[Ee][Nn][Dd]\\b"}}}}},
          {"indentationRules",
           {{"increaseIndentPattern", "^\\s*[Bb][Ee][Gg][Ii][Nn]\\b"},
            {"decreaseIndentPattern", "^\\s*[Ee][Nn][Dd]\\b"}}}};
}

}  // namespace

std::vector<ManualFile> make_vscode_files() {
  return {{"package.json", make_package().dump(2) + "\n"},
          {"language-configuration.json", make_configuration().dump(2) + "\n"},
          {"syntaxes/contactsim.tmLanguage.json", make_grammar().dump(2) + "\n"}};
}

}  // namespace contactsim
