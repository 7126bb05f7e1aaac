// STEP and IGES: names, units, and triangles within the chord tolerance of the surfaces they stand for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/cad/mesh_import.h"
#include "geometry/cavity/cavity.h"
#include "geometry/mesh/mesh_check.h"
#include "geometry/wall_spheres/wall_spheres.h"
#include "project_paths.h"
#include "tests/geometry/sample_tool_files.h"
#include "tests/support/temporary_folder.h"

namespace diefill::geometry {
namespace {

const std::string kTools = DIEFILL_SOURCE_DIR "/sample_tools/";

ImportedPart part_of(const std::filesystem::path& file, const std::string& name, double chord = 1.5e-6) {
  ImportOptions options;
  options.part = name;
  options.chord_tolerance = chord;
  return import_part(file, options);
}

TEST(CurvedFaces, PartsKeepNamesUnitAndPlaces) {
  const ImportedPart shoe = part_of(kTools + "stepped_ring/stepped_ring.step", "shoe");
  EXPECT_EQ(shoe.parts, (std::vector<std::string>{"die", "core rod", "lower punch", "shoe"}));
  EXPECT_TRUE(shoe.curved);
  EXPECT_TRUE(shoe.unit_from_file);
  EXPECT_DOUBLE_EQ(shoe.metres_per_unit, 1e-3);
  const Mesh stl = sample::tool("stepped_ring/shoe.stl");
  EXPECT_NEAR(shoe.mesh.volume(), stl.volume(), 1e-13);
  EXPECT_LT((shoe.mesh.bounding_box().upper - stl.bounding_box().upper).norm(), 1e-9);
}

TEST(CurvedFaces, IgesGivesTheSameShoe) {
  const ImportedPart shoe = part_of(kTools + "shoe/shoe.igs", "");
  EXPECT_TRUE(check_mesh(shoe.mesh).usable());
  EXPECT_NEAR(shoe.mesh.volume(), (38 * 56 - 32 * 50) * 37e-9, 1e-13);
}

/// The bytes of that file with metres as the unit of its numbers, which are of millimetres.
std::string in_metres(const std::string& file) {
  std::string text = support::contents(file);
  const std::string millimetre = "SI_UNIT(.MILLI.,.METRE.)";
  for (std::size_t at = text.find(millimetre); at != std::string::npos; at = text.find(millimetre))
    text.replace(at, millimetre.size(), "SI_UNIT($,.METRE.)");
  return text;
}

TEST(CurvedFaces, UnitComesFromTheFile) {
  const support::TemporaryFolder directory;
  const ImportedPart shoe = part_of(directory.write("metres.step", in_metres(kTools + "shoe/shoe.step")), "");
  EXPECT_DOUBLE_EQ(shoe.metres_per_unit, 1);
  EXPECT_NEAR(shoe.mesh.bounding_box().size().x(), 38, 1e-6);
}

TEST(CurvedFaces, OfAPartInAWrongUnitAreReadCoarsely) {
  const support::TemporaryFolder directory;
  const auto file = directory.write("ring.step", in_metres(kTools + "narrow_ring/narrow_ring_d1.88.step"));
  const ImportedPart rod = part_of(file, "core rod");
  EXPECT_NEAR(rod.mesh.bounding_box().size().x(), 16, 1e-2);
  EXPECT_LT(rod.mesh.triangles.size(), 1000U);
}

/// The shoe's STEP file without the units that it states for lengths.
std::string without_unit_of_length() {
  std::string text = support::contents(kTools + "shoe/shoe.step");
  for (const char* unit : {"LENGTH_UNIT()", "NAMED_UNIT(*)", "SI_UNIT(.MILLI.,.METRE.)"})
    if (text.find(unit) == std::string::npos) throw std::logic_error(std::string("no ") + unit);
  // The context refers to its units by number; the one of lengths goes.
  const std::size_t at = text.find("LENGTH_UNIT()");
  const std::size_t line = text.rfind('#', at);
  const std::string number = text.substr(line, text.find('=', line) - line);
  const std::string name = number.substr(0, number.find_last_not_of(' ') + 1);
  const std::size_t list = text.find("GLOBAL_UNIT_ASSIGNED_CONTEXT");
  const std::size_t place = text.find(name + ',', list);
  if (place == std::string::npos) throw std::logic_error("the units are listed in another way");
  return text.erase(place, name.size() + 1);
}

TEST(CurvedFaces, AStepFileWithoutUnitNeedsOne) {
  const support::TemporaryFolder directory;
  const auto file = directory.write("plain.step", without_unit_of_length());
  try {
    part_of(file, "");
    FAIL() << "accepted";
  } catch (const MeshError& error) {
    EXPECT_NE(std::string(error.what()).find("does not state its unit of length: give length_unit"),
              std::string::npos)
        << error.what();
  }
  ImportOptions options;
  options.metres_per_unit = 1e-2;
  const ImportedPart shoe = import_part(file, options);
  EXPECT_FALSE(shoe.unit_from_file);
  EXPECT_NEAR(shoe.mesh.bounding_box().size().x(), 0.38, 1e-6);
}

TEST(CurvedFaces, AParameterOfStepThatIsNoNumberIsNamedWithItsLine) {
  const std::string text = support::contents(kTools + "shoe/shoe.step"), point = "(-19.,-28.,0.)";
  const support::TemporaryFolder directory;
  const auto with = [&](const std::string& other) {
    std::string changed = text;
    changed.replace(changed.find(point), point.size(), other);
    return directory.write("changed.step", changed);
  };
  for (const char* const wrong : {"(-19.,nan,0.)", "(-19.,-28., -nan(ind))", "(INF,-28.,0.)"}) {
    try {
      part_of(with(wrong), "");
      FAIL() << wrong << " is accepted";
    } catch (const MeshError& error) {
      const auto line =
          1 + std::count(text.begin(), text.begin() + static_cast<long>(text.find(point)), '\n');
      EXPECT_NE(std::string(error.what()).find("for a number in line " + std::to_string(line)),
                std::string::npos)
          << error.what();
    }
  }
  // Names may be anything.
  std::string named = text;
  named.replace(named.find("CARTESIAN_POINT('',"), 19, "CARTESIAN_POINT('o''nan, (nan,inf)',");
  EXPECT_NO_THROW(part_of(directory.write("named.step", named), ""));
}

/// The shoe's STEP file with that name of its product.
std::string shoe_called(const std::string& name) {
  std::string text = support::contents(kTools + "shoe/shoe.step");
  const std::string product = "PRODUCT('shoe','shoe'";
  return text.replace(text.find(product), product.size(), "PRODUCT('shoe','" + name + "'");
}

TEST(CurvedFaces, NamesInUtf8Latin1AndAsStepWritesThemAreTheSame) {
  const support::TemporaryFolder directory;
  for (const std::string written : {"Matr\xc3\xa9"
                                    "ce",
                                    "Matr\xe9"
                                    "ce",
                                    "Matr\\X2\\00E9\\X0\\ce", "Matr\\X\\E9ce"}) {
    const ImportedPart part = part_of(directory.write("named.step", shoe_called(written)),
                                      "Matr\xc3\xa9"
                                      "ce");
    EXPECT_EQ(part.parts, std::vector<std::string>{"Matr\xc3\xa9"
                                                   "ce"})
        << written;
    EXPECT_NEAR(part.mesh.volume(), (38 * 56 - 32 * 50) * 37e-9, 1e-13) << written;
  }
}

TEST(CurvedFaces, AMarkOfUtf8IsPassedOver) {
  const support::TemporaryFolder directory;
  const std::string text = "\xef\xbb\xbf" + support::contents(kTools + "shoe/shoe.step");
  EXPECT_NEAR(part_of(directory.write("marked.step", text), "").mesh.volume(), (38 * 56 - 32 * 50) * 37e-9,
              1e-13);
}

TEST(CurvedFaces, TrianglesKeepTheChordTolerance) {
  double before = 0;
  for (const double chord : {2e-5, 5e-6, 1e-6}) {
    const Mesh rod = part_of(kTools + "narrow_ring/narrow_ring_d1.88.step", "core rod", chord).mesh;
    EXPECT_TRUE(check_mesh(rod).usable());
    double deepest = 0;
    for (const auto& triangle : rod.triangles) {
      const auto height = [&](int k) { return rod.vertices[static_cast<std::size_t>(triangle[k])].z(); };
      if (height(0) == height(1) && height(1) == height(2)) continue;  // of an end, not of the wall
      for (int k = 0; k < 3; ++k) {
        const auto& one = rod.vertices[static_cast<std::size_t>(triangle[k])];
        const auto& other = rod.vertices[static_cast<std::size_t>(triangle[(k + 1) % 3])];
        const bool on_wall =
            std::abs(one.head<2>().norm() - 8e-3) < 1e-8 && std::abs(other.head<2>().norm() - 8e-3) < 1e-8;
        if (on_wall && (one - other).head<2>().norm() < 4e-3)
          deepest = std::max(deepest, 8e-3 - ((one + other) / 2).head<2>().norm());
      }
    }
    EXPECT_GT(deepest, 0);
    EXPECT_LT(deepest, chord);
    const double missing = std::numbers::pi * 64e-6 * 25e-3 - rod.volume();
    EXPECT_GT(missing, 0);
    EXPECT_LT(missing, 2 * std::numbers::pi * 8e-3 * 25e-3 * chord);
    EXPECT_GT(static_cast<double>(rod.triangles.size()), before);
    before = static_cast<double>(rod.triangles.size());
  }
}

/// A press as STEP and as STL: file, and the STL of each of the STEP file's tools.
struct Press {
  std::string step;
  std::vector<std::pair<std::string, std::string>> tools;  ///< part, STL file
  double chord_of_stl;  ///< m, how far the STL's facets are inside the true circles
  double depth, wall;   ///< m, m of cavity outline, for what a chord makes of the volume
};

std::vector<Press> presses() {
  return {{"narrow_ring/narrow_ring_d1.88.step",
           {{"die", "narrow_ring/die_d1.88.stl"},
            {"core rod", "narrow_ring/core_rod.stl"},
            {"lower punch", "narrow_ring/punch_d1.88.stl"}},
           1.3e-6,
           20e-3,
           2 * std::numbers::pi * 20.5e-3},
          {"stepped_ring/stepped_ring.step",
           {{"die", "stepped_ring/die.stl"},
            {"core rod", "stepped_ring/core_rod.stl"},
            {"lower punch", "stepped_ring/punch.stl"}},
           1.3e-6,
           20e-3,
           2 * std::numbers::pi * 24e-3},
          {"gear/gear.step",
           {{"die", "gear/die.stl"}, {"core rods", "gear/core_rods.stl"}, {"lower punch", "gear/punch.stl"}},
           3e-6,
           15e-3,
           0.35}};
}

Cavity cavity_of(const std::vector<Mesh>& tools) {
  std::vector<const Mesh*> solids;
  for (const Mesh& tool : tools) solids.push_back(&tool);
  return find_cavity(solids, 0);
}

TEST(CurvedFaces, CavitiesAreThoseOfTheStlFiles) {
  constexpr double kChord = 1.5e-6;
  for (const Press& press : presses()) {
    SCOPED_TRACE(press.step);
    std::vector<Mesh> curved, flat;
    for (const auto& [part, stl] : press.tools) {
      curved.push_back(part_of(kTools + press.step, part, kChord).mesh);
      EXPECT_TRUE(check_mesh(curved.back()).usable()) << part;
      flat.push_back(sample::tool(stl));
      EXPECT_LT((curved.back().bounding_box().upper - flat.back().bounding_box().upper).norm(), 2e-6) << part;
    }
    const Cavity step = cavity_of(curved), stl = cavity_of(flat);
    ASSERT_TRUE(step.found && stl.found);
    // Both facet the same walls, each within its chord; the voxel search adds well below 1 %.
    const double chords = (kChord + press.chord_of_stl) * press.wall * press.depth;
    EXPECT_NEAR(step.volume, stl.volume, chords + 1e-3 * stl.volume);
    EXPECT_NEAR(step.narrowest_width, stl.narrowest_width, 2 * (kChord + press.chord_of_stl));
    EXPECT_EQ(step.is_ring, stl.is_ring);
  }
}

TEST(CurvedFaces, WallSpheresAreAsGoodAsThoseOfTheStlFiles) {
  WallSphereOptions options;
  const Mesh stl = sample::tool("narrow_ring/core_rod.stl");
  const Mesh step = part_of(kTools + "narrow_ring/narrow_ring_d1.88.step", "core rod").mesh;
  const WallSpheres of_stl = make_wall_spheres(stl, options), of_step = make_wall_spheres(step, options);
  const double chords = 3e-6;
  EXPECT_NEAR(static_cast<double>(of_step.centres.size()), static_cast<double>(of_stl.centres.size()),
              0.02 * static_cast<double>(of_stl.centres.size()));
  EXPECT_NEAR(of_step.mean_deviation, of_stl.mean_deviation, chords);
  EXPECT_NEAR(of_step.largest_deviation, of_stl.largest_deviation, chords);
  EXPECT_NEAR(of_step.largest_gap, of_stl.largest_gap, 2 * chords);
}

}  // namespace
}  // namespace diefill::geometry
