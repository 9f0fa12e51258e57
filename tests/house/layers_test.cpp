#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>
#include <string>

#include "support/temporary_folder.h"

namespace {

using Names = std::set<std::string>;
using std::filesystem::path;

const path algorithms = path(HSR_SOURCE_FOLDER) / "algorithms";

/// A part of algorithms/: a folder by its name, a header in algorithms/ itself by its file name.
std::string part_of(const path& file) { return file.begin()->string(); }

/// The parts that the files below `folder` include.
Names included_by(const std::string& folder) {
  const std::string include = "#include \"";
  Names parts;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(algorithms / folder)) {
    const path& file = entry.path();
    if (file.extension() != ".h" && file.extension() != ".cpp") continue;
    const std::string text = hsr::test::content_of(file);
    for (std::size_t found = text.find(include); found != std::string::npos;
         found = text.find(include, found + 1)) {
      const std::size_t begin = found + include.size();
      parts.insert(part_of(text.substr(begin, text.find('"', begin) - begin)));
    }
  }
  return parts;
}

std::string in_words(const Names& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// What `folder` includes beyond itself and `allowed`.
std::string beyond(const std::string& folder, Names allowed) {
  allowed.insert(folder);
  Names rest;
  std::ranges::set_difference(included_by(folder), allowed, std::inserter(rest, rest.end()));
  return in_words(rest);
}

Names folders() {
  Names names;
  for (const auto& entry : std::filesystem::directory_iterator(algorithms)) {
    if (entry.is_directory()) names.insert(entry.path().filename().string());
  }
  return names;
}

}  // namespace

TEST_CASE("house: data flows one way, from the scene to the frame") {
  CHECK(beyond("scene", {}) == "");
  CHECK(beyond("predicates", {"scene"}) == "");
  CHECK(beyond("view", {"scene", "predicates", "parallel.h"}) == "");
  CHECK(beyond("frame", {"scene", "predicates", "view"}) == "");
}

TEST_CASE("house: the exact answer knows no algorithm and no predicate of theirs") {
  CHECK(beyond("exact", {"scene", "view", "frame", "parallel.h"}) == "");
}

TEST_CASE("house: an algorithm knows no other algorithm and not the exact answer") {
  const Names below = {"scene", "predicates", "view", "frame", "trace", "lanes"};
  // Fast versions go on from what others do with tiles: the lists draw what is opaque as the z-buffer does,
  // and the A-buffer sorts the samples of a pixel as the lists do the pixels of a block.
  const std::map<std::string, Names> built_on = {{"depthlist", {"zbuffer"}}, {"abuffer", {"depthlist"}}};
  for (const std::string& folder : folders()) {
    if (below.contains(folder) || folder == "exact" || folder == "failures") continue;
    CAPTURE(folder);
    Names forbidden;
    std::ranges::set_difference(folders(), below, std::inserter(forbidden, forbidden.end()));
    forbidden.erase(folder);
    if (built_on.contains(folder)) {
      for (const std::string& other : built_on.at(folder)) forbidden.erase(other);
    }
    Names found;
    std::ranges::set_intersection(included_by(folder), forbidden, std::inserter(found, found.end()));
    CHECK(in_words(found) == "");
  }
}
