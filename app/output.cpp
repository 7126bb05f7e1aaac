#include "app/output.h"

#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>

#include "process/results/result_file.h"

namespace diefill::app {

void make_output_directory(const std::filesystem::path& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (!error && ::access(directory.c_str(), W_OK) != 0)
    error = std::error_code(errno, std::generic_category());
  if (error)
    throw std::runtime_error("cannot write into " + directory.string() + ": " + error.message() +
                             "; name another directory with --out");
}

void write_output(const std::function<void()>& write) {
  try {
    write();
  } catch (const results::ResultError& error) {
    throw std::runtime_error(error.what());
  }
}

}  // namespace diefill::app
