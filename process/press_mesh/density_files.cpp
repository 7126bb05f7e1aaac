#include "process/press_mesh/density_files.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

#include "process/results/storage/atomic_file.h"

namespace diefill::process {
namespace {

constexpr int kDigits = 9;  // sums of masses keep the cavity's to 1e-6

std::ostringstream text_of_numbers() {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(kDigits);
  return text;
}

void add_place(std::ostringstream& text, const Eigen::Vector3d& place) {
  text << ',' << place.x() << ',' << place.y() << ',' << place.z();
}

Eigen::Vector3d middle_of(const results::SolidMesh& mesh, const results::SolidElement& element) {
  const int nodes = results::kind_of(element.shape).nodes;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int n = 0; n < nodes; ++n) sum += mesh.nodes[element.nodes[static_cast<std::size_t>(n)]];
  return sum / nodes;
}

std::string elements_csv(const results::SolidMesh& mesh, const ElementDensity& density) {
  std::ostringstream text = text_of_numbers();
  text << "element,x [m],y [m],z [m],volume [m^3],relative density [1],density [kg/m^3],mass [kg],share in "
          "powder [1]\n";
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    text << mesh.elements[e].number;
    add_place(text, middle_of(mesh, mesh.elements[e]));
    text << ',' << density.volume[e] << ',' << density.relative[e] << ','
         << density.relative[e] * density.solid_density << ',' << density.mass[e] << ',' << density.filled[e]
         << '\n';
  }
  return text.str();
}

std::string nodes_csv(const results::SolidMesh& mesh, const ElementDensity& density) {
  std::ostringstream text = text_of_numbers();
  text << "node,x [m],y [m],z [m],volume [m^3],relative density [1],density [kg/m^3]\n";
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    text << mesh.node_numbers[n];
    add_place(text, mesh.nodes[n]);
    text << ',' << density.node_volume[n] << ',' << density.node_relative[n] << ','
         << density.node_relative[n] * density.solid_density << '\n';
  }
  return text.str();
}

std::string numbers_csv(const std::string& heading, const std::vector<std::uint64_t>& numbers) {
  std::string text = heading + '\n';
  for (const std::uint64_t number : numbers) text += std::to_string(number) + '\n';
  return text;
}

/// A text of the user's as part of a comment line.
std::string in_comment(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char letter) { return letter < ' '; }, ' ');
  return text;
}

std::string cards(const results::SolidMesh& mesh, const ElementDensity& density, const DensityNote& note,
                  const std::string& type, const std::string& meaning) {
  std::ostringstream text = text_of_numbers();
  text << "** Relative density (density over that of the solid, " << density.solid_density
       << " kg/m^3) after filling\n** run: " << in_comment(note.title)
       << "\n** mesh: " << in_comment(note.mesh) << "\n** " << meaning << "\n";
  if (!density.outside.empty())
    text << "** " << density.outside.size()
         << " elements lie outside the powder; nodes of such elements alone have no value\n";
  if (!density.above.empty())
    text << "** WARNING: " << density.above.size()
         << " elements are denser than the solid (relative density above 1)\n";
  text << "*INITIAL CONDITIONS, TYPE=" << type << '\n';
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    if (density.node_relative[n] > 0)
      text << mesh.node_numbers[n] << ", " << density.node_relative[n] << '\n';
  return text.str();
}

}  // namespace

std::string file_stem(const std::filesystem::path& file) {
  std::string stem = file.stem().string();
  std::replace_if(
      stem.begin(), stem.end(),
      [](unsigned char letter) {
        const bool plain = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                           (letter >= '0' && letter <= '9') || letter == '-';
        return !plain;
      },
      '_');
  return stem;
}

std::vector<std::filesystem::path> write_density_files(const std::filesystem::path& folder,
                                                       const std::string& stem,
                                                       const results::SolidMesh& mesh,
                                                       const ElementDensity& density,
                                                       const DensityNote& note) {
  std::vector<std::filesystem::path> written;
  const auto write = [&](const std::string& ending, const std::string& text) {
    written.push_back(folder / (stem + ending));
    results::write_text_atomically(written.back(), text);
  };
  write("_density_elements.csv", elements_csv(mesh, density));
  write("_density_nodes.csv", nodes_csv(mesh, density));
  write("_density_abaqus.inp", cards(mesh, density, note, "RELATIVE DENSITY",
                                     "for *POROUS METAL PLASTICITY without its own RELATIVE DENSITY"));
  write("_density_calculix.inp",
        cards(mesh, density, note, "TEMPERATURE",
              "CalculiX has no relative density: it is given as temperature, on which materials can depend"));
  write("_density_outside.csv", numbers_csv("element outside the powder", density.outside));
  if (!density.above.empty())
    write("_density_above_solid.csv", numbers_csv("element denser than its solid", density.above));
  return written;
}

}  // namespace diefill::process
