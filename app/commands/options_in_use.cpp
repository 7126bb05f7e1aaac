#include "app/commands/options_in_use.h"

#include <algorithm>

#include "app/pictures/picture_kinds.h"
#include "process/input/scene_error.h"

namespace diefill::app {
namespace {

struct OptionOfSomeKinds {
  const char* name;
  bool UsedOptions::*used;
};

constexpr OptionOfSomeKinds kOptions[] = {{"--origin", &UsedOptions::plane},
                                          {"--normal", &UsedOptions::plane},
                                          {"--from", &UsedOptions::from},
                                          {"--to", &UsedOptions::to},
                                          {"--range", &UsedOptions::range},
                                          {"--colour-by", &UsedOptions::look},
                                          {"--tools", &UsedOptions::look},
                                          {"--camera", &UsedOptions::look},
                                          {"--ambient-occlusion", &UsedOptions::look}};

bool is_of_time(const OptionOfSomeKinds& option) {
  return option.used == &UsedOptions::from || option.used == &UsedOptions::to;
}

bool is_used(const OptionOfSomeKinds& option, const WantedPictures& wanted) {
  if (wanted.measured) return false;
  if (wanted.kinds.empty()) return option.used == &UsedOptions::plane;
  if (wanted.time_average && is_of_time(option)) return true;
  return std::any_of(wanted.kinds.begin(), wanted.kinds.end(),
                     [&](const std::string& kind) { return picture_kind(kind).used.*option.used; });
}

/// What the option has an effect with.
std::string users_of(const OptionOfSomeKinds& option) {
  std::string kinds;
  for (const auto& kind : picture_kinds())
    if (kind.used.*option.used) kinds += (kinds.empty() ? "--picture " : ", ") + std::string(kind.name);
  return (is_of_time(option) ? "--time-average or " : "") + kinds;
}

}  // namespace

std::vector<std::string> options_of_some_kinds() {
  std::vector<std::string> names;
  for (const auto& option : kOptions) names.emplace_back(option.name);
  return names;
}

void require_in_use(const std::vector<std::string>& given, const WantedPictures& wanted) {
  for (const auto& option : kOptions) {
    if (std::find(given.begin(), given.end(), option.name) == given.end() || is_used(option, wanted))
      continue;
    const std::string start = std::string(option.name) + ": has no effect with";
    if (wanted.measured) throw process::SceneError(start + " --measured; leave the option out");
    throw process::SceneError(start + "out " + users_of(option) +
                              "; give one of them, or leave the option out");
  }
}

}  // namespace diefill::app
