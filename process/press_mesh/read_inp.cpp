#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "process/press_mesh/mesh_builder.h"
#include "process/press_mesh/read_press_mesh.h"

namespace diefill::process {
namespace {

using results::ElementShape;

std::string upper_case(std::string_view text) {
  std::string upper(text);
  for (char& letter : upper)
    if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - 'a' + 'A');
  return upper;
}

/// C3D8R is C3D8 and letters that say nothing about its nodes.
std::optional<ElementShape> shape_of(const std::string& type) {
  constexpr std::array<std::pair<const char*, ElementShape>, 7> kAll = {{{"4", ElementShape::tetra4},
                                                                         {"5", ElementShape::pyramid5},
                                                                         {"6", ElementShape::wedge6},
                                                                         {"8", ElementShape::hexa8},
                                                                         {"10", ElementShape::tetra10},
                                                                         {"15", ElementShape::wedge15},
                                                                         {"20", ElementShape::hexa20}}};
  if (!type.starts_with("C3D")) return {};
  const std::size_t end = std::min(type.find_first_not_of("0123456789", 3), type.size());
  for (const auto& [nodes, shape] : kAll)
    if (type.substr(3, end - 3) == nodes) return shape;
  return {};
}

/// A line with a keyword: *ELEMENT, TYPE=C3D4, ELSET=part.
struct Keyword {
  std::string name;
  std::vector<std::pair<std::string, std::string>> parameters;
  std::string value(const std::string& parameter) const {
    for (const auto& [key, text] : parameters)
      if (key == parameter) return text;
    return {};
  }
};

/// One input file.
class InpFile {
 public:
  InpFile(const std::filesystem::path& file, double unit)
      : name_(file.string()), lines_(file), builder_(lines_, unit) {}

  results::SolidMesh read() {
    while (next_line()) {
      if (!lines_.line().starts_with('*')) continue;  // data of a keyword that says nothing about the mesh
      const Keyword keyword = keyword_of_line();
      refuse(keyword);
      if (keyword.name == "*NODE") read_nodes(keyword);
      if (keyword.name == "*ELEMENT") read_elements(keyword);
    }
    return builder_.finish(name_);
  }

 private:
  /// The next line that is no comment.
  bool next_line() {
    while (lines_.next())
      if (!lines_.line().starts_with("**")) return true;
    return false;
  }
  /// The next line of data; false at a keyword, which is read again.
  bool next_data() {
    if (!next_line()) return false;
    if (!lines_.line().starts_with('*')) return true;
    lines_.put_back();
    return false;
  }

  Keyword keyword_of_line() {
    std::vector<std::string_view> cells = cells_of_line(lines_.line(), true);
    while (lines_.line().ends_with(',') && next_data())  // a keyword continues after a comma
      for (const auto cell : cells_of_line(lines_.line(), true)) cells.push_back(cell);
    Keyword keyword{upper_case(cells[0]), {}};
    for (std::size_t n = 1; n < cells.size(); ++n) {
      const std::size_t sign = std::min(cells[n].find('='), cells[n].size());
      const auto blank = cells[n].substr(0, sign).find_last_not_of(' ');
      std::string key = upper_case(cells[n].substr(0, blank == std::string_view::npos ? 0 : blank + 1));
      std::string_view value = cells[n].substr(std::min(sign + 1, cells[n].size()));
      while (value.starts_with(' ')) value.remove_prefix(1);
      keyword.parameters.emplace_back(std::move(key), upper_case(value));
    }
    return keyword;
  }

  void refuse(const Keyword& keyword) {
    constexpr std::array kParts = {"*PART", "*INSTANCE", "*ASSEMBLY"};
    constexpr std::array kMade = {"*NGEN", "*NFILL", "*NCOPY", "*NMAP", "*ELGEN", "*ELCOPY", "*SYSTEM"};
    const auto is_in = [&](const auto& names) {
      return std::find(names.begin(), names.end(), keyword.name) != names.end();
    };
    const bool block = keyword.name == "*NODE" || keyword.name == "*ELEMENT";
    if (keyword.name == "*INCLUDE" || (block && !keyword.value("INPUT").empty()))
      lines_.reject(
          "nodes and elements in the file itself; replace this line with the contents of the other file");
    if (is_in(kParts))
      lines_.reject("a flat file; in Abaqus/CAE write it without parts and assemblies (model attributes)");
    if (is_in(kMade)) lines_.reject("every node and element written out in *NODE and *ELEMENT");
    if (keyword.name == "*NODE" && !keyword.value("SYSTEM").empty() && keyword.value("SYSTEM") != "R")
      lines_.reject("Cartesian coordinates (SYSTEM=R)");
  }

  void read_nodes(const Keyword&) {
    while (next_data()) {
      const auto cells = cells_of_line(lines_.line(), true);
      if (!is_node(cells)) lines_.reject("a node: number, x, y, z, with decimal points, separated by commas");
      const Eigen::Vector3d place = vector_at(cells, 1);
      builder_.add_node(whole_number(cells[0], lines_), place);
    }
  }

  Eigen::Vector3d vector_at(const std::vector<std::string_view>& cells, std::size_t first) const {
    return {decimal_number(cells[first], lines_), decimal_number(cells[first + 1], lines_),
            decimal_number(cells[first + 2], lines_)};
  }

  /// A node may have a normal after its coordinates; other numbers of cells come from decimal commas.
  bool is_node(const std::vector<std::string_view>& cells) const {
    constexpr std::size_t kPlain = 4, kWithNormal = 7;
    if (cells.size() != kWithNormal) return cells.size() == kPlain;
    const double length = vector_at(cells, kPlain).norm();
    constexpr double kRounding = 0.01;
    return length == 0 || std::abs(length - 1) < kRounding;
  }

  void read_elements(const Keyword& keyword) {
    const std::string type = keyword.value("TYPE");
    if (type.empty()) lines_.reject("the type of the elements, such as *ELEMENT, TYPE=C3D4");
    const auto shape = shape_of(type);
    if (!shape && type.starts_with("C3D"))
      lines_.reject_text("found TYPE=" + type + ", expected C3D4, C3D5, C3D6, C3D8, C3D10, C3D15 or C3D20");
    if (!shape) {
      while (next_data())
        if (!lines_.line().ends_with(',')) builder_.leave_out(1);
      return;
    }
    const auto nodes = static_cast<std::size_t>(results::kind_of(*shape).nodes);
    while (next_data()) read_element(type, *shape, nodes);
  }

  void read_element(const std::string& type, ElementShape shape, std::size_t nodes) {
    std::vector<std::uint64_t> numbers;
    while (true) {
      const bool more = lines_.line().ends_with(',');
      for (const auto cell : cells_of_line(lines_.line(), true))
        numbers.push_back(whole_number(cell, lines_));
      if (!more || numbers.size() > nodes || !next_data()) break;
    }
    if (numbers.size() != nodes + 1)
      lines_.reject_text("element with " + std::to_string(numbers.empty() ? 0 : numbers.size() - 1) +
                         " nodes, expected " + std::to_string(nodes) + " for " + type);
    builder_.add_element(numbers[0], shape, {numbers.begin() + 1, numbers.end()});
  }

  std::string name_;
  MeshLines lines_;
  MeshBuilder builder_;
};

}  // namespace

results::SolidMesh read_inp(const std::filesystem::path& file, double unit) {
  return InpFile(file, unit).read();
}

}  // namespace diefill::process
