#include "app/shell/manual_page.h"

#include "app/exit_code.h"

namespace diefill::app {

namespace {

/// A word and what it means.
struct Entry {
  std::string word, meaning;
};

/// Of scripts; app/README.md has the same.
std::vector<Entry> exit_codes() {
  const auto entry = [](ExitCode code, const char* meaning) { return Entry{std::to_string(code), meaning}; };
  return {
      entry(kDone, "Done."),
      entry(kFailed, "Failed: a full disk, a missing library; not the fault of the scene."),
      entry(kBadInput, "Bad input: the scene, a CAD file, results or the command line."),
      entry(kOutOfRange, "The run left the valid range of the method."),
      entry(
          kUnfinished,
          "numerics.max_time was reached before the scene ended, or a step waits for a mass or a force that "
          "powder at rest never brings: the results are marked unfinished, and --resume continues the run "
          "with a larger max_time."),
      entry(kInterrupted, "Stopped by the user; a run leaves a checkpoint for --resume.")};
}

std::vector<Entry> environment() {
  return {{"DIEFILL_PROGRESS_SECONDS",
           "Time in seconds between lines of progress where standard error is no terminal (default: 10)."},
          {"XDG_CACHE_HOME",
           "Folder of caches (default: ~/.cache): diefill/pilots in it keeps the pilots of diefill plan."}};
}

/// `text` so that roff prints it as it is, line by line.
std::string roff(const std::string& text) {
  std::string safe;
  bool begins_line = true;
  for (const char c : text) {
    if (begins_line && (c == '.' || c == '\'')) safe += "\\&";
    if (c == '\\')
      safe += "\\e";
    else if (c == '-')
      safe += "\\-";
    else
      safe += c;
    begins_line = c == '\n';
  }
  return safe;
}

std::string option_entry(const OptionText& option) {
  std::string head;
  for (const auto& name : option.names) head += (head.empty() ? "" : ", ") + ("\\fB" + roff(name) + "\\fR");
  if (!option.positional && !option.value.empty()) head += " \\fI" + roff(option.value) + "\\fR";
  std::string text = ".TP\n" + head + "\n" + roff(option.description) + "\n";
  if (option.choices.empty()) return text;
  text += "One of:";
  for (const auto& choice : option.choices) text += ' ' + roff(choice);
  return text + ".\n";
}

/// Indented text whose lines stay as they are.
std::string as_it_is(const std::string& text) {
  return text.empty() ? "" : ".PP\n.nf\n" + roff(text) + "\n.fi\n";
}

std::string list_of(const char* heading, const std::vector<Entry>& entries) {
  std::string text = std::string(".SH ") + heading + "\n";
  for (const auto& entry : entries) text += ".TP\n.B " + roff(entry.word) + "\n" + roff(entry.meaning) + "\n";
  return text;
}

std::string usage_of(const CommandText& command) {
  std::string text = "diefill " + command.path();
  for (const auto& option : command.options)
    if (option.positional) text += ' ' + option.names.front();
  return text + (command.commands.empty() ? " [OPTIONS]" : " COMMAND [OPTIONS]");
}

std::string section_of(const CommandText& command) {
  std::string text = ".SS \"" + roff(usage_of(command)) + "\"\n" + roff(command.description) + "\n";
  for (const auto& option : command.options)
    if (option.names.back() != "--help") text += option_entry(option);
  return text + as_it_is(command.footer);
}

}  // namespace

std::string manual_page(const CommandText& program, const std::string& version) {
  std::string text = ".TH DIEFILL 1 \"\" \"diefill " + roff(version) +
                     "\" \"User Commands\"\n.SH NAME\ndiefill \\- " +
                     roff("predicts how powder fills a die") +
                     "\n.SH SYNOPSIS\n.B diefill\n\\fICOMMAND\\fR [\\fIARGUMENTS\\fR] [\\fIOPTIONS\\fR]\n" +
                     ".SH DESCRIPTION\n" + roff(program.description) + "\n.SH OPTIONS\n";
  for (const auto& option : program.options) text += option_entry(option);
  text += ".SH COMMANDS\n";
  for (const auto* command : all_commands(program))
    if (!command->words.empty()) text += section_of(*command);
  text += list_of("\"EXIT STATUS\"", exit_codes()) + list_of("ENVIRONMENT", environment());
  return text + ".SH EXAMPLES\n" + as_it_is(program.footer);
}

}  // namespace diefill::app
