#include "step_text.h"

#include "text_layout.h"
#include "trace/sentences.h"

namespace hsr {

std::string step_text(std::uint64_t step, std::uint64_t total, const Event& event,
                      std::optional<std::uint64_t> departure) {
  const std::string mark = departure == step ? " (the first departure from the exact answer)" : "";
  return paragraph("step " + grouped(step) + " of " + grouped(total) + mark + ": " + sentence(event));
}

std::string left_out_text(std::uint64_t count, const std::string& noun) {
  return "... " + counted(count, noun) + " left out ...\n";
}

}  // namespace hsr
