// Feeds damaged CAD files to the importers, the check and the repair, and reports what happened: anything but
// a mesh or one MeshError is a failure. Not a test of CI: `bin/import_fuzz SECONDS [SEED]`. Built with
// clang's -fsanitize=fuzzer and -DDIEFILL_LIBFUZZER it is guided by coverage instead (fuzz/build_guided.sh),
// and begins with the same seeds.
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>

#include "geometry/mesh_import.h"
#include "geometry/mesh_repair.h"
#include "tests/geometry/mesh_files.h"
#include "tests/geometry/sample_meshes.h"
#include "tests/support/temporary_folder.h"

namespace diefill::geometry {
namespace {

constexpr std::size_t kMostToRepair = 20000;  // triangles: beyond it an input only costs time

struct Seed {
  std::string ending, bytes;
};

std::vector<Seed> seeds() {
  const Mesh tube = sample::tube(8, 12, 10, 12), box = sample::box({0, 0, 0}, {1, 2, 3});
  const std::vector<sample::NamedMesh> parts = {{"die", box}, {"punch", tube}};
  return {{"stl", sample::binary_stl(tube)},
          {"stl", sample::stl_of_parts(parts)},
          {"obj", sample::obj_of_parts(parts)},
          {"ply", sample::ply(box)},
          {"off", sample::off(tube)},
          {"3mf", sample::three_mf(parts, "millimeter")},
          {"amf", sample::amf(box, "inch")},
          {"dae", sample::collada(box, 1e-3)},
          {"gltf", sample::gltf(box, "die")},
          {"step", support::contents(DIEFILL_SOURCE_DIR "/sample_tools/shoe/shoe.step")},
          {"igs", support::contents(DIEFILL_SOURCE_DIR "/sample_tools/shoe/shoe.igs")}};
}

/// What is left of the file name in messages, so that like failures count as one.
std::string outcome_of(const std::filesystem::path& file) {
  ImportOptions options;
  const std::string ending = file.extension().string();
  if (ending == ".stl" || ending == ".obj" || ending == ".ply" || ending == ".off")
    options.metres_per_unit = 1e-3;
  try {
    const Mesh mesh = import_part(file, options).mesh;
    const MeshFindings findings = check_mesh(mesh);
    if (mesh.triangles.size() > kMostToRepair) return "read, too large to repair";
    const RepairedMesh repaired = repair_mesh(mesh, findings, {});
    if (findings.usable()) return "read, usable";
    return repaired.findings.usable() ? "read, repaired" : "read, not usable";
  } catch (const MeshError& error) {
    const std::string words = error.what();
    for (const char* kind : {"crashed", "does not come to an end", "more memory"})
      if (words.find(kind) != std::string::npos) return std::string("refused, importer ") + kind;
    return "refused";
  }
}

/// Damages files as transport, editors and attackers do.
class Damage {
 public:
  explicit Damage(std::uint64_t seed) : random_(seed) {}

  std::string of(std::string bytes) {
    const int blows = 1 + pick(6);
    for (int blow = 0; blow < blows && !bytes.empty(); ++blow) strike(bytes);
    return bytes;
  }
  std::size_t pick(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
  }

 private:
  void strike(std::string& bytes) {
    const std::size_t at = pick(bytes.size());
    const std::size_t length = std::min(bytes.size() - at, 1 + pick(64));
    static const char* const kWords[] = {"nan", "1e308", "-1", "4294967295", "0", "2147483648",
                                         "inf", "\n",    " ",  "<",          "#"};
    switch (pick(8)) {
      case 0:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << pick(8)));
        break;
      case 1:
        bytes[at] = static_cast<char>(pick(256));
        break;
      case 2:
        bytes.erase(at, length);
        break;
      case 3:
        bytes.insert(pick(bytes.size()), bytes.substr(at, length));
        break;
      case 4:
        bytes.resize(at);
        break;
      case 5:
        bytes.replace(at, std::min<std::size_t>(length, 1 + pick(10)), kWords[pick(std::size(kWords))]);
        break;
      case 6:
        for (std::size_t k = 0; k < std::min<std::size_t>(4, bytes.size() - at); ++k) bytes[at + k] = '\xff';
        break;
      default:
        replace_number(bytes, at);
    }
  }

  /// The number at or after a place becomes another one.
  void replace_number(std::string& bytes, std::size_t at) {
    const std::size_t begin = bytes.find_first_of("0123456789", at);
    if (begin == std::string::npos) return;
    const std::size_t end = bytes.find_first_not_of("0123456789", begin);
    bytes.replace(begin, (end == std::string::npos ? bytes.size() : end) - begin,
                  std::to_string(pick(100000)));
  }

  std::mt19937_64 random_;
};

}  // namespace
}  // namespace diefill::geometry

#ifdef DIEFILL_LIBFUZZER

namespace {

/// The first byte of an input says what kind of file the rest is.
const char* const kEndings[] = {"stl", "obj", "ply", "off", "3mf", "amf", "dae", "gltf", "step", "igs"};

}  // namespace

/// Puts the seeds into the corpus: the folder named last.
extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
  using namespace diefill;
  const std::filesystem::path corpus = (*arguments)[*count - 1];
  if (*count < 2 || !std::filesystem::is_directory(corpus)) return 0;
  std::size_t number = 0;
  for (const auto& seed : geometry::seeds()) {
    const auto kind = std::find(std::begin(kEndings), std::end(kEndings), seed.ending) - std::begin(kEndings);
    std::ofstream file(corpus / ("seed" + std::to_string(number++)), std::ios::binary);
    file << static_cast<char>(kind) << seed.bytes;
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace diefill;
  static const support::TemporaryFolder folder;
  if (size < 2) return 0;
  const std::string bytes(reinterpret_cast<const char*>(data + 1), size - 1);
  geometry::outcome_of(folder.write(std::string("input.") + kEndings[data[0] % std::size(kEndings)], bytes));
  return 0;
}

#else

int main(int count, char** arguments) {
  using namespace diefill;
  using Clock = std::chrono::steady_clock;
  const double seconds = count > 1 ? std::atof(arguments[1]) : 60;
  geometry::Damage damage(count > 2 ? std::strtoull(arguments[2], nullptr, 10) : 1);
  const support::TemporaryFolder folder;
  const auto seeds = geometry::seeds();
  std::map<std::string, std::size_t> outcomes;
  const auto start = Clock::now();
  const auto since = [](Clock::time_point then) {
    return std::chrono::duration<double>(Clock::now() - then).count();
  };
  double longest = 0;
  std::size_t inputs = 0;
  for (; since(start) < seconds; ++inputs) {
    const auto& seed = seeds[damage.pick(seeds.size())];
    const auto file = folder.write("input." + seed.ending, damage.of(seed.bytes));
    const auto begun = Clock::now();
    ++outcomes[seed.ending + ": " + geometry::outcome_of(file)];
    longest = std::max(longest, since(begun));
  }
  for (const auto& [outcome, times] : outcomes) std::printf("%8zu  %s\n", times, outcome.c_str());
  rusage self{}, children{};
  getrusage(RUSAGE_SELF, &self);
  getrusage(RUSAGE_CHILDREN, &children);
  std::printf("%zu inputs in %.0f s; longest %.2f s; largest memory %.0f MB here, %.0f MB in a child\n",
              inputs, since(start), longest, 1e-3 * static_cast<double>(self.ru_maxrss),
              1e-3 * static_cast<double>(children.ru_maxrss));
  return 0;
}

#endif
