#include "scene/errors.h"
#include "scene/writers/writers.h"

namespace hsr {

void RowProgress::report() const {
  const double done = static_cast<double>(written_) / static_cast<double>(rows_);
  if (!report_progress(progress_, "writing", done)) throw InputError("interrupted");
}

}  // namespace hsr
