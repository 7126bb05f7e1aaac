#include "tests/geometry/mesh_files.h"

#include <cstdint>
#include <cstring>
#include <iomanip>
#include <sstream>

namespace diefill::geometry::sample {

namespace {

template <typename Value>
void append(std::string& bytes, Value value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

const Eigen::Vector3d& corner(const Mesh& mesh, const Eigen::Vector3i& triangle, int k) {
  return mesh.vertices[static_cast<std::size_t>(triangle[k])];
}

std::string base64(const std::string& bytes) {
  static const char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : letters[group >> (18 - 6 * k) & 63U];
  }
  return text;
}

/// CRC-32 of ISO 3309, as archives carry it.
std::uint32_t crc32(const std::string& bytes) {
  std::uint32_t crc = ~0U;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1U ? 0xedb88320U : 0U);
  }
  return ~crc;
}

}  // namespace

std::string ascii_stl(const Mesh& mesh) {
  std::ostringstream out;
  out << std::setprecision(9) << "solid sample\n";
  for (const Eigen::Vector3i& t : mesh.triangles) {
    out << "facet normal 0 0 0\n outer loop\n";
    for (int k = 0; k < 3; ++k) out << "  vertex " << corner(mesh, t, k).transpose() << "\n";
    out << " endloop\nendfacet\n";
  }
  out << "endsolid sample\n";
  return out.str();
}

std::string binary_stl(const Mesh& mesh) {
  std::string bytes = "solid in name only";
  bytes.resize(80, ' ');
  append(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const Eigen::Vector3i& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) append(bytes, 0.0F);
    for (int k = 0; k < 3; ++k)
      for (int axis = 0; axis < 3; ++axis) append(bytes, static_cast<float>(corner(mesh, t, k)[axis]));
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string obj(const Mesh& mesh) {
  std::ostringstream out;
  out << std::setprecision(9);
  for (const Eigen::Vector3d& v : mesh.vertices) out << "v " << v.transpose() << "\n";
  for (const Eigen::Vector3i& t : mesh.triangles) out << "f " << (t.array() + 1).transpose() << "\n";
  return out.str();
}

std::string ply(const Mesh& mesh) {
  std::ostringstream out;
  out << std::setprecision(9) << "ply\nformat ascii 1.0\nelement vertex " << mesh.vertices.size()
      << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << mesh.triangles.size()
      << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Eigen::Vector3d& v : mesh.vertices) out << v.transpose() << "\n";
  for (const Eigen::Vector3i& t : mesh.triangles) out << "3 " << t.transpose() << "\n";
  return out.str();
}

std::string binary_ply(const Mesh& mesh) {
  std::string bytes = ply(mesh);
  bytes.resize(bytes.find("end_header\n") + std::strlen("end_header\n"));
  bytes.replace(bytes.find("ascii"), 5, "binary_little_endian");
  for (const Eigen::Vector3d& v : mesh.vertices)
    for (int axis = 0; axis < 3; ++axis) append(bytes, static_cast<float>(v[axis]));
  for (const Eigen::Vector3i& t : mesh.triangles) {
    append(bytes, std::uint8_t{3});
    for (int k = 0; k < 3; ++k) append(bytes, static_cast<std::int32_t>(t[k]));
  }
  return bytes;
}

std::string off(const Mesh& mesh) {
  std::ostringstream out;
  out << std::setprecision(9) << "OFF\n" << mesh.vertices.size() << " " << mesh.triangles.size() << " 0\n";
  for (const Eigen::Vector3d& v : mesh.vertices) out << v.transpose() << "\n";
  for (const Eigen::Vector3i& t : mesh.triangles) out << "3 " << t.transpose() << "\n";
  return out.str();
}

std::string amf(const Mesh& mesh, const std::string& unit) {
  std::ostringstream out;
  out << std::setprecision(9) << "<?xml version=\"1.0\"?>\n<amf unit=\"" << unit
      << "\">\n<object id=\"0\"><mesh><vertices>\n";
  for (const Eigen::Vector3d& v : mesh.vertices)
    out << "<vertex><coordinates><x>" << v.x() << "</x><y>" << v.y() << "</y><z>" << v.z()
        << "</z></coordinates></vertex>\n";
  out << "</vertices><volume>\n";
  for (const Eigen::Vector3i& t : mesh.triangles)
    out << "<triangle><v1>" << t[0] << "</v1><v2>" << t[1] << "</v2><v3>" << t[2] << "</v3></triangle>\n";
  out << "</volume></mesh></object></amf>\n";
  return out.str();
}

