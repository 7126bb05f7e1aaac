#include "geometry/cad/amf_document.h"

#include <Eigen/Geometry>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>

#include "geometry/cad/cad_file.h"
#include "geometry/cad/shown_text.h"
#include "geometry/cad/xml_coordinates.h"
#include "geometry/cad/xml_tags.h"
#include "geometry/cad/zip_archive.h"

namespace diefill::geometry {

namespace {

constexpr std::size_t kMaxParts = 100000, kMaxCorners = 100000000;
constexpr std::size_t kDeepestNesting = 32;  // of constellations in constellations

/// An object or constellation as an element `instance` places it.
struct Instance {
  std::string of;                                     ///< id
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();    ///< units of the file
  Eigen::Vector3d degrees = Eigen::Vector3d::Zero();  ///< about x, y and z
};

/// By their id.
using Constellations = std::map<std::string, std::vector<Instance>>;

Eigen::Affine3d pose_of(const Instance& instance) {
  const Eigen::Vector3d angles = instance.degrees * std::numbers::pi / 180;
  return Eigen::Translation3d(instance.shift) * Eigen::AngleAxisd(angles.z(), Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(angles.y(), Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(angles.x(), Eigen::Vector3d::UnitX());
}

/// Where an element of an instance writes its number; null for other elements.
double* number_of(Instance& instance, std::string_view element) {
  static const std::map<std::string_view, int> shifts = {{"deltax", 0}, {"deltay", 1}, {"deltaz", 2}},
                                               angles = {{"rx", 0}, {"ry", 1}, {"rz", 2}};
  const auto shift = shifts.find(element), angle = angles.find(element);
  if (shift != shifts.end()) return &instance.shift[shift->second];
  return angle == angles.end() ? nullptr : &instance.degrees[angle->second];
}

Constellations constellations_of(std::string_view document) {
  Constellations all;
  std::vector<Instance>* open = nullptr;
  bool in_instance = false;
  visit_tags(document, [&](std::string_view name, std::string_view attributes, std::string_view rest) {
    if (name == "constellation") {
      open = &all[attribute(attributes, "id").value_or("")];
    } else if (name == "/constellation") {
      open = nullptr;
    } else if (open == nullptr) {
      return;
    } else if (name == "instance") {
      open->push_back({.of = attribute(attributes, "objectid").value_or("")});
      in_instance = true;
    } else if (name == "/instance") {
      in_instance = false;
    } else if (in_instance) {
      double* const number = number_of(open->back(), name);
      if (number != nullptr) *number = xml_number("an instance", name, rest.substr(0, rest.find('<')));
    }
  });
  return all;
}

/// Walks down from the constellations that no other contains.
class Placement {
 public:
  Placement(const Constellations& constellations, const std::vector<CadPart>& objects)
      : constellations_(constellations) {
    for (const CadPart& object : objects) objects_.emplace(object.name, &object);
    for (const auto& [id, instances] : constellations)
      for (const Instance& instance : instances) placed_.insert(instance.of);
  }

  std::vector<CadPart> run(const std::vector<CadPart>& objects) {
    for (const CadPart& object : objects)
      if (placed_.count(object.name) == 0) parts_.push_back(object);
    for (const auto& constellation : constellations_)
      if (placed_.count(constellation.first) == 0)
        add_constellation(constellation, Eigen::Affine3d::Identity(), {});
    if (reached_.size() < constellations_.size()) refuse_loop();
    return std::move(parts_);
  }

 private:
  [[noreturn]] static void refuse_loop() {
    throw std::runtime_error("its constellations contain each other without end");
  }

  void add_constellation(const Constellations::value_type& constellation, const Eigen::Affine3d& pose,
                         std::vector<std::string> assemblies) {
    if (assemblies.size() > kDeepestNesting) refuse_loop();
    reached_.insert(constellation.first);
    assemblies.push_back(constellation.first + "#" + std::to_string(++places_));
    if (places_ > kMaxParts) throw std::runtime_error("its constellations produce too many parts");
    for (const Instance& instance : constellation.second) {
      const Eigen::Affine3d placed = pose * pose_of(instance);
      const auto object = objects_.find(instance.of);
      const auto other = constellations_.find(instance.of);
      if (object != objects_.end()) {
        add_object(*object->second, placed, assemblies);
      } else if (other != constellations_.end()) {
        add_constellation(*other, placed, assemblies);
      } else {
        throw std::runtime_error("its constellation '" + shown(constellation.first, 40) +
                                 "' places object '" + shown(instance.of, 40) +
                                 "', which is not in the file or has no triangles");
      }
    }
  }

  void add_object(const CadPart& object, const Eigen::Affine3d& pose,
                  const std::vector<std::string>& assemblies) {
    if (parts_.size() >= kMaxParts) throw std::runtime_error("its constellations produce too many parts");
    corners_ += object.mesh.vertices.size();
    if (corners_ > kMaxCorners) throw std::runtime_error("its constellations produce too many corners");
    parts_.push_back(object);
    parts_.back().assemblies = assemblies;
    for (Eigen::Vector3d& vertex : parts_.back().mesh.vertices) vertex = pose * vertex;
  }

  const Constellations& constellations_;
  std::map<std::string, const CadPart*> objects_;
  std::set<std::string> placed_;   ///< ids of objects and constellations that are in a constellation
  std::set<std::string> reached_;  ///< ids of constellations
  std::vector<CadPart> parts_;
  std::size_t places_ = 0, corners_ = 0;
};

}  // namespace

std::string amf_document(const std::filesystem::path& file) {
  std::string text = read_cad_file(file);
  if (is_zip_archive(text)) {
    bool found = false;
    visit_archive(file, ".amf", [&](UnpackedFile unpacked) {
      if (!unpacked.is_whole)
        throw std::runtime_error("its ZIP archive is damaged, or packed in a way that is not read");
      text = std::move(unpacked.text);
      found = true;
      return false;
    });
    if (!found) throw std::runtime_error("it is a ZIP archive that holds no .amf file");
  }
  return without_comments(std::move(text));
}

std::string without_constellations(std::string document) {
  constexpr std::string_view kOpen = "<constellation", kClose = "</constellation";
  for (std::size_t at = document.find(kOpen); at != std::string::npos; at = document.find(kOpen, at)) {
    std::size_t end = document.find('>', at);
    if (end == std::string::npos) break;
    if (document[end - 1] != '/') end = document.find('>', document.find(kClose, end));
    if (end == std::string::npos) break;
    document.erase(at, end + 1 - at);
  }
  return document;
}

std::vector<CadPart> placed_amf_objects(std::string_view document, std::vector<CadPart> objects) {
  const Constellations constellations = constellations_of(document);
  if (constellations.empty()) return objects;
  return Placement(constellations, objects).run(objects);
}

}  // namespace diefill::geometry
