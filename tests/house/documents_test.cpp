// What README, lab sheets and docs name is there: commands and their flags, paths, links, tests.
#include "common/image/files.h"

#include "tests/house/repository.h"
#include "tests/support/pattern.h"
#include "tests/support/process.h"
#include "tests/support/scratch.h"

#include <fstream>
#include <map>
#include <regex>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rasterlab::house {
namespace {

namespace fs = std::filesystem;

/// A Markdown file: its lines, and the pieces of code in it with the line each starts on.
struct Document {
  struct Code {
    std::string text;
    int line;
  };

  fs::path path;
  std::vector<std::string> text;
  std::vector<Code> code;
};

void add_spans(Document& document, const std::string& line, int number) {
  static const std::regex span("`([^`]+)`");
  for (std::sregex_iterator it(line.begin(), line.end(), span), end; it != end; ++it) {
    document.code.push_back({(*it)[1], number});
  }
}

/// A line of a code block without its comment; continued lines are one.
void add_block_line(Document& document, const std::string& line, int number, bool& continued) {
  std::string command = std::regex_replace(line, std::regex("(^|\\s)#.*$"), "");
  const bool goes_on = !command.empty() && command.back() == '\\';
  if (goes_on) command.pop_back();
  if (continued) {
    document.code.back().text += " " + command;
  } else {
    document.code.push_back({command, number});
  }
  continued = goes_on;
}

Document parse(const fs::path& path) {
  Document document{.path = path, .text = lines(read_file(path)), .code = {}};
  bool in_block = false;
  bool continued = false;
  for (std::size_t i = 0; i < document.text.size(); ++i) {
    const std::string& line = document.text[i];
    const int number = static_cast<int>(i) + 1;
    if (std::regex_search(line, std::regex("^\\s*```"))) {
      in_block = !in_block;
      continued = false;
    } else if (in_block) {
      add_block_line(document, line, number, continued);
    } else {
      add_spans(document, line, number);
    }
  }
  return document;
}

std::vector<Document> documents() {
  std::vector<fs::path> paths{root() / "README.md", root() / "data/README.md"};
  for (const std::string& stage : stages()) paths.push_back(root() / stage / "README.md");
  for (const auto& entry : fs::directory_iterator(root() / "docs")) {
    if (entry.path().extension() == ".md") paths.push_back(entry.path());
  }
  std::vector<Document> found;
  for (const fs::path& path : paths) found.push_back(parse(path));
  return found;
}

std::vector<std::string> words(const std::string& command) {
  std::istringstream stream(command);
  return {std::istream_iterator<std::string>(stream), {}};
}

/// A word that stands for something: ID, NN, FILE, NN.M, WxH.
bool is_placeholder(const std::string& word) {
  return std::regex_match(word, std::regex("\\[?[A-Z][A-Zx_.,|]*\\]?|…|\\.\\.\\."));
}

const std::string& help_of(const std::vector<std::string>& command) {
  static std::map<std::vector<std::string>, std::string> known;
  auto& help = known[command];
  if (help.empty()) help = run_process(command, {.folder = root()}).out;
  return help;
}

/// Whether a help text has this flag or subcommand as a word of its own.
bool offers(const std::string& help, const std::string& word) {
  const std::string escaped = std::regex_replace(word, std::regex("[.*+?-]"), "\\$&");
  return std::regex_search(help, std::regex("(^|[\\s,\\[|])" + escaped + "($|[\\s,\\]=|])"));
}

bool is_exercise(const std::string& id) {
  for (const std::string& stage : stages()) {
    for (const nlohmann::json& exercise : exercises(stage)) {
      if (exercise.at("id") == id) return true;
    }
  }
  return false;
}

/// The stage folder that "07" names; empty when there is none.
std::string stage_of(const std::string& number) {
  for (const std::string& stage : stages()) {
    if (stage == number || stage.substr(0, 2) == number) return stage;
  }
  return "";
}

/// What is wrong with the value of a flag; empty when nothing is or nothing is known about it.
std::string value_fault(const std::string& stage, const std::string& flag,
                        const std::string& value) {
  if (is_placeholder(value)) return "";
  if (flag == "--exercise" && !is_exercise(value)) return "no exercise " + value;
  if (flag == "--stage" && stage_of(value).empty()) return "no stage " + value;
  const bool has_list = flag == "--algorithm" || flag == "--shader";
  if (has_list && value != "list" && !offers(help_of({program(stage), flag, "list"}), value) &&
      !offers(help_of({program(stage), flag, "list"}), value + ":")) {
    return "no " + flag + " " + value;
  }
  return "";
}

/// What is wrong with a command line; empty when nothing is.
std::string command_fault(const std::vector<std::string>& command) {
  if (command.size() < 2) return "";
  const std::string& subcommand = command[1];
  const std::string& lab_help = help_of({"./lab", "--help"});
  if (!offers(lab_help, subcommand)) return "./lab has no '" + subcommand + "'";
  std::string stage;
  std::size_t first = 2;
  if (subcommand == "stage" && command.size() > 2 && !is_placeholder(command[2])) {
    stage = stage_of(command[2]);
    if (stage.empty()) return "no stage " + command[2];
    first = 3;
  }
  const std::string& help = stage.empty() ? lab_help : help_of({program(stage), "--help"});
  for (std::size_t i = first; i < command.size(); ++i) {
    const bool is_flag =
        command[i].size() > 1 && command[i][0] == '-' && std::isdigit(command[i][1]) == 0;
    if (!is_flag) continue;
    if (!offers(help, command[i])) return subcommand + " " + stage + " has no " + command[i];
    if (i + 1 < command.size()) {
      std::string fault = value_fault(stage, command[i], command[i + 1]);
      if (!fault.empty()) return fault;
    }
  }
  return "";
}

bool exists_matching(const fs::path& pattern) {
  if (pattern.string().find('*') == std::string::npos) return fs::exists(pattern);
  const fs::path folder = pattern.parent_path();
  if (!fs::is_directory(folder)) return false;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (matches(pattern.filename(), entry.path().filename())) return true;
  }
  return false;
}

