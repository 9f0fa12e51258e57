#include "support/read_gif.h"

#include <doctest/doctest.h>
#include <gif_lib.h>

#include <memory>

namespace hsr::test {

Gif read_gif(const std::filesystem::path& file) {
  int error = 0;
  GifFileType* const opened = DGifOpenFileName(file.c_str(), &error);
  REQUIRE_MESSAGE(opened != nullptr, file.string());
  const auto close = [](GifFileType* gif) { (void)DGifCloseFile(gif, nullptr); };
  const std::unique_ptr<GifFileType, decltype(close)> gif(opened, close);
  REQUIRE(DGifSlurp(gif.get()) == GIF_OK);
  Gif read = {gif->SWidth, gif->SHeight, {}, {}};
  std::vector<Gif::Color> picture(static_cast<std::size_t>(read.width * read.height));
  for (int k = 0; k < gif->ImageCount; ++k) {
    const SavedImage& image = gif->SavedImages[k];
    const GifImageDesc& place = image.ImageDesc;
    for (int j = 0; j < place.Height; ++j) {
      for (int i = 0; i < place.Width; ++i) {
        const GifColorType& color = gif->SColorMap->Colors[image.RasterBits[j * place.Width + i]];
        picture[static_cast<std::size_t>((place.Top + j) * read.width + place.Left + i)] = {
            color.Red, color.Green, color.Blue};
      }
    }
    GraphicsControlBlock control;
    REQUIRE(DGifSavedExtensionToGCB(gif.get(), k, &control) == GIF_OK);
    read.pictures.push_back(picture);
    read.hundredths.push_back(control.DelayTime);
  }
  return read;
}

}  // namespace hsr::test
