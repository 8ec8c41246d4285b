// The judge: compares what a student's program wrote with what the reference wrote. Runs outside
// both jails and never runs anything of the student's.
//
//   rasterlab_judge --expected FILE --actual FILE [--pictures DIR] [--mistake NAME=FILE]…
//
// Prints one JSON object: right, score, per record what is wrong; per known mistake how alike it
// is.
#include "common/image/files.h"
#include "common/stage/guard.h"

#include "grading/judge/compare.h"

#include <algorithm>
#include <iostream>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace rasterlab::grading {
namespace {

using Json = nlohmann::json;

struct Options {
  std::string expected;
  std::string actual;
  std::string pictures;
  std::vector<std::string> mistakes;
};

/// Writes actual, expected and difference of a record that is a picture; returns their file names.
Json write_pictures(const std::string& folder, std::size_t index, const Record& expected,
                    const Record& actual) {
  Json names = Json::object();
  const auto write = [&](const char* what, const Image<Rgb8>& image) {
    if (image.empty()) return;
    const std::string name = std::to_string(index) + "_" + what + ".png";
    write_image(std::filesystem::path(folder) / name, image);
    names[what] = name;
  };
  write("expected", to_image(expected));
  write("actual", to_image(actual));
  write("difference", difference_image(expected, actual));
  return names;
}

Json judge_record(const Options& options, std::size_t index, const Record& expected,
                  const Record& actual) {
  const Comparison result = compare(expected, actual);
  Json json = {{"name", expected.name},
               {"right", result.right},
               {"score", result.score},
               {"message", result.message}};
  if (!result.right) {
    json["grid"] = character_grid(expected, actual);
    json["kind_of_wrong"] = kind_of_wrong(expected, actual);
  }
  if (!options.pictures.empty() && actual.kind == expected.kind)
    json["pictures"] = write_pictures(options.pictures, index, expected, actual);
  return json;
}

/// The mean likeness over the records that the mistake or the answer gets wrong; −1 where there is
/// none.
double likeness_of_files(const std::vector<Record>& expected, const std::vector<Record>& actual,
                         const std::vector<Record>& mistake) {
  double sum = 0;
  int count = 0;
  static const Record nothing;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Record& a = i < actual.size() ? actual[i] : nothing;
    const Record& m = i < mistake.size() ? mistake[i] : nothing;
    const bool both_missing = i >= actual.size() && i >= mistake.size();  // says nothing
    if (both_missing || (wrong_places(expected[i], a) == 0 && wrong_places(expected[i], m) == 0))
      continue;
    sum += likeness(expected[i], a, m);
    ++count;
  }
  return count == 0 ? -1 : sum / count;
}

Json judge(const Options& options) {
  const std::vector<Record> expected = read_results(options.expected);
  std::vector<Record> actual;
  Json json = {{"malformed", ""}};
  try {
    actual = read_results(options.actual);
  } catch (const InputError& error) {
    json["malformed"] = error.what();
  }
  for (const Record& record : actual) {
    if (record.name == "exception") json["exception"] = record.text;
  }
  double score = 0;
  bool right = actual.size() == expected.size();
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Json record =
        judge_record(options, i, expected[i], i < actual.size() ? actual[i] : Record{});
    score += record.at("score").get<double>();
    right = right && record.at("right").get<bool>();
    json["records"].push_back(record);
  }
  json["right"] = right;
  json["score"] = expected.empty() ? 0 : score / double(expected.size());
  for (const std::string& mistake : options.mistakes) {
    const std::size_t equals = mistake.find('=');
    const std::filesystem::path file = mistake.substr(equals + 1);
    if (std::filesystem::file_size(file) == 0) continue;
    json["likeness"][mistake.substr(0, equals)] =
        likeness_of_files(expected, actual, read_results(file));
  }
  return json;
}

int run(int argc, char** argv) {
  Options options;
  CLI::App app("Compares what a student's program wrote with what the reference wrote.");
  app.add_option("--expected", options.expected, "The reference's result file")->required();
  app.add_option("--actual", options.actual, "The student's result file")->required();
  app.add_option("--pictures", options.pictures, "Folder for actual, expected and difference");
  app.add_option("--mistake", options.mistakes, "NAME=FILE: the result of a known mistake");
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    std::cout << app.help();
    return 0;
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }
  std::cout << judge(options).dump(1, ' ', false, Json::error_handler_t::replace) << "\n";
  return 0;
}

}  // namespace
}  // namespace rasterlab::grading

int main(int argc, char** argv) {
  return rasterlab::run_guarded("rasterlab_judge",
                                [&] { return rasterlab::grading::run(argc, argv); });
}
