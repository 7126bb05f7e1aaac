#include <map>
#include <optional>

#include "process/press_mesh/mesh_builder.h"
#include "process/press_mesh/read_press_mesh.h"

namespace diefill::process {
namespace {

using results::ElementShape;

/// An element type of Gmsh: its number of nodes, and which of them corresponds to each node of ours.
struct GmshType {
  std::size_t nodes = 0;
  std::optional<ElementShape> shape;  ///< none: without volume
  std::vector<std::size_t> order;     ///< empty: as they stand
};

const GmshType* type_of(std::uint64_t number) {
  static const std::map<std::uint64_t, GmshType> all = {
      {1, {2, {}, {}}},
      {2, {3, {}, {}}},
      {3, {4, {}, {}}},
      {8, {3, {}, {}}},
      {9, {6, {}, {}}},
      {10, {9, {}, {}}},
      {15, {1, {}, {}}},
      {16, {8, {}, {}}},
      {4, {4, ElementShape::tetra4, {}}},
      {5, {8, ElementShape::hexa8, {}}},
      {6, {6, ElementShape::wedge6, {}}},
      {7, {5, ElementShape::pyramid5, {}}},
      {11, {10, ElementShape::tetra10, {0, 1, 2, 3, 4, 5, 6, 7, 9, 8}}},
      {17,
       {20, ElementShape::hexa20, {0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 13, 9, 16, 18, 19, 17, 10, 12, 14, 15}}},
      {18, {15, ElementShape::wedge15, {0, 1, 2, 3, 4, 5, 6, 9, 7, 12, 14, 13, 8, 10, 11}}},
  };
  const auto found = all.find(number);
  return found == all.end() ? nullptr : &found->second;
}

/// One file of Gmsh.
class GmshFile {
 public:
  GmshFile(const std::filesystem::path& file, double unit)
      : name_(file.string()), lines_(file), builder_(lines_, unit) {}

  results::SolidMesh read() {
    read_format();
    while (lines_.next()) {
      if (!lines_.line().starts_with('$')) lines_.reject("a section such as $Nodes");
      const std::string section(lines_.line().substr(1));
      if (section == "Nodes")
        newer_ ? read_node_blocks() : read_nodes();
      else if (section == "Elements")
        newer_ ? read_element_blocks() : read_elements();
      else
        skip(section);
    }
    return builder_.finish(name_);
  }

 private:
  std::vector<std::string_view> cells(const std::string& wanted, std::size_t least) {
    const auto found = cells_of_line(lines_.require(wanted), false);
    if (found.size() < least || lines_.line().starts_with('$')) lines_.reject(wanted);
    return found;
  }
  std::uint64_t count(const std::string& wanted) {
    const auto found = cells(wanted, 1);
    return whole_number(found[0], lines_);
  }
  void end(const std::string& section) {
    if (lines_.require("$End" + section) != "$End" + section) lines_.reject("$End" + section);
  }
  void skip(const std::string& section) {
    while (lines_.require("$End" + section) != "$End" + section) continue;
  }

  void read_format() {
    if (lines_.require("$MeshFormat") != "$MeshFormat")
      lines_.reject("$MeshFormat, with which a mesh of Gmsh begins");
    const auto format = cells("the version, such as 4.1 0 8", 2);
    newer_ = format[0] == "4.1";
    if (!newer_ && format[0] != "2.2") lines_.reject("version 2.2 or 4.1; write it with gmsh -format msh41");
    if (format[1] != "0") lines_.reject("a text file (0 after the version); write it without -bin");
    end("MeshFormat");
  }

  Eigen::Vector3d place(const std::vector<std::string_view>& cells, std::size_t first) {
    return {decimal_number(cells[first], lines_), decimal_number(cells[first + 1], lines_),
            decimal_number(cells[first + 2], lines_)};
  }

  void read_nodes() {
    const std::uint64_t nodes = count("the number of nodes");
    for (std::uint64_t n = 0; n < nodes; ++n) {
      const auto node = cells("a node: number x y z", 4);
      builder_.add_node(whole_number(node[0], lines_), place(node, 1));
    }
    end("Nodes");
  }

  void read_node_blocks() {
    const std::uint64_t blocks = count("the number of blocks of nodes");
    for (std::uint64_t b = 0; b < blocks; ++b) {
      const auto head = cells("a block of nodes: dimension, entity, parametric, nodes", 4);
      const std::uint64_t nodes = whole_number(head[3], lines_);
      std::vector<std::uint64_t> numbers;
      for (std::uint64_t n = 0; n < nodes; ++n) numbers.push_back(count("the number of a node"));
      for (const std::uint64_t number : numbers) builder_.add_node(number, place(cells("x y z", 3), 0));
    }
    end("Nodes");
  }

  void add(std::uint64_t number, std::uint64_t type, const std::vector<std::string_view>& cells,
           std::size_t first) {
    const GmshType* kind = type_of(type);
    if (kind == nullptr)
      lines_.reject_text("element of type " + std::to_string(type) +
                         ", allowed: tetrahedra, hexahedra, wedges (first order, or second without nodes in "
                         "faces) and pyramids of 5 nodes");
    if (cells.size() != first + kind->nodes)
      lines_.reject_text("element " + std::to_string(number) + " has " +
                         std::to_string(cells.size() - std::min(first, cells.size())) + " nodes, expected " +
                         std::to_string(kind->nodes));
    if (!kind->shape) return builder_.leave_out(1);
    std::vector<std::uint64_t> nodes;
    for (std::size_t n = 0; n < kind->nodes; ++n)
      nodes.push_back(whole_number(cells[first + (kind->order.empty() ? n : kind->order[n])], lines_));
    builder_.add_element(number, *kind->shape, nodes);
  }

  void read_elements() {
    const std::uint64_t elements = count("the number of elements");
    for (std::uint64_t n = 0; n < elements; ++n) {
      const auto element = cells("an element: number, type, tags, nodes", 4);
      const std::size_t tags = whole_number(element[2], lines_);
      if (tags > element.size()) lines_.reject("as many tags as stated");
      add(whole_number(element[0], lines_), whole_number(element[1], lines_), element, 3 + tags);
    }
    end("Elements");
  }

  void read_element_blocks() {
    const std::uint64_t blocks = count("the number of blocks of elements");
    for (std::uint64_t b = 0; b < blocks; ++b) {
      const auto head = cells("a block of elements: dimension, entity, type, elements", 4);
      const std::uint64_t type = whole_number(head[2], lines_), elements = whole_number(head[3], lines_);
      for (std::uint64_t n = 0; n < elements; ++n) {
        const auto element = cells("an element: number, nodes", 2);
        add(whole_number(element[0], lines_), type, element, 1);
      }
    }
    end("Elements");
  }

  std::string name_;
  MeshLines lines_;
  MeshBuilder builder_;
  bool newer_ = false;
};

}  // namespace

results::SolidMesh read_gmsh(const std::filesystem::path& file, double unit) {
  return GmshFile(file, unit).read();
}

}  // namespace diefill::process
