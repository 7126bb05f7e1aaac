#include "process/input/toml_bounds.h"

#include <algorithm>
#include <string_view>

#include "process/input/scene_error.h"

namespace diefill::process {
namespace {

constexpr int kMaxDots = 16, kMaxBrackets = 16;  // scenes use four of either

/// Goes through TOML text without its strings and comments, and counts.
class NestingCount {
 public:
  NestingCount(std::string_view text, const std::filesystem::path& file) : text_(text), file_(file) {}

  void check() {
    while (at_ < text_.size()) {
      const char letter = text_[at_];
      if (letter == '"' || letter == '\'')
        skip_string(letter);
      else if (letter == '#')
        skip_to(text_.find('\n', at_));
      else
        count(letter);
    }
  }

 private:
  void skip_to(std::size_t place) { at_ = std::min(place, text_.size()); }

  void skip_string(char quote) {
    const std::string three(3, quote);
    if (text_.substr(at_).starts_with(three)) return skip_long_string(three);
    for (++at_; at_ < text_.size() && text_[at_] != '\n'; ++at_) {
      if (text_[at_] == '\\' && quote == '"' && text_.substr(at_ + 1, 1) != "\n") {
        ++at_;
      } else if (text_[at_] == quote) {
        ++at_;
        return;
      }
    }
  }

  void skip_long_string(const std::string& three) {
    const std::size_t begin = at_, first_line = line_;
    at_ += three.size();
    while (at_ < text_.size() && !text_.substr(at_).starts_with(three)) {
      const bool is_escape = text_[at_] == '\\' && three[0] == '"' && text_.substr(at_ + 1, 1) != "\n";
      if (text_[at_] == '\n') ++line_;
      at_ += is_escape ? 2 : 1;
    }
    if (at_ >= text_.size()) refuse_unclosed(three, begin, first_line);
    skip_to(at_ + three.size());
  }

  void count(char letter) {
    ++at_;
    if (letter == '.') {
      if (++dots_ > kMaxDots)
        refuse("a key of more than " + std::to_string(kMaxDots) + " parts joined by dots");
      return;
    }
    if (letter == '\n') {
      ++line_;
      // An unclosed bracket is a separate error, which the parser reports.
    } else if (letter == '[' || letter == '{') {
      if (++brackets_ > kMaxBrackets)
        refuse("brackets nested more than " + std::to_string(kMaxBrackets) + " deep");
    } else if (letter == ']' || letter == '}') {
      brackets_ = std::max(0, brackets_ - 1);
    } else if (letter != ',' && letter != '=') {
      return;
    }
    dots_ = 0;
  }

  /// The parser would report the end of the file instead of the place where the text begins.
  [[noreturn]] void refuse_unclosed(const std::string& quotes, std::size_t begin, std::size_t line) const {
    const std::size_t end_before = begin == 0 ? std::string_view::npos : text_.rfind('\n', begin - 1);
    const std::size_t column = begin - (end_before == std::string_view::npos ? 0 : end_before + 1) + 1;
    throw SceneError(file_.string() + ':' + std::to_string(line) + ':' + std::to_string(column) + ": found " +
                     quotes + ", which begin a text that is never closed; write " + quotes +
                     " where it ends, or one quote on either side of a single-line text");
  }

  [[noreturn]] void refuse(const std::string& found) const {
    throw SceneError(file_.string() + ':' + std::to_string(line_) + ": found " + found +
                     ", but no scene needs more than four; is this a scene?");
  }

  std::string_view text_;
  const std::filesystem::path& file_;
  std::size_t at_ = 0, line_ = 1;
  int dots_ = 0, brackets_ = 0;
};

}  // namespace

void refuse_deep_nesting(const std::string& text, const std::filesystem::path& file) {
  NestingCount(text, file).check();
}

}  // namespace diefill::process
