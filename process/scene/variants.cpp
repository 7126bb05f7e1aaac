#include "process/scene/variants.h"

#include <toml++/toml.h>

#include <algorithm>
#include <sstream>

#include "process/input/nearest_key.h"
#include "process/input/units.h"
#include "process/scene/folder_names.h"
#include "process/scene/reading/sections.h"
#include "process/scene/scene_text.h"
#include "process/scene/setting.h"

namespace diefill::process {
namespace {

/// Puts `node` itself at `key`: a copy would forget its line, which messages name.
void put(toml::table& table, const toml::key& key, toml::node&& node) {
  node.visit([&](auto& value) { table.insert_or_assign(key, std::move(value)); });
}

/// What the entries of a list can be called: their names, or else their numbers from 1.
std::vector<std::string> entry_names(const toml::array& list) {
  std::vector<std::string> names;
  for (const toml::node& entry : list) {
    const auto* table = entry.as_table();
    const auto name = table != nullptr ? (*table)["name"].value_exact<std::string>() : std::nullopt;
    names.push_back(name.value_or(std::to_string(names.size() + 1)));
  }
  return names;
}

/// Place in the list of the entry that is called `word`, by name or by number from 1; its length if none is.
std::size_t entry_called(const std::string& word, const std::vector<std::string>& names) {
  const auto match = std::find(names.begin(), names.end(), word);
  if (match != names.end()) return static_cast<std::size_t>(match - names.begin());
  for (std::size_t k = 0; k < names.size(); ++k)
    if (word == std::to_string(k + 1)) return k;
  return names.size();
}

[[noreturn]] void reject_entry(const TableReader& reader, const std::string& list, const std::string& word,
                               const std::vector<std::string>& names) {
  std::string allowed = "no [[" + list + "]] has this name or number; ";
  if (const auto meant = nearest_key(word, names))
    reader.reject(word, allowed + "did you mean \"" + *meant + "\"?");
  allowed += "allowed: ";
  for (std::size_t k = 0; k < names.size(); ++k) allowed += (k == 0 ? "\"" : ", \"") + names[k] + '"';
  reader.reject(word, allowed);
}

void merge(toml::table& into, toml::table& changes, const std::filesystem::path& file,
           const std::string& path);

/// Whether the changes make an entry another kind of thing, whose keys are not those it has.
bool of_another_kind(const toml::table& entry, const toml::table& changes) {
  const auto kind = changes["kind"].value<std::string>();
  return kind && kind != entry["kind"].value<std::string>();
}

/// Takes out all that an entry says but its name, by which others call it.
void keep_name_only(toml::table& entry) {
  for (auto it = entry.begin(); it != entry.end();)
    it = it->first == "name" ? std::next(it) : entry.erase(it);
}

/// Changes the entries of a list one by one: every key of `changes` calls one of them.
void merge_entries(toml::array& list, toml::table& changes, const std::filesystem::path& file,
                   const std::string& path, const std::string& list_name) {
  const TableReader reader(changes, file, path);
  const auto names = entry_names(list);
  for (auto&& [key, node] : changes) {
    const std::string word(key.str());
    const std::size_t k = entry_called(word, names);
    if (k == names.size()) reject_entry(reader, list_name, word, names);
    toml::table* entry = list[k].as_table();
    toml::table* change = node.as_table();
    if (entry == nullptr || change == nullptr)
      reader.reject(word, "expected keys to change, such as " + list_name + '.' + word + ".name = \"...\"");
    if (of_another_kind(*entry, *change)) keep_name_only(*entry);
    merge(*entry, *change, file, path + '.' + word);
  }
}

/// Lays `changes` over `into`: tables key by key, lists of tables by name or number, everything else whole.
void merge(toml::table& into, toml::table& changes, const std::filesystem::path& file,
           const std::string& path) {
  for (auto&& [key, node] : changes) {
    const std::string word(key.str());
    toml::node* old = into.get(word);
    toml::table* change = node.as_table();
    const std::string below = path.empty() ? word : path + '.' + word;
    if (old != nullptr && change != nullptr && old->is_table())
      merge(*old->as_table(), *change, file, below);
    else if (old != nullptr && change != nullptr && old->is_array_of_tables())
      merge_entries(*old->as_array(), *change, file, below, word);
    else
      put(into, key, std::move(node));
  }
}

/// Any text that can be seen: folders are made of it by folder_names.
std::string variant_name(TableReader& table) {
  constexpr std::size_t kLongest = 1000;  // bytes; it stands in every line of a table
  const std::string example = "slow shoe";
  std::string name = table.required_text("name", example);
  if (name.find_first_not_of(" \t") == std::string::npos)
    table.reject("name", "expected a name of printable characters on one line, such as \"" + example + '"');
  if (name.size() > kLongest)
    table.reject("name", "allowed: a name of at most " + std::to_string(kLongest) + " bytes, such as \"" +
                             example + '"');
  return name;
}

/// Names and folders of all variants, in their order.
std::vector<Variant> named_variants(const toml::table& document, const std::filesystem::path& file) {
  std::vector<std::string> names;
  auto tables = TableReader(document, file, "").tables("variant");
  for (TableReader& table : tables) {
    const std::string name = variant_name(table);
    if (std::find(names.begin(), names.end(), name) != names.end())
      table.reject("name", "an earlier variant has this name; give each a unique name");
    if (table.has("variant"))
      table.reject("variant", "variants cannot be nested; write [[variant]] at the top level");
    names.push_back(name);
  }
  const auto folders = folder_names(names);
  std::vector<Variant> variants;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (std::find(folders.begin(), folders.begin() + static_cast<std::ptrdiff_t>(k), folders[k]) !=
        folders.begin() + static_cast<std::ptrdiff_t>(k))
      tables[k].reject("name", "an earlier variant would use the same results folder; choose another name");
    variants.push_back({names[k], folders[k], {}});
  }
  return variants;
}

/// Names of the keys on the way to `key`, outermost first.
std::vector<std::string> names_on_path(const std::string& key, const std::filesystem::path& file) {
  toml::table nested = parse_scene_text(key + " = 0", file);
  std::vector<std::string> words;
  for (const toml::table* table = &nested; table != nullptr && table->size() == 1;) {
    words.emplace_back(table->begin()->first.str());
    table = table->begin()->second.as_table();
  }
  return words;
}

/// What stands there; null where nothing does.
toml::node* node_at(toml::table& document, const std::vector<std::string>& words) {
  toml::node* node = &document;
  for (const std::string& word : words) {
    if (toml::table* table = node->as_table()) {
      node = table->get(word);
    } else if (toml::array* list = node->as_array()) {
      const std::size_t k = entry_called(word, entry_names(*list));
      node = k < list->size() ? list->get(k) : nullptr;
    } else {
      node = nullptr;
    }
    if (node == nullptr) return nullptr;
  }
  return node;
}

/// Takes a key out of the document, if it is there.
void take_out(toml::table& document, std::vector<std::string> words) {
  const std::string last = words.back();
  words.pop_back();
  toml::node* parent = node_at(document, words);
  if (parent != nullptr && parent->is_table()) parent->as_table()->erase(last);
}

/// The scene of variant `number`. Parses the text again, since laying the changes over it uses them up.
Scene variant_scene(const std::string& text, const std::filesystem::path& file, std::size_t number,
                    const std::string& name) {
  toml::table document = parse_scene_text(text, file);
  toml::array variants = std::move(*document["variant"].as_array());
  document.erase("variant");
  toml::table& changes = *variants[number].as_table();
  changes.erase("name");
  if (!changes.contains("title"))
    document.insert_or_assign("title", document["title"].value_or(file.stem().string()) + ": " + name);
  try {
    merge(document, changes, file, "variant");
    return scene_of(document, scene_text_of(document), file);
  } catch (const SceneError& error) {
    throw SceneError(std::string(error.what()) + " (in variant \"" + name + "\")");
  }
}

}  // namespace

