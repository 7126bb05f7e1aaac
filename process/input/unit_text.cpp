#include "process/input/unit_text.h"

#include <array>
#include <cctype>
#include <utility>

#include "process/input/shown_value.h"
#include "process/results/trimmed.h"

namespace diefill::process {
namespace {

constexpr std::size_t kLongest = 80;  // bytes; no unit of a scene takes half of it

bool is_digit(char letter) {
  return std::isdigit(static_cast<unsigned char>(letter)) != 0;
}

bool begins_name(char letter) {
  return std::isalpha(static_cast<unsigned char>(letter)) != 0 || (letter & 0x80) != 0 || letter == '%' ||
         letter == '\'' || letter == '"';
}

/// Digits and signs that are written raised.
constexpr std::array<std::pair<std::string_view, char>, 12> kSuperscripts = {{{"\u2070", '0'},
                                                                              {"\u00b9", '1'},
                                                                              {"\u00b2", '2'},
                                                                              {"\u00b3", '3'},
                                                                              {"\u2074", '4'},
                                                                              {"\u2075", '5'},
                                                                              {"\u2076", '6'},
                                                                              {"\u2077", '7'},
                                                                              {"\u2078", '8'},
                                                                              {"\u2079", '9'},
                                                                              {"\u207a", '+'},
                                                                              {"\u207b", '-'}}};

/// The superscript that `text` begins with; null where there is none.
const std::pair<std::string_view, char>* superscript_at(std::string_view text) {
  for (const auto& superscript : kSuperscripts)
    if (text.starts_with(superscript.first)) return &superscript;
  return nullptr;
}

/// One unit text, read from left to right.
class UnitReader {
 public:
  explicit UnitReader(std::string_view text) : text_(text) {}

  ParsedUnit whole() {
    Unit unit = begins_with_one_over() ? Unit(ut_get_dimensionless_unit_one(unit_system())) : factor();
    unit = product(std::move(unit));
    if (!rest().empty()) refuse_rest();
    return {std::move(unit), angles_};
  }

 private:
  std::string_view rest() const { return text_.substr(at_); }
  char next() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool skip_blanks() {
    const std::size_t before = at_;
    while (next() == ' ' || next() == '\t') ++at_;
    return at_ > before;
  }
  bool take(char letter) {
    if (next() != letter) return false;
    ++at_;
    return true;
  }

  [[noreturn]] void refuse_rest() const {
    const std::string shown = '"' + one_line(results::trimmed(rest()), 30) + '"';
    if (is_digit(next()) || (next() == '.' && rest().size() > 1 && is_digit(rest()[1])))
      throw UnitTextError("found a second number, " + shown + ": write one number followed by its unit");
    throw UnitTextError(rest().empty() ? "the unit is incomplete" : shown + " is not a unit");
  }

  /// Reciprocals are often written "1/s"; the 1 does not change the value.
  bool begins_with_one_over() {
    if (next() != '1') return false;
    const std::size_t slash = text_.find_first_not_of(" \t", at_ + 1);
    if (slash == std::string_view::npos || text_[slash] != '/') return false;
    at_ = slash;
    return true;
  }

  Unit product(Unit unit) {
    for (;;) {
      const std::size_t before = at_;
      const bool blank = skip_blanks();
      if (next() == '\0' || next() == ')') return unit;
      if (take('/')) {
        unit = Unit(ut_divide(unit.get(), factor().get()));
      } else if (next() == '*' ||
                 ((next() == '.' || next() == '-') && at_ + 1 < text_.size() && !is_digit(text_[at_ + 1]))) {
        ++at_;
        unit = Unit(ut_multiply(unit.get(), factor().get()));
      } else if (blank && takes_per()) {
        unit = Unit(ut_divide(unit.get(), factor().get()));
      } else if (blank && (begins_name(next()) || next() == '(')) {
        unit = Unit(ut_multiply(unit.get(), factor().get()));
      } else {
        if (!blank) at_ = before;
        refuse_rest();
      }
      if (!unit) throw UnitTextError('"' + one_line(text_, 40) + "\" is not a unit");
    }
  }

