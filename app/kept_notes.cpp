#include "app/kept_notes.h"

#include <cstdio>

namespace diefill::app {

void say_note(const std::string& line) {
  std::fprintf(stderr, "%s\n", line.c_str());
}

void say_what_is_kept(const std::optional<std::filesystem::path>& folder) {
  if (folder)
    say_note("note: earlier tables of runs that are not part of this call were moved to " + folder->string());
}

}  // namespace diefill::app
