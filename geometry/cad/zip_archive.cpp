#include "geometry/cad/zip_archive.h"

#include <minizip/unzip.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <memory>
#include <stdexcept>
#include <vector>

namespace diefill::geometry {

namespace {

constexpr std::size_t kPiece = 1U << 20U;      // bytes unpacked at once
constexpr std::size_t kMostBytes = 1U << 30U;  // as of a CAD file that is not packed (cad_file.cpp)

struct CloseArchive {
  void operator()(void* archive) const { unzClose(archive); }
};

/// The file of the archive that is reached.
UnpackedFile unpacked(unzFile archive) {
  UnpackedFile file;
  if (unzOpenCurrentFile(archive) != UNZ_OK) return file;
  std::vector<char> piece(kPiece);
  int got = 0;
  while ((got = unzReadCurrentFile(archive, piece.data(), static_cast<unsigned>(piece.size()))) > 0) {
    file.text.append(piece.data(), static_cast<std::size_t>(got));
    if (file.text.size() > kMostBytes)
      throw std::runtime_error("its ZIP archive unpacks to more than 1024 MiB");
  }
  file.is_whole = unzCloseCurrentFile(archive) == UNZ_OK && got == 0;
  return file;
}

/// In lower case.
std::string name_of_reached(unzFile archive) {
  std::array<char, 1000> name{};
  unz_file_info information{};  // which minizip writes unasked
  unzGetCurrentFileInfo(archive, &information, name.data(), name.size() - 1, nullptr, 0, nullptr, 0);
  std::string lower = name.data();
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

}  // namespace

bool is_zip_archive(std::string_view bytes) {
  return bytes.starts_with("PK\x03\x04");
}

void visit_archive(const std::filesystem::path& archive, std::string_view ending,
                   const std::function<bool(UnpackedFile)>& look) {
  const std::unique_ptr<void, CloseArchive> opened(unzOpen(archive.c_str()));
  if (!opened) return;
  for (int found = unzGoToFirstFile(opened.get()); found == UNZ_OK; found = unzGoToNextFile(opened.get()))
    if (name_of_reached(opened.get()).ends_with(ending) && !look(unpacked(opened.get()))) return;
}

}  // namespace diefill::geometry
