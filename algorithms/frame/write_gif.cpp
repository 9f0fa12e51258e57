#include "frame/write_gif.h"

#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <exception>
#include <string>
#include <utility>

#include "scene/atomic_file.h"
#include "scene/errors.h"

namespace hsr {

namespace {

constexpr int greatest_gif_size = 65535;

void free_map(ColorMapObject* map) { GifFreeMapObject(map); }

std::unique_ptr<ColorMapObject, void (*)(ColorMapObject*)> color_map(const GifPalette& palette) {
  std::array<GifColorType, 256> colors{};
  for (std::size_t k = 0; k < colors.size(); ++k) {
    const GifPalette::Color& color = palette.colors()[k];
    colors[k] = {color[0], color[1], color[2]};
  }
  return {GifMakeMapObject(static_cast<int>(colors.size()), colors.data()), free_map};
}

}  // namespace

/// giflib's stream with a file behind it. What goes wrong in the file is kept while giflib returns.
class GifWriter::Stream {
 public:
  explicit Stream(const std::filesystem::path& file) : name_(file.string()), file_(file) {
    int error = 0;
    gif_ = EGifOpen(this, write, &error);
    if (gif_ == nullptr) throw InputError("cannot write " + name_ + ": " + reason(error));
  }
  ~Stream() { (void)close(); }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  GifFileType* gif() { return gif_; }

  void check(int status) {
    if (failure_) std::rethrow_exception(failure_);
    if (status == GIF_ERROR) throw InputError("cannot write " + name_ + ": " + reason(gif_->Error));
  }

  void finish() {
    const int status = close();
    if (failure_) std::rethrow_exception(failure_);
    if (status == GIF_ERROR) throw InputError("cannot write " + name_);
    file_.close();
  }

 private:
  static std::string reason(int error) {
    const char* const text = GifErrorString(error);
    return text == nullptr ? "giflib gives no reason" : text;
  }

  static int write(GifFileType* gif, const GifByteType* bytes, int length) {
    auto& stream = *static_cast<Stream*>(gif->UserData);
    if (stream.failure_) return 0;
    try {
      const std::string block(bytes, bytes + length);
      stream.file_.write(block);
      return length;
    } catch (...) {
      stream.failure_ = std::current_exception();  // must not pass through C
      return 0;
    }
  }

  int close() {
    if (gif_ == nullptr) return GIF_OK;
    return EGifCloseFile(std::exchange(gif_, nullptr), nullptr);
  }

  std::string name_;
  OutputFile file_;
  GifFileType* gif_ = nullptr;
  std::exception_ptr failure_;
};

GifWriter::GifWriter(const std::filesystem::path& file, const PixelBox& window, int scale,
                     const GifPalette& palette, const glm::vec3& backdrop)
    : window_(window),
      scale_(scale),
      palette_(palette),
      backdrop_(backdrop),
      stream_(std::make_unique<Stream>(file)) {
  const int width = (window.last_i - window.first_i + 1) * scale;
  const int height = (window.last_j - window.first_j + 1) * scale;
  if (width > greatest_gif_size || height > greatest_gif_size) {
    throw InputError("cannot write " + file.string() + ": a GIF has at most 65535 pixels a side");
  }
  GifFileType* const gif = stream_->gif();
  EGifSetGifVersion(gif, true);
  constexpr int bits_per_channel = 8;
  stream_->check(EGifPutScreenDesc(gif, width, height, bits_per_channel, 0, color_map(palette_).get()));
  // Again and again: the extension that Netscape brought in.
  constexpr std::array<GifByteType, 3> forever = {1, 0, 0};
  stream_->check(EGifPutExtensionLeader(gif, APPLICATION_EXT_FUNC_CODE));
  stream_->check(EGifPutExtensionBlock(gif, 11, "NETSCAPE2.0"));
  stream_->check(EGifPutExtensionBlock(gif, static_cast<int>(forever.size()), forever.data()));
  stream_->check(EGifPutExtensionTrailer(gif));
}

GifWriter::~GifWriter() = default;

void GifWriter::add(const Frame& frame, PixelBox changed, int hundredths) {
  changed = {std::max(changed.first_i, window_.first_i), std::min(changed.last_i, window_.last_i),
             std::max(changed.first_j, window_.first_j), std::min(changed.last_j, window_.last_j)};
  if (first_) changed = window_;
  // A picture needs a pixel at least.
  if (changed.empty()) changed = {window_.first_i, window_.first_i, window_.first_j, window_.first_j};
  first_ = false;

  GifFileType* const gif = stream_->gif();
  GraphicsControlBlock control = {DISPOSE_DO_NOT, false, hundredths, NO_TRANSPARENT_COLOR};
  std::array<GifByteType, 4> extension{};
  (void)EGifGCBToExtension(&control, extension.data());
  stream_->check(
      EGifPutExtension(gif, GRAPHICS_EXT_FUNC_CODE, static_cast<int>(extension.size()), extension.data()));
  const int width = (changed.last_i - changed.first_i + 1) * scale_;
  const int height = (changed.last_j - changed.first_j + 1) * scale_;
  stream_->check(EGifPutImageDesc(gif, (changed.first_i - window_.first_i) * scale_,
                                  (changed.first_j - window_.first_j) * scale_, width, height, false,
                                  nullptr));
  std::vector<GifPixelType> line(static_cast<std::size_t>(width));
  for (int j = changed.first_j; j <= changed.last_j; ++j) {
    auto place = line.begin();
    for (int i = changed.first_i; i <= changed.last_i; ++i) {
      const glm::vec4& color = frame.color[frame.index(i, j)];
      place =
          std::fill_n(place, scale_, palette_.place(glm::vec3(color) + (1.0F - color.a) * backdrop_, i, j));
    }
    // giflib writes into the line.
    for (int copy = 0; copy < scale_; ++copy) {
      std::vector<GifPixelType> again = line;
      stream_->check(EGifPutLine(gif, again.data(), width));
    }
  }
}

void GifWriter::finish() { stream_->finish(); }

}  // namespace hsr