std::string collada(const Mesh& mesh, double unit) {
  std::ostringstream out;
  out << std::setprecision(9)
      << "<?xml version=\"1.0\"?>\n<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" "
         "version=\"1.4.1\"><asset><unit name=\"u\" meter=\""
      << unit
      << "\"/><up_axis>Z_UP</up_axis></asset><library_geometries><geometry id=\"g\" name=\"g\"><mesh><source "
         "id=\"p\"><float_array id=\"a\" count=\""
      << 3 * mesh.vertices.size() << "\">";
  for (const Eigen::Vector3d& v : mesh.vertices) out << v.transpose() << " ";
  out << "</float_array><technique_common><accessor source=\"#a\" count=\"" << mesh.vertices.size()
      << "\" stride=\"3\"><param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/><param "
         "name=\"Z\" "
         "type=\"float\"/></accessor></technique_common></source><vertices id=\"v\"><input "
         "semantic=\"POSITION\" source=\"#p\"/></vertices><triangles count=\""
      << mesh.triangles.size() << "\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>";
  for (const Eigen::Vector3i& t : mesh.triangles) out << t.transpose() << " ";
  out << "</p></triangles></mesh></geometry></library_geometries><library_visual_scenes><visual_scene "
         "id=\"s\"><node id=\"n\" name=\"tube\"><instance_geometry "
         "url=\"#g\"/></node></visual_scene></library_visual_scenes><scene><instance_visual_scene "
         "url=\"#s\"/></scene></COLLADA>\n";
  return out.str();
}

namespace {

/// Corners, y up, then triangles: the buffer of a glTF file.
std::string gltf_buffer(const Mesh& mesh) {
  std::string data;
  for (const Eigen::Vector3d& v : mesh.vertices)
    for (const double part : {v.x(), v.z(), -v.y()}) append(data, static_cast<float>(part));
  for (const Eigen::Vector3i& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) append(data, static_cast<std::uint32_t>(t[k]));
  return data;
}

/// The text of a glTF file; `source`: how its buffer says where it is.
std::string gltf_text(const Mesh& mesh, const std::string& name, const std::string& source) {
  const std::size_t corners = 12 * mesh.vertices.size(), indices = 12 * mesh.triangles.size();
  const Box box = mesh.bounding_box();
  std::ostringstream out;
  const auto list = [](double x, double y, double z) {
    std::ostringstream text;
    text << std::setprecision(9) << "[" << x << "," << y << "," << z << "]";
    return text.str();
  };
  out << R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"name":")"
      << name << R"("}],"meshes":[{"name":"m","primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
      << R"("accessors":[{"bufferView":0,"componentType":5126,"count":)" << mesh.vertices.size()
      << R"(,"type":"VEC3","min":)" << list(box.lower.x(), box.lower.z(), -box.upper.y()) << R"(,"max":)"
      << list(box.upper.x(), box.upper.z(), -box.lower.y())
      << R"(},{"bufferView":1,"componentType":5125,"count":)" << 3 * mesh.triangles.size()
      << R"(,"type":"SCALAR"}],"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":)" << corners
      << R"(},{"buffer":0,"byteOffset":)" << corners << R"(,"byteLength":)" << indices
      << R"(}],"buffers":[{"byteLength":)" << corners + indices << source << "}]}";
  return out.str();
}

/// A piece of a binary glTF file, filled up to four bytes.
void append_chunk(std::string& bytes, const std::string& kind, std::string content, char filler) {
  content.resize((content.size() + 3) / 4 * 4, filler);
  append(bytes, static_cast<std::uint32_t>(content.size()));
  bytes += kind + content;
}

}  // namespace

std::string gltf(const Mesh& mesh, const std::string& name) {
  return gltf_text(mesh, name,
                   R"(,"uri":"data:application/octet-stream;base64,)" + base64(gltf_buffer(mesh)) + "\"");
}

std::string glb(const Mesh& mesh, const std::string& name) {
  std::string chunks;
  append_chunk(chunks, "JSON", gltf_text(mesh, name, ""), ' ');
  append_chunk(chunks, std::string("BIN\0", 4), gltf_buffer(mesh), '\0');
  std::string bytes = "glTF";
  append(bytes, std::uint32_t{2});
  append(bytes, static_cast<std::uint32_t>(12 + chunks.size()));
  return bytes + chunks;
}

