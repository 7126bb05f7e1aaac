#include "geometry/cad/gltf_document.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace diefill::geometry {

namespace {

using nlohmann::json;

constexpr int kFloat = 5126;  // the component type of floating-point numbers

/// Extensions that say where corners are, and what a CAD program calls them.
constexpr std::array<std::pair<const char*, const char*>, 2> kUnread = {
    {{"EXT_meshopt_compression", "compression"}, {"EXT_mesh_gpu_instancing", "instancing"}}};

/// That element of a list in the document; null where there is none.
const json& element(const json& document, const char* list, const json& number) {
  static const json none;
  const auto entries = document.find(list);
  if (entries == document.end() || !entries->is_array() || !number.is_number_unsigned()) return none;
  const auto at = number.get<std::size_t>();
  return at < entries->size() ? (*entries)[at] : none;
}

/// Number of the accessor of the corners of a primitive; null where there is none.
json accessor_of_corners(const json& primitive) {
  if (!primitive.is_object()) return {};
  const auto attributes = primitive.find("attributes");
  if (attributes == primitive.end() || !attributes->is_object()) return {};
  return attributes->value("POSITION", json());
}

void refuse_whole_numbers(const json& document) {
  const auto meshes = document.find("meshes");
  if (meshes == document.end() || !meshes->is_array()) return;
  for (const json& mesh : *meshes) {
    if (!mesh.is_object() || !mesh.contains("primitives") || !mesh["primitives"].is_array()) continue;
    for (const json& primitive : mesh["primitives"]) {
      const json& accessor = element(document, "accessors", accessor_of_corners(primitive));
      if (!accessor.is_object() || accessor.value("componentType", json(kFloat)) == kFloat) continue;
      throw std::runtime_error(
          "its corners are whole numbers (KHR_mesh_quantization), which are not supported: switch "
          "quantization off");
    }
  }
}

void refuse_extensions(const json& document) {
  const auto required = document.find("extensionsRequired");
  if (required == document.end() || !required->is_array()) return;
  for (const auto& [extension, what] : kUnread)
    for (const json& name : *required)
      if (name == extension)
        throw std::runtime_error("it requires " + std::string(extension) +
                                 ", which is not supported: switch " + what + " off");
}

}  // namespace

std::string json_of_gltf(const std::string& bytes) {
  // A binary file begins with 12 bytes of header and a chunk of JSON (Khronos, glTF 2.0, 4.4).
  constexpr std::size_t kStart = 20;
  if (!bytes.starts_with("glTF")) return bytes;
  if (bytes.size() < kStart || bytes.compare(16, 4, "JSON") != 0) return {};
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 12, sizeof length);
  return bytes.substr(kStart, length);
}

void refuse_unread_corners(const std::string& text) {
  const json document = json::parse(text, nullptr, false);
  if (!document.is_object()) return;
  refuse_whole_numbers(document);
  refuse_extensions(document);
}

}  // namespace diefill::geometry
