#include "report/journal.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "scene/errors.h"

namespace hsr::report {
namespace {

using Json = nlohmann::ordered_json;

std::string dump(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace

Journal::Journal(std::filesystem::path file, const std::string& run) : file_(std::move(file)) {
  const std::string first = dump({{"run", run}});
  std::string kept = first + "\n";
  {
    std::ifstream lines(file_, std::ios::binary);
    std::string line;
    if (std::getline(lines, line) && line == first) {
      while (std::getline(lines, line) && !lines.eof()) {
        const Json entry = Json::parse(line, nullptr, false);
        if (!entry.is_object() || !entry.contains("key") || !entry["key"].is_string() ||
            !entry.contains("value"))
          break;
        values_[entry["key"].get<std::string>()] = dump(entry["value"]);
        kept += line + "\n";
      }
    }
  }
  taken_over_ = values_.size();
  // Without what was cut off, so that the next line begins a line.
  std::ofstream out(file_, std::ios::binary | std::ios::trunc);
  out << kept << std::flush;
  if (!out) throw InputError("cannot write " + file_.string());
}

std::optional<std::string> Journal::find(const std::string& key) const {
  const auto found = values_.find(key);
  return found == values_.end() ? std::nullopt : std::optional(found->second);
}

void Journal::add(const std::string& key, const std::string& json) {
  std::ofstream out(file_, std::ios::binary | std::ios::app);
  out << "{\"key\":" << dump(key) << ",\"value\":" << json << "}\n" << std::flush;
  if (!out) throw InputError("cannot write " + file_.string());
  values_[key] = json;
}

void Journal::finish() {
  std::error_code ignored;
  std::filesystem::remove(file_, ignored);
}

}  // namespace hsr::report
