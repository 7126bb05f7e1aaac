// One key of a part of a contact law: how it is read from the scene, and how reports show it.
#pragma once

#include <functional>
#include <limits>
#include <string>

#include "process/input/table_reader.h"
#include "process/scene/scene.h"

namespace diefill::process {

/// A key that sets a member of a part's Parameters.
template <class Parameters>
struct ContactKey {
  std::string name;
  std::string of_powder;  ///< key of [powder] that gives the value where this one is left out; empty: none
  std::function<void(TableReader&, const PowderSpec&, Parameters&)> read;
  std::function<std::string(const Parameters&)> shown;  ///< such as "modulus 5e+06 Pa"
  std::string example = {};  ///< value in a scene, where the key has no value of its own
};

/// Whether a key must be given.
enum class Need {
  given,     ///< refused where it is missing
  optional,  ///< the part has a default
  linked     ///< another part gives it where it is missing: not a number until then
};

/// Whether a part on its own needs the key.
inline bool wanted(Need need) {
  return need != Need::optional;
}

/// A rule with the SI unit that values are shown in.
struct ContactQuantity {
  QuantityRule rule;
  std::string_view unit;
};

inline std::string shown_quantity(const std::string& name, double value, std::string_view unit) {
  return name + ' ' + number_text(value) + ' ' + std::string(unit);
}

/// A key with a unit.
template <class Parameters>
ContactKey<Parameters> quantity_key(std::string name, double Parameters::*member, ContactQuantity quantity,
                                    Need need = Need::given) {
  return {
      name, "",
      [=](TableReader& table, const PowderSpec&, Parameters& parameters) {
        if (need == Need::given) parameters.*member = table.required_quantity(name, quantity.rule);
        const double absent =
            need == Need::linked ? std::numeric_limits<double>::quiet_NaN() : parameters.*member;
        parameters.*member = table.quantity(name, quantity.rule).value_or(absent);
      },
      [=](const Parameters& parameters) { return shown_quantity(name, parameters.*member, quantity.unit); },
      wanted(need) ? '"' + std::string(quantity.rule.example) + '"' : ""};
}

/// A key that holds a bare number.
template <class Parameters>
ContactKey<Parameters> number_key(std::string name, double Parameters::*member, NumberRule rule,
                                  Need need = Need::given) {
  return {name, "",
          [=](TableReader& table, const PowderSpec&, Parameters& parameters) {
            if (need == Need::given) table.require(name, std::string(rule.example));
            const double absent =
                need == Need::linked ? std::numeric_limits<double>::quiet_NaN() : parameters.*member;
            parameters.*member = table.number(name, rule).value_or(absent);
          },
          [=](const Parameters& parameters) { return name + ' ' + number_text(parameters.*member); },
          wanted(need) ? std::string(rule.example) : ""};
}

/// A key that is true or false.
template <class Parameters>
ContactKey<Parameters> flag_key(std::string name, bool Parameters::*member) {
  return {name, "",
          [=](TableReader& table, const PowderSpec&, Parameters& parameters) {
            parameters.*member = table.flag(name).value_or(parameters.*member);
          },
          [=](const Parameters& parameters) { return (parameters.*member ? std::string() : "no ") + name; }};
}

/// A key that chooses among words.
template <class Parameters, class Value>
ContactKey<Parameters> choice_key(std::string name, Value Parameters::*member, Choices<Value> choices) {
  return {name, "",
          [=](TableReader& table, const PowderSpec&, Parameters& parameters) {
            parameters.*member = table.choice(name, choices).value_or(parameters.*member);
          },
          [=](const Parameters& parameters) {
            for (const auto& [word, value] : choices)
              if (value == parameters.*member) return name + ' ' + word;
            return name;
          }};
}

/// A key that is used for some values of keys read before it, and otherwise refused with `reason`.
template <class Parameters>
ContactKey<Parameters> key_where(const std::function<bool(const Parameters&)>& in_use,
                                 const ContactKey<Parameters>& key, std::string reason) {
  ContactKey<Parameters> limited = key;
  limited.read = [=](TableReader& table, const PowderSpec& powder, Parameters& parameters) {
    if (in_use(parameters)) return key.read(table, powder, parameters);
    if (table.has(key.name)) table.reject(key.name, reason);
  };
  limited.shown = [=](const Parameters& parameters) {
    return in_use(parameters) ? key.shown(parameters) : std::string();
  };
  if (!in_use({})) limited.example.clear();
  return limited;
}

/// A bare number that [powder] gives under the same name where it is left out.
template <class Parameters>
ContactKey<Parameters> number_of_powder(std::string name, double Parameters::*member, NumberRule rule,
                                        double PowderSpec::*source) {
  auto key = number_key(name, member, rule, Need::optional);
  key.of_powder = name;
  key.read = [=](TableReader& table, const PowderSpec& powder, Parameters& parameters) {
    parameters.*member = table.number(name, rule).value_or(powder.*source);
  };
  return key;
}

/// The same with a unit. `over_radius`: the key is the member over the powder's sphere radius, and `quantity`
/// has the unit of the member.
template <class Parameters>
ContactKey<Parameters> quantity_of_powder(std::string name, double Parameters::*member,
                                          ContactQuantity quantity, double PowderSpec::*source,
                                          bool over_radius = false) {
  return {name, name,
          [=](TableReader& table, const PowderSpec& powder, Parameters& parameters) {
            parameters.*member = table.quantity(name, quantity.rule).value_or(powder.*source) *
                                 (over_radius ? powder.sphere_radius : 1);
          },
          [=](const Parameters& parameters) {
            const std::string what = over_radius ? name.substr(0, name.find("_over")) : name;
            return shown_quantity(what, parameters.*member, quantity.unit);
          }};
}

}  // namespace diefill::process