std::string three_mf(const std::vector<NamedMesh>& parts, const std::string& unit,
                     const std::string& type_of_last) {
  std::ostringstream out;
  out << std::setprecision(9) << "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<model unit=\"" << unit
      << "\" xml:lang=\"en-US\" "
         "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"><resources>\n";
  for (std::size_t k = 0; k < parts.size(); ++k) {
    out << "<object id=\"" << k + 1 << "\" name=\"" << parts[k].first << "\" type=\""
        << (k + 1 < parts.size() ? "model" : type_of_last) << "\"><mesh><vertices>\n";
    for (const Eigen::Vector3d& v : parts[k].second.vertices)
      out << "<vertex x=\"" << v.x() << "\" y=\"" << v.y() << "\" z=\"" << v.z() << "\"/>\n";
    out << "</vertices><triangles>\n";
    for (const Eigen::Vector3i& t : parts[k].second.triangles)
      out << "<triangle v1=\"" << t[0] << "\" v2=\"" << t[1] << "\" v3=\"" << t[2] << "\"/>\n";
    out << "</triangles></mesh></object>\n";
  }
  out << "</resources><build>";
  for (std::size_t k = 0; k < parts.size(); ++k) out << "<item objectid=\"" << k + 1 << "\"/>";
  out << "</build></model>\n";
  return zip(
      {{"[Content_Types].xml",
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Types "
        "xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\"><Default Extension=\"rels\" "
        "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/><Default "
        "Extension=\"model\" "
        "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>"},
       {"_rels/.rels",
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Relationships "
        "xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship "
        "Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
        "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>"},
       {"3D/3dmodel.model", out.str()}});
}

std::string zip(const std::vector<std::pair<std::string, std::string>>& files) {
  std::string bytes, directory;
  for (const auto& [name, content] : files) {
    std::string entry;  // what the local header and the directory have in common
    append(entry, std::uint16_t{20});
    for (const int zero : {0, 0, 0}) append(entry, static_cast<std::uint16_t>(zero));
    append(entry, std::uint16_t{0x21});  // 1 January 1980
    append(entry, crc32(content));
    append(entry, static_cast<std::uint32_t>(content.size()));
    append(entry, static_cast<std::uint32_t>(content.size()));
    append(entry, static_cast<std::uint16_t>(name.size()));
    append(entry, std::uint16_t{0});
    directory += "PK\x01\x02" + std::string("\x14\0", 2) + entry + std::string(10, '\0');
    append(directory, static_cast<std::uint32_t>(bytes.size()));
    directory += name;
    bytes += "PK\x03\x04" + entry + name + content;
  }
  std::string end = "PK\x05\x06" + std::string(4, '\0');
  append(end, static_cast<std::uint16_t>(files.size()));
  append(end, static_cast<std::uint16_t>(files.size()));
  append(end, static_cast<std::uint32_t>(directory.size()));
  append(end, static_cast<std::uint32_t>(bytes.size()));
  append(end, std::uint16_t{0});
  return bytes + directory + end;
}

std::string obj_of_parts(const std::vector<NamedMesh>& parts) {
  std::ostringstream out;
  out << std::setprecision(9);
  int first = 1;
  for (const auto& [name, mesh] : parts) {
    out << "o " << name << "\n";
    for (const Eigen::Vector3d& v : mesh.vertices) out << "v " << v.transpose() << "\n";
    for (const Eigen::Vector3i& t : mesh.triangles) out << "f " << (t.array() + first).transpose() << "\n";
    first += static_cast<int>(mesh.vertices.size());
  }
  return out.str();
}

std::string stl_of_parts(const std::vector<NamedMesh>& parts) {
  std::string text;
  for (const auto& [name, mesh] : parts) {
    std::string solid = ascii_stl(mesh);
    for (const char* word : {"solid sample\n", "endsolid sample\n"}) {
      const std::size_t at = solid.find(word);
      solid.replace(at, std::string(word).size(),
                    std::string(word).replace(std::string(word).find("sample"), 6, name));
    }
    text += solid;
  }
  return text;
}

}  // namespace diefill::geometry::sample
