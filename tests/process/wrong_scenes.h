// Scenes with one fault each, and what the user must be told about it. Data, so that the reader and the whole
// program can be tried on the same cases.
#pragma once

#include <vector>

#include "tests/process/wrong_scene.h"
#include "tests/process/wrong_scenes_contact.h"
#include "tests/process/wrong_scenes_powder.h"
#include "tests/process/wrong_scenes_process.h"
#include "tests/process/wrong_scenes_sizes.h"
#include "tests/process/wrong_scenes_text.h"
#include "tests/process/wrong_scenes_tools.h"

namespace diefill::process {

/// All of them, each with a name of its own.
inline std::vector<WrongScene> wrong_scenes() {
  std::vector<WrongScene> all;
  for (const auto& some :
       {wrong_documents(), wrong_syntax(), wrong_settings(), wrong_powders(), wrong_sizes(), wrong_walls(),
        wrong_contacts(), wrong_tools(), wrong_pours(), wrong_steps(), wrong_numerics(), wrong_economies(),
        wrong_suctions(), wrong_measures()}) {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

}  // namespace diefill::process
