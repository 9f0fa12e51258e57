#include "bench/speed.h"
#include "text_layout.h"

namespace hsr::bench {
namespace {

std::string text(const Ratio& ratio) {
  return significant(ratio.median, 3) + " (" + significant(ratio.low, 3) + " to " +
         significant(ratio.high, 3) + ")";
}

std::string errors_text(const exact::Errors& errors) {
  return grouped(errors.wrong) + " / " + grouped(errors.holes) + " / " + grouped(errors.leaks);
}

}  // namespace

std::string to_text(const SpeedRace& race) {
  const std::optional<std::size_t> peer = fastest_peer(race);
  const SpeedRow& slow = race.rows[peer.value_or(race.rows.size() - 1)];
  TextTable table(
      {"", "least ms", "median", "runs", "wrong / holes / leaks", "depth error", "times as fast"});
  for (const SpeedRow& row : race.rows) {
    if (row.timing.ms.empty()) continue;
    table.add_row({row.name, three_digits(row.timing.least()), three_digits(row.timing.median()),
                   grouped(row.timing.ms.size()), errors_text(row.errors),
                   row.errors.depth ? significant(row.errors.depth->max, 2) : "",
                   text(ratio(slow.timing, row.timing))});
  }
  std::string result = std::string(race.scene.name) + ", " + counted(race.triangles, "triangle") + ", " +
                       std::to_string(race.size.width) + "x" + std::to_string(race.size.height) + ", " +
                       counted(static_cast<std::uint64_t>(race.threads), "thread") + ": " +
                       std::string(name_of(race.task)) + ", times as fast as " + slow.name + "\n\n" +
                       table.text();
  for (const SpeedRow& row : race.rows) {
    if (!row.failed.empty()) result += paragraph("Took no part: " + row.name + ", " + row.failed);
  }
  return result;
}

}  // namespace hsr::bench
