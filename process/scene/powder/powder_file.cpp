#include "process/scene/powder/powder_file.h"

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/numerics/fnv1a.h"
#include "process/input/text_file.h"
#include "process/results/storage/hash_text.h"
#include "process/scene/contact/contact_spec.h"
#include "process/scene/reading/sections.h"
#include "process/scene/reading/wall_rules.h"
#include "process/scene/scene_text.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kLength = {Dimension::length, "1.88 mm", "0 mm", "100 mm", true};
constexpr QuantityRule kModulus = {Dimension::pressure, "10 MPa", "1e4 Pa", "1e12 Pa"};
constexpr double kSame = 1e-3;  // relative: what rounding in a file makes of a number
constexpr std::array<const char*, 3> kSections = {"powder", "walls", "contact"};  // of a powder file
constexpr std::array<const char*, 4> kKeysFromFile = {"preset", "model", "sphere_radius", "grain_mass"};

/// Number of [contact], by which another one is told; empty where the document has none.
std::string contact_number(const toml::table& document) {
  const toml::table* contact = document["contact"].as_table();
  if (contact == nullptr) return {};
  engine::Fnv1a hash;
  hash.add(scene_text_of(*contact));
  return results::hash_text(hash.value());
}

/// Reads the file as a scene would read these tables, so that faults are named in it and not in the scene.
void check(const toml::table& parsed, const std::filesystem::path& file) {
  TableReader document(parsed, file, "");
  TableReader table = document.required_table("powder");
  if (table.has("file"))
    table.reject("file",
                 "a powder file gives the powder itself and names no other file; name that one in the scene");
  read_coarse_graining(table);
  const PowderSpec powder = read_powder(table);
  const auto given = document.table("walls");
  const WallSpec walls = given ? read_walls(*given, powder) : WallSpec{};  // else those of the scene
  read_contact(document, powder, walls);
  document.table("calibration");
  document.finish();
}

/// Lays `under` below `table`: what the table has itself stays.
void lay_under(toml::table& table, toml::table& under) {
  for (auto&& [key, node] : under) {
    if (table.contains(key)) continue;
    node.visit([&](auto& value) { table.insert(key, std::move(value)); });
  }
}

/// A setting chooses these itself.
void leave_to_setting(toml::table& from_file) {
  from_file["powder"].as_table()->erase("grain_diameter");
  if (toml::table* walls = from_file["walls"].as_table()) walls->erase("spacing");
}

/// Throws SceneError where one of the scene's own sections is no table: a file's cannot be laid below it.
void refuse_other_than_tables(const toml::table& document, const std::filesystem::path& file) {
  TableReader reader(document, file, "");
  for (const char* key : kSections) reader.table(key);
}

/// Of a document whose sections are tables.
toml::table& table_in(toml::table& document, const char* key) {
  if (!document.contains(key)) document.insert(key, toml::table{});
  return *document[key].as_table();
}

bool differ(double a, double b) {
  return std::abs(a - b) > kSame * std::max(std::abs(a), std::abs(b));
}

void add(std::string& words, const std::string& what, double now, double then, const char* unit) {
  words += (words.empty() ? "" : ", ") + what + ' ' + number_text(now) + unit + " instead of " +
           number_text(then) + unit;
}

}  // namespace

bool merge_powder_file(toml::table& document, const std::filesystem::path& scene_file) {
  refuse_other_than_tables(document, scene_file);
  toml::table* powder = document["powder"].as_table();
  if (powder == nullptr || !powder->contains("file")) return false;
  TableReader reader(*powder, scene_file, "powder");
  const std::filesystem::path file = scene_file.parent_path() / reader.required_text("file", "powder.toml");
  for (const char* key : kKeysFromFile)
    if (reader.has(key)) reader.reject(key, "powder.file gives it; remove one of the two");
  std::string text;
  try {
    text = load_text_file(file, {"powder file", "but a powder file is a short TOML text", 1U << 20U});
  } catch (const std::runtime_error& reason) {
    reader.reject("file", file.string() + ": " + reason.what());
  }
  toml::table from_file = parse_scene_text(text, file);
  check(from_file, file);
  make_spheres_file_absolute(from_file, file);
  if (document.contains("setting")) leave_to_setting(from_file);
  powder->erase("file");
  lay_under(*powder, *from_file["powder"].as_table());
  if (toml::table* walls = from_file["walls"].as_table()) lay_under(table_in(document, "walls"), *walls);
  if (toml::table* contact = from_file["contact"].as_table();
      contact != nullptr && !document.contains("contact"))
    document.insert("contact", std::move(*contact));
  return true;
}

