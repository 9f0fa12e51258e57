#include "algorithm.h"

namespace hsr {

RenderReport Renderer::trace(const View& view, const RenderOptions& options, const EventListener&,
                             Frame& frame) {
  return render(view, options, frame);
}

}  // namespace hsr
