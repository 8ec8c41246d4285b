// What a stress run is made of: families of adversarial cases, each with what must hold for all of
// them.
#pragma once

#include "tests/stress/random.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace rasterlab::stress {

/// A case is nothing but numbers, so that any can be written to a file, read back and made simpler.
using Numbers = std::vector<double>;

/// How often an approximate rung of a ladder is wrong in a family's cases: it promises nothing, so
/// this is its error and no violation.
struct RungError {
  std::int64_t samples = 0;
  std::int64_t wrong = 0;

  double per_million() const {
    return samples == 0 ? 0 : 1e6 * static_cast<double>(wrong) / static_cast<double>(samples);
  }
};

/// What checking cases has shown.
struct Verdict {
  std::int64_t samples = 0;  ///< how many single facts were compared with the oracle
  std::int64_t violations = 0;
  std::string first;       ///< the first violation, in words
  double worst_error = 0;  ///< for families that measure one: as a part of what is allowed
  std::map<std::string, RungError> rungs;  ///< by name

  /// Counts a sample; `words()` says what was found where the contract does not hold.
  template <class Words>
  void expect(bool holds, Words&& words) {
    ++samples;
    if (holds) return;
    if (violations++ == 0) first = words();
  }

  /// Counts a measured error and what is allowed. NaN is a violation.
  template <class Words>
  void expect_error(double error, double allowed, Words&& words) {
    worst_error = error / allowed > worst_error ? error / allowed : worst_error;
    expect(error <= allowed, words);
  }

  void measure(const std::string& rung, std::int64_t compared, std::int64_t wrong) {
    rungs[rung].samples += compared;
    rungs[rung].wrong += wrong;
  }

  /// Adds what further cases have shown.
  void add(const Verdict& more) {
    samples += more.samples;
    violations += more.violations;
    if (first.empty()) first = more.first;
    worst_error = std::max(worst_error, more.worst_error);
    for (const auto& [rung, error] : more.rungs) measure(rung, error.samples, error.wrong);
  }
};

struct Family {
  std::string name;      ///< "slivers"
  std::string contract;  ///< what must hold, one sentence
  /// The numbers after the first `fixed` come in groups of this many, any of which can be left out;
  /// 0: none can.
  std::size_t group;
  std::size_t fixed;
  std::function<Numbers(Random&)> draw;
  /// Holds its oracle against the code. Any numbers are allowed, also ones draw() never makes.
  std::function<void(const Numbers&, Verdict&)> check;
};

/// A family whose cases are many small ones: as many as `count` draws of `length` numbers each,
/// every one of which `check_one` is given alone and can be left out.
Family many_at_once(std::string name, std::string contract, std::size_t length, int count,
                    const std::function<Numbers(Random&)>& draw_one,
                    const std::function<void(const Numbers&, Verdict&)>& check_one);

std::vector<Family> coverage_families();
std::vector<Family> clipping_families();
std::vector<Family> cutting_families();
std::vector<Family> mesh_families();
std::vector<Family> precision_families();
std::vector<Family> transform_families();
std::vector<Family> shading_families();

/// All of them.
const std::vector<Family>& families();

/// The family of that name. Throws InputError, which lists the names there are.
const Family& family_named(const std::string& name);

/// Checks one case; what is thrown counts as a violation.
Verdict check(const Family& family, const Numbers& numbers);

/// Case `index` of a family: always the same numbers for the same seed.
Numbers draw(const Family& family, std::uint64_t seed, std::uint64_t index);

/// A simpler case that still violates the contract: groups are left out, numbers become 0, 1, whole
/// or shorter.
Numbers shrink(const Family& family, const Numbers& failing);

/// A case as JSON, every number exactly. Throws InputError when the file can't be read as a case.
void save_case(const std::filesystem::path& path, const Family& family, const Numbers& numbers,
               const Verdict& verdict);
struct SavedCase {
  const Family* family;
  Numbers numbers;
};
SavedCase load_case(const std::filesystem::path& path);

}  // namespace rasterlab::stress
