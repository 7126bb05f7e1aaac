#include "process/scene/folder_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <map>
#include <string_view>

#include "engine/numerics/fnv1a.h"

namespace diefill::process {
namespace {

constexpr std::size_t kLongest = 64;  // letters; file systems take 255, messages should stay readable
constexpr std::size_t kNumber = 8;    // digits of the number after a name

/// What the program writes into a directory of runs, each with any ending; and names that Windows keeps for
/// itself.
constexpr std::array<std::string_view, 24> kReserved = {
    "beginnings",  "checkpoint", "comparison", "cost",  "exit_code", "jobs",  "report",   "results",
    "run",         "run_here",   "scene",      "slurm", "snapshots", "tools", "tradeoff", "paraview",
    "calibration", "screening",  "powder",     "live",  "aux",       "con",   "nul",      "prn"};
constexpr std::array<std::string_view, 4> kReservedStarts = {"parameter_", "previous-", "frames", "probe_"};

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

bool is_ascii(char letter) {
  return static_cast<unsigned char>(letter) < 0x80;
}

/// Every letter that may not stand in a folder's name as '_'; the further bytes of a UTF-8 letter as nothing.
std::string plain_form(const std::string& name) {
  std::string form;
  for (const char letter : name) {
    const auto code = static_cast<unsigned char>(letter);
    if ((code & 0xc0U) == 0x80U) continue;
    const bool plain = is_ascii(letter) && (std::isalnum(code) != 0 || letter == '-' || letter == '.');
    form += plain ? letter : '_';
  }
  if (!form.empty() && (form.front() == '-' || form.front() == '.')) form.front() = '_';
  return form;
}

bool is_reserved(const std::string& form) {
  const std::string small = lower(form);
  const auto begins_it = [&](std::string_view start) { return small.starts_with(start); };
  return std::find(kReserved.begin(), kReserved.end(), small.substr(0, small.find('.'))) != kReserved.end() ||
         std::any_of(kReservedStarts.begin(), kReservedStarts.end(), begins_it);
}

/// Whether it could be taken for a name with a number after it.
bool seems_numbered(const std::string& form) {
  if (form.size() <= kNumber || form[form.size() - kNumber - 1] != '-') return false;
  return std::all_of(form.end() - kNumber, form.end(),
                     [](unsigned char letter) { return std::isxdigit(letter) != 0; });
}

/// Whether the plain form alone will not do for the name, whatever others are called.
bool needs_number(const std::string& name, const std::string& form) {
  return form.size() > kLongest || !std::all_of(name.begin(), name.end(), is_ascii) ||
         form.find_first_not_of("._") == std::string::npos || form.back() == '.' || name.front() == '-' ||
         name.front() == '.' || is_reserved(form) || seems_numbered(form);
}

std::string numbered(const std::string& name, const std::string& form) {
  engine::Fnv1a hash;
  hash.add(name);
  char number[kNumber + 1];
  std::snprintf(number, sizeof number, "%08x",
                static_cast<unsigned>(((hash.value() >> 32U) ^ hash.value()) & 0xffffffffU));
  return form.substr(0, kLongest) + '-' + number;
}

}  // namespace

std::vector<std::string> folder_names(const std::vector<std::string>& names) {
  std::map<std::string, int> uses;
  for (const std::string& name : names) ++uses[lower(plain_form(name))];
  std::vector<std::string> folders;
  for (const std::string& name : names) {
    const std::string form = plain_form(name);
    const bool clashes = uses[lower(form)] > 1 && name != lower(form);
    folders.push_back(clashes || needs_number(name, form) ? numbered(name, form) : form);
  }
  return folders;
}

std::string folder_of_name(const std::string& name) {
  return folder_names({name}).front();
}

}  // namespace diefill::process
