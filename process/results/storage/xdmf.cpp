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

/// A set of numbers in the HDF5 file.
struct Numbers {
  std::string path;
  std::string dimensions;  ///< such as "15 3"
  const char* type = "Float";
  int bytes = 8;
};

/// Writes XDMF elements that refer to datasets of one HDF5 file.
class Xdmf {
 public:
  explicit Xdmf(const std::string& file) : file_(escaped(file)) { text_ << std::setprecision(17); }

  void open(const std::string& tag) { text_ << std::string(2 * depth_++, ' ') << '<' << tag << ">\n"; }
  void close(const std::string& name) { text_ << std::string(2 * --depth_, ' ') << "</" << name << ">\n"; }
  void element(const std::string& tag) { text_ << std::string(2 * depth_, ' ') << '<' << tag << "/>\n"; }
  /// An element that holds one set of numbers.
  void holder(const std::string& name, const std::string& attributes, const Numbers& numbers) {
    text_ << std::string(2 * depth_, ' ') << '<' << name << ' ' << attributes << "><DataItem Dimensions=\""
          << numbers.dimensions << "\" NumberType=\"" << numbers.type << "\" Precision=\"" << numbers.bytes
          << "\" Format=\"HDF\">" << file_ << ':' << numbers.path << "</DataItem></" << name << ">\n";
  }
  void three_numbers(double first, double second, double third) {
    text_ << std::string(2 * depth_, ' ')
          << "<DataItem Dimensions=\"3\" NumberType=\"Float\" Precision=\"8\" Format=\"XML\">" << first << ' '
          << second << ' ' << third << "</DataItem>\n";
  }
  void geometry(const std::string& path, std::size_t rows) {
    holder("Geometry", "GeometryType=\"XYZ\"", {path, std::to_string(rows) + " 3"});
  }
  void attribute(const std::string& name, const Numbers& numbers, const char* kind = "Scalar",
                 const char* centre = "Node") {
    holder("Attribute", "Name=\"" + name + "\" AttributeType=\"" + kind + "\" Center=\"" + centre + "\"",
           numbers);
  }
  /// Opens a grid of points, one vertex each.
  void open_points(const std::string& name, std::size_t count) {
    open("Grid Name=\"" + name + "\" GridType=\"Uniform\"");
    element("Topology TopologyType=\"Polyvertex\" NumberOfElements=\"" + std::to_string(count) +
            "\" NodesPerElement=\"1\"");
  }
  std::string text() const { return text_.str(); }
  static std::string quoted(const std::string& text) { return escaped(text); }

 private:
  std::string file_;
  std::ostringstream text_;
  std::size_t depth_ = 0;
};

std::string number_text(double value) {
  std::ostringstream text;
  text << std::setprecision(17) << value;
  return text.str();
}

// ParaView takes UInt for 32 bits whatever the precision: identities are Int.
void add_powder(Xdmf& xdmf, const ShownInstant& instant, const std::string& shown) {
  const std::string count = std::to_string(instant.grains);
  xdmf.open_points("powder", instant.grains);
  xdmf.geometry(instant.powder + "/position", instant.grains);
  xdmf.attribute("id", {instant.powder + "/id", count, "Int"});
  xdmf.attribute("diameter", {shown + "/diameter", count});
  xdmf.attribute("velocity", {instant.powder + "/velocity", count + " 3"}, "Vector");
  xdmf.close("Grid");
}

void add_spheres(Xdmf& xdmf, std::size_t spheres) {
  const std::string count = std::to_string(spheres);
  xdmf.open_points("spheres", spheres);
  xdmf.geometry("/spheres/centre", spheres);
  xdmf.attribute("radius", {"/spheres/radius", count});
  xdmf.attribute("solid_fraction", {"/spheres/solid_fraction", count});
  xdmf.attribute("grain", {"/spheres/grain", count, "Int"});
  xdmf.close("Grid");
}

void add_tool(Xdmf& xdmf, const ToolState& tool, const std::string& group, const std::string& vertices) {
  const std::string count = std::to_string(tool.triangles.size());
  xdmf.open("Grid Name=\"" + Xdmf::quoted(tool.name) + "\" GridType=\"Uniform\"");
  xdmf.holder("Topology", "TopologyType=\"Triangle\" NumberOfElements=\"" + count + "\"",
              {"/tools/" + group + "/triangles", count + " 3", "Int", 4});
  xdmf.geometry(vertices, tool.vertices.size());
  xdmf.close("Grid");
}

/// XDMF counts dimensions from the slowest: z, y, x.
void add_grid(Xdmf& xdmf, const ShownGrid& grid, const std::string& shown) {
  const auto& [x, y, z] = grid.cells;
  const auto dimensions = [&](std::size_t more) {
    return std::to_string(z + more) + ' ' + std::to_string(y + more) + ' ' + std::to_string(x + more);
  };
  xdmf.open("Grid Name=\"solid share\" GridType=\"Uniform\"");
  xdmf.element("Topology TopologyType=\"3DCoRectMesh\" Dimensions=\"" + dimensions(1) + "\"");
  xdmf.open("Geometry GeometryType=\"ORIGIN_DXDYDZ\"");
  xdmf.three_numbers(grid.origin.z(), grid.origin.y(), grid.origin.x());
  xdmf.three_numbers(grid.spacing, grid.spacing, grid.spacing);
  xdmf.close("Geometry");
  xdmf.attribute("solid_share", {shown + "/solid_share", dimensions(0)}, "Scalar", "Cell");
  xdmf.close("Grid");
}

}  // namespace

std::string xdmf_text(const FillResult& result, const std::vector<ShownInstant>& instants,
                      const ShownGrid& grid, const std::string& hdf5_name) {
  const bool placed = result.powder.orientation.size() == result.powder.position.size();
  const std::size_t spheres = placed ? result.powder.sphere_count() : 0;
  std::vector<std::string> tools;
  for (const ToolState& tool : result.tools) tools.push_back(tool.name);
  tools = group_names(tools);
  const auto names = shown_names(result);
  Xdmf xdmf(hdf5_name);
  xdmf.open("Xdmf Version=\"2.0\"");
  xdmf.open("Domain");
  xdmf.open("Grid Name=\"filling\" GridType=\"Collection\" CollectionType=\"Temporal\"");
  for (std::size_t n = 0; n < instants.size(); ++n) {
    const ShownInstant& instant = instants[n];
    const std::string shown = "/shown/" + names[n];
    xdmf.open("Grid Name=\"" + names[n] + "\" GridType=\"Collection\" CollectionType=\"Spatial\"");
    xdmf.element("Time Value=\"" + number_text(instant.time) + "\"");
    if (instant.grains > 0) add_powder(xdmf, instant, shown);
    for (std::size_t t = 0; t < tools.size(); ++t) {
      if (result.tools[t].triangles.empty()) continue;
      const bool moved = !instant.vertices[t].empty();
      add_tool(xdmf, result.tools[t], tools[t],
               moved ? shown + "/tools/" + tools[t] : "/tools/" + tools[t] + "/vertices");
    }
    if (grid.size() > 0) add_grid(xdmf, grid, shown);
    if (n + 1 == instants.size() && spheres > 0) add_spheres(xdmf, spheres);
    xdmf.close("Grid");
  }
  xdmf.close("Grid");
  xdmf.close("Domain");
  xdmf.close("Xdmf");
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<!-- Open in ParaView (Xdmf Reader); show \"powder\" as Point Gaussian or as glyphs scaled by "
         "diameter. "
         "-->\n" +
         xdmf.text();
}

}  // namespace diefill::results
