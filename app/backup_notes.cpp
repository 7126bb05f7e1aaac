#include "app/backup_notes.h"

#include <cstdio>

namespace diefill::app {

void print_note(const std::string& line) {
  std::fprintf(stderr, "%s\n", line.c_str());
}

void note_moved_results(const std::optional<std::filesystem::path>& folder) {
  if (folder)
    print_note("note: earlier tables of runs that are not part of this call were moved to " +
               folder->string());
}

}  // namespace diefill::app
