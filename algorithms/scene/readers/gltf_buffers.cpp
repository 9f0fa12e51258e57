#include "scene/readers/gltf_buffers.h"

#include <algorithm>
#include <bit>
#include <system_error>

#include "scene/readers/file_bytes.h"
#include "scene/readers/uri.h"

namespace hsr {

namespace fs = std::filesystem;

namespace {

std::uint64_t size_of(GltfComponent component) {
  switch (component) {
    case GltfComponent::int8:
    case GltfComponent::uint8:
      return 1;
    case GltfComponent::int16:
    case GltfComponent::uint16:
      return 2;
    default:
      return 4;
  }
}

/// The bytes of one component as a whole number, little-endian as all of glTF.
std::uint32_t bits_at(const char* bytes, GltfComponent component) {
  std::uint32_t bits = 0;
  for (std::uint64_t k = 0; k < size_of(component); ++k) {
    bits |= std::uint32_t{static_cast<unsigned char>(bytes[k])} << (8 * k);
  }
  return bits;
}

/// A normalized integer as glTF maps it: 0 to 1, or -1 to 1.
double normalize(double value, double greatest) { return std::max(value / greatest, -1.0); }

}  // namespace

GltfBuffers::GltfBuffers(const Input& input, const GltfModel& model, std::string_view binary)
    : input_(input), model_(model), binary_(binary) {}

double GltfBuffers::Elements::number(std::uint64_t element, std::uint32_t k, bool normalized) const {
  const std::uint32_t bits = bits_at(first + element * stride + k * size_of(component), component);
  switch (component) {
    case GltfComponent::int8: {
      const auto value = static_cast<double>(static_cast<std::int8_t>(bits));
      return normalized ? normalize(value, 127) : value;
    }
    case GltfComponent::uint8:
      return normalized ? normalize(bits, 255) : bits;
    case GltfComponent::int16: {
      const auto value = static_cast<double>(static_cast<std::int16_t>(bits));
      return normalized ? normalize(value, 32767) : value;
    }
    case GltfComponent::uint16:
      return normalized ? normalize(bits, 65535) : bits;
    case GltfComponent::uint32:
      return bits;
    case GltfComponent::float32:
      break;
  }
  return std::bit_cast<float>(bits);
}

std::uint64_t GltfBuffers::Elements::whole(std::uint64_t element) const {
  return bits_at(first + element * stride, component);
}

const GltfAccessor& GltfBuffers::checked(std::uint32_t accessor, std::uint32_t components) const {
  const GltfAccessor& result = model_.accessors[accessor];
  const std::string name = "accessors[" + std::to_string(accessor) + "]";
  if (result.components != components) {
    fail(name + (components == 1 ? " must be SCALAR" : " must be VEC3"));
  }
  if (!result.run && result.count > input_.bytes.size()) {
    fail(name + " has no data for its " + std::to_string(result.count) + " elements");
  }
  return result;
}

/// Finds `count` elements, all within the view and the view within its buffer.
GltfBuffers::Elements GltfBuffers::elements(const GltfRun& run, std::uint32_t components, std::uint64_t count,
                                            const std::string& what) {
  const GltfView& view = model_.views[run.view];
  const std::string name = "bufferViews[" + std::to_string(run.view) + "]";
  const std::string_view bytes = buffer(view.buffer);
  if (view.offset > bytes.size() || view.bytes > bytes.size() - view.offset) {
    fail(name + " ends after the " + counted(bytes.size(), "byte", "bytes") + " of its buffer");
  }
  const std::uint64_t element = components * size_of(run.component);
  const std::uint64_t stride = view.stride == 0 ? element : view.stride;
  if (stride < element) {
    fail(name + ": byteStride is smaller than an element");
  }
  // All of these are below 2^54, so that no sum overflows; the product is avoided.
  const bool fits = count == 0 || (run.offset + element <= view.bytes &&
                                   count - 1 <= (view.bytes - run.offset - element) / stride);
  if (!fits) {
    fail(what + " has " + std::to_string(count) + " elements, which are more than " + name + " holds");
  }
  return {bytes.data() + view.offset + run.offset, stride, run.component};
}

/// Calls set(index, elements, k) for every element of the accessor that its sparse part replaces.
template <class Set>
void GltfBuffers::each_exception(std::uint32_t accessor, Set&& set) {
  const GltfAccessor& whole = model_.accessors[accessor];
  if (!whole.sparse) {
    return;
  }
  const std::string name = "accessors[" + std::to_string(accessor) + "].sparse";
  const GltfSparse& sparse = *whole.sparse;
  if (sparse.indices.component == GltfComponent::float32) {
    fail(name + ": indices must be of a whole type");
  }
  const Elements indices = elements(sparse.indices, 1, sparse.count, name);
  const Elements values = elements(sparse.values, whole.components, sparse.count, name);
  for (std::uint64_t k = 0; k < sparse.count; ++k) {
    const std::uint64_t index = indices.whole(k);
    if (index >= whole.count) {
      fail(name + ": index " + std::to_string(index) + " out of range (" + std::to_string(whole.count) +
           " elements)");
    }
    set(index, values, k);
  }
}

std::vector<glm::dvec3> GltfBuffers::vectors(std::uint32_t accessor) {
  const GltfAccessor& source = checked(accessor, 3);
  const auto vector = [&](const Elements& from, std::uint64_t i) {
    return glm::dvec3(from.number(i, 0, source.normalized), from.number(i, 1, source.normalized),
                      from.number(i, 2, source.normalized));
  };
  std::vector<glm::dvec3> result;
  if (source.run) {
    const Elements all =
        elements(*source.run, 3, source.count, "accessors[" + std::to_string(accessor) + "]");
    result.reserve(source.count);
    for (std::uint64_t i = 0; i < source.count; ++i) {
      result.push_back(vector(all, i));
    }
  } else {
    result.assign(source.count, glm::dvec3(0.0));
  }
  each_exception(accessor, [&](std::uint64_t index, const Elements& values, std::uint64_t k) {
    result[index] = vector(values, k);
  });
  return result;
}

std::vector<std::uint32_t> GltfBuffers::indices(std::uint32_t accessor) {
  const GltfAccessor& source = checked(accessor, 1);
  const std::string name = "accessors[" + std::to_string(accessor) + "]";
  if (source.component == GltfComponent::float32) {
    fail(name + ": indices must be of a whole type");
  }
  std::vector<std::uint32_t> result;
  if (source.run) {
    const Elements all = elements(*source.run, 1, source.count, name);
    result.reserve(source.count);
    for (std::uint64_t i = 0; i < source.count; ++i) {
      result.push_back(static_cast<std::uint32_t>(all.whole(i)));
    }
  } else {
    result.assign(source.count, 0);
  }
  each_exception(accessor, [&](std::uint64_t index, const Elements& values, std::uint64_t k) {
    result[index] = static_cast<std::uint32_t>(values.whole(k));
  });
  return result;
}

std::string_view GltfBuffers::buffer(std::uint32_t index) {
  const std::string_view bytes = find_bytes(index);
  const std::uint64_t wanted = model_.buffers[index].bytes;
  if (bytes.size() < wanted) {
    fail("truncated: buffers[" + std::to_string(index) + "] has " + std::to_string(bytes.size()) + " of " +
         counted(wanted, "byte", "bytes"));
  }
  return bytes.substr(0, wanted);
}

std::string_view GltfBuffers::find_bytes(std::uint32_t index) {
  const GltfBuffer& buffer = model_.buffers[index];
  const std::string name = "buffers[" + std::to_string(index) + "]";
  if (!buffer.uri) {
    if (binary_.data() == nullptr || index != 0) {
      fail(name + " has neither a uri nor a binary part of a GLB file");
    }
    return binary_;
  }
  const auto known = loaded_.find(*buffer.uri);
  if (known != loaded_.end()) {
    return known->second;
  }
  std::optional<std::string> bytes = data_uri_bytes(*buffer.uri);
  if (!bytes) {
    const std::optional<std::string> path = uri_path(*buffer.uri);
    if (!path) {
      fail(name + ": the uri " + in_quotes(*buffer.uri) + " is neither a file nor data in base64");
    }
    const fs::path file = input_.file.parent_path() / *path;
    std::error_code error;
    if (!fs::is_regular_file(file, error)) {
      fail(name + ": there is no file " + in_quotes(file.string()));
    }
    bytes = raw_file_bytes(file, input_.progress);
  }
  loaded_bytes_ += bytes->size();
  return loaded_.emplace(*buffer.uri, std::move(*bytes)).first->second;
}

}  // namespace hsr
