// Reads results from a folder that has none, and prints what is said of that.
#include <diefill/process/results/storage/result_file.h>

#include <cstdio>

int main(int, char** words) {
  try {
    diefill::results::read_results(words[1]);
  } catch (const diefill::results::ResultError& error) {
    std::printf("%s\n", error.what());
  }
}
