#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "bench/contestant.h"

namespace hsr::bench {

/// Starts a program that speaks the language of peers/peer.h, and lets it make the picture as often as asked.
/// It ends when the contestant is destroyed. `arguments` does not name the program itself; `environment` is
/// NAME=VALUE, beside what there is. Throws InputError with what it said if it does not get ready.
std::unique_ptr<Contestant> start_peer(const std::filesystem::path& program,
                                       const std::vector<std::string>& arguments,
                                       const std::vector<std::string>& environment, int width, int height);

}  // namespace hsr::bench
