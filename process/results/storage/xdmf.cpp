#include "process/results/storage/xdmf.h"

#include <iomanip>
#include <sstream>

#include "process/results/storage/group_names.h"

namespace diefill::results {
namespace {

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

/// Writes XDMF elements that refer to datasets of one HDF5 file.
class Xdmf {
 public:
  explicit Xdmf(const std::string& file) : file_(escaped(file)) {}

  void data(const std::string& path, std::size_t rows, int columns, const char* type, int bytes) {
    text_ << "<DataItem Dimensions=\"" << rows;
    if (columns > 1) text_ << ' ' << columns;
    text_ << "\" NumberType=\"" << type << "\" Precision=\"" << bytes << "\" Format=\"HDF\">" << file_ << ':'
          << path << "</DataItem>";
  }
  void scalar(const char* name, const std::string& path, std::size_t rows, const char* type) {
    text_ << "        <Attribute Name=\"" << name << "\" AttributeType=\"Scalar\" Center=\"Node\">";
    data(path, rows, 1, type, 8);
    text_ << "</Attribute>\n";
  }
  void geometry(const std::string& path, std::size_t rows) {
    text_ << "        <Geometry GeometryType=\"XYZ\">";
    data(path, rows, 3, "Float", 8);
    text_ << "</Geometry>\n";
  }
  void spheres(std::size_t count);
  void tool(const ToolState& tool, const std::string& group);
  std::ostringstream& text() { return text_; }

 private:
  std::string file_;
  std::ostringstream text_;
};

void Xdmf::spheres(std::size_t count) {
  text_ << "      <Grid Name=\"powder\" GridType=\"Uniform\">\n"
        << "        <Topology TopologyType=\"Polyvertex\" NumberOfElements=\"" << count
        << "\" NodesPerElement=\"1\"/>\n";
  geometry("/spheres/centre", count);
  scalar("radius", "/spheres/radius", count, "Float");
  scalar("solid_fraction", "/spheres/solid_fraction", count, "Float");
  scalar("grain", "/spheres/grain", count, "Int");  // ParaView takes UInt for 32 bits whatever the precision
  text_ << "      </Grid>\n";
}

void Xdmf::tool(const ToolState& tool, const std::string& group) {
  const std::string path = "/tools/" + group;
  text_ << "      <Grid Name=\"" << escaped(tool.name) << "\" GridType=\"Uniform\">\n"
        << "        <Topology TopologyType=\"Triangle\" NumberOfElements=\"" << tool.triangles.size()
        << "\">";
  data(path + "/triangles", tool.triangles.size(), 3, "Int", 4);
  text_ << "</Topology>\n";
  geometry(path + "/vertices", tool.vertices.size());
  text_ << "      </Grid>\n";
}

}  // namespace

std::string xdmf_text(const FillResult& result, const std::string& hdf5_name) {
  Xdmf xdmf(hdf5_name);
  xdmf.text() << std::setprecision(17) << R"(<?xml version="1.0" encoding="UTF-8"?>
<!-- Open in ParaView (Xdmf Reader); show "powder" as Point Gaussian or as glyphs scaled by radius. -->
<Xdmf Version="2.0">
  <Domain>
    <Grid Name="diefill" GridType="Collection" CollectionType="Spatial">
      <Time Value=")"
              << result.powder.time << "\"/>\n";
  const bool placed = result.powder.orientation.size() == result.powder.position.size();
  const std::size_t spheres = placed ? result.powder.sphere_count() : 0;
  if (spheres > 0) xdmf.spheres(spheres);
  std::vector<std::string> names;
  for (const ToolState& tool : result.tools) names.push_back(tool.name);
  names = group_names(names);
  for (std::size_t n = 0; n < names.size(); ++n)
    if (!result.tools[n].triangles.empty()) xdmf.tool(result.tools[n], names[n]);
  xdmf.text() << "    </Grid>\n  </Domain>\n</Xdmf>\n";
  return xdmf.text().str();
}

}  // namespace diefill::results
