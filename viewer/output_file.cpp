#include "output_file.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <system_error>

#include "scene/errors.h"

namespace hsr {

void require_ending(std::string_view option, const std::filesystem::path& file,
                    std::initializer_list<std::string_view> endings) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](char letter) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  });
  if (std::ranges::find(endings, ending) != endings.end()) return;
  std::error_code ignored;
  const auto type = std::filesystem::status(file, ignored).type();
  using std::filesystem::file_type;
  if (type == file_type::character || type == file_type::fifo || type == file_type::socket) return;
  std::string allowed;
  for (const std::string_view known : endings) allowed.append(allowed.empty() ? "" : " or ").append(known);
  throw UsageError(std::string(option) + ": \"" + file.string() + "\" must end in " + allowed);
}

void require_place(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) {
    throw InputError("cannot write " + file.string() + ": it is a folder");
  }
  if (std::filesystem::is_directory(folder, ignored)) return;
  throw InputError("cannot write " + file.string() + ": there is no folder " + folder.string());
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder)) {
    throw InputError("cannot make the folder " + folder.string() +
                     (error ? ": " + error.message() : ": a file has its name"));
  }
}

}  // namespace hsr
