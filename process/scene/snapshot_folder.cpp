#include "process/scene/snapshot_folder.h"

#include <algorithm>
#include <cctype>

#include "process/results/storage/group_names.h"
#include "process/scene/folder_names.h"

namespace diefill::process {
namespace {

constexpr std::size_t kDigits = 4;  // of a repeated snapshot's number, at least

/// Whether the folder of `name` is that of a numbered snapshot of `repeated`.
bool is_numbered_one_of(const std::string& repeated, const std::string& name) {
  const std::string start = snapshot_folder(repeated + ' '), folder = snapshot_folder(name);
  if (!folder.starts_with(start) || folder.size() < start.size() + kDigits) return false;
  return std::all_of(folder.begin() + static_cast<std::ptrdiff_t>(start.size()), folder.end(),
                     [](unsigned char letter) { return std::isdigit(letter) != 0; });
}

}  // namespace

std::string snapshot_folder(const std::string& name) {
  const bool is_ascii = std::all_of(name.begin(), name.end(),
                                    [](char letter) { return static_cast<unsigned char>(letter) < 0x80; });
  return is_ascii ? results::group_names({name}).front() : folder_of_name(name);
}

bool have_same_folder(const SnapshotSpec& one, const SnapshotSpec& other) {
  if (one.every.has_value() == other.every.has_value())
    return snapshot_folder(one.name) == snapshot_folder(other.name);
  return one.every ? is_numbered_one_of(one.name, other.name) : is_numbered_one_of(other.name, one.name);
}

}  // namespace diefill::process
