#include <dlfcn.h>

#include <string>
#include <string_view>

#include "geometry/cad/cad_file.h"
#include "geometry/cad/cad_readers.h"
#include "geometry/cad/mesh_import.h"
#include "geometry/cad/opencascade/step_and_iges.h"
#include "geometry/cad/shown_text.h"

namespace diefill::geometry {

namespace {

using Reader = decltype(&diefill_read_step_or_iges);

[[noreturn]] void refuse() {
  const char* const why = dlerror();
  throw MissingLibrary("STEP and IGES cannot be read, because a library is missing (" +
                       std::string(why == nullptr ? DIEFILL_OPENCASCADE : why) +
                       "): install diefill again, or export the parts as STL");
}

/// The library lies where the run path of the program says: in lib/diefill, beside bin.
Reader load() {
  void* const library = dlopen(DIEFILL_OPENCASCADE, RTLD_LAZY | RTLD_LOCAL);
  if (library == nullptr) refuse();
  void* const symbol = dlsym(library, "diefill_read_step_or_iges");
  if (symbol == nullptr) refuse();
  return reinterpret_cast<Reader>(symbol);
}

/// OpenCASCADE 7.6 takes STEP for UTF-8, reads no mark of it, and loses names in other encodings.
std::string step_text(std::string bytes) {
  constexpr std::string_view kMark = "\xef\xbb\xbf";
  if (bytes.starts_with(kMark)) bytes.erase(0, kMark.size());
  return as_utf8(bytes);
}

Reader reader() {
  static const Reader loaded = load();
  return loaded;
}

}  // namespace

void load_opencascade() {
  reader();
}

CadParts read_curved_faces(const std::filesystem::path& file, const CadFormat& format,
                           double chord_tolerance) {
  CadParts contents;
  const bool is_step = format.ending.starts_with("st");
  reader()(file, is_step ? step_text(read_cad_file(file)) : "", format, chord_tolerance, contents);
  return contents;
}

}  // namespace diefill::geometry
