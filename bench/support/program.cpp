#include "bench/support/program.h"

#include "common/image/bytes.h"
#include "common/image/check.h"
#include "common/stage/guard.h"

#include "bench/support/measure.h"
#include "bench/support/report.h"

#include <filesystem>
#include <iostream>

#include <CLI/CLI.hpp>

namespace rasterlab::bench {
int run_program(int argc, char** argv, const Program& program) {
  return run_guarded(program.name, [&] {
    bool quick = false;
    std::string part;
    std::filesystem::path out = "out/bench";
    CLI::App app{program.description, program.name};
    app.add_flag("--quick", quick, "Fewer and shorter repetitions: ends within half a minute");
    app.add_option("--ladder", part, "Only the ladders whose name has this in it")
        ->type_name("TEXT");
    app.add_option("--out", out, "Folder for " + program.name + ".json")
        ->type_name("DIR")
        ->capture_default_str();
    if (!parse_command_line(app, argc, argv)) return 0;
    std::filesystem::create_directories(out);
    const Effort effort = quick ? Effort{.repetitions = 7, .seconds = 0.005}
                                : Effort{.repetitions = 15, .seconds = 0.05};
    std::vector<MeasuredLadder> measured;
    for (const MakeLadder& make : program.ladders) {
      TimedLadder ladder = make();
      if (ladder.name.find(part) == std::string::npos) continue;
      std::vector<std::vector<double>> samples = measure(ladder, effort);
      measured.push_back({std::move(ladder), std::move(samples)});
      std::cout << table(measured.back()) << '\n' << std::flush;
    }
    if (measured.empty()) throw InputError("no ladder has '" + part + "' in its name");
    const std::filesystem::path file = out / (program.name + ".json");
    write_file(file, to_json(measured).dump(1) + "\n");
    std::cout << "wrote " << file.string() << '\n';
    return 0;
  });
}

}  // namespace rasterlab::bench
