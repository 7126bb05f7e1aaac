#include "process/results/storage/hashed_file.h"

#include <algorithm>
#include <cstdint>
#include <fstream>

#include "process/results/storage/hash_text.h"
#include "process/results/storage/result_file.h"

namespace diefill::results {
namespace {

constexpr std::string_view kBeforeHash = "\ndiefill: FNV-1a hash of the bytes above: ";
constexpr std::size_t kHashDigits = 16, kSealLength = kBeforeHash.size() + kHashDigits + 1;

std::string seal_of(std::string_view contents) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char letter : contents) hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3ULL;
  return std::string(kBeforeHash) + hash_text(hash) + '\n';
}

std::ifstream opened(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    throw ResultError(file.string() + ": is a folder, expected a file; rename the folder");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw ResultError(file.string() + ": cannot be read; check its permissions");
  return stream;
}

/// The file's last `length` bytes, or all of them.
std::string end_of(std::ifstream& stream, std::streamoff length) {
  stream.seekg(0, std::ios::end);
  const std::streamoff size = stream.tellg();
  std::string bytes(static_cast<std::size_t>(std::min(size, length)), '\0');
  stream.seekg(size - static_cast<std::streamoff>(bytes.size()));
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return bytes;
}

}  // namespace

std::string with_hash(std::string contents) {
  contents += seal_of(contents);
  return contents;
}

bool ends_in_hash(const std::filesystem::path& file) {
  auto stream = opened(file);
  const std::string end = end_of(stream, kSealLength);
  return end.size() == kSealLength && end.starts_with(kBeforeHash) && end.back() == '\n';
}

std::optional<std::string> read_hashed(const std::filesystem::path& file) {
  auto stream = opened(file);
  std::string bytes = end_of(stream, static_cast<std::streamoff>(std::filesystem::file_size(file)));
  if (!stream) throw ResultError(file.string() + ": cannot be read completely; check the disk");
  if (bytes.size() < kSealLength) return std::nullopt;
  const std::string seal = bytes.substr(bytes.size() - kSealLength);
  bytes.resize(bytes.size() - kSealLength);
  if (seal != seal_of(bytes)) return std::nullopt;
  return bytes;
}

}  // namespace diefill::results