/// What is wrong with a piece of code that may be a path; empty when nothing is.
std::string path_fault(const Document& document, const std::string& text) {
  if (!std::regex_match(text, std::regex("[A-Za-z0-9_.-]+(/[A-Za-z0-9_.*-]+)+/?"))) return "";
  const std::string top = text.substr(0, text.find('/'));
  if (top == "out" || top == "build" || top == "." || top == ".." || top == "NN_topic") return "";
  const fs::path here = document.path.parent_path();
  for (const fs::path& folder : {root(), here, root() / "common"}) {
    if (exists_matching(folder / text)) return "";
  }
  const bool is_ours =
      fs::exists(root() / top) || fs::exists(here / top) ||
      std::regex_search(text, std::regex("\\.(h|cpp|md|json|png|py|scene|off|obj)$"));
  return is_ours ? "no such path" : "";
}

std::string code_fault(const Document& document, const std::string& text) {
  const std::vector<std::string> command = words(text);
  if (!command.empty() && command[0] == "./lab") return command_fault(command);
  static const std::regex test_name(
      "(stage0[1-7]|image|mesh|oracle|house|cli|engine|stress|fuzz|grading)\\.[a-z0-9_]+\\.[a-z0-9_"
      ".*]+");
  if (std::regex_match(text, test_name)) return some_test_matches(text) ? "" : "no such test";
  return path_fault(document, text);
}

TEST(house_documents, commands_flags_paths_and_tests_in_code_exist) {
  for (const Document& document : documents()) {
    for (const Document::Code& code : document.code) {
      EXPECT_EQ(code_fault(document, code.text), "")
          << document.path.string() << ":" << code.line << ": " << code.text;
    }
  }
}

