#include "geometry/cad/read_text_stl.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "geometry/cad/shown_text.h"
#include "geometry/mesh/equal_vertices.h"

namespace diefill::geometry {

namespace {

constexpr std::size_t kLookForText = 1024;  // a text file shows its first facet within so many bytes
constexpr std::size_t kHeader = 84;         // of a binary file
constexpr std::size_t kShownWord = 30;
constexpr std::string_view kMark = "\xef\xbb\xbf";
constexpr std::string_view kBlanks = " \t\r\v\f";

bool is_blank(char letter) {
  return letter == '\n' || kBlanks.find(letter) != std::string_view::npos;
}

char lower(char letter) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
}

bool same_word(std::string_view word, std::string_view lower_case) {
  return word.size() == lower_case.size() && std::equal(word.begin(), word.end(), lower_case.begin(),
                                                        [](char a, char b) { return lower(a) == b; });
}

/// Words of a text, which keep the line they stand in.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}
  std::size_t line() const { return line_; }

  /// The next word; empty at the end.
  std::string_view next() {
    for (; at_ < text_.size(); ++at_) {
      const char letter = text_[at_];
      if (letter == '\n') ++line_;
      if (letter == '#' || letter == ';')
        skip_line();
      else if (!is_blank(letter))
        break;
    }
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_blank(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  /// The rest of the line without blanks round it, up to a facet where that stands in the same line.
  std::string_view rest_of_line() {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    std::string_view rest = text_.substr(at_, end - at_);
    const auto facet = [&](std::string_view from) {
      for (std::size_t k = 0; k + 13 <= from.size(); ++k)
        if (is_blank(from[k]) && same_word(from.substr(k + 1, 12), "facet normal")) return k;
      return from.size();
    };
    rest = rest.substr(0, facet(rest));
    at_ += rest.size();
    const std::size_t first = rest.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) return {};
    return rest.substr(first, rest.find_last_not_of(kBlanks) - first + 1);
  }

 private:
  void skip_line() {
    while (at_ + 1 < text_.size() && text_[at_ + 1] != '\n') ++at_;
  }

  std::string_view text_;
  std::size_t at_ = 0, line_ = 1;
};

[[noreturn]] void refuse(std::size_t line, const std::string& what) {
  throw std::runtime_error("line " + std::to_string(line) + ": " + what);
}

/// Builds facets, solid by solid.
class Reader {
 public:
  explicit Reader(std::string_view text) : words_(text) {}

  CadParts read() {
    for (std::string_view word = words_.next(); !word.empty(); word = words_.next()) {
      if (same_word(word, "vertex")) add_corner();
      if (same_word(word, "endloop") || same_word(word, "endfacet")) end_facet();
      if (same_word(word, "solid")) begin_part(std::string(words_.rest_of_line()));
      if (same_word(word, "endsolid")) words_.rest_of_line();
    }
    if (!facet_.empty()) refuse(words_.line(), "the file ends within a facet");
    finish_part();
    return std::move(contents_);
  }

 private:
  void add_corner() {
    Eigen::Vector3d corner;
    for (double& number : corner) {
      const std::string_view word = words_.next();
      if (!is_number(word, number))
        refuse(words_.line(), "a corner needs three numbers, found '" + shown(word, kShownWord) + "'" +
                                  (word.find(',') != std::string_view::npos ? " with a comma" : ""));
      number += 0.0;  // makes one of both zeros
    }
    facet_.push_back(static_cast<int>(places_.add(corner)));
  }

  void end_facet() {
    if (facet_.empty()) return;
    if (facet_.size() < 3) refuse(words_.line(), "a facet has fewer than three corners");
    for (std::size_t k = 2; k < facet_.size(); ++k)
      triangles_.emplace_back(facet_[0], facet_[k - 1], facet_[k]);
    facet_.clear();
  }

  void begin_part(std::string name) {
    if (!facet_.empty()) refuse(words_.line(), "a solid begins within a facet");
    finish_part();
    name_ = std::move(name);
  }

  void finish_part() {
    if (triangles_.empty()) return;
    contents_.parts.push_back({name_, {places_.take_places(), std::move(triangles_)}});
    places_ = {};
    triangles_.clear();
  }

  Words words_;
  CadParts contents_;
  std::string name_;
  EqualVertices places_;
  std::vector<Eigen::Vector3i> triangles_;
  std::vector<int> facet_;
};

std::string_view without_mark(std::string_view text) {
  return text.substr(text.starts_with(kMark) ? kMark.size() : 0);
}

/// The text from the first line on that is no comment.
std::string_view after_comments(std::string_view text) {
  for (;;) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return {};
    text.remove_prefix(first);
    if (text.front() != '#' && text.front() != ';') return text;
    text.remove_prefix(std::min(text.find('\n'), text.size()));
  }
}

/// Unlike binary triangles: the name of a solid may be longer than what is looked at.
bool is_printable(std::string_view text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return static_cast<unsigned char>(c) >= 0x20 || is_blank(c); });
}

}  // namespace

bool is_number(std::string_view word, double& number) {
  std::string text(word.substr(word.starts_with('+') ? 1 : 0));
  const std::size_t exponent = text.find_first_of("dD");
  if (exponent != std::string::npos && exponent > 0) text[exponent] = 'e';
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error == std::errc::result_out_of_range)
    number = text.find("e-") != std::string::npos || text.find("E-") != std::string::npos
                 ? 0
                 : std::numeric_limits<double>::infinity();
  return error != std::errc::invalid_argument && stop == end;
}

bool is_text_stl(const std::string& bytes) {
  std::string start(after_comments(without_mark(bytes)).substr(0, kLookForText));
  std::transform(start.begin(), start.end(), start.begin(), lower);
  if (start.find('\0') != std::string::npos) return false;
  const std::size_t word = start.find_first_not_of(" \t\r\n");
  if (word == std::string::npos || start.compare(word, 5, "solid") != 0) return false;
  return start.find("facet") != std::string::npos || start.find("endsolid") != std::string::npos ||
         bytes.size() < kHeader || is_printable(start);
}

CadParts read_text_stl(const std::string& bytes) {
  return Reader(without_mark(bytes)).read();
}

}  // namespace diefill::geometry
