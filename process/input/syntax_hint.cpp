#include "process/input/syntax_hint.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cctype>

#include "process/input/shown_value.h"
#include "process/input/toml_bounds.h"

namespace diefill::process {
namespace {

constexpr std::size_t kLongestExample = 80;

/// `example` where it is a short line of TOML, otherwise `usual`: an invalid line must not become advice.
std::string sound(const std::string& example, const std::string& usual) {
  if (example.empty() || example.size() > kLongestExample || !is_printable(example)) return usual;
  try {
    refuse_deep_nesting(example, "");
    const toml::table parsed = toml::parse(example);
    return example;
  } catch (const std::exception&) {
    return usual;
  }
}

bool is_digit(char letter) {
  return std::isdigit(static_cast<unsigned char>(letter)) != 0;
}

bool is_letter(char letter) {
  return std::isalpha(static_cast<unsigned char>(letter)) != 0 || (letter & 0x80) != 0;
}

/// Key and value round the first "="; trimmed.
struct Assignment {
  std::string key, value;
};

Assignment parted(const std::string& line, std::size_t equals) {
  Assignment parts;
  const std::size_t end = equals == 0 ? std::string::npos : line.find_last_not_of(" \t", equals - 1);
  if (end != std::string::npos) parts.key = line.substr(0, end + 1);
  const std::size_t start = line.find_first_not_of(" \t", equals + 1);
  if (start != std::string::npos) parts.value = line.substr(start);
  return parts;
}

/// The value in quotes, without a comment after it.
std::string quoted(const Assignment& parts) {
  std::string value = parts.value.substr(0, parts.value.find(" #"));
  value.resize(value.find_last_not_of(" \t") + 1);
  if (value.find_first_of("\"'=[]{}") != std::string::npos) return {};
  return parts.key + " = \"" + value + '"';
}

std::string number_remedy(const Assignment& parts) {
  const std::string& value = parts.value;
  const std::size_t after_number = value.find_first_not_of("+-0123456789.eE");
  if (after_number != std::string::npos && value[after_number] == ',')
    return "; write a decimal point, not a comma";
  const std::size_t unit = value.find_first_not_of(" \t", after_number);
  if (unit != std::string::npos && is_letter(value[unit]))
    return "; put a quantity with its unit in quotes, such as " +
           sound(quoted(parts), "velocity = \"0.2 m/s\"");
  if (value.front() == '.') {
    const std::string example = sound(parts.key + " = 0" + value, parts.key + " = 0.6");
    return "; write a digit before the decimal point, such as " + example.substr(example.find(" = ") + 3);
  }
  return {};
}

std::string header_remedy(const std::string& line) {
  const bool list = line.starts_with("[[");
  return "; close the bracket, such as " +
         (list ? sound(line + "]]", "[[tool]]") : sound(line + ']', "[powder]"));
}

/// Of what the parser says alone, whatever the line is.
std::string remedy_of(const std::string& reason) {
  const auto says = [&](const char* words) { return reason.find(words) != std::string::npos; };
  if (says("cannot redefine")) return "; it is already defined above, keep one of the two";
  if (says("representable"))
    return "; whole numbers must be between -9223372036854775808 and 9223372036854775807";
  if (says("after '\\r'"))
    return "; lines end in a carriage return alone: save the file with the line ends of Linux or Windows";
  if (says("comma or closing ']'"))
    return "; write a comma between values, or close the bracket \"[\" of this line or of one above";
  if (says("comma or closing '}'") || says("key or closing '}'"))
    return "; write a comma between keys, or close the brace \"{\" in its line";
  return {};
}

}  // namespace

std::string syntax_hint(const std::string& line, const std::string& reason) {
  if (const std::string remedy = remedy_of(reason); !remedy.empty()) return remedy;
  if (line.starts_with('[') && line.find(']') == std::string::npos) return header_remedy(line);
  if (std::count(line.begin(), line.end(), '"') % 2 != 0) return "; close the quote";
  const std::size_t equals = line.find('=');
  if (equals == std::string::npos) return "; each line is key = value, [table] or # comment";
  const Assignment parts = parted(line, equals);
  if (parts.key.empty()) return "; the key is missing before \"=\"";
  if (parts.value.empty()) return "; the value is missing after \"=\"";
  const char first = parts.value.front();
  if (is_digit(first) || first == '-' || first == '+' || first == '.') {
    const std::string remedy = number_remedy(parts);
    if (!remedy.empty()) return remedy;
  }
  if (is_letter(first)) return "; put text in quotes, such as " + sound(quoted(parts), "role = \"die\"");
  if (line.find('\\') != std::string::npos) return "; use / instead of \\ in paths";
  return {};
}

std::string change_hint(const std::string& line, const std::string& reason) {
  if (reason.find("cannot redefine") == std::string::npos) return syntax_hint(line, reason);
  return "; an earlier change gives this key, or the list or table that it is in, as a whole: give the final "
         "value there";
}

}  // namespace diefill::process