TEST(house_documents, links_lead_somewhere) {
  static const std::regex link(R"re((?:\]\(|src="|href=")([^)"\s]+)[)"])re");
  for (const Document& document : documents()) {
    for (std::size_t i = 0; i < document.text.size(); ++i) {
      const std::string& line = document.text[i];
      for (std::sregex_iterator it(line.begin(), line.end(), link), end; it != end; ++it) {
        const std::string target = (*it)[1];
        if (target.rfind("http", 0) == 0 || target[0] == '#') continue;
        const fs::path path = document.path.parent_path() / target.substr(0, target.find('#'));
        EXPECT_TRUE(fs::exists(path)) << document.path.string() << ":" << i + 1 << ": " << target;
      }
    }
  }
}

/// Whether one of the code pieces between a line and the next heading makes pictures of this
/// exercise.
bool has_command_below(const Document& document, std::size_t line, const std::string& id) {
  std::size_t end = line;
  while (end < document.text.size() && document.text[end].rfind("## ", 0) != 0) ++end;
  for (const Document::Code& code : document.code) {
    const auto at = static_cast<std::size_t>(code.line);
    if (at < line || at > end) continue;
    if (code.text.rfind("./lab stage", 0) == 0 && offers(code.text, id)) return true;
  }
  return false;
}

TEST(house_documents, every_picture_in_a_lab_sheet_has_the_command_that_makes_it_under_it) {
  static const std::regex picture(R"re(expected/(0[1-7]\.[0-9]+)[^)"\s]*\.png)re");
  for (const std::string& stage : stages()) {
    const Document sheet = parse(root() / stage / "README.md");
    for (std::size_t i = 0; i < sheet.text.size(); ++i) {
      std::smatch found;
      if (!std::regex_search(sheet.text[i], found, picture)) continue;
      EXPECT_TRUE(has_command_below(sheet, i + 1, found[1]))
          << sheet.path.string() << ":" << i + 1 << ": " << found[0];
    }
  }
}

TEST(house_documents, every_exercise_has_a_section_in_its_lab_sheet) {
  for (const std::string& stage : stages()) {
    const std::string sheet = read_file(root() / stage / "README.md");
    for (const nlohmann::json& exercise : exercises(stage)) {
      const std::string id = exercise.at("id");
      const std::string escaped = std::regex_replace(id, std::regex("\\."), "\\.");
      EXPECT_TRUE(std::regex_search(sheet, std::regex("(^|\n)##+ [^\n]*" + escaped + "(?![0-9])")))
          << stage << " " << id;
      EXPECT_THAT(sheet, testing::HasSubstr("./lab test --exercise " + id)) << stage;
    }
  }
}

TEST(house_documents, what_is_not_there_is_found) {
  const Document here{.path = root() / "README.md", .text = {}, .code = {}};
  EXPECT_EQ(code_fault(here, "./lab demo"), "");
  EXPECT_NE(code_fault(here, "./lab fly"), "");
  EXPECT_NE(code_fault(here, "./lab test --fly 01"), "");
  EXPECT_NE(code_fault(here, "./lab test --stage 09"), "");
  EXPECT_NE(code_fault(here, "./lab test --exercise 01.99"), "");
  EXPECT_NE(code_fault(here, "./lab stage 09"), "");
  EXPECT_NE(code_fault(here, "./lab stage 01 --fly"), "");
  EXPECT_EQ(code_fault(here, "./lab stage 01 --list"), "");
  EXPECT_EQ(code_fault(here, "common/image/image.h"), "");
  EXPECT_NE(code_fault(here, "common/image/imagine.h"), "");
  EXPECT_NE(code_fault(here, "stage01.no_such.test"), "");
}

TEST(house_documents, code_is_told_from_prose) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "a.md") << "Use `./lab demo` and\n```sh\n./lab stage 07 --mesh m \\\n  "
                                     "--size 3x4  # note\n```\n`x`\n";
  const Document document = parse(scratch / "a.md");
  ASSERT_EQ(document.code.size(), 3U);
  EXPECT_EQ(document.code[0].text, "./lab demo");
  EXPECT_EQ(words(document.code[1].text),
            (std::vector<std::string>{"./lab", "stage", "07", "--mesh", "m", "--size", "3x4"}));
  EXPECT_EQ(document.code[2].line, 6);
}

}  // namespace
}  // namespace rasterlab::house
