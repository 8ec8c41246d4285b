#include "tests/stress/family.h"

#include "common/image/bytes.h"
#include "common/image/check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <utility>

#include <nlohmann/json.hpp>

namespace rasterlab::stress {

const std::vector<Family>& families() {
  static const std::vector<Family> all = [] {
    std::vector<Family> list;
    for (const auto& part :
         {coverage_families(), clipping_families(), cutting_families(), mesh_families(),
          precision_families(), transform_families(), shading_families()}) {
      list.insert(list.end(), part.begin(), part.end());
    }
    return list;
  }();
  return all;
}

const Family& family_named(const std::string& name) {
  std::string names;
  for (const Family& family : families()) {
    if (family.name == name) return family;
    names += (names.empty() ? "" : ", ") + family.name;
  }
  const auto replace = nlohmann::json::error_handler_t::replace;  // what is no UTF-8
  throw InputError("no family is called " + nlohmann::json(name).dump(-1, ' ', true, replace) +
                   "; there are " + names);
}

Family many_at_once(std::string name, std::string contract, std::size_t length, int count,
                    const std::function<Numbers(Random&)>& draw_one,
                    const std::function<void(const Numbers&, Verdict&)>& check_one) {
  const auto draw_all = [=](Random& random) {
    Numbers numbers;
    for (int i = 0; i < count; ++i) {
      const Numbers one = draw_one(random);
      numbers.insert(numbers.end(), one.begin(), one.end());
    }
    return numbers;
  };
  const auto check_all = [=](const Numbers& numbers, Verdict& verdict) {
    for (std::size_t i = 0; i + length <= numbers.size(); i += length) {
      const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(i);
      check_one(Numbers(first, first + static_cast<std::ptrdiff_t>(length)), verdict);
    }
  };
  return {std::move(name), std::move(contract), length, 0, draw_all, check_all};
}

Verdict check(const Family& family, const Numbers& numbers) {
  Verdict verdict;
  try {
    family.check(numbers, verdict);
  } catch (const std::exception& error) {
    verdict.expect(false, [&] { return std::string("threw: ") + error.what(); });
  }
  return verdict;
}

Numbers draw(const Family& family, std::uint64_t seed, std::uint64_t index) {
  std::uint64_t name = 0;
  for (const char letter : family.name) name = name * 131 + static_cast<unsigned char>(letter);
  Random random({seed, name, index});
  return family.draw(random);
}

namespace {

/// Looks for simpler numbers while the contract stays violated.
class Shrinking {
 public:
  Shrinking(const Family& family, Numbers failing) : family_(family), best_(std::move(failing)) {}

  Numbers run() {
    leave_out_groups();
    bool simpler = true;
    while (simpler) {
      simpler = false;
      for (std::size_t i = 0; i < best_.size(); ++i) simpler = simplify(i) || simpler;
    }
    return best_;
  }

 private:
  static constexpr int most_checks = 3000;

  bool take_if_failing(Numbers candidate) {
    if (checks_++ >= most_checks || check(family_, candidate).violations == 0) return false;
    best_ = std::move(candidate);
    return true;
  }

  void leave_out_groups() {
    if (family_.group == 0) return;
    std::size_t length = (best_.size() - family_.fixed) / family_.group;
    for (; length > 0; length /= 2) {
      std::size_t begin = family_.fixed;
      while (begin + length * family_.group <= best_.size()) {
        Numbers shorter = best_;
        const auto from = shorter.begin() + static_cast<std::ptrdiff_t>(begin);
        shorter.erase(from, from + static_cast<std::ptrdiff_t>(length * family_.group));
        if (!take_if_failing(std::move(shorter))) begin += length * family_.group;
      }
    }
  }

  bool simplify(std::size_t i) {
    const double old = best_[i];
    for (const double simpler : {0.0, 1.0, std::trunc(old), std::round(old * 16) / 16,
                                 std::round(old * 256) / 256, std::round(old * 65536) / 65536}) {
      if (simpler == old || old == 0 || (old == 1 && simpler != 0)) continue;
      Numbers candidate = best_;
      candidate[i] = simpler;
      if (take_if_failing(std::move(candidate))) return true;
    }
    return false;
  }

  const Family& family_;
  Numbers best_;
  int checks_ = 0;
};

std::string exact_text(double number) {
  char text[64];
  std::snprintf(text, sizeof text, "%a", number);
  return text;
}

double number_of(const nlohmann::json& text) {
  const auto string = text.get<std::string>();
  char* end = nullptr;
  const double number = std::strtod(string.c_str(), &end);
  if (string.empty() || end != string.c_str() + string.size()) {
    throw InputError("expected numbers as 0x1.8p+3, not " + text.dump());
  }
  return number;
}

}  // namespace

Numbers shrink(const Family& family, const Numbers& failing) {
  return Shrinking(family, failing).run();
}

void save_case(const std::filesystem::path& path, const Family& family, const Numbers& numbers,
               const Verdict& verdict) {
  nlohmann::json exact = nlohmann::json::array();
  for (const double number : numbers) exact.push_back(exact_text(number));
  const nlohmann::json saved = {{"family", family.name},
                                {"contract", family.contract},
                                {"violation", verdict.first},
                                {"numbers", exact}};
  write_file(path, saved.dump(1) + "\n");
}

SavedCase load_case(const std::filesystem::path& path) {
  const std::string text = read_file(path);
  try {
    const nlohmann::json saved = nlohmann::json::parse(text);
    SavedCase loaded = {&family_named(saved.at("family").get<std::string>()), {}};
    for (const nlohmann::json& number : saved.at("numbers")) {
      loaded.numbers.push_back(number_of(number));
    }
    return loaded;
  } catch (const nlohmann::json::exception& error) {
    throw InputError(path.string() + ": not a saved case: " + error.what());
  } catch (const InputError& error) {
    throw InputError(path.string() + ": not a saved case: " + error.what());
  }
}

}  // namespace rasterlab::stress
