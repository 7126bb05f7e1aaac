// Prints how a scene fills its die.
#include <diefill/process/scene/scene.h>

#include <cstdio>

int main(int, char** words) {
  std::printf("%s\n", diefill::process::strategy_text(diefill::process::read_scene(words[1])).c_str());
}
