#include "geometry/cad/wanted_part.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>
#include <numeric>

#include "geometry/cad/mesh_import.h"
#include "geometry/cad/shown_text.h"

namespace diefill::geometry {

namespace {

constexpr std::size_t kMaxListed = 20;

using Indices = std::vector<std::size_t>;

/// Finds parts of one file by name.
class Search {
 public:
  Search(const std::vector<CadPart>& parts, const std::string& name, const std::string& file,
         double metres_per_unit)
      : parts_(parts), name_(name), file_(file), millimetres_(1e3 * metres_per_unit) {}

  Indices run() const {
    const Indices exact = those([&](const CadPart& part) { return part.name == name_; });
    if (!exact.empty()) return {exact.front()};
    const std::map<std::string, Indices> assemblies = assemblies_of_that_name();
    const Indices called = those([&](const CadPart& part) { return part.plain_name == name_; });
    if (assemblies.size() == 1 && contains(assemblies.begin()->second, called))
      return assemblies.begin()->second;
    if (assemblies.size() > 1) refuse_assemblies(assemblies);
    if (called.size() > 1) refuse(called, "occurs more than once");
    const Indices begun = those([&](const CadPart& part) { return part.name.starts_with(name_ + " "); });
    if (begun.size() == 1) return begun;
    if (begun.size() > 1) refuse(begun, "matches several");
    throw UnknownPart(file_ + " has no part \"" + shown(name_) + "\": it contains " + list(all(), false),
                      names());
  }

 private:
  Indices all() const {
    Indices every(parts_.size());
    std::iota(every.begin(), every.end(), std::size_t{0});
    return every;
  }

  Indices those(const std::function<bool(const CadPart&)>& are_meant) const {
    Indices found;
    for (std::size_t k = 0; k < parts_.size(); ++k)
      if (are_meant(parts_[k])) found.push_back(k);
    return found;
  }

  /// Parts of each place of an assembly of that name.
  std::map<std::string, Indices> assemblies_of_that_name() const {
    std::map<std::string, Indices> found;
    for (std::size_t k = 0; k < parts_.size(); ++k)
      for (const std::string& assembly : parts_[k].assemblies)
        if (assembly.substr(0, assembly.rfind('#')) == name_) found[assembly].push_back(k);
    return found;
  }

  static bool contains(const Indices& many, const Indices& some) {
    return std::includes(many.begin(), many.end(), some.begin(), some.end());
  }

  std::string place(const Indices& indices) const {
    Box box;
    for (const std::size_t k : indices) box.include(parts_[k].mesh.bounding_box());
    const Eigen::Vector3d middle = millimetres_ * (box.lower + box.upper) / 2;
    char text[120];
    std::snprintf(text, sizeof text, " around (%.2f, %.2f, %.2f) mm", middle.x(), middle.y(), middle.z());
    return text;
  }

  std::string list(const Indices& indices, bool with_places) const {
    std::string text;
    for (std::size_t k = 0; k < std::min(indices.size(), kMaxListed); ++k)
      text += (k == 0 ? "\"" : ", \"") + shown(parts_[indices[k]].name) + "\"" +
              (with_places ? place({indices[k]}) : "");
    if (indices.size() > kMaxListed) text += " and " + std::to_string(indices.size() - kMaxListed) + " more";
    return text;
  }

  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const CadPart& part : parts_) names.push_back(part.name);
    return names;
  }

  [[noreturn]] void refuse(const Indices& indices, const std::string& why) const {
    throw MeshError(file_ + ": part \"" + shown(name_) + "\" " + why + ": " + list(indices, true) +
                    "; write the full name of the one you mean");
  }

  [[noreturn]] void refuse_assemblies(const std::map<std::string, Indices>& assemblies) const {
    std::string places;
    Indices members;
    for (const auto& [key, indices] : assemblies) {
      places += (places.empty() ? "" : " and") + place(indices);
      members.insert(members.end(), indices.begin(), indices.end());
    }
    std::sort(members.begin(), members.end());
    throw MeshError(file_ + ": assembly \"" + shown(name_) + "\" is placed " +
                    std::to_string(assemblies.size()) + " times," + places +
                    "; choose one of its parts: " + list(members, true));
  }

  const std::vector<CadPart>& parts_;
  const std::string& name_;
  const std::string& file_;
  double millimetres_;
};

}  // namespace

std::vector<std::size_t> wanted_parts(const std::vector<CadPart>& parts, const std::string& name,
                                      const std::string& file, double metres_per_unit) {
  if (!name.empty()) return Search(parts, name, file, metres_per_unit).run();
  std::vector<std::size_t> every(parts.size());
  std::iota(every.begin(), every.end(), std::size_t{0});
  return every;
}

}  // namespace diefill::geometry
