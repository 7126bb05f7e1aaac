#include "process/plan/variant_setting.h"

#include <algorithm>

#include "process/plan/setting.h"
#include "process/setup/read_tooling.h"

namespace diefill::process::plan {
namespace {

SettingNumbers own_numbers(const Scene& scene, Setting setting) {
  return numbers_of(setting, scene, read_tooling(scene).all_cavities());
}

void equalize(std::vector<SettingNumbers>& all) {
  const auto finer = [](const SettingNumbers& a, const SettingNumbers& b) {
    return a.grain_diameter < b.grain_diameter;
  };
  const auto closer = [](const SettingNumbers& a, const SettingNumbers& b) {
    return a.wall_spacing < b.wall_spacing;
  };
  const double diameter = std::ranges::min_element(all, finer)->grain_diameter;
  const double spacing = std::ranges::min_element(all, closer)->wall_spacing;
  for (SettingNumbers& numbers : all) {
    numbers.grain_diameter = diameter;
    numbers.wall_spacing = spacing;
  }
}

}  // namespace

std::vector<Variant> with_setting(std::vector<Variant> variants, Setting setting) {
  std::vector<SettingNumbers> numbers;
  for (const Variant& variant : variants) numbers.push_back(own_numbers(variant.scene, setting));
  if (setting != Setting::reference && !numbers.empty()) equalize(numbers);
  for (std::size_t k = 0; k < variants.size(); ++k)
    variants[k].scene = with_numbers(variants[k].scene, numbers[k], "setting " + description(setting));
  return variants;
}

}  // namespace diefill::process::plan