std::vector<Variant> read_variants(const std::filesystem::path& file) {
  const std::string text = load_scene_text(file);
  Scene as_it_is = parse_scene(text, file);
  toml::table document = parse_scene_text(text, file);
  std::vector<Variant> variants = named_variants(document, file);
  for (std::size_t k = 0; k < variants.size(); ++k)
    variants[k].scene = variant_scene(text, file, k, variants[k].name);
  if (variants.empty()) variants.push_back({"as it is", "as_it_is", std::move(as_it_is)});
  return variants;
}

bool has_variants(const Scene& scene) {
  return parse_scene_text(scene.text, scene.file).contains("variant");
}

Scene changed_scene(const std::string& text, const std::filesystem::path& file, const SceneChanges& changes) {
  toml::table document = parse_scene_text(text, file);
  document.erase("variant");
  for (const std::string& key : changes.without) take_out(document, names_on_path(key, file));
  WrittenKeys written;
  for (const std::string& layer : {changes.under, changes.set}) {
    toml::table laid = parse_changes(layer, changes.source);
    written.add(laid);
    merge(document, laid, file, "");
  }
  return scene_of(document, scene_text_of(document), file, written);
}

std::optional<std::string> value_at(const std::string& text, const std::filesystem::path& file,
                                    const std::string& key) {
  toml::table document = parse_scene_text(text, file);
  const toml::node* node = node_at(document, names_on_path(key, file));
  if (node == nullptr) return std::nullopt;
  if (const auto word = node->value_exact<std::string>()) return word;
  if (const auto number = node->value_exact<double>()) return number_text(*number);
  std::stringstream written;
  node->visit([&](const auto& value) { written << value; });
  return written.str();
}

std::string scene_text_with(const Scene& scene, std::uint64_t seed,
                            const std::function<std::string(const std::filesystem::path&)>& elsewhere) {
  toml::table document = parse_scene_text(scene.text, scene.file);
  document.insert_or_assign("seed", static_cast<std::int64_t>(seed));
  const auto move_file = [&](toml::table* table, const char* key) {
    if (table == nullptr) return;
    if (const auto file = (*table)[key].value_exact<std::string>())
      table->insert_or_assign(key, elsewhere(scene.file.parent_path() / *file));
  };
  for (const auto& [list, key] :
       {std::pair{"tool", "file"}, {"step", "file"}, {"other_powder", "spheres_file"}})
    if (toml::array* entries = document[list].as_array())
      for (toml::node& entry : *entries) move_file(entry.as_table(), key);
  move_file(document["powder"].as_table(), "spheres_file");
  move_file(document["pour"].as_table(), "grains_file");
  // A directory stays where it is.
  if (const auto state = document["pour"]["state"].value<std::string>())
    document["pour"].as_table()->insert_or_assign(
        "state", std::filesystem::absolute(scene.file.parent_path() / *state).lexically_normal().string());
  return as_comment(chosen_numbers_in(scene.text)) + scene_text_of(document);
}

}  // namespace diefill::process
