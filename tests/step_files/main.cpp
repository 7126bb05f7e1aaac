// Writes the STEP files that tests of the program read: a die of 4 x 4 x 4 mm, turned back by a quarter,
// which an assembly places. A program of its own, because loading OpenCASCADE with every test takes longer
// than most tests.
//   step_files FOLDER    writes nested.step and placed_twice.step
#include <filesystem>

#include "tests/step_files/step_file.h"

int main(int count, char** arguments) {
  using namespace diefill::step_files;
  if (count != 2) return 2;
  const std::filesystem::path folder = arguments[1];
  const StepPart die = {"die", {{-3.5, -6, -5}, {3.5, 15, 0}}, {{{-2, 1, -4}, {2, 5, 1}}}};
  const StepPart shoe = {"shoe", {{-3.1, -3.1, 0}, {3.1, 3.1, 10}}, {{{-2.5, -2.5, -1}, {2.5, 2.5, 11}}}};
  // The die stands in a table, which the press moves back.
  write_step(folder / "nested.step", {die, shoe},
             {{"table", {{"die", {1, {0, 20, -8}}}}},
              {"press", {{"table", {0, {0, -20, 8}}}, {"shoe", {0, {3, 0, 0}}}}}});
  write_step(folder / "placed_twice.step", {die},
             {{"press", {{"die", {1, {0, 0, 0}}}, {"die", {1, {40, 0, 0}}}}}});
}