  bool takes_per() {
    const std::string_view word = rest().substr(0, 4);
    if (word != "per " && word != "PER ") return false;
    at_ += 4;
    return true;
  }

  Unit factor() {
    skip_blanks();
    Unit unit;
    if (take('(')) {
      unit = product(factor());
      if (!take(')')) throw UnitTextError("the unit has an unclosed parenthesis");
    } else {
      if (!begins_name(next()) || superscript_at(rest()) != nullptr) refuse_rest();
      unit = named();
    }
    const int power = exponent();
    return power == 1 ? std::move(unit) : Unit(ut_raise(unit.get(), power));
  }

  /// Digits belong to a name where letters follow, as in cmH2O.
  std::string_view name() {
    const std::size_t begin = at_;
    while (at_ < text_.size()) {
      std::size_t end = at_;
      while (end < text_.size() && is_digit(text_[end])) ++end;
      const bool on = end < text_.size() && (begins_name(text_[end]) || text_[end] == '_') &&
                      superscript_at(text_.substr(end)) == nullptr;
      if (!on) break;
      at_ = end + 1;
    }
    return text_.substr(begin, at_ - begin);
  }

  Unit named() {
    const std::string word(name());
    const std::string shown = '"' + one_line(word, 40) + '"';
    Unit unit(ut_parse(unit_system(), word.c_str(), UT_UTF8));
    if (!unit) throw UnitTextError("the unit " + shown + " is not known");
    const UnitMakeup makeup = makeup_of(unit.get());
    if (makeup.pure_number) throw UnitTextError(shown + " is a number, not a unit");
    if (!makeup.proportional) throw UnitTextError(shown + " has an offset zero point");
    if (makeup.angle != 0) ++angles_;
    return unit;
  }

  int exponent() {
    const bool raised = take('^') || (rest().starts_with("**") && take('*') && take('*'));
    std::string written;
    while (const auto* superscript = superscript_at(rest())) {
      written += superscript->second;
      at_ += superscript->first.size();
    }
    const bool signed_digit =
        (next() == '-' || next() == '+') && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]);
    if (written.empty() && (is_digit(next()) || signed_digit)) {
      written += text_[at_++];
      while (is_digit(next())) written += text_[at_++];
    }
    if (written.empty() && !raised) return 1;
    const bool has_sign = !written.empty() && !is_digit(written.front());
    const std::string digits = written.substr(has_sign ? 1 : 0);
    if (digits.size() != 1 || digits[0] < '1' || digits[0] > '9' ||
        (next() == '.' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1])))
      throw UnitTextError("found the power \"" + one_line(written, 20) +
                          "\" in the unit, allowed: whole numbers from 1 to 9, with or without a minus sign");
    return (written.front() == '-' ? -1 : 1) * (digits[0] - '0');
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int angles_ = 0;
};

}  // namespace

ParsedUnit parse_unit(std::string_view text) {
  if (text.size() > kLongest) throw UnitTextError('"' + one_line(text, 40) + "\" is not a unit");
  return UnitReader(results::trimmed(text)).whole();
}

std::string as_typed(std::string_view text) {
  static constexpr std::array<std::pair<std::string_view, char>, 21> kTypeset = {
      {{"\u00a0", ' '}, {"\u1680", ' '}, {"\u2000", ' '}, {"\u2001", ' '}, {"\u2002", ' '}, {"\u2003", ' '},
       {"\u2004", ' '}, {"\u2005", ' '}, {"\u2006", ' '}, {"\u2007", ' '}, {"\u2008", ' '}, {"\u2009", ' '},
       {"\u200a", ' '}, {"\u202f", ' '}, {"\u205f", ' '}, {"\u3000", ' '}, {"\u2212", '-'}, {"\u2010", '-'},
       {"\u2011", '-'}, {"\u00b7", '*'}, {"\u22c5", '*'}}};
  std::string typed;
  while (!text.empty()) {
    char letter = text.front();
    std::size_t length = 1;
    for (const auto& [typeset, plain] : kTypeset) {
      if (!text.starts_with(typeset)) continue;
      letter = plain;
      length = typeset.size();
    }
    typed += letter;
    text.remove_prefix(length);
  }
  return typed;
}

}  // namespace diefill::process
