#include "tests/geometry/broken_files.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>

#include "project_paths.h"
#include "tests/geometry/mesh_files.h"
#include "tests/geometry/sample_meshes.h"
#include "tests/support/temporary_folder.h"

namespace diefill::geometry::sample {

namespace {

Mesh plain_block() {
  return box({0, 0, 0}, {20, 30, 10});
}

Mesh fine_tube() {
  return tube(8, 12, 10, 90);
}

Mesh with(Mesh mesh, const std::function<void(Mesh&)>& spoil) {
  spoil(mesh);
  return mesh;
}

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  text.replace(text.find(old), old.size(), by);
  return text;
}

std::string cut_after_lines(const std::string& text, int lines) {
  std::size_t end = 0;
  for (int k = 0; k < lines; ++k) end = text.find('\n', end) + 1;
  return text.substr(0, end);
}

std::string sample_step() {
  return support::contents(DIEFILL_SOURCE_DIR "/sample_tools/shoe/shoe.step");
}

std::string with_count(std::string stl, std::uint32_t count) {
  for (std::size_t k = 0; k < 4; ++k) stl[80 + k] = static_cast<char>(count >> (8 * k) & 255U);
  return stl;
}

}  // namespace

std::vector<BrokenFile> broken_bytes() {
  const std::string stl = binary_stl(fine_tube()), text = ascii_stl(fine_tube());
  const std::string archive = three_mf({{"tube", fine_tube()}}, "millimeter");
  return {
      {"no_bytes", "a.stl", "", "is empty"},
      {"binary_cut_short", "a.stl", stl.substr(0, stl.size() / 2), "is truncated: its header declares 720"},
      {"text_cut_short", "a.stl", text.substr(0, text.size() / 2), "without a closing 'endsolid'"},
      {"huge_count", "a.stl", with_count(stl, 0xfffffffe), "header declares 4294967294 triangles"},
      {"count_of_nothing", "a.stl", with_count(stl.substr(0, 84), 0), "a.stl"},
      {"letter", "a.stl", "Dear Sir,\nenclosed is the drawing of the die.\n", "is text, but not STL"},
      {"picture", "a.stl", "\x89PNG\r\n\x1a\n" + std::string(200, '\1'), "actually a PNG picture"},
      {"document", "a.stl", "%PDF-1.4\n" + std::string(200, ' '), "actually a PDF document"},
      {"archive", "a.stl", archive, "actually a ZIP archive"},
      {"step_named_stl", "a.stl", sample_step(), "actually a STEP file"},
      {"web_page", "a.step", "<!DOCTYPE html><html></html>", "actually a web page"},
      {"step_cut_short", "a.step", sample_step().substr(0, 3000), "cannot be read as step"},
      {"step_of_nothing", "a.step", "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n",
       "cannot be read as step"},
      {"iges_of_noise", "a.igs", std::string(800, 'S'), "cannot be read as igs"},
      {"archive_cut_short", "a.3mf", archive.substr(0, archive.size() / 2), "cannot be read as 3mf"},
      {"archive_of_nothing", "a.3mf", zip({{"readme.txt", "nothing"}}), "cannot be read as 3mf"},
      {"unit_that_is_none", "a.amf", amf(fine_tube(), "furlong"), "\"furlong\" in node <unit>"},
      {"huge_ply", "a.ply", replaced(ply(fine_tube()), "vertex 360", "vertex 4000000000"),
       "header declares 4000000000 vertex elements"},
      {"ply_without_end", "a.ply", replaced(ply(fine_tube()), "end_header", "end_heade"),
       "no line 'end_header'"},
      {"ply_cut_short", "a.ply", cut_after_lines(ply(fine_tube()), 9 + 360 + 100),
       "is truncated: it ends before face 101 of 720"},
      {"ply_without_faces", "a.ply", cut_after_lines(ply(fine_tube()), 9 + 340),
       "is truncated: it ends before vertex 341 of 360"},
      {"binary_ply_cut_short", "a.ply",
       binary_ply(fine_tube()).substr(0, binary_ply(fine_tube()).size() - 40),
       "is truncated: it ends before face 717 of 720"},
      {"off_cut_short", "a.off", cut_after_lines(off(fine_tube()), 2 + 360 + 7),
       "is truncated: it ends before face 8 of 720"},
      {"off_without_faces", "a.off", cut_after_lines(off(fine_tube()), 2 + 350),
       "is truncated: it ends before corner 351 of 360"},
      {"huge_off", "a.off", replaced(off(fine_tube()), "360 720", "360 4000000000"),
       "header declares 4000000000 faces"},
      {"points_only", "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "a.obj"},
      {"corner_that_is_not_there", "a.off", replaced(off(plain_block()), "3 0 2 3", "3 0 2 99"),
       "has the corner 99, but its 8 corners are counted from 0"},
      {"face_of_ten_corners", "a.off",
       "OFF\n10 1 0\n" +
           [] {
             std::string corners;
             for (int k = 0; k < 10; ++k) corners += std::to_string(k) + " " + std::to_string(k * k) + " 0\n";
             return corners;
           }() +
           "10 0 1 2 3 4 5 6 7 8 9\n",
       "face 1 has 10 corners, allowed in OFF: up to 9"},
      {"decimal_comma_3mf", "a.3mf",
       replaced(three_mf({{"block", plain_block()}}, "millimeter"), "x=\"20\"", "x=\"2,\""),
       "found x = '2,' with a comma"},
      {"decimal_comma_amf", "a.amf", replaced(amf(plain_block(), "millimeter"), "<x>20", "<x>20,5"),
       "found x = '20,5' with a comma"},
      {"gltf_of_whole_numbers", "a.gltf", replaced(gltf(fine_tube(), "t"), "5126", "5122"),
       "its corners are whole numbers (KHR_mesh_quantization), which are not supported: switch quantization "
       "off"},
      {"glb_of_whole_numbers", "a.glb", replaced(glb(fine_tube(), "t"), "5126", "5121"),
       "its corners are whole numbers (KHR_mesh_quantization)"},
      {"gltf_with_packed_corners", "a.gltf",
       replaced(gltf(fine_tube(), "t"), "{\"asset\"",
                "{\"extensionsRequired\":[\"EXT_meshopt_compression\"],\"asset\""),
       "it requires EXT_meshopt_compression, which is not supported: switch compression off"},
      {"gltf_without_its_buffer", "a.gltf",
       replaced(gltf(fine_tube(), "t"), "data:application/octet-stream;base64,", "missing.bin?"),
       "cannot be read as gltf"},
      {"glb_cut_short", "a.glb", glb(fine_tube(), "t").substr(0, 900), "cannot be read as glb"},
      {"collada_cut_short", "a.dae", collada(fine_tube(), 1e-3).substr(0, 2000), "cannot be read as dae"},
      {"not_a_number", "a.stl",
       binary_stl(with(fine_tube(), [](Mesh& m) { m.vertices[3].y() = std::nan(""); })),
       "corner with a non-finite coordinate"},
      {"infinite", "b.stl",
       binary_stl(
           with(fine_tube(), [](Mesh& m) { m.vertices[9].x() = std::numeric_limits<double>::infinity(); })),
       "corner with a non-finite coordinate"},
  };
}

std::vector<BrokenFile> broken_meshes() {
  const auto stl = [](const Mesh& mesh) { return binary_stl(mesh); };
  const Mesh far = box({40, 0, 0}, {50, 10, 10});
  return {
      {"small_hole", "a.stl",
       stl(with(fine_tube(), [](Mesh& m) { m.triangles.erase(m.triangles.begin() + 40); })),
       "the surface has a hole", "a hole of"},
      {"open_shell", "a.stl", stl(with(plain_block(), [](Mesh& m) { m.triangles.resize(10); })),
       "the surface has a hole"},
      {"sheet", "a.obj", "v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\nf 1 2 3\nf 1 3 4\n", "4 open edges"},
      {"flipped_face", "a.stl",
       stl(with(fine_tube(), [](Mesh& m) { std::swap(m.triangles[10][0], m.triangles[10][1]); })),
       "triangles are flipped", "neighbours agree"},
      {"inside_out", "a.stl", stl(inside_out(fine_tube())), "whole surface is inside out", "point outward"},
      {"one_shell_inside_out", "a.stl", stl(joined(fine_tube(), inside_out(far))),
       "1 shell faces the wrong way", "1 shell reversed"},
      {"edge_of_four_triangles", "a.stl", stl(joined(plain_block(), box({20, 30, 0}, {25, 35, 10}))),
       "1 edge shared by more than two triangles"},
      {"fin", "a.stl",
       stl(with(plain_block(),
                [](Mesh& m) {
                  m.vertices.emplace_back(-9, -9, 5);
                  m.triangles.emplace_back(0, 1, 8);
                })),
       "shared by more than two triangles"},
      {"through_itself", "a.stl", stl(prism({{0, 0}, {10, 10}, {10, 0}, {0, 10}}, {5, 5}, 10)),
       "triangles that cross"},
      {"overlapping_shells", "a.stl", stl(joined(plain_block(), box({5.1, 5.2, 5.3}, {9.4, 9.5, 20}))),
       "the surface passes through itself", "2 shells that overlap united"},
      {"sliver", "a.stl",
       stl(with(plain_block(),
                [](Mesh& m) {
                  m.vertices.emplace_back(10, 0, 0);  // in the middle of an edge
                  m.triangles[4] = {0, 8, 5};         // split on one side only
                  m.triangles.emplace_back(8, 1, 5);
                  m.triangles.emplace_back(0, 1, 8);
                })),
       "1 triangle without area"},
      {"loose_corners", "a.obj",
       [] {
         Mesh soup;
         for (const auto& t : fine_tube().triangles) {
           const int first = static_cast<int>(soup.vertices.size());
           for (int k = 0; k < 3; ++k)
             soup.vertices.push_back(fine_tube().vertices[static_cast<std::size_t>(t[k])] +
                                     Eigen::Vector3d(0, 0, 3e-5 * (first / 3 % 4)));
           soup.triangles.emplace_back(first, first + 1, first + 2);
         }
         return obj(soup);
       }(),
       "open edges", "welded"},
  };
}

}  // namespace diefill::geometry::sample
