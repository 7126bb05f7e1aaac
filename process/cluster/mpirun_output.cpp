#include "process/cluster/mpirun_output.h"

#include <algorithm>

namespace diefill::process::cluster {

namespace {

bool is_ruler(const std::string& line) {
  constexpr std::size_t kShortest = 20;
  return line.size() >= kShortest && line.find_first_not_of('-') == std::string::npos;
}

bool is_blank(const std::string& line) {
  return line.find_first_not_of(" \t\r") == std::string::npos;
}

/// mpirun says these of every program that returns an error.
bool tells_nothing(const std::string& block) {
  return block.empty() || block.starts_with("Primary job") || block.starts_with("mpirun detected that");
}

}  // namespace

bool MpirunOutput::is_of_program(const std::string& line) {
  if (line == kRanksBegin) {
    begun_ = true;
    return false;
  }
  if (line.starts_with("diefill: ")) {
    reported_error_ = true;
    return true;
  }
  if (is_ruler(line)) {
    in_block_ = !in_block_;
    paragraph_over_ = false;
    if (in_block_) blocks_.emplace_back();
    return false;
  }
  if (in_block_) {
    paragraph_over_ = paragraph_over_ || is_blank(line);
    if (!paragraph_over_) blocks_.back() += (blocks_.back().empty() ? "" : " ") + line;
    return false;
  }
  if (line.starts_with("mpirun: Forwarding signal")) return false;
  if (begun_) return true;
  if (!is_blank(line)) last_word_ = line;
  return false;
}

std::string MpirunOutput::reason() const {
  std::string reason = last_word_;
  const auto noticed = std::find_if(blocks_.begin(), blocks_.end(),
                                    [](const auto& block) { return block.starts_with("mpirun noticed"); });
  if (noticed != blocks_.end()) reason = *noticed;
  const auto first = std::find_if_not(blocks_.begin(), blocks_.end(), tells_nothing);
  if (reason.empty() && first != blocks_.end()) reason = *first;
  while (!reason.empty() && std::string_view(".: \r").find(reason.back()) != std::string_view::npos)
    reason.pop_back();
  return reason;
}

}  // namespace diefill::process::cluster
