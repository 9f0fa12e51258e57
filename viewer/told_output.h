#pragma once

#include <filesystem>
#include <optional>
#include <ostream>
#include <set>
#include <string>
#include <string_view>

#include "algorithm.h"
#include "trace/picture_stream.h"

namespace hsr {

/// What a picture's stream tells beside ids, depths, colours and the camera.
struct TellChoice {
  bool lists = false;
  bool steps = false;
};

/// Reads "lists", "steps" or both with a comma between. Throws UsageError.
TellChoice parse_tell_choice(std::string_view option, std::string_view text);

/// The frame with what else is to be told of it; renders once more for lists, and once for steps. Throws
/// UsageError if the algorithm keeps no lists, InputError if it makes more steps than a stream may have.
ToldPicture tell_picture(const View& view, const AlgorithmSpec& algorithm, Renderer& renderer,
                         const RenderOptions& options, const Frame& frame, TellChoice tell);

/// Writes it to the file, or to `out` if that is called "-". Throws InputError.
void write_told_picture(const ToldPicture& picture, const std::filesystem::path& file, std::ostream& out);

}  // namespace hsr
