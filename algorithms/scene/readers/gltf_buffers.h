#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "scene/readers/gltf_model.h"
#include "scene/readers/input.h"

namespace hsr {

/// The bytes of a glTF model's buffers, found when they are first asked for, and the elements of
/// its accessors. Throws InputError on anything that points outside of what is there.
class GltfBuffers {
 public:
  /// `binary` is the binary part of a GLB file.
  GltfBuffers(const Input& input, const GltfModel& model, std::string_view binary);

  /// The elements of an accessor of three components, in order.
  std::vector<glm::dvec3> vectors(std::uint32_t accessor);

  /// The elements of an accessor of one whole component, in order.
  std::vector<std::uint32_t> indices(std::uint32_t accessor);

  /// How many bytes there are: of the file and of the buffers that were asked for.
  std::uint64_t total_bytes() const { return input_.bytes.size() + loaded_bytes_; }

 private:
  /// Elements in a buffer, all of them within it.
  struct Elements {
    const char* first = nullptr;
    std::uint64_t stride = 0;
    GltfComponent component = GltfComponent::float32;

    double number(std::uint64_t element, std::uint32_t k, bool normalized) const;
    std::uint64_t whole(std::uint64_t element) const;
  };

  const GltfAccessor& checked(std::uint32_t accessor, std::uint32_t components) const;
  Elements elements(const GltfRun& run, std::uint32_t components, std::uint64_t count,
                    const std::string& what);
  template <class Set>
  void each_exception(std::uint32_t accessor, Set&& set);
  std::string_view buffer(std::uint32_t index);
  std::string_view find_bytes(std::uint32_t index);
  [[noreturn]] void fail(const std::string& text) const { input_.fail({}, text); }

  const Input& input_;
  const GltfModel& model_;
  std::string_view binary_;
  std::map<std::string, std::string, std::less<>> loaded_;  // by URI
  std::uint64_t loaded_bytes_ = 0;
};

}  // namespace hsr
