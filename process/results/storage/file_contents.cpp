#include "process/results/storage/file_contents.h"

#include <array>
#include <fstream>

#include "process/results/storage/result_file.h"

namespace diefill::results {

std::optional<std::string> contents_or_nothing(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return std::nullopt;
  std::string bytes;
  std::array<char, 65536> block;
  do {
    stream.read(block.data(), block.size());
    bytes.append(block.data(), static_cast<std::size_t>(stream.gcount()));
  } while (stream);
  if (stream.bad()) throw ResultError(file.string() + ": cannot be read completely; check the disk");
  return bytes;
}

}  // namespace diefill::results