void make_spheres_file_absolute(toml::table& document, const std::filesystem::path& file) {
  toml::table* powder = document["powder"].as_table();
  if (powder == nullptr) return;
  if (const auto spheres = (*powder)["spheres_file"].value_exact<std::string>())
    powder->insert_or_assign(
        "spheres_file", std::filesystem::absolute(file.parent_path() / *spheres).lexically_normal().string());
}

std::optional<FittedWith> read_fitted_with(TableReader& powder) {
  auto table = powder.table("fitted_with");
  if (!table) return std::nullopt;
  FittedWith fitted;
  fitted.grain_diameter = table->required_quantity("grain_diameter", kLength);
  fitted.reduced_modulus = table->required_quantity("reduced_modulus", kModulus);
  fitted.wall_kind = table->required_choice("wall_kind", wall_kinds());
  fitted.wall_sphere_radius = table->required_quantity("wall_sphere_radius", kWallSphereRadius);
  fitted.wall_spacing = table->number("wall_spacing", kWallSpacing).value_or(WallSpec{}.spacing);
  fitted.contact = table->text("contact").value_or("");
  fitted.program = table->text("program").value_or("");
  table->finish();
  return fitted;
}

std::string fitted_with_text(const FittedWith& fitted) {
  std::string text = "[powder.fitted_with]\n";
  text += "grain_diameter = \"" + number_text(1e3 * fitted.grain_diameter) + " mm\"\n";
  text += "reduced_modulus = \"" + number_text(1e-6 * fitted.reduced_modulus) + " MPa\"\n";
  for (const auto& [word, kind] : wall_kinds())
    if (kind == fitted.wall_kind) text += "wall_kind = \"" + word + "\"\n";
  text += "wall_sphere_radius = \"" + number_text(1e3 * fitted.wall_sphere_radius) + " mm\"\n";
  text += "wall_spacing = " + number_text(fitted.wall_spacing) + "\n";
  if (!fitted.contact.empty()) text += "contact = \"" + fitted.contact + "\"\n";
  if (!fitted.program.empty()) text += "program = \"" + fitted.program + "\"\n";
  return text;
}

FittedWith fitted_with_of(const Scene& scene, const std::string& program_version) {
  return {scene.powder.grain_diameter,
          scene.powder.reduced_modulus,
          scene.walls.kind,
          scene.walls.sphere_radius,
          scene.walls.spacing,
          contact_number(parse_scene_text(scene.text, scene.file)),
          program_version};
}

std::string fitted_with_warning(const Scene& scene) {
  const toml::table document = parse_scene_text(scene.text, scene.file);
  const toml::table* powder = document["powder"].as_table();
  if (powder == nullptr || !powder->contains("fitted_with")) return {};
  TableReader reader(*powder, scene.file, "powder");
  const FittedWith then = *read_fitted_with(reader), now = fitted_with_of(scene, "");
  std::string words;
  if (now.wall_kind != then.wall_kind) words += "a different kind of wall";
  if (then.wall_kind == WallKind::spheres && now.wall_kind == WallKind::spheres) {
    if (differ(now.wall_sphere_radius, then.wall_sphere_radius))
      add(words, "wall spheres of radius", 1e3 * now.wall_sphere_radius, 1e3 * then.wall_sphere_radius,
          " mm");
    if (differ(now.wall_spacing, then.wall_spacing))
      add(words, "wall spacing", now.wall_spacing, then.wall_spacing, "");
  }
  if (now.contact != then.contact)
    words += std::string(words.empty() ? "" : ", ") + "a different [contact]";
  else if (now.contact.empty() && differ(now.reduced_modulus, then.reduced_modulus))
    add(words, "reduced modulus", 1e-6 * now.reduced_modulus, 1e-6 * then.reduced_modulus, " MPa");
  if (words.empty()) return {};
  return "the powder was calibrated with different settings (" + words +
         "): its friction and adhesion are valid only with those; use the same settings or calibrate again";
}

}  // namespace diefill::process
