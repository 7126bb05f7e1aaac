#include "process/scene/reading/graded_pour.h"

#include <toml++/toml.h>

#include "process/results/formatted.h"
#include "process/scene/reading/sections.h"
#include "process/scene/setting.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kHeight = {Dimension::length, "24 mm", "0 mm", "1 m", true};
constexpr QuantityRule kCorner = {Dimension::length, "18 mm", "-10 m", "10 m"};
constexpr NumberRule kFactor = {1, 4, true, "2"};
constexpr double kUsualFactor = 2;

struct Graded {
  double depth = 0;   ///< m, of fine grains over the floor of the box
  double factor = 0;  ///< of the size of those above
};

void refuse_other_grains(TableReader& pour, toml::table& document) {
  for (const char* other : {"layers", "grains_file", "state"})
    if (pour.has(other))
      pour.reject("graded",
                  std::string("pour.") + other + " says which grains there are; remove one of the two");
  if (document.contains("other_powder"))
    pour.reject("graded",
                "it makes a second powder of larger grains, and the scene has [[other_powder]]; remove one "
                "of the two");
  const toml::table* powder = document["powder"].as_table();
  if (powder != nullptr && powder->contains("sizes"))
    pour.reject("graded", "powder.sizes already gives several sizes; remove one of the two");
}

Graded read_graded(TableReader& pour) {
  TableReader table = pour.required_table("graded");
  Graded graded;
  graded.depth = table.required_quantity("depth", kHeight);
  graded.factor = table.number("factor", kFactor).value_or(kUsualFactor);
  table.finish();
  return graded;
}

/// m, of all powder; a scene with a setting has it from there, and until then the height of the box.
double height_of(TableReader& pour, bool has_setting) {
  if (!has_setting) return pour.required_quantity("fill_height", kHeight);
  return pour.required_point("to", kCorner)[2] - pour.required_point("from", kCorner)[2];
}

std::string metres(double length) {
  return results::formatted("%.17g m", length);
}

/// [powder] again, with larger grains.
toml::table larger_grains(const toml::table& powder, const PowderSpec& fine, double factor,
                          const std::filesystem::path& file) {
  toml::table larger = powder;
  for (const char* shared : {"air_viscosity", "coarse_graining", "fitted_with", "grain_diameter", "name"})
    larger.erase(shared);
  // What a scene states and what the powder has differ where presets are named by a rounded size.
  const double wanted = factor * fine.grain_diameter;
  larger.insert("grain_diameter", metres(wanted));
  TableReader reader(larger, file, "powder");
  const double first = read_powder(reader).grain_diameter;
  larger.insert("name", fine.label + ", coarse");
  larger.insert_or_assign("grain_diameter", metres(wanted * wanted / first));
  return larger;
}

toml::array layers_of(const std::string& fine, const std::string& coarse, double share) {
  return toml::array{toml::table{{"powder", fine}, {"share", share}},
                     toml::table{{"powder", coarse}, {"share", 1 - share}}};
}

}  // namespace

void apply_graded_pour(toml::table& document, const std::filesystem::path& file) {
  toml::table* own = document["pour"].as_table();
  toml::table* powder = document["powder"].as_table();
  if (own == nullptr || powder == nullptr || !own->contains("graded")) return;
  TableReader pour(*own, file, "pour");
  refuse_other_grains(pour, document);
  const Graded graded = read_graded(pour);
  const double height = height_of(pour, document.contains("setting"));
  if (graded.depth >= height)
    pour.reject("graded", "depth must be less than all powder, " + number_text(1e3 * height) + " mm" +
                              "; without a layer above there are no larger grains");
  TableReader powder_reader(*powder, file, "powder");
  read_coarse_graining(powder_reader);
  const PowderSpec fine = read_powder(powder_reader);
  toml::table larger = larger_grains(*powder, fine, graded.factor, file);
  const std::string coarse = *larger["name"].value<std::string>();
  own->erase("graded");
  own->insert("layers", layers_of(fine.label, coarse, graded.depth / height));
  document.insert("other_powder", toml::array{std::move(larger)});
}

}  // namespace diefill::process
