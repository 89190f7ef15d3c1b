// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/file_paths.hpp"

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;
namespace fs = std::filesystem;

namespace {

std::string refusal_of(const std::string& path) {
  try {
    refuse_link_out_of_folder(path);
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a bare name is in the folder of the run", "[core][base]") {
  CHECK(folder_of("a.e") == ".");
  CHECK(folder_of("out/a.e") == "out");
  CHECK(folder_of("/a.e") == "/");
  CHECK(folder_of("../a.e") == "..");
}

TEST_CASE("streams, /dev and /proc are devices, files and folders are none", "[core][base]") {
  const TemporaryDirectory directory;
  write_bytes(directory.file("a"), "x");
  CHECK(is_device("/dev/null"));
  CHECK(is_device("/dev/stdout"));
  CHECK(is_device("/dev/fd/1"));
  CHECK(is_device("/proc/self/fd/1"));
  CHECK_FALSE(is_device(directory.file("a")));
  CHECK_FALSE(is_device(directory.path()));
  CHECK_FALSE(is_device(directory.file("not there")));
  CHECK_FALSE(is_device(directory.file("no folder/either")));
  CHECK_FALSE(is_device("/device"));
}

TEST_CASE("links are followed to their end, there or not", "[core][base]") {
  const TemporaryDirectory directory;
  fs::create_directory(directory.path() / "sub");
  fs::create_symlink("sub/second", directory.path() / "first");
  fs::create_symlink("third", directory.path() / "sub/second");
  CHECK(follow_links(directory.path() / "first") == directory.path() / "sub/third");
  CHECK(follow_links(directory.path() / "plain") == directory.path() / "plain");
  fs::create_symlink("/dev/null", directory.path() / "null");
  CHECK(follow_links(directory.path() / "null") == directory.path() / "null");
  fs::create_symlink("loop", directory.path() / "loop");
  CHECK(follow_links(directory.path() / "loop") == directory.path() / "loop");  // ends after some links
}

TEST_CASE("files are the same by whatever path, also before they are there", "[core][base]") {
  const TemporaryDirectory directory;
  fs::create_directory(directory.path() / "sub");
  const std::string a = directory.file("a"), b = directory.file("b");
  CHECK(is_same_file(a, directory.file("sub/../a")));
  CHECK_FALSE(is_same_file(a, directory.file("sub/a")));
  CHECK_FALSE(is_same_file(a, b));
  CHECK(is_same_file(directory.file("none/a"), directory.file("none/./a")));
  write_bytes(a, "x");
  fs::create_hard_link(a, b);
  CHECK(is_same_file(a, b));
  fs::create_directory_symlink("sub", directory.path() / "other");
  CHECK(is_same_file(directory.file("sub/c"), directory.file("other/c")));
}

TEST_CASE("a file is written beside its name, and neither may be another file's", "[core][base]") {
  const TemporaryDirectory directory;
  const std::string a = directory.file("a.e");
  CHECK(unfinished_name(a) == a + ".part");
  CHECK(would_overwrite(a, a));
  CHECK(would_overwrite(a, a + ".part"));
  CHECK_FALSE(would_overwrite(a + ".part", a));
  CHECK_FALSE(would_overwrite(a, directory.file("b.e")));
  fs::create_symlink("b.e", directory.path() / "a.e");
  CHECK(unfinished_name(a) == directory.file("b.e.part"));
  CHECK(would_overwrite(a, directory.file("b.e")));
}

TEST_CASE("links out of their folder are refused", "[core][base]") {
  const TemporaryDirectory directory, outside;
  const auto link = [&](const fs::path& target, const std::string& name) {
    fs::create_symlink(target, directory.path() / name);
    return directory.file(name);
  };
  fs::create_directory(directory.path() / "sub");
  CHECK(refusal_of(directory.file("plain")) == "");
  CHECK(refusal_of(link("other", "beside")) == "");
  CHECK(refusal_of(link("sub/other", "below")) == "");
  CHECK(refusal_of(link("sub/../other", "and_back")) == "");
  CHECK(refusal_of(link("/dev/null", "null")) == "");
  const std::string reason = "outside its folder: remove the link, or give the run that name";
  const std::string away = link(outside.path() / "other", "away");
  CHECK(refusal_of(away) == away + ": is a link to '" + outside.file("other") + "', " + reason);
  CHECK(refusal_of(link("away", "by_another")).find(reason) != std::string::npos);
  // A folder whose name begins as that of the link's is another one.
  const fs::path longer = directory.path().string() + "_more";
  CHECK(refusal_of(link(longer / "other", "longer")).find(reason) != std::string::npos);
  CHECK(refusal_of(link("../other", "up")).find(reason) != std::string::npos);
}
