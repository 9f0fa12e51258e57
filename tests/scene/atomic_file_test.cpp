#include "scene/atomic_file.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "scene/errors.h"
#include "support/temporary_folder.h"

namespace fs = std::filesystem;
using hsr::test::content_of;
using hsr::test::TemporaryFolder;

namespace {

std::ptrdiff_t entries(const TemporaryFolder& folder) {
  return std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator());
}

std::string message_of_writing(const fs::path& file) {
  try {
    hsr::write_file_atomically(file, [](const fs::path& temporary) { hsr::write_bytes(temporary, "new"); });
  } catch (const hsr::InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("scene: an atomically written file appears whole and alone") {
  const TemporaryFolder folder;
  const fs::path file = folder / "a.bin";
  hsr::write_file_atomically(file, [&](const fs::path& temporary) {
    CHECK(temporary.parent_path() == folder.path());
    CHECK(temporary.extension() == ".bin");
    hsr::write_bytes(temporary, std::string("one\0two", 7));
    CHECK_FALSE(fs::exists(file));
  });
  CHECK(content_of(file) == std::string("one\0two", 7));
  CHECK(entries(folder) == 1);
}

TEST_CASE("scene: a failing writer leaves the old file and nothing else") {
  const TemporaryFolder folder;
  const fs::path file = folder.write("a.txt", "old");
  CHECK_THROWS_WITH_AS(hsr::write_file_atomically(file,
                                                  [](const fs::path& temporary) {
                                                    hsr::write_bytes(temporary, "half");
                                                    throw hsr::InputError("lost " + temporary.string());
                                                  }),
                       ("lost " + file.string()).c_str(), hsr::InputError);
  CHECK(content_of(file) == "old");
  CHECK(entries(folder) == 1);
}

TEST_CASE("scene: replacing a file keeps its permissions and goes through a link") {
  const TemporaryFolder folder;
  const fs::path file = folder.write("a.txt", "old");
  const fs::perms permissions = fs::perms::owner_read | fs::perms::owner_write;
  fs::permissions(file, permissions);
  fs::create_symlink("a.txt", folder / "link.txt");
  CHECK(message_of_writing(folder / "link.txt").empty());
  CHECK(content_of(file) == "new");
  CHECK(fs::status(file).permissions() == permissions);
  CHECK(fs::is_symlink(folder / "link.txt"));
}

TEST_CASE("scene: what cannot be written is named with the reason") {
  const TemporaryFolder folder;
  const fs::path missing = folder / "no/such/a.txt";
  CHECK(message_of_writing(missing) == "cannot write " + missing.string() + ": No such file or directory");
  CHECK(message_of_writing(folder.path()) == "cannot write " + folder.path().string() + ": Is a directory");
  CHECK(message_of_writing("") == "cannot write: the file has no name");
  CHECK(entries(folder) == 0);
}

TEST_CASE("scene: a device is written in place and a full one is an error") {
  CHECK(message_of_writing("/dev/null").empty());
  CHECK(fs::is_character_file("/dev/null"));
  if (fs::exists("/dev/full")) {
    CHECK(message_of_writing("/dev/full") == "cannot write /dev/full: No space left on device");
  }
}
