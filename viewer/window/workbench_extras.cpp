// What the workbench computes only while somebody looks at it: overlays, boxes, times of skips.

#include <utility>

#include "window/workbench.h"

namespace hsr::window {

void Workbench::want_extras() {
  if (!picture_is_current() || settling_) return skips_lane_.interrupt();
  if (state.overlay == Overlay::list_length && truth()) {
    lengths_lane_.want(view_key(), true, [&] {
      return [exact = truth()](const Progress& progress) {
        std::vector<std::uint32_t> lengths;
        lengths.reserve(exact->frame.pixel_count());
        for (int row = 0; row < exact->frame.height; ++row) {
          const exact::DepthLists lists = exact->answer->depth_lists(row, row + 1);
          for (std::size_t k = 0; k + 1 < lists.begin.size(); ++k) {
            lengths.push_back(static_cast<std::uint32_t>(lists.begin[k + 1] - lists.begin[k]));
          }
          if (!report_progress(progress, "measuring lists", (row + 1.0) / exact->frame.height)) break;
        }
        return lengths;
      };
    });
  }
  if (state.overlay == Overlay::overdraw) {
    overdraw_lane_.want(picture_key(), true, [&] {
      return [key = picture_key(), given = surroundings()](const Progress& progress) {
        return count_overdraw(key, given, progress);
      };
    });
  }
  const StructureKey structure = structure_key();
  if (structure.kind != StructureKind::none && state.outside) {
    structure_lane_.want(structure, true, [&] {
      return
          [structure, scene = model()->scene](const Progress&) { return find_structure(structure, *scene); };
    });
  }
  // Last, when nothing else is going on that would be measured too.
  if (want_skip_times_ && !shows_elsewhere() && (skips_lane_.busy() || !busy())) {
    const SkipsKey skips = {picture_key(), patient_picture_ == picture_key()};
    skips_lane_.want(skips, true, [&] {
      return [key = skips, given = surroundings(), prepared = skips_prepared_](const Progress& progress) {
        return measure_skips(key, given, *prepared, progress);
      };
    });
  }
}

void Workbench::write_gif(const std::filesystem::path& file) {
  const auto steps = trace();
  if (!steps) return;
  const GifKey key = {trace_key(), file, ++gifs_};
  gif_lane_.want(key, true, [&] {
    return [key, steps, given = surroundings()](const Progress& progress) {
      write_gif_of(*steps, key.file, given, progress);
      return key.file;
    };
  });
}

void Workbench::poll_gif() {
  const bool was_busy = gif_lane_.busy();
  const bool written = gif_lane_.poll();
  if (written) {
    gif_news_ = "wrote " + std::filesystem::absolute(*gif_lane_.result()).string();
  } else if (was_busy && !gif_lane_.busy()) {
    gif_news_ = gif_lane_.error().empty() ? "the animation was stopped" : gif_lane_.error();
  }
}

std::optional<std::string> Workbench::gif_news() { return std::exchange(gif_news_, std::nullopt); }

StructureKey Workbench::structure_key() const {
  const bool own = model() && !shows_elsewhere();
  return own ? StructureKey{model()->number, structure_kind(state.algorithm)} : StructureKey{};
}

std::shared_ptr<const std::vector<std::uint32_t>> Workbench::list_lengths() const {
  if (!model() || !lengths_lane_.result() || !(*lengths_lane_.result_key() == view_key())) return nullptr;
  return lengths_lane_.result();
}

std::shared_ptr<const std::vector<std::uint32_t>> Workbench::overdraw() const {
  if (!picture_is_current() || !overdraw_lane_.result() || !(*overdraw_lane_.result_key() == picture_key()))
    return nullptr;
  return overdraw_lane_.result();
}

std::shared_ptr<const Structure> Workbench::structure() const {
  if (!structure_lane_.result() || !(*structure_lane_.result_key() == structure_key())) return nullptr;
  return structure_lane_.result();
}

std::shared_ptr<const SkipTimes> Workbench::skip_times() const {
  if (!picture_is_current() || !skips_lane_.result()) return nullptr;
  return skips_lane_.result_key()->picture == picture_key() ? skips_lane_.result() : nullptr;
}

}  // namespace hsr::window
